/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ownedGrains.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Found>
void Foam::ownedGrains::locate(const Found& found)
{
    grains_ = session_.grains();
    exchange_ = session_.fluidForces();
    heats_ = session_.heats();
    const label me = Pstream::myProcNo();

    previousCells_.swap(cells_);
    makeRoom(cells_, grains_.n);
    makeRoom(pyramids_, grains_.n);
    makeRoom(sources_, grains_.n);
    remoteGrains_.clear();
    sentAtoms_.clear();

    // Not of this rank's mesh, or not found in it yet
    DynamicList<grainData> sent;
    DynamicList<label> firstRank;

    // Many together, so that memory is fetched while other grains are looked at: first that of the
    // cells of the interval before, then that of the cells they have entered since
    const label nTogether = 32;
    grainData grains[nTogether];
    cellLocator::place places[nTogether];
    label ends[nTogether];

    fetchLastCells(0, nTogether);
    for (label first = 0; first < grains_.n; first += nTogether)
    {
        const label n = min(nTogether, grains_.n - first);
        fetchLastCells(first + n, nTogether);
        for (label i = 0; i < n; ++i)
        {
            places[i] = findInLastCell(first + i, ends[i]);
        }

        const label number = cells_.size();
        label nFound = 0;
        for (label i = 0; i < n; ++i)
        {
            const label atom = first + i;
            grainData& grain = grains[nFound];
            grain = grainOf(atom);

            // A grain that another rank owned probably still lies there: that rank is asked first
            const double* owner = exchange_.owner[atom];
            const label rank = label(owner[LAMMPS_NS::OWNER_RANK]);
            const bool ownedElsewhere =
                rank >= 0 && rank != me && owner[LAMMPS_NS::OWNER_PRESENT] > 0;

            if
            (
                places[i].cell < 0
             && !ownedElsewhere
             && !cellLocator::isRemote(ends[i])
            )
            {
                places[i] =
                    locator_.findOrFollow(grain.position, ends[i], ends[i]);
            }

            if (places[i].cell >= 0)
            {
                add(grain, places[i], source{atom, false});
                ++nFound;
                continue;
            }

            label firstAsked = -1;
            if (ownedElsewhere)
            {
                firstAsked = rank;
                grain.hintNumber = label(owner[LAMMPS_NS::OWNER_NUMBER]);
            }
            else if (cellLocator::isRemote(ends[i]))
            {
                firstAsked = locator_.remote(ends[i]).rank;
                grain.hintCell = locator_.remote(ends[i]).cell;
            }
            // Without a hint ranks are chosen by their boxes, which lie inside of the periodic one
            grain.position = locator_.wrap(grain.position);
            sent.append(grain);
            firstRank.append(firstAsked);
            sentAtoms_.append(atom);
        }
        found(number, UList<grainData>(grains, nFound));
    }

    const auto addOne = [&]
    (
        grainData& grain,
        const cellLocator::place& place,
        const source& from
    )
    {
        add(grain, place, from);
        found(cells_.size() - 1, UList<grainData>(&grain, 1));
    };

    // Grains that arrive together are neighbours: without a hint the search begins in the cell
    // that was found last
    label near = -1;
    const labelList owner = route_.establish<grainData>
    (
        sent,
        firstRank,
        [&](grainData grain) -> ownerRoute::reply
        {
            const label hint =
                grain.hintNumber >= 0
              ? previousCell(grain.hintNumber) : grain.hintCell;
            label end = -1;
            const cellLocator::place place =
                hint >= 0 ? locator_.findOrFollow(grain.position, hint, end)
              : locator_.find(grain.position, near, end);

            if (place.cell >= 0)
            {
                near = place.cell;
                addOne(grain, place, source{remoteGrains_.size(), true});
                remoteGrains_.append(grain);
                return ownerRoute::reply{cells_.size() - 1, -1, -1};
            }
            return ownerRoute::reply::refusal(locator_, end);
        },
        [&](const label i, const label hint) -> ownerRoute::reply
        {
            label end;
            const cellLocator::place place =
                locator_.findOrFollow(sent[i].position, hint, end);
            if (place.cell >= 0)
            {
                addOne(sent[i], place, source{sentAtoms_[i], false});
                return ownerRoute::reply{cells_.size() - 1, -1, -1};
            }
            return ownerRoute::reply::refusal(locator_, end);
        }
    );
    remoteActions_.setSize(nAction_*remoteGrains_.size());
    remoteExtras_.setSize(nExtras_*remoteGrains_.size());
    if (nExtras_)
    {
        route_.forward
        (
            nExtras_,
            [&](const label item, scalar* values)
            {
                const label atom = sentAtoms_[item];
                scalar* next = values;
                if (session_.requested().spin)
                {
                    std::copy_n(grains_.spin[atom], 3, next);
                    next += 3;
                }
                if (session_.requested().needsTemperature())
                {
                    next[0] = heats_.temperature[atom];
                    next[1] = capacityOf(atom);
                }
                if (session_.requested().impulse)
                {
                    std::copy_n
                    (
                        exchange_.impulse[atom], 3, values + nExtras_ - nState_ - 3
                    );
                }
                getAtomState(atom, values + nExtras_ - nState_);
            },
            [&](const label g, const scalar* values)
            {
                std::copy_n
                (
                    values, nExtras_, &remoteExtras_[nExtras_*sources_[g].index]
                );
            }
        );
    }

    outsideAtoms_.clear();
    forAll(sent, i)
    {
        if (owner[i] < 0)
        {
            outsideAtoms_.append(sentAtoms_[i]);
        }
    }
}


// ************************************************************************* //
