/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coupledPoints.H"
#include "globalMeshData.H"
#include "mapDistribute.H"
#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

// A point of a rank
typedef labelPair rankPoint;
typedef List<rankPoint> group;

// How OpenFOAM combines the points that are one: here in one list
struct appendGroup
{
    void operator()(group& all, const group& others) const
    {
        all.append(others);
    }
};

// Which points these are does not change on the way through a periodic side
struct keepGroup
{
    template<class List>
    void operator()(const vectorTensorTransform&, const bool, List&) const
    {}
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupledPoints::coupledPoints(const polyMesh& mesh)
:
    members_(),
    firstMember_(),
    nPoints_(mesh.nPoints()),
    needed_(Pstream::nProcs()),
    nArriving_(Pstream::nProcs(), Zero)
{
    const label me = Pstream::myProcNo();
    const globalMeshData& data = mesh.globalData();
    const labelList& points = data.coupledPatch().meshPoints();

    List<group> groups(points.size());
    forAll(points, i)
    {
        groups[i] = group(1, rankPoint(me, points[i]));
    }
    globalMeshData::syncData
    (
        groups,
        data.globalPointSlaves(),
        data.globalPointTransformedSlaves(),
        data.globalPointSlavesMap(),
        data.globalTransforms(),
        appendGroup(),
        keepGroup()
    );

    // Each group once, by its first point of this rank, and in the same order on all ranks: that
    // of the first point of all
    DynamicList<label> once;
    forAll(points, i)
    {
        const auto mine = std::find_if
        (
            groups[i].begin(), groups[i].end(),
            [&](const rankPoint& p){ return p.first() == me; }
        );
        if (groups[i].size() > 1 && mine->second() == points[i])
        {
            once.append(i);
        }
    }
    std::sort
    (
        once.begin(), once.end(),
        [&](const label a, const label b){ return groups[a][0] < groups[b][0]; }
    );

    // Where values from a rank begin is known once all of them are counted
    DynamicList<rankPoint> arriving;
    for (const label i : once)
    {
        firstMember_.append(members_.size());
        for (const rankPoint& p : groups[i])
        {
            if (p.first() == me)
            {
                members_.append(p.second());
            }
            else
            {
                arriving.append(rankPoint(p.first(), members_.size()));
                members_.append(nArriving_[p.first()]++);
            }
        }
        DynamicList<label> ranks;
        for (const rankPoint& p : groups[i])
        {
            if (p.first() != me && !ranks.found(p.first()))
            {
                ranks.append(p.first());
                for (const rankPoint& q : groups[i])
                {
                    if (q.first() == me)
                    {
                        needed_[p.first()].append(q.second());
                    }
                }
            }
        }
    }
    firstMember_.append(members_.size());

    labelList start(Pstream::nProcs(), nPoints_);
    for (label proci = 1; proci < Pstream::nProcs(); ++proci)
    {
        start[proci] = start[proci - 1] + nArriving_[proci - 1];
    }
    for (const rankPoint& a : arriving)
    {
        members_[a.second()] += start[a.first()];
    }
}


// ************************************************************************* //
