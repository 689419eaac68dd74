/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dividedVoidFraction.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(dividedVoidFraction, 0);
    addToRunTimeSelectionTable
    (
        voidFractionModel,
        dividedVoidFraction,
        dictionary
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


Foam::FixedList<Foam::vector, Foam::dividedVoidFraction::nParts> makePoints()
{
    Foam::FixedList<Foam::vector, Foam::dividedVoidFraction::nParts> points;

    Foam::label n = 0;
    points[n++] = Foam::Zero;

    for (const scalar r : {innerShell, outerShell})
    {
        for (Foam::direction k = 0; k < 3; ++k)
        {
            for (const scalar sign : {-1, 1})
            {
                points[n] = Foam::Zero;
                points[n++][k] = sign*r;
            }
        }
        const scalar c = r/Foam::sqrt(scalar(3));
        for (const scalar x : {-c, c})
        {
            for (const scalar y : {-c, c})
            {
                for (const scalar z : {-c, c})
                {
                    points[n++] = Foam::vector(x, y, z);
                }
            }
        }
    }

    return points;
}

// How many of the points of a sphere of radius R lie farther along the unit vector n than
// `distance`, which is not negative. Points come in opposite pairs, one of which lies
// on the near side.
Foam::label nBeyond(const Foam::vector& n, const scalar R, const scalar distance)
{
    const scalar c = 1/Foam::sqrt(scalar(3));
    const scalar along[7] =
    {
        n.x(), n.y(), n.z(),
        c*(n.x() + n.y() + n.z()), c*(n.x() + n.y() - n.z()),
        c*(n.x() - n.y() + n.z()), c*(n.x() - n.y() - n.z())
    };

    Foam::label count = 0;
    for (const scalar a : along)
    {
        const scalar reach = Foam::mag(a)*R;
        count += (innerShell*reach > distance) + (outerShell*reach > distance);
    }
    return count;
}


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


Foam::scalar Foam::dividedVoidFraction::outermost()
{
    return outerShell;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::dividedVoidFraction::shareOverFace
(
    const label number,
    const guestGrain& guest,
    grainShares& shares
) const
{
    const float reach = outerShell*guest.radius;
    const label nLanes = cellLocator::nLanes;

    const cellLocator::faceBlock& here = *locator_.block(guest.cell);
    if (here.nFaces > nLanes)
    {
        return false;
    }
    const cellLocator::lanes inside
    (
        here.distance
        (
            here.relative(locator_.fromCentre(guest.position, here))
        )
    );

    const unsigned reached = inside.atMost(reach);
    if (!isSingle(reached))
    {
        return false;
    }
    const label near = __builtin_ctz(reached);
    if (here.behind[near] < 0)
    {
        return false;
    }
    const label behind = here.behind[near];
    const scalar distance = max(scalar(inside[near]), scalar(0));

    // The sphere must not reach the other faces of the cell behind either
    const cellLocator::faceBlock& there = *locator_.block(behind);
    if (there.nFaces > nLanes)
    {
        return false;
    }
    const cellLocator::lanes beyond
    (
        there.distance
        (
            there.relative(locator_.fromCentre(guest.position, there))
        )
    );
    unsigned shared = 0;
    for (label i = 0; i < nLanes; ++i)
    {
        shared |= unsigned(there.behind[i] == guest.cell) << i;
    }
    if (!isSingle(shared) || (beyond.atMost(reach) & ~shared))
    {
        return false;
    }

    const label n = nBeyond(here.normal(near), guest.radius, distance);
    if (n > 0)
    {
        shares.add(number, guest.cell, scalar(nParts - n)/nParts);
        shares.add(number, behind, scalar(n)/nParts);
    }
    return true;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dividedVoidFraction::share
(
    const label number,
    const guestGrain& guest,
    grainShares& shares
) const
{
    if
    (
        guest.clearance >= outerShell*guest.radius
     || shareOverFace(number, guest, shares)
    )
    {
        return;
    }

    // Only the faces that the sphere may reach decide which points stay
    const cellLocator::faceBlock* faces = locator_.block(guest.cell);
    const vector fromCentre(locator_.fromCentre(guest.position, *faces));
    scalar room[nParts];
    room[0] = 0;
    for (label i = 1; i < nParts; ++i)
    {
        room[i] = VGREAT;
    }
    for (label f = 0, n = faces->nFaces; f < n; f += cellLocator::nLanes, ++faces)
    {
        const cellLocator::lanes distance
        (
            faces->distance(faces->relative(fromCentre))
        );
        for (label lane = 0; lane < cellLocator::nLanes; ++lane)
        {
            if (distance[lane] < outerShell*guest.radius)
            {
                const vector normal(faces->normal(lane));
                for (label i = 1; i < nParts; ++i)
                {
                    room[i] =
                        min(room[i], distance[lane] - guest.radius*(normal & points()[i]));
                }
            }
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
        if (room[i] >= 0)
        {
            count(guest.cell);
            continue;
        }

        const point p = guest.position + guest.radius*points()[i];
        label end;
        const label celli = locator_.walk(p, guest.cell, end).cell;
        if (celli >= 0)
        {
            count(celli);
        }
        else
        {
            shares.addSatellite(number, locator_.wrap(p), 1.0/nParts, end);
        }
    }

    for (label k = 0; k < nCells; ++k)
    {
        shares.add(number, cells[k], scalar(counts[k])/nParts);
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
