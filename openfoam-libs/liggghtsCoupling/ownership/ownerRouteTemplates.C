/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ownerRoute.H"
#include "PstreamReduceOps.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class T>
Foam::labelList Foam::ownerRoute::sizes
(
    const List<DynamicList<T>>& lists,
    const label width
)
{
    labelList result(lists.size());
    forAll(lists, proci)
    {
        result[proci] = width*lists[proci].size();
    }
    return result;
}


template<class Item>
Foam::labelList Foam::ownerRoute::announce(const List<DynamicList<Item>>& asks)
{
    // The last bit tells every rank whether this one asks any
    const labelList own(sizes(asks));
    const bool asking = std::any_of(own.begin(), own.end(), [](const label n){ return n > 0; });
    labelList sent(own.size());
    forAll(own, proci)
    {
        sent[proci] = 2*own[proci] + asking;
    }
    labelList arriving(own.size());
    Pstream::allToAll(sent, arriving);

    bool any = false;
    for (label& n : arriving)
    {
        any = any || n%2;
        n /= 2;
    }
    return any ? arriving : labelList();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class T, class Take>
std::int64_t Foam::ownerRoute::exchange
(
    const List<DynamicList<T>>& lists,
    const Take& take
)
{
    if (!Pstream::parRun())
    {
        return 0;
    }
    labelList arriving(lists.size());
    Pstream::allToAll(sizes(lists), arriving);
    return exchange<T>(lists, arriving, take);
}


template<class T, class Take>
std::int64_t Foam::ownerRoute::exchange
(
    const List<DynamicList<T>>& lists,
    const labelUList& arriving,
    const Take& take
)
{
    std::int64_t bytes = 0;

    if (!Pstream::parRun())
    {
        return bytes;
    }

    for (const DynamicList<T>& list : lists)
    {
        bytes += std::int64_t(list.size())*sizeof(T);
    }

    List<DynamicList<T>> received(Pstream::nProcs());
    Pstream::exchange<DynamicList<T>, T>(lists, arriving, received);

    forAll(received, proci)
    {
        if (received[proci].size())
        {
            take(proci, received[proci]);
        }
    }

    return bytes;
}


template<class Item, class Accept, class Local>
Foam::labelList Foam::ownerRoute::establish
(
    UList<Item>& items,
    const labelUList& first,
    const Accept& accept,
    const Local& local
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

    // The rank that is asked in this round: first those that replies name, then the candidates
    // in their order
    labelList asked(first);
    labelList hops(items.size(), 0);
    labelList lastCandidate(items.size(), -1);
    DynamicList<label> pending(items.size());

    const label nProcs = Pstream::nProcs();
    const label me = Pstream::myProcNo();

    // Follow a reply about an item. If it names this rank, the item is looked for here
    const auto follow = [&](const label i, reply said)
    {
        if (said.rank == me)
        {
            said = local(i, said.cell);
            owner[i] = (said.stored >= 0 ? me : -1);
        }
        items[i].setHint(said.cell);
        const bool led =
            owner[i] < 0 && said.rank >= 0 && said.rank != me && hops[i] < maxHops_;
        if (led)
        {
            ++hops[i];
            asked[i] = said.rank;
            pending.append(i);
        }
        return led || owner[i] >= 0;
    };

    const auto askCandidate = [&](const label i)
    {
        items[i].setHint(-1);
        hops[i] = 0;
        asked[i] = -1;
        if (lastCandidate[i] == me)
        {
            return;
        }
        asked[i] = lastCandidate[i] =
            nextCandidate(items[i].position, lastCandidate[i]);
        if (asked[i] >= 0)
        {
            pending.append(i);
        }
        else if (first[i] >= 0)
        {
            // Not searched here so far
            lastCandidate[i] = me;
            follow(i, reply{-1, me, -1});
        }
    };

    forAll(items, i)
    {
        if (asked[i] >= 0)
        {
            pending.append(i);
        }
        else
        {
            askCandidate(i);
        }
    }

    // What replies of a round leave for the next one is known only when all ranks have answered
    do
    {
        List<DynamicList<Item>> asks(nProcs);
        List<DynamicList<label>> askedItems(nProcs);
        for (const label i : pending)
        {
            asks[asked[i]].append(items[i]);
            askedItems[asked[i]].append(i);
        }
        pending.clear();
        const labelList arriving(announce(asks));
        if (arriving.empty())
        {
            break;
        }

        List<DynamicList<reply>> replies(nProcs);
        bytes_ += exchange<Item>
        (
            asks,
            arriving,
            [&](const label proci, const UList<Item>& incoming)
            {
                for (const Item& item : incoming)
                {
                    replies[proci].append(accept(item));
                    if (replies[proci].last().stored >= 0)
                    {
                        received_[proci].append(replies[proci].last().stored);
                    }
                }
            }
        );

        bytes_ += exchange<reply>
        (
            replies,
            sizes(askedItems),
            [&](const label proci, const UList<reply>& answers)
            {
                forAll(answers, k)
                {
                    const label i = askedItems[proci][k];
                    const reply& answer = answers[k];
                    if (answer.stored >= 0)
                    {
                        owner[i] = proci;
                        sent_[proci].append(i);
                        continue;
                    }

                    if (!follow(i, answer))
                    {
                        askCandidate(i);
                    }
                }
            }
        );
    } while (returnReduce(!pending.empty(), orOp<bool>()));

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
        sizes(received_),
        [&](const label proci, const UList<T>& values)
        {
            forAll(values, k)
            {
                take(received_[proci][k], values[k]);
            }
        }
    );
}


template<class Fill, class Take>
void Foam::ownerRoute::follow
(
    const List<DynamicList<label>>& from,
    const List<DynamicList<label>>& to,
    const label width,
    const Fill& fill,
    const Take& take
)
{
    List<DynamicList<scalar>> lists(Pstream::nProcs());
    forAll(from, proci)
    {
        DynamicList<scalar>& list = lists[proci];
        list.setSize(width*from[proci].size());
        forAll(from[proci], k)
        {
            fill(from[proci][k], list.data() + width*k);
        }
    }

    bytes_ += exchange<scalar>
    (
        lists,
        sizes(to, width),
        [&](const label proci, const UList<scalar>& values)
        {
            forAll(to[proci], k)
            {
                take(to[proci][k], values.cdata() + width*k);
            }
        }
    );
}


template<class Fill, class Take>
void Foam::ownerRoute::forward(const label width, const Fill& fill, const Take& take)
{
    follow(sent_, received_, width, fill, take);
}


template<class Fill, class Take>
void Foam::ownerRoute::back(const label width, const Fill& fill, const Take& take)
{
    follow(received_, sent_, width, fill, take);
}


// ************************************************************************* //
