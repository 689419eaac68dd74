/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "debtTransport.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::debtTransport::weight
(
    const scalar coefficient,
    const scalar mass,
    const scalar dt
)
{
    return -mass*std::expm1(-coefficient*dt/mass);
}


void Foam::debtTransport::add
(
    vectorField& momentum,
    scalarField* energy,
    const label celli,
    const scalar fraction,
    const debt& whole
)
{
    momentum[celli] += fraction*vector(whole[0], whole[1], whole[2]);
    if (energy)
    {
        (*energy)[celli] += fraction*whole[3];
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::debtTransport::debtTransport
(
    vectorField& momentum,
    scalarField* energy,
    vectorField& lostMomentum,
    scalarField* lostEnergy
)
:
    momentum_(momentum),
    energy_(energy),
    lostMomentum_(lostMomentum),
    lostEnergy_(lostEnergy)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::debtTransport::remember
(
    const UList<grainForces::record>& records,
    const scalar dt
)
{
    ownedGrains::makeRoom(weight_, records.size());
    for (const grainForces::record& r : records)
    {
        weight_.append(weight(r.dragCoefficient/r.voidFraction, r.mass, dt));
    }
}


void Foam::debtTransport::restore
(
    const ownedGrains& grains,
    const UList<scalar>& coefficients,
    const scalar dt
)
{
    weight_.clear();
    forAll(coefficients, g)
    {
        weight_.append(weight(coefficients[g], grains.grain(g).mass, dt));
    }
}


bool Foam::debtTransport::take
(
    const ownedGrains& grains,
    cellAverages& averages,
    const carrierFluid& fluid
)
{
    carried_.clear();

    // Before the first interval there are grains, but no weights
    const label n = min(grains.size(), weight_.size());
    if (averages.filter() || !returnReduce(n, sumOp<label>()))
    {
        return false;
    }

    const auto cellOf = [&](const label g){ return grains.cell(g); };
    occupiedCells& occupied = averages.cells();
    DynamicList<scalar> sums;
    averages.shares().deposit<scalar>
    (
        n,
        cellOf,
        [&](const label g){ return weight_[g]; },
        [&](const label celli, const scalar fraction, const scalar w)
        {
            occupied.sum(sums, celli) += fraction*w;
        }
    );

    const scalarField& V = fluid.mesh().V();
    const tmp<volScalarField> trho(fluid.rho());
    bool stiff = false;
    forAll(sums, i)
    {
        const label celli = occupied.cells()[i];
        const scalar inertia = trho()[celli]*fluid.inertiaVoidFraction(celli)*V[celli];
        stiff = stiff || sums[i] > stiff_*inertia;
    }
    if (!returnReduce(stiff, orOp<bool>()))
    {
        return false;
    }

    carried_.setSize(n, debt(Zero));
    averages.shares().collect<debt>
    (
        n,
        cellOf,
        [&](const label celli)
        {
            const scalar sum = occupied.sum(sums, celli);
            debt unit(Zero);
            if (sum > 0)
            {
                for (direction k = 0; k < 3; ++k)
                {
                    unit[k] = momentum_[celli][k]/sum;
                }
                unit[3] = energy_ ? (*energy_)[celli]/sum : 0;
            }
            return unit;
        },
        [&](const label g, const scalar fraction, const debt& unit)
        {
            for (label k = 0; k < debt::size(); ++k)
            {
                carried_[g][k] += fraction*weight_[g]*unit[k];
            }
        }
    );
    forAll(sums, i)
    {
        if (sums[i] > 0)
        {
            const label celli = occupied.cells()[i];
            momentum_[celli] = Zero;
            if (energy_)
            {
                (*energy_)[celli] = 0;
            }
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
            add(lostMomentum_, lostEnergy_, celli, 1, whole);
        }
    );
    averages.shares().deposit<debt>
    (
        grains.size(),
        [&](const label g){ return grains.cell(g); },
        [&](const label g){ return present[g]; },
        [&](const label celli, const scalar fraction, const debt& whole)
        {
            add(momentum_, energy_, celli, fraction, whole);
        }
    );
}


// ************************************************************************* //
