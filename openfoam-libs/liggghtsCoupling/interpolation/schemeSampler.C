/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "schemeSampler.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(schemeSampler, 0);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::schemeSampler::schemeSampler(const word& scheme)
:
    scheme_(scheme)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::schemeSampler::update
(
    const volVectorField& U,
    const volVectorField& force,
    const volScalarField& voidFraction
)
{
    U_ = interpolation<vector>::New(scheme_, U);
    force_ = interpolation<vector>::New(scheme_, force);
    voidFraction_ = interpolation<scalar>::New(scheme_, voidFraction);
}


void Foam::schemeSampler::at
(
    const UList<guestGrain>& grains,
    sample* fluid
) const
{
    forAll(grains, i)
    {
        const guestGrain& grain = grains[i];
        fluid[i] = sample
        {
            U_->interpolate(grain.position, grain.cell),
            force_->interpolate(grain.position, grain.cell),
            voidFraction_->interpolate(grain.position, grain.cell)
        };
    }
}


// ************************************************************************* //
