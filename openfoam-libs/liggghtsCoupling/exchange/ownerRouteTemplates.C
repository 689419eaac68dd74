/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ownerRoute.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class T, class Take>
Foam::label Foam::ownerRoute::exchange
(
    const List<DynamicList<T>>& lists,
    const Take& take
)
{
    label bytes = 0;

    if (!Pstream::parRun())
    {
        return bytes;
    }

    for (const DynamicList<T>& list : lists)
    {
        bytes += list.size()*sizeof(T);
    }

    List<DynamicList<T>> received(Pstream::nProcs());
    Pstream::exchange<DynamicList<T>, T>(lists, received);

    forAll(received, proci)
    {
        if (received[proci].size())
        {
            take(proci, received[proci]);
        }
    }

    return bytes;
}


template<class Item, class Accept>
Foam::labelList Foam::ownerRoute::establish
(
    const UList<Item>& items,
    const labelUList& first,
    const Accept& accept
)
{
    forAll(sent_, proci)
    {
        sent_[proci].clear();
        received_[proci].clear();
    }

    labelList owner(items.size(), -1);

    if (!Pstream::parRun())
    {
        return owner;
    }

    // The rank that is asked in this round; after the preferred one
    // the candidates follow in their order
    labelList asked(items.size());
    labelList lastCandidate(items.size(), -1);
    DynamicList<label> pending(items.size());

    forAll(items, i)
    {
        asked[i] = first[i];
        if (asked[i] < 0 || asked[i] == Pstream::myProcNo())
        {
            asked[i] = lastCandidate[i] = nextCandidate(items[i].position, -1);
        }
        if (asked[i] >= 0)
        {
            pending.append(i);
        }
    }

    const label nProcs = Pstream::nProcs();

    while (returnReduce(pending.size(), sumOp<label>()))
    {
        List<DynamicList<Item>> asks(nProcs);
        List<DynamicList<label>> askedItems(nProcs);
        for (const label i : pending)
        {
            asks[asked[i]].append(items[i]);
            askedItems[asked[i]].append(i);
        }

        List<DynamicList<label>> answers(nProcs);
        bytes_ += exchange<Item>
        (
            asks,
            [&](const label proci, const UList<Item>& incoming)
            {
                for (const Item& item : incoming)
                {
                    const label stored = accept(item);
                    answers[proci].append(stored);
                    if (stored >= 0)
                    {
                        received_[proci].append(stored);
                    }
                }
            }
        );

        DynamicList<label> again;
        bytes_ += exchange<label>
        (
            answers,
            [&](const label proci, const UList<label>& stored)
            {
                forAll(stored, k)
                {
                    const label i = askedItems[proci][k];
                    if (stored[k] >= 0)
                    {
                        owner[i] = proci;
                        sent_[proci].append(i);
                        continue;
                    }

                    label next = nextCandidate(items[i].position, lastCandidate[i]);
                    if (next == first[i] && next >= 0)
                    {
                        next = nextCandidate(items[i].position, next);
                    }
                    if (next >= 0)
                    {
                        asked[i] = lastCandidate[i] = next;
                        again.append(i);
                    }
                }
            }
        );
        pending.transfer(again);
    }

    return owner;
}


template<class T, class Value, class Take>
void Foam::ownerRoute::forward(const Value& value, const Take& take)
{
    List<DynamicList<T>> lists(Pstream::nProcs());
    forAll(sent_, proci)
    {
        for (const label item : sent_[proci])
        {
            lists[proci].append(value(item));
        }
    }

    bytes_ += exchange<T>
    (
        lists,
        [&](const label proci, const UList<T>& values)
        {
            forAll(values, k)
            {
                take(received_[proci][k], values[k]);
            }
        }
    );
}


template<class T, class Value, class Take>
void Foam::ownerRoute::back(const Value& value, const Take& take)
{
    List<DynamicList<T>> lists(Pstream::nProcs());
    forAll(received_, proci)
    {
        for (const label stored : received_[proci])
        {
            lists[proci].append(value(stored));
        }
    }

    bytes_ += exchange<T>
    (
        lists,
        [&](const label proci, const UList<T>& values)
        {
            forAll(values, k)
            {
                take(sent_[proci][k], values[k]);
            }
        }
    );
}


// ************************************************************************* //
