/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "implicitMomentum.H"
#include "addToRunTimeSelectionTable.H"
#include "fvMatrices.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(implicitMomentum, 0);
    addToRunTimeSelectionTable(grainMomentum, implicitMomentum, dictionary);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::vectorField> Foam::implicitMomentum::missing() const
{
    return slope_*(fluid_.U().primitiveField() - U0_)*dt_;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::implicitMomentum::implicitMomentum(const carrierFluid& fluid)
:
    grainMomentum(fluid),
    used_(false),
    wanted_(fluid.mesh().nCells(), Zero),
    owed_
    (
        IOobject
        (
            "particleMomentumOwed",
            fluid.mesh().time().timeName(),
            fluid.mesh(),
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE
        ),
        fluid.mesh(),
        dimensionedVector(dimForce*dimTime, Zero)
    ),
    slope_(fluid.mesh().nCells(), Zero),
    U0_(fluid.mesh().nCells(), Zero),
    dt_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::implicitMomentum::close()
{
    if (!used_)
    {
        return Zero;
    }

    owed_.field() = missing();

    return sum(wanted_) - sum(owed_.field());
}


Foam::vector Foam::implicitMomentum::owed() const
{
    return sum(owed_.field());
}


void Foam::implicitMomentum::set
(
    const vectorField& impulse,
    const scalarField& slope,
    const scalar dt
)
{
    used_ = true;
    wanted_ = owed_.field() - impulse;
    slope_ = slope;
    U0_ = fluid_.U().primitiveField();
    dt_ = dt;
}


void Foam::implicitMomentum::addSup(fvMatrix<vector>& eqn) const
{
    // fvMatrix keeps (diagonal)*U = source, integrated over cells
    eqn.diag() -= slope_/fluid_.rho();
    eqn.source() -= (wanted_/dt_ + slope_*U0_)/fluid_.rho();
}


void Foam::implicitMomentum::write() const
{
    volVectorField::Internal owed
    (
        IOobject
        (
            owed_.name(),
            fluid_.mesh().time().timeName(),
            fluid_.mesh(),
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        owed_
    );
    if (used_)
    {
        owed.field() = missing();
    }
    owed.write();
}


// ************************************************************************* //
