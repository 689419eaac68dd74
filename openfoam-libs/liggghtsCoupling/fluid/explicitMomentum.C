/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "explicitMomentum.H"
#include "addToRunTimeSelectionTable.H"
#include "fvMatrices.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(explicitMomentum, 0);
    addToRunTimeSelectionTable(grainMomentum, explicitMomentum, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::explicitMomentum::explicitMomentum(const carrierFluid& fluid)
:
    grainMomentum(fluid),
    dt_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::explicitMomentum::close(const vectorField&)
{
    return sum(wanted_);
}


Foam::vector Foam::explicitMomentum::owed() const
{
    return Zero;
}


void Foam::explicitMomentum::set
(
    const labelUList& cells,
    const vectorField& impulse,
    const scalarField&,
    const scalarField&,
    const stressList&,
    const scalar dt
)
{
    cells_ = cells;
    wanted_ = -impulse;
    dt_ = dt;
}


void Foam::explicitMomentum::addSup(fvMatrix<vector>& eqn) const
{
    // fvMatrix keeps (diagonal)*U = source, integrated over cells
    vectorField& source = eqn.source();
    forAll(cells_, i)
    {
        source[cells_[i]] -= wanted_[i]/(dt_*fluid_.equationDensity(cells_[i]));
    }
}


// ************************************************************************* //
