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
    fields_(nullptr)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::cellSampler::update(const sampledFields& fields)
{
    fields_ = &fields;
}


void Foam::cellSampler::ofCells
(
    const sampledFields& fields,
    const grainBatch& grains,
    grainBatch::lane* lanes
)
{
    for (const sampledFields::field& field : fields.fields)
    {
        grainBatch::lane* to = lanes + field.lane;
        for (label i = 0; i < grainBatch::size; ++i)
        {
            if (field.scalar)
            {
                to[0][i] = (*field.scalar)[grains.cell[i]];
            }
            else
            {
                const vector& v = (*field.vector)[grains.cell[i]];
                for (direction k = 0; k < 3; ++k)
                {
                    to[k][i] = v[k];
                }
            }
        }
    }
}


void Foam::cellSampler::at(const grainBatch& grains, grainBatch::lane* lanes) const
{
    ofCells(*fields_, grains, lanes);
}


// ************************************************************************* //
