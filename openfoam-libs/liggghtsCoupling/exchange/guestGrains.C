/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "guestGrains.H"

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
