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
    label near = -1;
    const labelList owner = route_.establish<satellite>
    (
        satellites_,
        labelList(satellites_.size(), -1),
        [&](const satellite& item) -> label
        {
            const cellLocator::place place = locator_.find(item.position, near);
            if (place.cell < 0)
            {
                return -1;
            }
            near = place.cell;
            foreign_.append(share{-1, place.cell, item.fraction});
            return foreign_.size() - 1;
        }
    );

    forAll(owner, i)
    {
        if (owner[i] < 0)
        {
            const satellite& item = satellites_[i];
            const label celli = locator_.find(item.position, -1).cell;
            add
            (
                item.guest,
                celli >= 0 ? celli : cellOf(item.guest),
                item.fraction
            );
        }
    }
}


template<class Type, class Value, class Add>
void Foam::grainShares::deposit(const Value& value, const Add& add)
{
    for (const share& s : shares_)
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


// ************************************************************************* //
