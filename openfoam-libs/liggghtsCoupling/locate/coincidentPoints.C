/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coincidentPoints.H"
#include "globalIndex.H"
#include "labelIOList.H"
#include "swapLists.H"
#include "syncTools.H"

#include <algorithm>
#include <functional>
#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

// A point as the rank sees it where points meet
struct meetingPoint
{
    point place;
    label number;
    label key;
};

// A point whose key is settled
struct keyedPoint
{
    label key;
    label point;
};

// One line of a group on its way to a member
struct groupLine
{
    label group;
    label rank;
    label point;
};

label meetingRank(const point& p)
{
    std::size_t h = 0;
    for (direction k = 0; k < 3; ++k)
    {
        // Zero of either sign is one place
        h = 31*h + std::hash<scalar>()(p[k] + 0.0);
    }
    return (h ^ (h >> 32))%std::size_t(Pstream::nProcs());
}

bool before(const meetingPoint& a, const meetingPoint& b)
{
    for (direction k = 0; k < 3; ++k)
    {
        if (a.place[k] != b.place[k])
        {
            return a.place[k] < b.place[k];
        }
    }
    return a.number < b.number;
}

} // End anonymous namespace

template<> struct is_contiguous<meetingPoint> : std::true_type {};
template<> struct is_contiguous<keyedPoint> : std::true_type {};
template<> struct is_contiguous<groupLine> : std::true_type {};

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelList Foam::coincidentPoints::undecomposed(const polyMesh& mesh)
{
    const labelIOList numbers
    (
        IOobject
        (
            "pointProcAddressing",
            mesh.facesInstance(),
            mesh.meshSubDir,
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    );
    return numbers.size() == mesh.nPoints() ? labelList(numbers) : labelList();
}


bool Foam::coincidentPoints::mergeKeys
(
    const polyMesh& mesh,
    const labelUList& points,
    const labelUList& numbers,
    labelList& keys
)
{
    List<DynamicList<meetingPoint>> sent(Pstream::nProcs());
    List<DynamicList<label>> sentPoints(Pstream::nProcs());
    for (const label pointi : points)
    {
        const point& p = mesh.points()[pointi];
        const label proci = meetingRank(p);
        sent[proci].append(meetingPoint{p, numbers[pointi], keys[pointi]});
        sentPoints[proci].append(pointi);
    }

    List<DynamicList<meetingPoint>> met(swapLists(sent));
    std::vector<meetingPoint*> all;
    for (DynamicList<meetingPoint>& list : met)
    {
        for (meetingPoint& v : list)
        {
            all.push_back(&v);
        }
    }
    std::sort
    (
        all.begin(), all.end(),
        [](const meetingPoint* a, const meetingPoint* b){ return before(*a, *b); }
    );
    for (auto first = all.begin(); first != all.end();)
    {
        auto last = first;
        label key = labelMax;
        for (; last != all.end() && !before(**first, **last); ++last)
        {
            key = min(key, (*last)->key);
        }
        for (; first != last; ++first)
        {
            (*first)->key = key;
        }
    }

    const List<DynamicList<meetingPoint>> back(swapLists(met));
    bool changed = false;
    forAll(back, proci)
    {
        forAll(back[proci], i)
        {
            label& key = keys[sentPoints[proci][i]];
            changed = changed || key != back[proci][i].key;
            key = back[proci][i].key;
        }
    }
    return returnReduce(changed, orOp<bool>());
}


void Foam::coincidentPoints::collect
(
    const polyMesh& mesh,
    const labelUList& points,
    const labelUList& keys
)
{
    // Points of one key meet on the rank whose point the key is
    const globalIndex index(mesh.nPoints());
    List<DynamicList<keyedPoint>> sent(Pstream::nProcs());
    for (const label pointi : points)
    {
        sent[index.whichProcID(keys[pointi])].append(keyedPoint{keys[pointi], pointi});
    }

    const List<DynamicList<keyedPoint>> met(swapLists(sent));
    std::vector<groupLine> all;
    forAll(met, proci)
    {
        for (const keyedPoint& m : met[proci])
        {
            all.push_back(groupLine{m.key, proci, m.point});
        }
    }
    std::sort
    (
        all.begin(), all.end(),
        [](const groupLine& a, const groupLine& b)
        {
            return
                a.group != b.group ? a.group < b.group
              : a.rank != b.rank ? a.rank < b.rank : a.point < b.point;
        }
    );

    List<DynamicList<groupLine>> replies(Pstream::nProcs());
    for (auto first = all.begin(); first != all.end();)
    {
        auto last = first;
        while (last != all.end() && last->group == first->group)
        {
            ++last;
        }
        if (last - first > 1)
        {
            label told = -1;
            for (auto m = first; m != last; ++m)
            {
                if (m->rank != told)
                {
                    told = m->rank;
                    for (auto line = first; line != last; ++line)
                    {
                        replies[told].append(*line);
                    }
                }
            }
        }
        first = last;
    }

    DynamicList<List<rankPoint>> groups;
    for (const DynamicList<groupLine>& lines : swapLists(replies))
    {
        for (label first = 0, last = 0; first < lines.size(); first = last)
        {
            while (last < lines.size() && lines[last].group == lines[first].group)
            {
                ++last;
            }
            List<rankPoint> group(last - first);
            forAll(group, i)
            {
                group[i] = rankPoint(lines[first + i].rank, lines[first + i].point);
            }
            groups.append(group);
        }
    }
    std::sort
    (
        groups.begin(), groups.end(),
        [](const List<rankPoint>& a, const List<rankPoint>& b){ return a[0] < b[0]; }
    );
    groups_.transfer(groups);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coincidentPoints::coincidentPoints(const polyMesh& mesh, const identity by)
{
    const primitivePatch boundary
    (
        SubList<face>(mesh.faces(), mesh.nBoundaryFaces(), mesh.nInternalFaces()),
        mesh.points()
    );
    const labelList& points = boundary.meshPoints();

    labelList numbers;
    bool known = true;
    if (by == identity::place)
    {
        numbers = labelList(mesh.nPoints(), Zero);
    }
    else
    {
        numbers = undecomposed(mesh);
        known =
            returnReduce(numbers.size() == mesh.nPoints(), andOp<bool>())
         && Pstream::parRun();
    }

    const bool throughPatches =
        by != identity::cut || (Pstream::parRun() && !known);

    // Each point begins with a key of its own; those that are one agree on the smallest
    labelList keys(globalIndex(mesh.nPoints()).toGlobal(Foam::identity(mesh.nPoints())));
    bool changed = true;
    while (changed)
    {
        if (throughPatches)
        {
            syncTools::syncPointList(mesh, keys, minEqOp<label>(), labelMax);
        }
        changed = known && mergeKeys(mesh, points, numbers, keys);
    }
    collect(mesh, points, keys);
}


// ************************************************************************* //
