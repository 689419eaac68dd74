/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "guestGrains.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// An impulse on its way to the guest that it belongs to
struct impulseParcel
{
    label guest;
    vector impulse;
};

template<> struct is_contiguous<impulseParcel> : std::true_type {};

} // End namespace Foam


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Found>
void Foam::guestGrains::locate(const Found& found)
{
    grains_ = session_.grains();
    door_ = session_.fluidForces();
    const label me = Pstream::myProcNo();

    previousCells_.swap(cells_);
    makeRoom(cells_, grains_.n);
    makeRoom(pyramids_, grains_.n);
    makeRoom(source_, grains_.n);
    visitors_.clear();
    travellers_.clear();

    const auto admit = [&]
    (
        guestGrain& guest,
        const cellLocator::place& place,
        const label source
    )
    {
        guest.position = locator_.near(guest.position, place.cell);
        guest.cell = place.cell;
        guest.clearance = place.clearance;
        guest.pyramid = place.pyramid;
        cells_.append(place.cell);
        pyramids_.append(place.pyramid);
        source_.append(source);
        found(cells_.size() - 1, guest);
    };

    DynamicList<guestGrain> away;
    DynamicList<label> firstRank;

    // Far enough ahead for memory to arrive: first that of the cell which held a grain
    // last, then that of the cell it has probably entered since
    const label ahead = 8;
    FixedList<cellLocator::place, ahead> places;
    FixedList<label, ahead> starts;

    const auto prepare = [&](const label atom)
    {
        if (atom + ahead < grains_.n)
        {
            const label celli = lastCell(atom + ahead);
            if (celli >= 0)
            {
                locator_.fetch(celli);
            }
        }
        if (atom >= 0 && atom < grains_.n)
        {
            cellLocator::place& place = places[atom % ahead];
            label& start = starts[atom % ahead];
            place.cell = start = -1;

            const label celli = lastCell(atom);
            if (celli >= 0)
            {
                place = locator_.step(position(atom), celli, start);
            }
            if (start >= 0)
            {
                locator_.fetch(start);
            }
        }
    };

    for (label atom = -ahead; atom < ahead; ++atom)
    {
        prepare(atom);
    }

    for (label atom = 0; atom < grains_.n; ++atom)
    {
        cellLocator::place place = places[atom % ahead];
        label end = starts[atom % ahead];
        prepare(atom + ahead);

        guestGrain guest(asGuest(atom));
        const label rank = label(door_.host[atom][0]);
        const label number = label(door_.host[atom][1]);

        // A grain that was a guest elsewhere is probably still one: it asks there first
        const bool elsewhere = rank >= 0 && rank != me && number >= 0;

        if (place.cell < 0 && !elsewhere && !cellLocator::leadsAway(end))
        {
            place = locator_.findOrFollow(guest.position, end, end);
        }

        if (place.cell >= 0)
        {
            admit(guest, place, atom);
            continue;
        }

        label first = -1;
        if (elsewhere)
        {
            first = rank;
            guest.cell = -2 - number;
        }
        else if (cellLocator::leadsAway(end))
        {
            first = locator_.foreign(end).rank;
            guest.cell = locator_.foreign(end).cell;
        }
        // Without a hint ranks are chosen by their boxes, which lie inside of the periodic one
        guest.position = locator_.wrap(guest.position);
        away.append(guest);
        firstRank.append(first);
        travellers_.append(atom);
    }

    // Without a hint a host has but the cell it found last: grains that arrive together are
    // neighbours
    label near = -1;
    const labelList owner = route_.establish<guestGrain>
    (
        away,
        firstRank,
        [&](guestGrain guest) -> ownerRoute::reply
        {
            const label hint =
                guest.cell < -1 ? formerCell(-2 - guest.cell) : guest.cell;
            label end = -1;
            const cellLocator::place place =
                hint >= 0 ? locator_.findOrFollow(guest.position, hint, end)
              : locator_.find(guest.position, near);

            if (place.cell >= 0)
            {
                near = place.cell;
                admit(guest, place, -1 - visitors_.size());
                visitors_.append(guest);
                return ownerRoute::reply{cells_.size() - 1, -1, -1};
            }
            return ownerRoute::reply::refusal(locator_, end);
        },
        [&](const label i)
        {
            label end;
            const cellLocator::place place =
                locator_.findOrFollow(away[i].position, away[i].cell, end);
            if (place.cell >= 0)
            {
                admit(away[i], place, travellers_[i]);
            }
            return place.cell >= 0;
        }
    );
    visitorActions_.setSize(visitors_.size());

    homeless_.clear();
    forAll(away, i)
    {
        if (owner[i] >= 0)
        {
            continue;
        }

        // Not searched here so far, if it was sent elsewhere at once
        const cellLocator::place place =
            firstRank[i] >= 0
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


template<class Former>
Foam::vector Foam::guestGrains::receiveImpulse
(
    DynamicList<vector>& impulse,
    const Former& former
)
{
    const label n = session_.grains().n;
    LAMMPS_NS::FluidForceExchange& losses = session_.fluidForce();
    const liggghtsSession::fluidArrays door = session_.fluidForces();
    const label me = Pstream::myProcNo();

    makeRoom(impulse, cells_.size());
    impulse.setSize(cells_.size(), Zero);
    vector all(Zero);

    const auto arrive = [&](const label number, const vector& received)
    {
        all += received;
        if (number >= 0)
        {
            impulse[number] += received;
        }
        else
        {
            former(previousCells_[-2 - number], received);
        }
    };

    List<DynamicList<impulseParcel>> parcels(Pstream::nProcs());

    const auto book = [&](const double* host, const double* given)
    {
        const label rank = label(host[0]);
        const label number = label(host[1]);
        const vector received(given[0], given[1], given[2]);
        if (rank == me)
        {
            arrive(number, received);
        }
        else if (rank >= 0)
        {
            parcels[rank].append(impulseParcel{number, received});
        }
        else
        {
            all += received;
        }
    };

    for (label atom = 0; atom < n; ++atom)
    {
        book(door.host[atom], door.impulse[atom]);
    }
    for (label i = 0; i < losses.nLost; ++i)
    {
        book(losses.lost[i].host, losses.lost[i].impulse);
    }
    left_ = losses.nLost;
    losses.clearLost(&losses);

    impulseBytes_ += ownerRoute::exchange<impulseParcel>
    (
        parcels,
        [&](const label, const UList<impulseParcel>& incoming)
        {
            for (const impulseParcel& p : incoming)
            {
                arrive(p.guest, p.impulse);
            }
        }
    );
    return all;
}


// ************************************************************************* //
