/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dividedVoidFraction.H"
#include "addToRunTimeSelectionTable.H"

#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(dividedVoidFraction, 0);
    addToRunTimeSelectionTable(voidFractionModel, dividedVoidFraction, dictionary);
    const knownEntries::ofModel dividedEntries
    (
        voidFractionModel::typeName_(), dividedVoidFraction::typeName_()
    );
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::scalar;

// Mean radius of the shell that holds the parts from `begin` to `end` of 29
scalar shellRadius(const scalar begin, const scalar end)
{
    const scalar n = Foam::dividedVoidFraction::nParts;
    const scalar a = Foam::cbrt(begin/n);
    const scalar b = Foam::cbrt(end/n);
    return 0.75*(Foam::pow4(b) - Foam::pow4(a))/(Foam::pow3(b) - Foam::pow3(a));
}

const scalar innerShell = shellRadius(1, 15);
const scalar outerShell = shellRadius(15, 29);


// A point nearer than this to a plane, relative to the distances that tell so, may lie on the
// face: its cell is looked up. Single precision is good to 3e-7, and within 1e-6 is on a face
const scalar onPlane = 2e-6;


// With a margin of r below this a cell's faces are as good as flat
const float flatMargin = 1e-4f;


const Foam::label nDirections = 7;

// Half of the directions of a shell's points; the others are opposite to them
const Foam::vector* directions()
{
    static const scalar c = 1/Foam::sqrt(scalar(3));
    static const Foam::vector all[nDirections] =
    {
        {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {c, c, c}, {c, c, -c}, {c, -c, c}, {c, -c, -c}
    };
    return all;
}


// The centre, then pairs of opposite points, shell by shell
Foam::FixedList<Foam::vector, Foam::dividedVoidFraction::nParts> makePoints()
{
    Foam::FixedList<Foam::vector, Foam::dividedVoidFraction::nParts> points;

    Foam::label n = 0;
    points[n++] = Foam::Zero;
    for (const scalar r : {innerShell, outerShell})
    {
        for (Foam::label k = 0; k < nDirections; ++k)
        {
            points[n++] = r*directions()[k];
            points[n++] = -r*directions()[k];
        }
    }

    return points;
}


// A sphere of radius R along a unit vector
struct reach
{
    // How far along it the points of a shell of radius R would lie; their opposites are as
    // far on the other side
    scalar along[nDirections];

    reach(const Foam::vector& n, const scalar R)
    {
        const scalar c = R/Foam::sqrt(scalar(3));
        along[0] = R*n.x();
        along[1] = R*n.y();
        along[2] = R*n.z();
        along[3] = c*(n.x() + n.y() + n.z());
        along[4] = c*(n.x() + n.y() - n.z());
        along[5] = c*(n.x() - n.y() + n.z());
        along[6] = c*(n.x() - n.y() - n.z());
    }

    // How many of its points lie farther than `distance`, which is not negative: of a pair
    // at most one. -1 if one of them lies there but for `uncertain`
    Foam::label nBeyond(const scalar distance, const scalar uncertain) const
    {
        Foam::label count = 0;
        Foam::label near = 0;
        for (const scalar a : along)
        {
            const scalar inner = innerShell*Foam::mag(a) - distance;
            const scalar outer = outerShell*Foam::mag(a) - distance;
            count += (inner > uncertain) + (outer > uncertain);
            near += (inner >= -uncertain) + (outer >= -uncertain);
        }
        return near == count ? count : -1;
    }
};


// Is one bit set, and no other?
bool isSingle(const unsigned bits)
{
    return bits && !(bits & (bits - 1));
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

const Foam::FixedList<Foam::vector, Foam::dividedVoidFraction::nParts>&
Foam::dividedVoidFraction::points()
{
    static const FixedList<vector, nParts> points(makePoints());
    return points;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::dividedVoidFraction::shareOverFace
(
    const label number,
    const grainData& grain,
    grainShares& shares
) const
{
    const float outermost = outerShell*grain.radius;
    const label nLanes = cellLocator::nLanes;

    const cellLocator::faceBlock& here = *locator_.block(grain.cell);
    if (here.nFaces > nLanes)
    {
        return false;
    }
    const vector fromCentre(locator_.fromCentre(grain.position, here));
    const cellLocator::lanes relative(here.relative(fromCentre));

    const unsigned reached = here.sureDistance(relative).atMost(outermost);
    if (!isSingle(reached))
    {
        return false;
    }
    const label near = __builtin_ctz(reached);
    const label behind = here.behind[near];
    if (behind == -1)
    {
        return false;
    }
    const scalar distance = max(scalar(here.distance(relative)[near]), scalar(0));

    // The sphere must not reach the other faces of the cell behind either
    const cellLocator::faceBlock& there =
        behind >= 0 ? *locator_.block(behind) : locator_.remoteBlock(behind);
    if (there.nFaces > nLanes)
    {
        return false;
    }
    const cellLocator::lanes beyond
    (
        there.sureDistance
        (
            there.relative(locator_.fromCentre(grain.position, there))
        )
    );
    unsigned shared = 0;
    for (label i = 0; i < nLanes; ++i)
    {
        shared |= unsigned(there.behind[i] == grain.cell) << i;
    }
    if (!isSingle(shared) || (beyond.atMost(outermost) & ~shared))
    {
        return false;
    }

    const label n = reach(here.normal(near), grain.radius).nBeyond
    (
        distance,
        onPlane*(cmptSum(cmptMag(fromCentre)) + here.h[near] + grain.radius)
      + max
        (
            here.rMargin()*here.h[near],
            there.rMargin()*there.h[__builtin_ctz(shared)]
        )
    );
    if (n > 0)
    {
        shares.add(number, grain.cell, scalar(nParts - n)/nParts);
        if (behind >= 0)
        {
            shares.add(number, behind, scalar(n)/nParts);
        }
        else
        {
            shares.addRemote(number, locator_.remote(behind), scalar(n)/nParts);
        }
    }
    return n >= 0;
}


void Foam::dividedVoidFraction::sharePoints
(
    const label number,
    const grainData& grain,
    grainShares& shares
) const
{
    // Only the faces that the sphere may reach decide which points stay: those on the side of the
    // centre. Of each point the distance from the nearest face, and what is behind that
    scalar room[nParts];
    label behind[nParts];
    std::fill(room, room + nParts, VGREAT);
    std::fill(behind, behind + nParts, -1);

    const cellLocator::faceBlock* faces = locator_.block(grain.cell);
    const vector fromCentre(locator_.fromCentre(grain.position, *faces));
    const scalar uncertain =
        2*onPlane*(cmptSum(cmptMag(fromCentre)) + grain.radius);
    const auto side = [&](const scalar distance, const vector& outward, const label next)
    {
        const reach towards(outward, grain.radius);
        label i = 1;
        for (const scalar shell : {innerShell, outerShell})
        {
            for (const scalar along : towards.along)
            {
                for (const scalar far : {shell*along, -shell*along})
                {
                    if (distance - far < room[i])
                    {
                        room[i] = distance - far;
                        behind[i] = next;
                    }
                    ++i;
                }
            }
        }
    };

    const bool flat = faces->rMargin() < flatMargin;
    for (label f = 0, n = faces->nFaces; f < n; f += cellLocator::nLanes, ++faces)
    {
        const cellLocator::lanes distance
        (
            faces->sureDistance(faces->relative(fromCentre))
        );
        unsigned reached = distance.atMost(outerShell*grain.radius);
        for (; reached; reached &= reached - 1)
        {
            const label lane = __builtin_ctz(reached);
            const label next = faces->behind[lane];
            if (flat)
            {
                side(distance[lane], faces->normal(lane), next);
                continue;
            }

            // Which side of a warped face a point lies on tell its triangles
            locator_.tets().triangles
            (
                grain.cell,
                locator_.mesh().cells()[grain.cell][f + lane],
                [&](const label a, const label b, const label c)
                {
                    const pointField& points = locator_.mesh().points();
                    vector normal
                    (
                        (points[b] - points[a]) ^ (points[c] - points[a])
                    );
                    normal /= mag(normal) + VSMALL;
                    const scalar beyond =
                        normal & (grain.position - points[a]);
                    if (beyond < uncertain && beyond > -outerShell*grain.radius - uncertain)
                    {
                        side(max(-beyond, scalar(0)), normal, next);
                    }
                    if (beyond > -uncertain && beyond < outerShell*grain.radius + uncertain)
                    {
                        side(max(beyond, scalar(0)), -normal, next);
                    }
                }
            );
        }
    }

    // Parts in the same cell make one share
    label cells[nParts];
    label counts[nParts];
    label nCells = 0;
    const auto count = [&](const label celli)
    {
        label k = 0;
        while (k < nCells && cells[k] != celli)
        {
            ++k;
        }
        if (k == nCells)
        {
            cells[nCells] = celli;
            counts[nCells++] = 0;
        }
        ++counts[k];
    };

    for (label i = 0; i < nParts; ++i)
    {
        if (room[i] > uncertain)
        {
            count(grain.cell);
            continue;
        }

        const point p = grain.position + grain.radius*points()[i];
        const label start = (behind[i] >= 0 ? behind[i] : grain.cell);
        label end;
        const label celli = locator_.walk(p, start, end).cell;
        if (celli >= 0)
        {
            count(celli);
        }
        else
        {
            shares.addRemotePart(number, locator_.wrap(p), 1.0/nParts, end);
        }
    }

    for (label k = 0; k < nCells; ++k)
    {
        shares.add(number, cells[k], scalar(counts[k])/nParts);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dividedVoidFraction::share
(
    const label first,
    const UList<grainData>& grains,
    grainShares& shares
) const
{
    forAll(grains, i)
    {
        const grainData& grain = grains[i];
        if
        (
            grain.clearance < outerShell*grain.radius
         && !shareOverFace(first + i, grain, shares)
        )
        {
            sharePoints(first + i, grain, shares);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dividedVoidFraction::dividedVoidFraction
(
    const dictionary& dict,
    const cellLocator& locator
)
:
    voidFractionModel(dict, locator)
{}


// ************************************************************************* //
