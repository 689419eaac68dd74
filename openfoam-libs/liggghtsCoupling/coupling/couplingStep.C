/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "couplingStep.H"
#include "PstreamReduceOps.H"

#include <functional>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// In front those of which the largest one counts, then those that are added up
const Foam::label nLargest = 4;
const Foam::label nSums = 19;
const Foam::label nVectors = 4;

typedef Foam::FixedList<Foam::scalar, nLargest + nSums + 3*nVectors> figures;

struct combine
{
    figures operator()(const figures& a, const figures& b) const
    {
        figures result(a);
        forAll(result, i)
        {
            result[i] = i < nLargest ? Foam::max(a[i], b[i]) : a[i] + b[i];
        }
        return result;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::couplingStep::reduce()
{
    // Counters as scalars, which hold whole numbers up to 9e15
    scalar leftBox = grains.leftBox;
    scalar deleted = grains.deleted;
    scalar remote = grains.remote;
    scalar outsideMesh = grains.outsideMesh;
    mostGrains = max(scalar(grains.owned), counts.present);
    scalar allSearches = searches;
    scalar allBytes = bytes;

    scalar* const scalars[nLargest + nSums] =
    {
        &cells.maxSolidFraction, &outletCourant, &stiffness, &mostGrains,

        &counts.present, &leftBox, &deleted, &remote, &outsideMesh, &allSearches, &allBytes,
        &slipSum, &slips, &change, &changeWeight, &cells.volumeCut, &fluidVolume,
        &received.work, &received.heat, &energyToFluid, &energyOwed, &gasMass, &warnings
    };
    vector* const vectors[nVectors] = {&received.reacting, &received.nonReacting, &toFluid, &owed};

    figures all;
    const auto forEach = [&](const std::function<void(scalar&, scalar&)>& copy)
    {
        label place = 0;
        for (scalar* value : scalars)
        {
            copy(*value, all[place++]);
        }
        for (vector* value : vectors)
        {
            for (direction k = 0; k < 3; ++k)
            {
                copy((*value)[k], all[place++]);
            }
        }
    };
    forEach([](scalar& own, scalar& place){ place = own; });
    Foam::reduce(all, combine());
    forEach([](scalar& own, scalar& place){ own = place; });

    grains.leftBox = leftBox;
    grains.deleted = deleted;
    grains.remote = remote;
    grains.outsideMesh = outsideMesh;
    searches = allSearches;
    bytes = allBytes;
}


// ************************************************************************* //
