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

    // Not of this rank's mesh, or not found in it yet
    DynamicList<guestGrain> away;
    DynamicList<label> firstRank;

    // Many together, so that memory arrives while others are looked at: first that of the cells
    // which held grains last, then that of the cells they have entered since
    const label nTogether = 32;
    guestGrain guests[nTogether];
    cellLocator::place places[nTogether];
    label ends[nTogether];

    fetchLastCells(0, nTogether);
    for (label first = 0; first < grains_.n; first += nTogether)
    {
        const label n = min(nTogether, grains_.n - first);
        fetchLastCells(first + n, nTogether);
        for (label i = 0; i < n; ++i)
        {
            places[i] = stay(first + i, ends[i]);
        }

        const label number = cells_.size();
        label nFound = 0;
        for (label i = 0; i < n; ++i)
        {
            const label atom = first + i;
            guestGrain& guest = guests[nFound];
            guest = asGuest(atom);

            // A grain that was a guest elsewhere is probably still one: it asks there first
            const label rank = label(door_.host[atom][0]);
            const label formerNumber = label(door_.host[atom][1]);
            const bool elsewhere = rank >= 0 && rank != me && formerNumber >= 0;

            if
            (
                places[i].cell < 0
             && !elsewhere
             && !cellLocator::leadsAway(ends[i])
            )
            {
                places[i] =
                    locator_.findOrFollow(guest.position, ends[i], ends[i]);
            }

            if (places[i].cell >= 0)
            {
                admit(guest, places[i], atom);
                ++nFound;
                continue;
            }

            label firstAsked = -1;
            if (elsewhere)
            {
                firstAsked = rank;
                guest.cell = -2 - formerNumber;
            }
            else if (cellLocator::leadsAway(ends[i]))
            {
                firstAsked = locator_.foreign(ends[i]).rank;
                guest.cell = locator_.foreign(ends[i]).cell;
            }
            // Without a hint ranks are chosen by their boxes, which lie inside of the periodic one
            guest.position = locator_.wrap(guest.position);
            away.append(guest);
            firstRank.append(firstAsked);
            travellers_.append(atom);
        }
        found(number, UList<guestGrain>(guests, nFound));
    }

    const auto admitOne = [&]
    (
        guestGrain& guest,
        const cellLocator::place& place,
        const label source
    )
    {
        admit(guest, place, source);
        found(cells_.size() - 1, UList<guestGrain>(&guest, 1));
    };

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
              : locator_.find(guest.position, near, end);

            if (place.cell >= 0)
            {
                near = place.cell;
                admitOne(guest, place, -1 - visitors_.size());
                visitors_.append(guest);
                return ownerRoute::reply{cells_.size() - 1, -1, -1};
            }
            return ownerRoute::reply::refusal(locator_, end);
        },
        [&](const label i) -> ownerRoute::reply
        {
            label end;
            const cellLocator::place place =
                locator_.findOrFollow(away[i].position, away[i].cell, end);
            if (place.cell >= 0)
            {
                admitOne(away[i], place, travellers_[i]);
                return ownerRoute::reply{cells_.size() - 1, -1, -1};
            }
            return ownerRoute::reply::refusal(locator_, end);
        }
    );
    visitorActions_.setSize(visitors_.size());

    homeless_.clear();
    forAll(away, i)
    {
        if (owner[i] < 0)
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
