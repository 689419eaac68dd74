/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "particleTracker.H"
#include "PstreamBuffers.H"
#include "bitSet.H"
#include "ops.H"
#include <unordered_map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// Parcels mostly keep their order in the list; this many removed in a row are
// skipped before the search by identity
static const label lookAhead = 8;

// The rank on which those who miss a parcel and those who have it meet
static label meetingRank(const int64_t key)
{
    // Fibonacci hashing: neighbouring numbers go to different ranks
    const uint64_t mixed = uint64_t(key)*0x9E3779B97F4A7C15ull;
    return label((mixed >> 33) % uint64_t(Pstream::nProcs()));
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::particleTracker::matchHere
(
    const particleState& now,
    List<point>& start,
    DynamicList<label>& newcomers,
    DynamicList<label>& missing
) const
{
    const label nBefore = before_.size();
    bitSet found(nBefore);
    DynamicList<label> unknown;

    label next = 0;
    forAll(now.position, i)
    {
        const int64_t key = now.key(i);
        const label last = min(next + lookAhead + 1, nBefore);

        label candidate = next;
        while (candidate < last && before_.key(candidate) != key)
        {
            ++candidate;
        }

        if (candidate < last)
        {
            start[i] = before_.position[candidate];
            found.set(candidate);
            next = candidate + 1;
        }
        else
        {
            unknown.append(i);
        }
    }

    std::unordered_map<int64_t, label> rest;
    for (label j = 0; j < nBefore; ++j)
    {
        if (!found.test(j))
        {
            rest.emplace(before_.key(j), j);
        }
    }

    for (const label i : unknown)
    {
        const auto iter = rest.find(now.key(i));
        if (iter == rest.end())
        {
            newcomers.append(i);
        }
        else
        {
            start[i] = before_.position[iter->second];
            rest.erase(iter);
        }
    }

    for (const auto& entry : rest)
    {
        missing.append(entry.second);
    }
}


Foam::particleState Foam::particleTracker::matchElsewhere
(
    const particleState& now,
    List<point>& start,
    DynamicList<label>& newcomers,
    const particleState& missing
) const
{
    const label nProcs = Pstream::nProcs();

    // Both lists go to the meeting ranks
    List<DynamicList<label>> missingFor(nProcs);
    forAll(missing.position, j)
    {
        missingFor[meetingRank(missing.key(j))].append(j);
    }
    List<DynamicList<label>> newcomersFor(nProcs);
    for (const label i : newcomers)
    {
        newcomersFor[meetingRank(now.key(i))].append(i);
    }

    PstreamBuffers questions(Pstream::commsTypes::nonBlocking);
    for (label proci = 0; proci < nProcs; ++proci)
    {
        if (missingFor[proci].size() || newcomersFor[proci].size())
        {
            List<int64_t> keys(newcomersFor[proci].size());
            forAll(keys, k)
            {
                keys[k] = now.key(newcomersFor[proci][k]);
            }

            UOPstream os(proci, questions);
            os  << missing.subset(missingFor[proci]) << keys;
        }
    }
    labelList received;
    questions.finishedSends(received);

    particleState met;
    List<List<int64_t>> asked(nProcs);
    for (label proci = 0; proci < nProcs; ++proci)
    {
        if (received[proci])
        {
            UIPstream is(proci, questions);
            particleState part;
            is  >> part >> asked[proci];
            met.append(part);
        }
    }

    std::unordered_map<int64_t, label> index;
    forAll(met.position, j)
    {
        index.emplace(met.key(j), j);
    }

    // The answers: for each question whether it was found, and where it was
    PstreamBuffers answers(Pstream::commsTypes::nonBlocking);
    for (label proci = 0; proci < nProcs; ++proci)
    {
        if (asked[proci].empty())
        {
            continue;
        }

        boolList known;
        known.setSize(asked[proci].size(), false);
        DynamicList<point> places;
        forAll(known, k)
        {
            const auto iter = index.find(asked[proci][k]);
            if (iter != index.end())
            {
                known[k] = true;
                places.append(met.position[iter->second]);
                index.erase(iter);
            }
        }

        UOPstream os(proci, answers);
        os  << known << places;
    }
    answers.finishedSends();

    newcomers.clear();
    for (label proci = 0; proci < nProcs; ++proci)
    {
        if (newcomersFor[proci].empty())
        {
            continue;
        }

        UIPstream is(proci, answers);
        boolList known(is);
        List<point> places(is);

        label n = 0;
        forAll(known, k)
        {
            const label i = newcomersFor[proci][k];
            if (known[k])
            {
                start[i] = places[n++];
            }
            else
            {
                newcomers.append(i);
            }
        }
    }

    DynamicList<label> gone;
    for (const auto& entry : index)
    {
        gone.append(entry.second);
    }
    return met.subset(gone);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::particleTracker::remember(const particleState& now)
{
    before_ = now;
}


Foam::List<Foam::point> Foam::particleTracker::startPoints
(
    particleState& now,
    const UList<scalar>& age,
    const scalar deltaT,
    const boundBox& bounds
)
{
    List<point> start(now.size());
    DynamicList<label> newcomers;
    DynamicList<label> missing;
    matchHere(now, start, newcomers, missing);

    particleState gone = before_.subset(missing);
    if (returnReduce(newcomers.size() + missing.size(), sumOp<label>()))
    {
        if (Pstream::parRun())
        {
            gone = matchElsewhere(now, start, newcomers, gone);
        }
    }

    for (const label i : newcomers)
    {
        // The injection models of OpenFOAM move a new parcel to the end of the
        // step of its injection and then by a whole step with all others
        const bool cameIn = age.size() && age[i] < 2*deltaT*(1 + 1e-6);
        start[i] = now.position[i] - (cameIn ? age[i] : 0)*now.U[i];
    }

    before_ = now;

    start.append(gone.position);
    gone.flyOn(deltaT, bounds);
    now.append(gone);

    return start;
}


// ************************************************************************* //
