/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "probedMesh.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::List<Foam::FixedList<Foam::scalar, 4>> Foam::probedMesh::sample
(
    const UList<point>& points,
    const UList<cellLocator::place>& places
) const
{
    dictionary cellPoint;
    cellPoint.add("interpolation", "cellPoint");
    autoPtr<fluidSampler> sampler(fluidSampler::New(cellPoint, locator_));
    sampledFields fields;
    fields.fields =
        List<sampledFields::field>
        ({
            sampledFields::field{&p_, nullptr, 0}, sampledFields::field{nullptr, &U_, 1}
        });
    fields.nLanes = 4;
    sampler->update(fields);

    List<FixedList<scalar, 4>> values(points.size(), FixedList<scalar, 4>(Zero));
    grainBatch batch(labelList({0, 1, 4}), labelList({0}));
    labelList numbers(grainBatch::size);
    const auto flush = [&]()
    {
        for (label i = batch.n; batch.n && i < grainBatch::size; ++i)
        {
            for (direction k = 0; k < 3; ++k)
            {
                batch.position[k][i] = batch.position[k][batch.n - 1];
            }
            batch.cell[i] = batch.cell[batch.n - 1];
            batch.pyramid[i] = batch.pyramid[batch.n - 1];
        }
        if (batch.n)
        {
            sampler->at(batch, batch.fluidLanes());
        }
        for (label i = 0; i < batch.n; ++i)
        {
            for (label k = 0; k < 4; ++k)
            {
                values[numbers[i]][k] = batch.fluidLanes()[k][i];
            }
        }
        batch.n = 0;
    };
    forAll(points, i)
    {
        if (places[i].cell < 0)
        {
            continue;
        }
        for (direction k = 0; k < 3; ++k)
        {
            batch.position[k][batch.n] = points[i][k];
        }
        batch.cell[batch.n] = places[i].cell;
        batch.pyramid[batch.n] = places[i].pyramid;
        numbers[batch.n++] = i;
        if (batch.n == grainBatch::size)
        {
            flush();
        }
    }
    flush();
    return values;
}


// ************************************************************************* //
