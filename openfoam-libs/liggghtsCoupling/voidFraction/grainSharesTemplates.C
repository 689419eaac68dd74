/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainShares.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class CellOf>
void Foam::grainShares::settle(const CellOf& cellOf)
{
    // What no walk leads to is searched here first. Parts of a grain follow each other: what holds
    // one probably holds the next
    label nAway = 0;
    label hint = -1;
    forAll(satellites_, i)
    {
        satellite item = satellites_[i];
        label rank = firstRank_[i];
        if (rank < 0)
        {
            label end;
            const label start = (hint < 0 ? cellOf(item.guest) : hint);
            const label celli = locator_.find(item.position, start, end).cell;
            if (celli >= 0)
            {
                hint = celli;
                late_.append(share{item.guest, celli, item.fraction});
                continue;
            }
            if (cellLocator::leadsAway(end))
            {
                rank = locator_.foreign(end).rank;
                item.cell = locator_.foreign(end).cell;
            }
        }
        satellites_[nAway] = item;
        firstRank_[nAway++] = rank;
    }
    satellites_.setSize(nAway);
    firstRank_.setSize(nAway);

    label near = -1;
    const labelList owner = route_.establish<satellite>
    (
        satellites_,
        firstRank_,
        [&](const satellite& item) -> ownerRoute::reply
        {
            label end = -1;
            const cellLocator::place place =
                item.isKnown ? cellLocator::place{item.cell, 0, -1}
              : item.cell >= 0
              ? locator_.findOrFollow(item.position, item.cell, end)
              : locator_.find(item.position, near, end);

            if (place.cell >= 0)
            {
                near = place.cell;
                foreign_.append(share{-1, place.cell, item.fraction});
                return ownerRoute::reply{foreign_.size() - 1, -1, -1};
            }
            return ownerRoute::reply::refusal(locator_, end);
        },
        [&](const label i) -> ownerRoute::reply
        {
            const satellite& item = satellites_[i];
            label end;
            const label celli =
                locator_.findOrFollow(item.position, item.cell, end).cell;
            if (celli >= 0)
            {
                late_.append(share{item.guest, celli, item.fraction});
                return ownerRoute::reply{late_.size() - 1, -1, -1};
            }
            return ownerRoute::reply::refusal(locator_, end);
        }
    );

    forAll(owner, i)
    {
        if (owner[i] < 0)
        {
            const satellite& item = satellites_[i];
            late_.append(share{item.guest, cellOf(item.guest), item.fraction});
        }
    }
}


template<class Type, class Add>
Foam::label Foam::grainShares::depositOne
(
    const label first,
    const label guest,
    const label cell,
    const Type& whole,
    const Add& add
) const
{
    label i = first;
    for (; i < shares_.size() && shares_[i].guest == guest; ++i)
    {
        add(shares_[i].cell, shares_[i].fraction, whole);
    }
    if (i == first)
    {
        add(cell, scalar(1), whole);
    }
    return i;
}


template<class Type, class Value, class Add>
void Foam::grainShares::depositRest(const Value& value, const Add& add)
{
    for (const share& s : late_)
    {
        add(s.cell, s.fraction, value(s.guest));
    }

    route_.forward<Type>
    (
        [&](const label item) -> Type
        {
            return value(satellites_[item].guest);
        },
        [&](const label stored, const Type& whole)
        {
            const share& s = foreign_[stored];
            add(s.cell, s.fraction, whole);
        }
    );
}


template<class Type, class CellOf, class Value, class Add>
void Foam::grainShares::deposit
(
    const label nGuests,
    const CellOf& cellOf,
    const Value& value,
    const Add& add
)
{
    label i = 0;
    for (label g = 0; g < nGuests; ++g)
    {
        const Type whole = value(g);
        i = depositOne(i, g, cellOf(g), whole, add);
    }
    depositRest<Type>(value, add);
}


// ************************************************************************* //
