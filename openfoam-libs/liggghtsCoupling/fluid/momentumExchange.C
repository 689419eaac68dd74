/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "momentumExchange.H"
#include "couplingEntries.H"
#include "debtTransport.H"
#include "fvMatrices.H"
#include "voidFractionEquations.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::momentumExchange::deposit
(
    const ownedGrains& grains,
    const UList<grainForces::record>& records,
    cellAverages& averages,
    const scalar dt
)
{
    averages.shares().deposit<exchanged>
    (
        grains.size(),
        [&](const label g){ return grains.cell(g); },
        [&](const label g)
        {
            const grainForces::record& r = records[g];
            scalar slope = 0;
            if (twoWay_)
            {
                slope = grainMomentum::slope
                (
                    r.dragCoefficient, r.allCoefficients, r.mass, r.addedMass, dt, r.voidFraction
                );
                // A grain that is held received more than one that is free to move
                const scalar seen =
                    (impulse_[g] & r.slip)/(dt*r.voidFraction*(magSqr(r.slip) + VSMALL));
                slope = max(slope, min(seen, r.dragCoefficient/r.voidFraction));
            }
            const scalar heatSlope =
                r.heatCapacity > 0
              ? debtTransport::weight(r.heatTransferCoefficient, r.heatCapacity, dt) : 0;
            return exchanged
            {
                impulse_[g], r.dragCoefficient, slope, r.mass + r.addedMass,
                work_.empty() ? 0 : work_[g], heat_.empty() ? 0 : heat_[g],
                heatSlope, heatSlope*r.fluidTemperature
            };
        },
        [&](const label celli, const scalar fraction, const exchanged& e)
        {
            exchanged& sum = averages.cells().sum(exchanged_, celli);
            sum.impulse += fraction*e.impulse;
            sum.dragCoefficient += fraction*e.dragCoefficient;
            sum.slope += fraction*e.slope;
            sum.mass += fraction*e.mass;
            sum.work += fraction*e.work;
            sum.heat += fraction*e.heat;
            sum.heatSlope += fraction*e.heatSlope;
            sum.slopeTemperature += fraction*e.slopeTemperature;
        }
    );
}


void Foam::momentumExchange::setHeat
(
    heatExchange& heat,
    const labelUList& cells,
    const scalar dt
) const
{
    scalarField received(cells.size());
    scalarField slope(cells.size());
    scalarField felt(cells.size());
    forAll(cells, i)
    {
        const exchanged& e = exchanged_[i];
        received[i] = e.heat;
        slope[i] = e.heatSlope;
        felt[i] = e.heatSlope > 0 ? e.slopeTemperature/e.heatSlope : 0;
    }
    heat.set(cells, received, slope, felt, dt);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::momentumExchange::momentumExchange
(
    const dictionary& dict,
    const carrierFluid& fluid
)
:
    twoWay_(couplingEntries::twoWay(dict)),
    setI_(couplingEntries::setI(dict)),
    full_(voidFractionEquations::full(dict)),
    momentum_(grainMomentum::New(dict, fluid)),
    responseTime_(fluid.mesh().nCells(), Zero),
    dragCoefficient_
    (
        cellAverages::writtenField("dragCoefficient", fluid.mesh()),
        fluid.mesh(),
        dimensionedScalar(dimDensity/dimTime, Zero)
    ),
    particleMomentumSource_
    (
        cellAverages::writtenField("particleMomentumSource", fluid.mesh()),
        fluid.mesh(),
        dimensionedVector(dimForce/dimVolume, Zero)
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::ownedGrains::received Foam::momentumExchange::receive
(
    ownedGrains& grains,
    const grainForces& forces,
    UList<grainForces::record>& records,
    cellAverages& averages,
    const vectorField& stress,
    energyExchange* energy,
    heatExchange* heat
)
{
    const fvMesh& mesh = dragCoefficient_.mesh();
    const scalar dt = mesh.time().deltaTValue();
    const scalarField& V = mesh.V();

    for (const label celli : averages.cells().previous())
    {
        dragCoefficient_[celli] = 0;
        particleMomentumSource_[celli] = Zero;
        responseTime_[celli] = 0;
    }

    exchanged_.clear();
    exchanged_.setSize(averages.cells().cells().size(), exchanged{});
    const ownedGrains::received received = grains.receiveImpulse
    (
        impulse_,
        work_,
        heat_,
        [&](const label celli, const vector& impulse, const scalar work, const scalar received)
        {
            exchanged& sum = averages.cells().sum(exchanged_, celli);
            sum.impulse += impulse;
            sum.work += work;
            sum.heat += received;
        }
    );
    forAll(heat_, g)
    {
        if (heat_[g] == 0)
        {
            records[g].heatTransferCoefficient = 0;
        }
    }
    deposit(grains, records, averages, dt);
    if (averages.filter())
    {
        averages.filter()->spread
        (
            averages.cells(), exchanged_,
            heat ? exchanged::all : energy ? exchanged::withoutHeat : exchanged::withoutEnergy
        );
    }

    const labelUList& cells = averages.cells().cells();
    felt_.clear();
    vectorField impulse(cells.size());
    scalarField slope(cells.size());
    scalarField work(energy ? cells.size() : 0);
    scalarField response(cells.size());
    forAll(cells, i)
    {
        const label celli = cells[i];
        exchanged& e = exchanged_[i];
        if (full_ && setI_)
        {
            felt_.append
            (
                grainMomentum::feltStress
                {
                    (1 - averages.voidFraction()[celli])*V[celli], stress[celli]
                }
            );
        }
        else if (!full_ && !setI_)
        {
            const vector reaction
            (
                dt*averages.solidVolume(i)*forces.stressDensity(celli)
            );
            e.impulse += reaction;
            e.work += reaction & averages.particleVelocity()[celli];
        }
        else if (full_ && energy)
        {
            // The gas' equation leaves this work to the grains
            e.work +=
                dt*(1 - averages.voidFraction()[celli])*V[celli]
               *(stress[celli] & averages.particleVelocity()[celli]);
        }
        if (energy)
        {
            work[i] = e.work;
        }

        impulse[i] = e.impulse;
        slope[i] = e.slope;
        response[i] = 1;
        if (e.slope > 0)
        {
            const scalar b = e.dragCoefficient;
            const scalar free = grainMomentum::slope
            (
                b, b, e.mass, 0, dt, full_ ? averages.voidFraction()[celli] : 1
            );
            response[i] = free*dt/e.mass*min(free/e.slope, 1.0);
        }
        responseTime_[celli] =
            averages.filter() && averages.solidVolume(i) < grainFilter::tiny*V[celli]
          ? 0
          : e.mass/(e.dragCoefficient + VSMALL);
        dragCoefficient_[celli] = e.dragCoefficient/V[celli];
        particleMomentumSource_[celli] = -e.impulse/(dt*V[celli]);
    }

    if (twoWay_)
    {
        momentum_->set(cells, impulse, slope, response, felt_, dt);
    }
    if (energy)
    {
        energy->set(cells, work, dt);
    }
    if (heat)
    {
        setHeat(*heat, cells, dt);
    }
    return received;
}


void Foam::momentumExchange::addSup(fvMatrix<vector>& eqn) const
{
    if (twoWay_)
    {
        momentum_->addSup(eqn);
    }
}


// ************************************************************************* //
