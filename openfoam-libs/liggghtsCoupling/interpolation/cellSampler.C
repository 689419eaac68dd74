/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellSampler.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(cellSampler, 0);
    addToRunTimeSelectionTable(fluidSampler, cellSampler, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellSampler::cellSampler(const cellLocator&)
:
    U_(nullptr),
    force_(nullptr),
    voidFraction_(nullptr)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::cellSampler::update
(
    const volVectorField& U,
    const volVectorField& force,
    const volScalarField& voidFraction
)
{
    U_ = &U;
    force_ = &force;
    voidFraction_ = &voidFraction;
}


void Foam::cellSampler::at
(
    const UList<guestGrain>& grains,
    sample* fluid
) const
{
    forAll(grains, i)
    {
        const label celli = grains[i].cell;
        fluid[i] = sample{(*U_)[celli], (*force_)[celli], (*voidFraction_)[celli]};
    }
}


// ************************************************************************* //
