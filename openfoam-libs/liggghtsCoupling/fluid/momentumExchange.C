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
    cellAverages& averages
)
{
    const scalar dt = fluid_.mesh().time().deltaTValue();
    const scalar interval = fluid_.interval();
    const scalar part = 1.0/fluid_.subSteps();

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
                const scalar free =
                    fluid_.subSteps() == 1
                  ? slope
                  : grainMomentum::slope
                    (
                        r.dragCoefficient, r.allCoefficients, r.mass, r.addedMass, interval, r.voidFraction
                    );
                const scalar seen =
                    (impulse_[g] & r.slip)/(interval*r.voidFraction*(magSqr(r.slip) + VSMALL));
                slope = max(slope, min(seen, r.dragCoefficient/r.voidFraction) + (slope - free));
            }
            const scalar heatSlope =
                r.heatCapacity > 0
              ? debtTransport::weight(r.heatTransferCoefficient, r.heatCapacity, dt) : 0;
            return exchanged
            {
                impulse_[g], part*r.dragCoefficient, part*slope, part*(r.mass + r.addedMass),
                work_.empty() ? 0 : work_[g], heat_.empty() ? 0 : heat_[g],
                part*heatSlope, part*heatSlope*r.fluidTemperature
            };
        },
        [&](const label celli, const scalar fraction, const exchanged& e)
        {
            exchanged& sum = occupied_.sum(exchanged_, celli);
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


void Foam::momentumExchange::addCells(const grainForces& forces, cellAverages& averages)
{
    const scalar interval = fluid_.interval();
    const labelUList& cells = averages.cells().cells();
    forAll(cells, i)
    {
        const label celli = cells[i];
        occupied_.sum(exchanged_, celli);
        stressOfCell& sum = occupied_.sum(stressed_, celli);
        sum.volume += averages.solidVolume(i);
        if (!full_ && !setI_)
        {
            const vector reaction
            (
                interval*averages.solidVolume(i)*forces.stressDensity(celli)
            );
            sum.impulse += reaction;
            sum.work += reaction & averages.particleVelocity()[celli];
        }
    }
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


void Foam::momentumExchange::setStiffness(const scalarField& slope)
{
    const fvMesh& mesh = fluid_.mesh();
    const tmp<volScalarField> trho(fluid_.rho());
    const scalarField& rho = trho().primitiveField();
    stiffness_ = 0;
    forAll(slope, i)
    {
        const label celli = occupied_.cells()[i];
        stiffness_ = max(stiffness_, slope[i]*mesh.time().deltaTValue()/(rho[celli]*mesh.V()[celli]));
    }
}


void Foam::momentumExchange::warnOfStiffDrag(const scalar stiffness)
{
    if (!warnedOfDrag_ && twoWay_ && stiffness > 1)
    {
        warnedOfDrag_ = true;
        WarningInFunction
            << "subSteps " << fluid_.subSteps() << ", time " << fluid_.mesh().time().timeName()
            << ": within the fluid step the drag of grains in a cell would change its fluid "
            << stiffness << " times as much as their slip (K dt/(rho V)). They should not fly through"
            << " a fluid that stays as it is for so long. Shorten deltaT, with subSteps, if this"
            << " comes with large velocities. This is said once" << endl;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::momentumExchange::momentumExchange
(
    const dictionary& dict,
    const carrierFluid& fluid
)
:
    fluid_(fluid),
    twoWay_(couplingEntries::twoWay(dict)),
    setI_(couplingEntries::setI(dict)),
    full_(voidFractionEquations::full(dict)),
    momentum_(grainMomentum::New(dict, fluid)),
    occupied_(fluid.mesh().nCells()),
    warnedOfDrag_(false),
    stiffness_(0),
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
    const bool newStep
)
{
    if (newStep)
    {
        occupied_.clear();
        exchanged_.clear();
        stressed_.clear();
    }
    addCells(forces, averages);
    const ownedGrains::received received = grains.receiveImpulse
    (
        impulse_,
        work_,
        heat_,
        [&](const label celli, const vector& impulse, const scalar work, const scalar received)
        {
            exchanged& sum = occupied_.sum(exchanged_, celli);
            sum.impulse += impulse;
            sum.work += work;
            sum.heat += received;
        }
    );
    // Grains that the script lets exchange no heat. One that has come to the fluid's temperature in a sub-step before has
    // none to exchange either, but would if the fluid were not to stay as it is
    const auto idle = [&](const bool all)
    {
        forAll(heat_, g)
        {
            if (heat_[g] == 0 && (all || records[g].heatDifference != 0))
            {
                records[g].heatTransferCoefficient = 0;
            }
        }
    };
    idle(newStep);
    deposit(grains, records, averages);
    idle(true);     // which a continued run finds in its grains, too
    return received;
}


void Foam::momentumExchange::set
(
    cellAverages& averages,
    const vectorField& stress,
    energyExchange* energy,
    heatExchange* heat
)
{
    const fvMesh& mesh = dragCoefficient_.mesh();
    const scalar dt = mesh.time().deltaTValue();
    const scalarField& V = mesh.V();

    for (const label celli : occupied_.previous())
    {
        dragCoefficient_[celli] = 0;
        particleMomentumSource_[celli] = Zero;
        responseTime_[celli] = 0;
    }
    if (averages.filter())
    {
        averages.filter()->spread
        (
            occupied_, exchanged_,
            heat ? exchanged::all : energy ? exchanged::withoutHeat : exchanged::withoutEnergy
        );
    }
    stressed_.setSize(exchanged_.size(), stressOfCell{});

    const labelUList& cells = occupied_.cells();
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
            e.impulse += stressed_[i].impulse;
            e.work += stressed_[i].work;
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
            averages.filter() && stressed_[i].volume < grainFilter::tiny*V[celli]
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
    if (fluid_.subSteps() > 1)
    {
        setStiffness(slope);
        change_.begin(fluid_.U(), cells, dragCoefficient_);
    }
}


void Foam::momentumExchange::addSup(fvMatrix<vector>& eqn) const
{
    if (twoWay_)
    {
        momentum_->addSup(eqn);
    }
}


// ************************************************************************* //
