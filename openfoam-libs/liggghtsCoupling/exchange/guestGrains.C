/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "guestGrains.H"
#include "PstreamReduceOps.H"
#include "fluid-force/fluid_force_exchange.h"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::vector toVector(const double* v)
{
    return Foam::vector(v[0], v[1], v[2]);
}

// An impulse on its way to the guest that it belongs to
struct parcel
{
    Foam::label guest;
    Foam::vector impulse;
};

// What a host answers to a traveller
struct answer
{
    Foam::fluidAction action;
    Foam::label rank;
    Foam::label guest;
};

} // End anonymous namespace

namespace Foam
{
    template<> struct is_contiguous<parcel> : std::true_type {};
    template<> struct is_contiguous<answer> : std::true_type {};
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::guestGrain Foam::guestGrains::asGuest
(
    const liggghtsSession::grainArrays& grains,
    const label atom
) const
{
    guestGrain guest;
    guest.position = locator_.wrap(toVector(grains.position[atom]));
    guest.velocity = toVector(grains.velocity[atom]);
    guest.radius = grains.radius[atom];
    guest.mass = grains.mass[atom];
    guest.cg = session_.coarseGraining(grains.type[atom]);
    guest.clearance = 0;
    guest.cell = -1;
    guest.pyramid = -1;
    return guest;
}


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
    outside_(0),
    travelling_(0),
    impulseBytes_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::guestGrains::locate()
{
    const liggghtsSession::grainArrays grains = session_.grains();
    const LAMMPS_NS::FluidForceExchange& door = session_.fluidForce();
    const label me = Pstream::myProcNo();

    previousCells_.setSize(guests_.size());
    forAll(guests_, g)
    {
        previousCells_[g] = guests_[g].cell;
    }
    guests_.clear();
    atomOfGuest_.clear();
    travellers_.clear();

    const auto admit = [&]
    (
        guestGrain& guest,
        const cellLocator::place& place,
        const label atom
    )
    {
        guest.cell = place.cell;
        guest.clearance = place.clearance;
        guest.pyramid = place.pyramid;
        guests_.append(guest);
        atomOfGuest_.append(atom);
    };

    DynamicList<guestGrain> away;
    DynamicList<label> lastRank;

    // The cell that held an atom last, if it was a guest here
    const auto lastCell = [&](const label atom) -> label
    {
        const label number = label(door.host[atom][1]);
        const bool known =
            label(door.host[atom][0]) == me
         && number >= 0
         && number < previousCells_.size();

        return known ? previousCells_[number] : -1;
    };

    // Far enough ahead for memory to arrive
    const label ahead = 8;

    for (label atom = 0; atom < grains.n; ++atom)
    {
        if (atom + ahead < grains.n)
        {
            const label celli = lastCell(atom + ahead);
            if (celli >= 0)
            {
                locator_.fetch(celli);
            }
        }

        guestGrain guest = asGuest(grains, atom);
        const label rank = label(door.host[atom][0]);

        // A grain that was a guest elsewhere is probably still one: it asks there first
        const bool elsewhere = (rank >= 0 && rank != me);

        const cellLocator::place place =
            elsewhere
          ? cellLocator::place{-1, 0, -1}
          : locator_.find(guest.position, lastCell(atom));

        if (place.cell >= 0)
        {
            admit(guest, place, atom);
        }
        else
        {
            away.append(guest);
            lastRank.append(elsewhere ? rank : -1);
            travellers_.append(atom);
        }
    }

    // A host has no hint for a traveller but the cell it found last: grains that
    // arrive together are neighbours
    label near = -1;
    travelling_ = 0;
    const labelList owner = route_.establish<guestGrain>
    (
        away,
        lastRank,
        [&](guestGrain guest) -> label
        {
            const cellLocator::place place = locator_.find(guest.position, near);
            if (place.cell < 0)
            {
                return -1;
            }
            near = place.cell;
            admit(guest, place, -1);
            ++travelling_;
            return guests_.size() - 1;
        }
    );

    homeless_.clear();
    forAll(away, i)
    {
        if (owner[i] >= 0)
        {
            continue;
        }

        // Once a guest elsewhere, now perhaps back where it lives
        const cellLocator::place place =
            lastRank[i] >= 0
          ? locator_.find(away[i].position, -1)
          : cellLocator::place{-1, 0, -1};

        if (place.cell >= 0)
        {
            admit(away[i], place, travellers_[i]);
        }
        else
        {
            homeless_.append(travellers_[i]);
        }
    }
    outside_ = returnReduce(homeless_.size(), sumOp<label>());
}


void Foam::guestGrains::send(const UList<fluidAction>& actions)
{
    const liggghtsSession::grainArrays grains = session_.grains();
    LAMMPS_NS::FluidForceExchange& door = session_.fluidForce();
    const label me = Pstream::myProcNo();

    const auto hand = [&]
    (
        const label atom,
        const fluidAction& action,
        const label rank,
        const label number
    )
    {
        for (direction k = 0; k < 3; ++k)
        {
            door.fluidVelocity[atom][k] = action.velocity[k];
            door.explicitForce[atom][k] = action.force[k];
            door.impulse[atom][k] = 0;
            door.startPosition[atom][k] = grains.position[atom][k];
        }
        door.dragCoefficient[atom] = action.dragCoefficient;
        door.host[atom][0] = rank;
        door.host[atom][1] = number;
    };

    forAll(guests_, g)
    {
        if (atomOfGuest_[g] >= 0)
        {
            hand(atomOfGuest_[g], actions[g], me, g);
        }
    }

    route_.back<answer>
    (
        [&](const label g)
        {
            return answer{actions[g], me, g};
        },
        [&](const label item, const answer& a)
        {
            hand(travellers_[item], a.action, a.rank, a.guest);
        }
    );

    for (const label atom : homeless_)
    {
        hand(atom, fluidAction{Zero, 0, Zero}, -1, -1);
    }
}


void Foam::guestGrains::receiveImpulse(vectorField& impulse, vector& orphaned)
{
    const label n = session_.grains().n;
    LAMMPS_NS::FluidForceExchange& door = session_.fluidForce();
    const label me = Pstream::myProcNo();

    impulse.setSize(guests_.size());
    impulse = Zero;
    orphaned = Zero;

    List<DynamicList<parcel>> parcels(Pstream::nProcs());

    const auto book = [&](const double* host, const double* received)
    {
        const label rank = label(host[0]);
        const label guest = label(host[1]);
        if (rank == me)
        {
            impulse[guest] += toVector(received);
        }
        else if (rank >= 0)
        {
            parcels[rank].append(parcel{guest, toVector(received)});
        }
        else
        {
            orphaned += toVector(received);
        }
    };

    for (label atom = 0; atom < n; ++atom)
    {
        book(door.host[atom], door.impulse[atom]);
    }
    for (label i = 0; i < door.nLost; ++i)
    {
        book(door.lost[i].host, door.lost[i].impulse);
    }
    door.clearLost(&door);

    impulseBytes_ += ownerRoute::exchange<parcel>
    (
        parcels,
        [&](const label, const UList<parcel>& incoming)
        {
            for (const parcel& p : incoming)
            {
                impulse[p.guest] += p.impulse;
            }
        }
    );
}


// ************************************************************************* //
