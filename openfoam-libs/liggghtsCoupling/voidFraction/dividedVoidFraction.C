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


Foam::FixedList<Foam::vector, Foam::dividedVoidFraction::nParts> makePoints()
{
    Foam::FixedList<Foam::vector, Foam::dividedVoidFraction::nParts> points;

    Foam::label n = 0;
    points[n++] = Foam::Zero;

    for (const scalar r : {shellRadius(1, 15), shellRadius(15, 29)})
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
    static const scalar r = shellRadius(15, 29);
    return r;
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

void Foam::dividedVoidFraction::share
(
    const label number,
    const guestGrain& guest,
    grainShares& shares
) const
{
    if (guest.clearance >= outermost()*guest.radius)
    {
        shares.add(number, guest.cell, 1);
        return;
    }

    // Only the faces that the sphere may reach decide which points stay
    const UList<cellLocator::facePlane> planes(locator_.planes(guest.cell));
    scalar room[nParts];
    room[0] = 0;
    for (label i = 1; i < nParts; ++i)
    {
        room[i] = VGREAT;
    }
    for (const cellLocator::facePlane& plane : planes)
    {
        const scalar distance = plane.d - (plane.n & guest.position);
        if (distance < outermost()*guest.radius)
        {
            for (label i = 1; i < nParts; ++i)
            {
                room[i] = min
                (
                    room[i],
                    distance - guest.radius*(plane.n & points()[i])
                );
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
        if (room[i] >= -locator_.tolerance())
        {
            count(guest.cell);
            continue;
        }

        const point p = guest.position + guest.radius*points()[i];
        const label celli = locator_.walk(p, guest.cell).cell;
        if (celli >= 0)
        {
            count(celli);
        }
        else
        {
            shares.addSatellite(number, locator_.wrap(p), 1.0/nParts);
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
