/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "couplingPipeline.H"
#include "couplingCase.H"
#include "couplingChecks.H"
#include "couplingEntries.H"
#include "grainWatcher.H"
#include "noFloatTraps.H"
#include "sessionWarnings.H"
#include "host/grainjet_version.h"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// The case is checked before anything is made of it
const Foam::dictionary& checkedCase
(
    const Foam::dictionary& dict,
    const Foam::carrierFluid& fluid
)
{
    fluid.check();
    Foam::couplingCase(dict, fluid.mesh()).check();

    // LIGGGHTS needs MPI also where the solver runs without
    Foam::UPstream::initNull();
    Foam::liggghtsSession::checkRanks(Foam::Pstream::nProcs());
    return dict;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::couplingPipeline::start()
{
    liggghtsSession::requests requests(forces_.requests());
    requests.work = bool(energy_);
    {
        // LIGGGHTS may divide by zero on its way to an error of its own, or to the checks below
        const noFloatTraps quiet;
        session_.start
        (
            dict_.get<fileName>("script"), former_.grains(), requests,
            demSteps::adjusted(fluid_.mesh().time())
        );
    }
    const couplingChecks checks(dict_, fluid_.mesh(), session_);
    steps_.check(session_);
    checks.overlap();
    checks.grains();
    checks.heat(forces_.requests());

    const liggghtsSession::simulationBox box = session_.box();
    vector period(Zero);
    point low;
    for (direction k = 0; k < 3; ++k)
    {
        low[k] = box.low[k];
        if (box.periodic[k])
        {
            period[k] = box.high[k] - box.low[k];
        }
    }
    locator_.setPeriod(low, period);

    grains_.reset(new ownedGrains(session_, locator_));
    if (former_.continues())
    {
        DynamicList<fluidCoefficients> acted;
        averages_.restoreShares(*grains_, acted);

        // A former run with fixed steps may not have written its step
        const scalar dt =
            former_.deltaT() > 0 ? former_.deltaT() : fluid_.mesh().time().deltaTValue();
        for (debtTransport* debts : {debts_.get(), heatDebts_.get()})
        {
            if (debts)
            {
                debts->restore(*grains_, acted, dt);
            }
        }
    }
    else
    {
        grains_->clearOwners();
        grains_->locate([](const label, const UList<grainData>&){});
        checks.anyInside(returnReduce(grains_->numbers().outsideMesh, sumOp<label>()));
    }
}


Foam::autoPtr<Foam::voidFractionEquations> Foam::couplingPipeline::newEquations()
{
    autoPtr<voidFractionEquations> equations;
    if (voidFractionEquations::full(dict_))
    {
        const volScalarField& e = averages_.voidFraction();
        const volVectorField& q = averages_.solidsFlux();
        if (fluid_.compressible())
        {
            equations.reset(new compressibleVoidFraction(fluid_, e, q));
        }
        else
        {
            equations.reset(new voidFractionEquations(fluid_, e, q));
        }
    }
    return equations;
}


void Foam::couplingPipeline::closeFluidStep(couplingLog::step& step)
{
    if (equations_)
    {
        equations_->closeStep();
    }
    if (heat_)
    {
        heat_->close();
    }
    log_.closeFluidStep(step, momentum_.momentum(), equations_.get(), energy_.get(), heat_.get(), gas_);
    if (steps_.subSteps() > 1)
    {
        momentum_.addFluidChange(step.change, step.changeWeight);
    }
}


void Foam::couplingPipeline::warn(const couplingLog::step& step)
{
    if (step.warnings > 0)
    {
        sessionWarnings::gather();
    }
    inflow_.warn(step.outletCourant);
    momentum_.warnOfStiffDrag(step.stiffness);
}


void Foam::couplingPipeline::fly
(
    const label subStep,
    const label n,
    const clockTime& clock,
    couplingLog::step& step
)
{
    const label subSteps = steps_.subSteps();
    const bool first = (subStep == 0);
    fluid_.setInterval(subSteps, session_.step());

    // What the fluid is still owed moves to where the grains have come to at the end of a fluid step
    const bool moved = first && debts_ && debts_->take(*grains_, averages_, fluid_);
    const bool heatMoved = first && heatDebts_ && heatDebts_->take(*grains_, averages_, fluid_);
    step.add(averages_.update(*grains_), subSteps);
    if (weights_)
    {
        weights_->add(*grains_, fluid_.interval());
    }
    if (moved)
    {
        debts_->give(*grains_, averages_);
    }
    const scalar returned = heatMoved ? heatDebts_->giveHeat(*grains_) : 0;
    if (forces_.requests().heat)
    {
        averages_.updateTemperature(*grains_);
    }
    if (equations_)
    {
        equations_->beginStep();
        step.fluidVolume =
            sum(averages_.voidFraction().primitiveField()*fluid_.mesh().V().field());
    }
    step.slipSum += forces_.act(*grains_, records_, first);
    step.slips += grains_->size();
    if (debts_)
    {
        debts_->remember(records_, fluid_.mesh().time().deltaTValue());
    }

    const scalar before = clock.elapsedTime();
    {
        const noFloatTraps asInTheStockProgram;
        session_.advance(n);
    }
    step.demSeconds += clock.elapsedTime() - before;
    if (subStep + 1 < subSteps)
    {
        grainWatcher::tellAll(fluid_.mesh().time(), fluid_.interval());
    }

    step.add(momentum_.receive(*grains_, forces_, records_, averages_, first));
    step.received.heat += returned;
    if (heatDebts_)
    {
        heatDebts_->remember(records_, fluid_.mesh().time().deltaTValue());
    }
    step.add(grains_->numbers());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::couplingPipeline::couplingPipeline
(
    const dictionary& dict,
    carrierFluid& fluid,
    liggghtsCloud& cloud
)
:
    dict_(checkedCase(dict, fluid)),
    fluid_(fluid),
    locator_(fluid.mesh()),
    forces_(dict, fluid, locator_),
    former_(dict, fluid.mesh()),
    steps_(dict, fluid.mesh(), former_.deltaT()),
    averages_(dict, locator_),
    equations_(newEquations()),
    gas_(dynamic_cast<compressibleVoidFraction*>(equations_.get())),
    momentum_(dict, fluid),
    energy_
    (
        couplingEntries::twoWay(dict) && !energyExchange::fieldName(fluid.mesh()).empty()
      ? new energyExchange(fluid)
      : nullptr
    ),
    heat_
    (
        energy_ && forces_.requests().heat
      ? new heatExchange(fluid, energyExchange::fieldName(fluid.mesh()))
      : nullptr
    ),
    debts_
    (
        couplingEntries::twoWay(dict) && momentum_.momentum().debts()
      ? new debtTransport
        (
            debtTransport::fields
            {
                momentum_.momentum().debts(), energy_ ? &energy_->debts() : nullptr,
                momentum_.momentum().debtsOfLost(), energy_ ? &energy_->debtsOfLost() : nullptr
            }
        )
      : nullptr
    ),
    heatDebts_
    (
        heat_
      ? new debtTransport
        (
            debtTransport::fields{nullptr, &heat_->debts(), nullptr, &heat_->debtsOfLost()}
        )
      : nullptr
    ),
    inflow_(fluid),
    weights_(decompositionWeights::New(dict, fluid.mesh())),
    session_
    (
        fluid.mesh().time().globalPath(),
        dict.lookupOrDefault<fileName>("log", "log.liggghts")
    ),
    log_
    (
        fluid.mesh(), couplingEntries::twoWay(dict), steps_.subSteps() > 1,
        voidFractionEquations::full(dict), bool(energy_), bool(heat_)
    )
{
    if (energy_)
    {
        couplingEntries::onMaster([&](){ energyExchange::checkEntries(dict); });
    }
    start();
    if (energy_ && (former_.continues() || session_.counts().present > 0))
    {
        energyExchange::keepOldTimes(fluid.mesh());
    }

    vector g;
    const couplingChecks checks(dict, fluid.mesh(), session_);
    const bool hasGravity = checks.gravity(g);
    if (hasGravity)
    {
        fluid.setGravity(g);
    }
    checks.sameGravity(fluid.solverGravity(), hasGravity ? &g : nullptr);
    restart_.reset
    (
        new couplingRestart
        (
            fluid.mesh(), session_, stateFiles(), [this](){ writeState(); }, log_, former_
        )
    );
    cloud.show(session_);

    Info<< "liggghtsCoupling: " << dict.get<fileName>("script") << ", "
        << session_.counts().present
        << (former_.continues() ? " continued" : " new") << " grains, ";
    steps_.report(session_, Info);
    Info<< nl;
    forces_.report(Info);
    Info<< "    Grainjet " GRAINJET_VERSION << nl;
    Info<< "    Fluid: " << fluid.type() << nl;
    Info<< "    Void fraction in the equations: " << (equations_ ? "full" : "neglected") << nl;
    if (averages_.filter())
    {
        Info<< "    Grains are spread over " << averages_.filter()->length() << " m" << nl;
    }
    Info<< endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::couplingPipeline::advance()
{
    const clockTime clock;
    couplingLog::step step;
    step.outletCourant = inflow_.largest();

    scalar previous;
    const label n = steps_.next(session_, previous);
    fluid_.setPreviousStep(previous);
    closeFluidStep(step);

    for (label subStep = 0; subStep < steps_.subSteps(); ++subStep)
    {
        fly(subStep, n, clock, step);
    }
    momentum_.set
    (
        averages_, equations_ ? equations_->feltStress()() : vectorField::null(), energy_.get(), heat_.get()
    );

    step.stiffness = momentum_.stiffness();
    step.warnings = sessionWarnings::anyWaiting();
    step.counts = session_.countsHere();
    step.searches = locator_.searches();
    step.bytes = grains_->bytes() + averages_.shares().bytes();
    step.reduce();
    warn(step);
    step.couplingSeconds = clock.elapsedTime() - step.demSeconds;
    log_.write(step);
    if (weights_)
    {
        weights_->addClock(step, log_.fluidSeconds());
    }
}


void Foam::couplingPipeline::addSup(fvMatrix<vector>& eqn) const
{
    if (equations_)
    {
        equations_->addSup(eqn);
    }
    momentum_.addSup(eqn);
}


void Foam::couplingPipeline::addEnergySup(fvMatrix<scalar>& eqn)
{
    if (gas_)
    {
        gas_->addEnergySup(eqn);
    }
    energy_->addSup(eqn, momentum_.momentum());
    if (heat_)
    {
        heat_->addSup(eqn);
    }
}


void Foam::couplingPipeline::addTransportSup(fvMatrix<scalar>& eqn) const
{
    if (gas_)
    {
        gas_->addTransportSup(eqn);
    }
}


void Foam::couplingPipeline::addContinuitySup(fvMatrix<scalar>& eqn) const
{
    gas_->addContinuitySup(eqn);
}


// ************************************************************************* //
