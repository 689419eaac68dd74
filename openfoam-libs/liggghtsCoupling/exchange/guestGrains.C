/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "guestGrains.H"
#include "Pair.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

// What a host answers to a traveller
struct answer
{
    fluidAction action;
    label rank;
    label guest;
};

} // End anonymous namespace

template<> struct is_contiguous<answer> : std::true_type {};

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::guestGrains::guestGrains
(
    const liggghtsSession& session,
    const cellLocator& locator,
    const List<boundBox>& boxes
)
:
    session_(session),
    locator_(locator),
    route_(boxes),
    grains_(),
    door_(),
    outside_(0),
    left_(0),
    impulseBytes_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::guestGrains::forget()
{
    const label n = session_.grains().n;
    const liggghtsSession::fluidArrays door = session_.fluidForces();

    for (label atom = 0; atom < n; ++atom)
    {
        door.host[atom][0] = door.host[atom][1] = -1;
    }
}


void Foam::guestGrains::recall()
{
    const liggghtsSession::grainArrays grains = session_.grains();
    const liggghtsSession::fluidArrays door = session_.fluidForces();

    // Positions and beginnings of way change places while cells are looked for
    List<Pair<vector>> ways(grains.n);
    boolList guest(grains.n);
    forAll(ways, atom)
    {
        double* now = grains.position[atom];
        const double* then = door.startPosition[atom];
        ways[atom].first() = vector(now[0], now[1], now[2]);
        ways[atom].second() = vector(then[0], then[1], then[2]);
        guest[atom] = door.host[atom][0] >= 0 && door.host[atom][1] >= 0;
        if (guest[atom])
        {
            std::copy_n(then, 3, now);
        }
    }

    forget();
    locate([](const label, const UList<guestGrain>&){});
    for (label g = 0; g < size(); ++g)
    {
        give(g, fluidAction{Zero, 0, Zero});
    }
    send();

    forAll(ways, atom)
    {
        std::copy_n(ways[atom].first().cdata(), 3, grains.position[atom]);
        std::copy_n(ways[atom].second().cdata(), 3, door.startPosition[atom]);
        if (!guest[atom])
        {
            door.host[atom][0] = door.host[atom][1] = -1;
        }
    }
}


void Foam::guestGrains::send()
{
    route_.back<answer>
    (
        [&](const label g)
        {
            return answer
            {
                visitorActions_[-1 - source_[g]], Pstream::myProcNo(), g
            };
        },
        [&](const label item, const answer& a)
        {
            hand(travellers_[item], a.action, a.rank, a.guest);
        }
    );

    // One that has just left the mesh still gets the second half of its last kick: its
    // former host will book it. Numbers from -2 downwards mean a former guest
    for (const label atom : homeless_)
    {
        const label rank = label(door_.host[atom][0]);
        const label number = label(door_.host[atom][1]);
        const bool leaving = (rank >= 0 && number >= 0);

        hand
        (
            atom,
            fluidAction{Zero, 0, Zero},
            leaving ? rank : -1,
            leaving ? -2 - number : -1
        );
    }
}


// ************************************************************************* //
