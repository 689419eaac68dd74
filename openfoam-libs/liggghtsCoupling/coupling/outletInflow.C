/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "outletInflow.H"
#include "surfaceFields.H"
#include "wallFvPatch.H"
#include "zeroGradientFvPatchFields.H"

#include <sstream>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::List<Foam::outletInflow::inflow> Foam::outletInflow::inflows() const
{
    const fvMesh& mesh = fluid_.mesh();
    const scalarField& V = mesh.V();
    const scalar dt = mesh.time().deltaTValue();
    const volVectorField& U = fluid_.U();
    tmp<volScalarField> trho;
    List<inflow> result(U.boundaryField().size());

    forAll(U.boundaryField(), patchi)
    {
        const fvPatchVectorField& Ub = U.boundaryField()[patchi];
        if (!isA<zeroGradientFvPatchVectorField>(Ub) || isA<wallFvPatch>(Ub.patch()))
        {
            continue;
        }
        if (fluid_.compressible() && !trho.valid())
        {
            trho = fluid_.rho();
        }
        const scalarField& flux = fluid_.phi().boundaryField()[patchi];
        const labelUList& cells = Ub.patch().faceCells();
        inflow& most = result[patchi];
        forAll(flux, facei)
        {
            const label celli = cells[facei];
            const scalar volume = -flux[facei]/(trho.valid() ? trho()[celli] : 1);
            most.courant = max(most.courant, volume*dt/V[celli]);
            most.speed = max(most.speed, volume/Ub.patch().magSf()[facei]);
        }
    }
    return result;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::outletInflow::largest() const
{
    scalar courant = 0;
    if (!warned_)
    {
        for (const inflow& i : inflows())
        {
            courant = max(courant, i.courant);
        }
    }
    return courant;
}


void Foam::outletInflow::warn(const scalar largest)
{
    if (!(largest > most_))
    {
        return;
    }
    warned_ = true;
    const volVectorField& U = fluid_.U();
    const List<inflow> here(inflows());
    forAll(U.boundaryField(), patchi)
    {
        const fvPatchVectorField& Ub = U.boundaryField()[patchi];
        // Patches between ranks come last and are not the same on all
        if (Ub.patch().coupled())
        {
            continue;
        }
        const scalar courant = returnReduce(here[patchi].courant, maxOp<scalar>());
        const scalar speed = returnReduce(here[patchi].speed, maxOp<scalar>());
        if (courant > most_)
        {
            std::ostringstream figures;
            figures.precision(3);
            figures << speed << " m/s and a Courant number of " << courant;
            WarningInFunction
                << "The fluid comes in through the outlet " << Ub.patch().name() << ", at up to "
                << figures.str().c_str() << ". Since " << U.name() << " is zeroGradient there it brings the"
                << " velocity of the cell behind, which can grow without bound and end the run, with or"
                << " without grains. Set " << U.name() << " of " << Ub.patch().name() << " to inletOutlet with"
                << " inletValue uniform (0 0 0), or to pressureInletOutletVelocity, or put the outlet further"
                << " away" << endl;
            return;
        }
    }
}


// ************************************************************************* //
