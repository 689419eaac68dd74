/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "lostDebts.H"
#include "continuedField.H"
#include "surfaceFields.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::lostDebts::lostDebts(const carrierFluid& fluid)
:
    fluid_(fluid),
    momentum_
    (
        continuedField::header("momentumOfLostGrains", fluid.mesh(), IOobject::NO_WRITE),
        fluid.mesh(),
        dimensionedVector(dimForce*dimTime, Zero)
    )
{}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::lostDebts::share
(
    const carrierFluid& fluid,
    const label celli,
    const scalar rho,
    const scalar dt
)
{
    const fvMesh& mesh = fluid.mesh();
    const surfaceScalarField& phi = fluid.phi();

    // A flux of mass in a gas
    scalar through = 0;
    for (const label facei : mesh.cells()[celli])
    {
        if (mesh.isInternalFace(facei))
        {
            through += mag(phi[facei]);
            continue;
        }
        const label patchi = mesh.boundaryMesh().whichPatch(facei);
        const scalarField& flux = phi.boundaryField()[patchi];
        const label i = facei - mesh.boundaryMesh()[patchi].start();
        through += i < flux.size() ? mag(flux[i]) : 0;
    }
    const scalar volume = mesh.V()[celli]*(fluid.compressible() ? rho : 1);
    return -std::expm1(-0.01*0.5*through*dt/volume);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::Map<Foam::vector> Foam::lostDebts::pay(const scalar dt)
{
    const fvMesh& mesh = fluid_.mesh();
    const volVectorField& U = fluid_.U();

    Map<vector> paid;
    if (max(cmptMag(momentum_.field())) == vector::zero)
    {
        return paid;
    }
    const tmp<volScalarField> trho(fluid_.rho());
    forAll(momentum_, celli)
    {
        vector& owed = momentum_[celli];
        if (owed != vector::zero)
        {
            const scalar rho = trho()[celli];
            const scalar own = rho*mesh.V()[celli]*mag(U[celli]);
            const vector now(share(fluid_, celli, rho, dt)*min(1.0, own/mag(owed))*owed);
            owed -= now;
            paid.insert(celli, now);
        }
    }
    return paid;
}


void Foam::lostDebts::write(const vectorField& momentum) const
{
    continuedField::write(momentum_, momentum);
}


void Foam::lostDebts::addWork(scalarField& work) const
{
    const volVectorField& U = fluid_.U();
    forAll(momentum_, celli)
    {
        work[celli] += momentum_[celli] & U[celli];
    }
}


// ************************************************************************* //
