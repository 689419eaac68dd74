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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::implicitMomentum::implicitMomentum(const carrierFluid& fluid)
:
    grainMomentum(fluid),
    wanted_(fluid.mesh().nCells(), Zero),
    owed_(fluid.mesh().nCells(), Zero),
    slope_(fluid.mesh().nCells(), Zero),
    U0_(fluid.mesh().nCells(), Zero),
    dt_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::implicitMomentum::close()
{
    const vectorField& U = fluid_.U();

    owed_ = slope_*(U - U0_)*dt_;

    return sum(wanted_) - sum(owed_);
}


Foam::vector Foam::implicitMomentum::owed() const
{
    return sum(owed_);
}


void Foam::implicitMomentum::set
(
    const vectorField& impulse,
    const scalarField& slope,
    const scalar dt
)
{
    wanted_ = owed_ - impulse;
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


// ************************************************************************* //
