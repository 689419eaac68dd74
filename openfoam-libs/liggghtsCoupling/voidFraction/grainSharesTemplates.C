/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainShares.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class CellOf>
void Foam::grainShares::findRemoteParts(const CellOf& cellOf)
{
    // What no walk leads to is searched here first. Parts of a grain follow each other: what holds
    // one probably holds the next
    label nAway = 0;
    label hint = -1;
    forAll(remoteParts_, i)
    {
        remotePart item = remoteParts_[i];
        label rank = firstRank_[i];
        if (rank < 0)
        {
            label end;
            const label start = (hint < 0 ? cellOf(item.grain) : hint);
            const label celli = locator_.find(item.position, start, end).cell;
            if (celli >= 0)
            {
                hint = celli;
                late_.append(share{item.grain, celli, item.fraction});
                continue;
            }
            if (cellLocator::isRemote(end))
            {
                rank = locator_.remote(end).rank;
                item.cell = locator_.remote(end).cell;
            }
        }
        remoteParts_[nAway] = item;
        firstRank_[nAway++] = rank;
    }
    remoteParts_.setSize(nAway);
    firstRank_.setSize(nAway);

    label near = -1;
    const labelList owner = route_.establish<remotePart>
    (
        remoteParts_,
        firstRank_,
        [&](const remotePart& item) -> ownerRoute::reply
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
                remote_.append(share{-1, place.cell, item.fraction});
                return ownerRoute::reply{remote_.size() - 1, -1, -1};
            }
            return ownerRoute::reply::refusal(locator_, end);
        },
        [&](const label i, const label near) -> ownerRoute::reply
        {
            const remotePart& item = remoteParts_[i];
            label end;
            const label celli =
                locator_.findOrFollow(item.position, near, end).cell;
            if (celli >= 0)
            {
                late_.append(share{item.grain, celli, item.fraction});
                return ownerRoute::reply{late_.size() - 1, -1, -1};
            }
            return ownerRoute::reply::refusal(locator_, end);
        }
    );

    forAll(owner, i)
    {
        if (owner[i] < 0)
        {
            const remotePart& item = remoteParts_[i];
            late_.append(share{item.grain, cellOf(item.grain), item.fraction});
        }
    }
}


template<class Type, class Add>
Foam::label Foam::grainShares::depositOne
(
    const label first,
    const label grain,
    const label cell,
    const Type& whole,
    const Add& add
) const
{
    label i = first;
    for (; i < shares_.size() && shares_[i].grain == grain; ++i)
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
        add(s.cell, s.fraction, value(s.grain));
    }

    route_.forward<Type>
    (
        [&](const label item) -> Type
        {
            return value(remoteParts_[item].grain);
        },
        [&](const label stored, const Type& whole)
        {
            const share& s = remote_[stored];
            add(s.cell, s.fraction, whole);
        }
    );
}


template<class Type, class CellOf, class Value, class Add>
void Foam::grainShares::deposit
(
    const label nGrains,
    const CellOf& cellOf,
    const Value& value,
    const Add& add
)
{
    label i = 0;
    for (label g = 0; g < nGrains; ++g)
    {
        const Type whole = value(g);
        i = depositOne(i, g, cellOf(g), whole, add);
    }
    depositRest<Type>(value, add);
}


template<class Type, class CellOf, class Value, class Take>
void Foam::grainShares::collect
(
    const label nGrains,
    const CellOf& cellOf,
    const Value& value,
    const Take& take
)
{
    label i = 0;
    for (label g = 0; g < nGrains; ++g)
    {
        i = depositOne
        (
            i, g, cellOf(g), g,
            [&](const label celli, const scalar fraction, const label grain)
            {
                take(grain, fraction, value(celli));
            }
        );
    }
    for (const share& s : late_)
    {
        take(s.grain, s.fraction, value(s.cell));
    }
    route_.back
    (
        Type::size(),
        [&](const label stored, scalar* values)
        {
            const Type ofCell(value(remote_[stored].cell));
            std::copy(ofCell.begin(), ofCell.end(), values);
        },
        [&](const label item, const scalar* values)
        {
            Type ofCell;
            std::copy_n(values, Type::size(), ofCell.begin());
            take(remoteParts_[item].grain, remoteParts_[item].fraction, ofCell);
        }
    );
}


// ************************************************************************* //
