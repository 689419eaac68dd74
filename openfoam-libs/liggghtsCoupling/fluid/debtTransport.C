/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "debtTransport.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::debtTransport::add
(
    vectorField* momentum,
    scalarField* energy,
    const label celli,
    const debt& whole
)
{
    if (momentum)
    {
        (*momentum)[celli] += vector(whole[0], whole[1], whole[2]);
    }
    if (energy)
    {
        (*energy)[celli] += whole[3];
    }
}


void Foam::debtTransport::scale
(
    const fields& debts,
    const label celli,
    const scalar factor
)
{
    // Nothing is 0, not -0: a run that is continued would differ in the sign
    if (debts.momentum)
    {
        vector& momentum = (*debts.momentum)[celli];
        momentum = factor == 0 ? vector::zero : factor*momentum;
    }
    if (debts.energy)
    {
        scalar& energy = (*debts.energy)[celli];
        energy = factor == 0 ? 0 : factor*energy;
    }
}


void Foam::debtTransport::divide
(
    const fields& debts,
    List<debt>& ofGrains,
    const ownedGrains& grains,
    cellAverages& averages
) const
{
    const scalarField& V = averages.voidFraction().mesh().V();
    occupiedCells& occupied = averages.cells();
    DynamicList<debt> units;
    debt rest(Zero);
    forAll(sums_, i)
    {
        const label celli = occupied.cells()[i];
        debt whole(Zero);
        if (sums_[i] > 0)
        {
            for (direction k = 0; k < 3; ++k)
            {
                whole[k] = debts.momentum ? (*debts.momentum)[celli][k] : 0;
            }
            whole[3] = debts.energy ? (*debts.energy)[celli] : 0;
        }
        units.append(debt(Zero));
        forAll(whole, k)
        {
            rest[k] += whole[k];
            units[i][k] = sums_[i] > 0 ? whole[k]/sums_[i] : 0;
            units[i][k] *= averages.filter() ? V[celli] : 1;
        }
    }
    if (averages.filter())
    {
        // What a grain has of the cells that it is spread over
        averages.filter()->spread(occupied, units);
        forAll(units, i)
        {
            for (scalar& value : units[i])
            {
                value /= V[occupied.cells()[i]];
            }
        }
    }

    ofGrains.setSize(weight_.size());
    ofGrains = debt(Zero);
    averages.shares().collect<debt>
    (
        weight_.size(),
        [&](const label g){ return grains.cell(g); },
        [&](const label celli)
        {
            return occupied.holds(celli) ? units[occupied.number(celli)] : debt(Zero);
        },
        [&](const label g, const scalar fraction, const debt& unit)
        {
            forAll(unit, k)
            {
                ofGrains[g][k] += fraction*weight_[g]*unit[k];
            }
        }
    );

    if (averages.filter())
    {
        // By the tolerance of its linear solver the sum is not that of the cells
        for (const debt& whole : ofGrains)
        {
            forAll(whole, k)
            {
                rest[k] -= whole[k];
            }
        }
        const scalar all = returnReduce(sum(weight_), sumOp<scalar>());
        for (scalar& value : rest)
        {
            reduce(value, sumOp<scalar>());
            value /= all;
        }
        forAll(ofGrains, g)
        {
            forAll(rest, k)
            {
                ofGrains[g][k] += weight_[g]*rest[k];
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::debtTransport::debtTransport(const fields& debts)
:
    debts_(debts)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::debtTransport::leave
(
    const ownedGrains& grains,
    cellAverages& averages,
    const fields& debts
)
{
    List<debt> ofGrains;
    divide(debts, ofGrains, grains, averages);
    scalarList removed(weight_.size(), Zero);
    for (const label g : grains.removed())
    {
        add(debts.lostMomentum, debts.lostEnergy, grains.cell(g), ofGrains[g]);
        removed[g] = weight_[g];
    }

    DynamicList<scalar> ofRemoved;
    sumUp(removed, ofRemoved, grains, averages);
    if (averages.filter())
    {
        averages.filter()->spread(averages.cells(), ofRemoved);
    }
    forAll(ofRemoved, i)
    {
        if (sums_[i] > 0)
        {
            scale(debts, averages.cells().cells()[i], 1 - ofRemoved[i]/sums_[i]);
        }
    }
}


void Foam::debtTransport::retire
(
    const ownedGrains& grains,
    cellAverages& averages,
    const carrierFluid& fluid,
    const fields& debts
)
{
    // Most often none was removed. Then nothing is changed, also by a filter
    bool removed = returnReduce(!grains.removed().empty(), orOp<bool>());
    if (removed && stiff(grains, averages, fluid, removed))
    {
        leave(grains, averages, debts);
    }
}


bool Foam::debtTransport::take
(
    const ownedGrains& grains,
    cellAverages& averages,
    const carrierFluid& fluid
)
{
    bool removed = false;
    bool any = stiff(grains, averages, fluid, removed);
    if (removed)
    {
        // As when the run was continued here, without the grains that were removed
        if (any)
        {
            leave(grains, averages, debts_);
        }
        for (const label g : grains.removed())
        {
            weight_[g] = 0;
        }
        any = stiff(grains, averages, fluid, removed);
    }

    carried_.clear();
    if (!any)
    {
        return false;
    }
    divide(debts_, carried_, grains, averages);
    forAll(sums_, i)
    {
        if (sums_[i] > 0)
        {
            scale(debts_, averages.cells().cells()[i], 0);
        }
    }
    return true;
}


void Foam::debtTransport::give(ownedGrains& grains, cellAverages& averages)
{
    DynamicList<debt> present;
    grains.handOver
    (
        carried_,
        present,
        [&](const label celli, const debt& whole)
        {
            add(debts_.lostMomentum, debts_.lostEnergy, celli, whole);
        }
    );
    occupiedCells& occupied = averages.cells();
    DynamicList<debt> sums;
    averages.shares().deposit<debt>
    (
        grains.size(),
        [&](const label g){ return grains.cell(g); },
        [&](const label g){ return present[g]; },
        [&](const label celli, const scalar fraction, const debt& whole)
        {
            debt& sum = occupied.sum(sums, celli);
            forAll(whole, k)
            {
                sum[k] += fraction*whole[k];
            }
        }
    );
    if (averages.filter())
    {
        averages.filter()->spread(occupied, sums);
    }
    forAll(sums, i)
    {
        add(debts_.momentum, debts_.energy, occupied.cells()[i], sums[i]);
    }
}


Foam::scalar Foam::debtTransport::giveHeat(ownedGrains& grains)
{
    scalarList heat(carried_.size());
    forAll(heat, g)
    {
        heat[g] = carried_[g][3];
    }
    return grains.giveHeat
    (
        heat, [&](const label celli, const scalar whole){ (*debts_.lostEnergy)[celli] += whole; }
    );
}


// ************************************************************************* //
