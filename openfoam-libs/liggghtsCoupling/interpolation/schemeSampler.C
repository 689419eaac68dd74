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

void Foam::schemeSampler::update(const sampledFields& fields)
{
    label nScalars = 0;
    label nVectors = 0;
    for (const sampledFields::field& field : fields.fields)
    {
        label& i = (field.scalar ? nScalars : nVectors);
        if (!fields.newFluid && !field.withGrains)
        {
            ++i;
            continue;
        }
        if (field.scalar)
        {
            scalarLane_(i) = field.lane;
            scalars_.resize(max(i + 1, scalars_.size()));
            scalars_.set(i, interpolation<scalar>::New(scheme_, *field.scalar));
        }
        else
        {
            vectorLane_(i) = field.lane;
            vectors_.resize(max(i + 1, vectors_.size()));
            vectors_.set(i, interpolation<vector>::New(scheme_, *field.vector));
        }
        ++i;
    }
}


void Foam::schemeSampler::at(const grainBatch& grains, grainBatch::lane* lanes) const
{
    for (label i = 0; i < grains.n; ++i)
    {
        const point p
        (
            grains.position[0][i], grains.position[1][i], grains.position[2][i]
        );
        const label celli = grains.cell[i];
        forAll(scalars_, f)
        {
            lanes[scalarLane_[f]][i] = scalars_[f].interpolate(p, celli);
        }
        forAll(vectors_, f)
        {
            const vector v(vectors_[f].interpolate(p, celli));
            for (direction k = 0; k < 3; ++k)
            {
                lanes[vectorLane_[f] + k][i] = v[k];
            }
        }
    }

    // The rest of the batch repeats the last grain
    for (const labelUList* first : {&scalarLane_, &vectorLane_})
    {
        const label width = (first == &scalarLane_ ? 1 : 3);
        for (const label lane : *first)
        {
            for (label k = 0; k < width; ++k)
            {
                for (label i = grains.n; i < grainBatch::size; ++i)
                {
                    lanes[lane + k][i] = lanes[lane + k][grains.n - 1];
                }
            }
        }
    }
}


// ************************************************************************* //
