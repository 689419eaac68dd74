/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "parcelWatch.H"
#include "ops.H"
#include "PstreamReduceOps.H"
#include "releases.H"
#include <unordered_map>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::vector<bool> Foam::parcelWatch::present
(
    const std::vector<int64_t>& keys,
    const particleState& now
)
{
    // Nearly all parcels are none of those asked for: a table of flags tells
    // so without a search
    const uint64_t nFlags = 1 << 16;
    std::vector<bool> flagged(nFlags, false);
    std::unordered_map<int64_t, size_t> index;
    for (size_t i = 0; i < keys.size(); ++i)
    {
        flagged[uint64_t(keys[i]) % nFlags] = true;
        index.emplace(keys[i], i);
    }

    std::vector<bool> found(keys.size(), false);
    for (label i = 0; i < now.size() && !keys.empty(); ++i)
    {
        const int64_t key = now.key(i);
        if (flagged[uint64_t(key) % nFlags])
        {
            const auto iter = index.find(key);
            if (iter != index.end())
            {
                found[iter->second] = true;
            }
        }
    }

    return found;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::particleState Foam::parcelWatch::gone(const particleState& now) const
{
    std::vector<int64_t> keys;
    for (label i = 0; i < watched_.size(); ++i)
    {
        keys.push_back(watched_.key(i));
    }
    const std::vector<bool> here(present(keys, now));

    DynamicList<label> missing;
    for (label i = 0; i < watched_.size(); ++i)
    {
        if (!here[i])
        {
            missing.append(i);
        }
    }

    if (!Pstream::parRun() || !returnReduce(missing.size(), sumOp<label>()))
    {
        return watched_.subset(missing);
    }

    // Ask the other ranks
    List<List<int64_t>> asked(Pstream::nProcs());
    List<int64_t>& mine = asked[Pstream::myProcNo()];
    mine.setSize(missing.size());
    forAll(missing, k)
    {
        mine[k] = watched_.key(missing[k]);
    }
    Pstream::gatherList(asked);
    releases::fromMaster(asked);

    std::vector<int64_t> all;
    label firstMine = 0;
    forAll(asked, proci)
    {
        if (proci == Pstream::myProcNo())
        {
            firstMine = label(all.size());
        }
        all.insert(all.end(), asked[proci].begin(), asked[proci].end());
    }

    const std::vector<bool> found(present(all, now));
    labelList ranksWithIt(label(all.size()));
    forAll(ranksWithIt, i)
    {
        ranksWithIt[i] = found[i];
    }
    Pstream::listCombineGather(ranksWithIt, plusEqOp<label>());
    releases::fromMaster(ranksWithIt);

    DynamicList<label> nowhere;
    forAll(missing, k)
    {
        if (!ranksWithIt[firstMine + k])
        {
            nowhere.append(missing[k]);
        }
    }
    return watched_.subset(nowhere);
}


// ************************************************************************* //
