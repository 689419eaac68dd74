/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    One step of the coupling.

\*---------------------------------------------------------------------------*/

#include "liggghtsCoupling.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

// What a guest brings to its cells before the interval
struct content
{
    scalar volume;          // m3
    scalar mass;            // kg
    vector momentum;        // kg m/s
};

// What a guest brings to its cells after the interval
struct exchanged
{
    vector impulse;         // N s, to be taken from the fluid
    scalar dragCoefficient; // kg/s
    scalar slope;           // kg/s, d(impulse)/dU/dt
    scalar mass;            // kg
};

} // End anonymous namespace

template<> struct is_contiguous<content> : std::true_type {};
template<> struct is_contiguous<exchanged> : std::true_type {};

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fv::liggghtsCoupling::fillCells(couplingLog::step& step)
{
    const UList<guestGrain>& guests = guests_->guests();

    solidVolume_ = Zero;
    scalarField mass(mesh_.nCells(), Zero);
    vectorField& momentum = particleVelocity_.primitiveFieldRef();
    momentum = Zero;

    shares_.deposit<content>
    (
        [&](const label g)
        {
            const guestGrain& grain = guests[g];
            return content
            {
                grain.volume(), grain.mass, grain.mass*grain.velocity
            };
        },
        [&](const label celli, const scalar fraction, const content& c)
        {
            solidVolume_[celli] += fraction*c.volume;
            mass[celli] += fraction*c.mass;
            momentum[celli] += fraction*c.momentum;
        }
    );

    forAll(mass, celli)
    {
        if (mass[celli] > 0)
        {
            momentum[celli] /= mass[celli];
        }
    }

    step.maxSolidFraction = gMax(scalarField(solidVolume_/mesh_.V().field()));
    step.volumeCut = voidFractionModel_->calculate(solidVolume_, voidFraction_);
}


void Foam::fv::liggghtsCoupling::evaluateFluid(couplingLog::step& step)
{
    const UList<guestGrain>& guests = guests_->guests();

    forceDensity_.primitiveFieldRef() = Zero;
    for (const grainForce& force : forces_)
    {
        force.addDensity(forceDensity_);
    }
    forceDensity_.correctBoundaryConditions();
    sampler_->update(fluid_.U(), forceDensity_, voidFraction_);

    const tmp<volScalarField> tnu(fluid_.nu());
    const scalarField& nu = tnu();

    grainjet::drag::State state;
    state.density = fluid_.rho();

    // Far enough ahead for memory to arrive
    const label ahead = 8;

    actions_.setSize(guests.size());
    forAll(guests, g)
    {
        if (g + 2*ahead < guests.size())
        {
            sampler_->soon(guests[g + 2*ahead]);
            sampler_->verySoon(guests[g + ahead]);
        }

        const guestGrain& grain = guests[g];
        const fluidSampler::sample fluid = sampler_->at(grain);
        const scalar volume = grain.volume();

        state.voidFraction = fluid.voidFraction;
        state.slipSpeed = mag(fluid.U - grain.velocity);
        state.diameter = grain.particleDiameter();
        state.viscosity = nu[grain.cell];

        fluidAction& action = actions_[g];
        action.velocity = fluid.U;
        action.dragCoefficient = drag_(state)*volume;
        action.force = volume*(fluid.force + bodyForce_);

        step.slipSum += state.slipSpeed;
    }
    step.guests = guests.size();
}


void Foam::fv::liggghtsCoupling::collectMomentum(couplingLog::step& step)
{
    const UList<guestGrain>& guests = guests_->guests();
    const scalar dt = mesh_.time().deltaTValue();

    vector orphaned;
    guests_->receiveImpulse(impulse_, orphaned);

    // Forces without reaction are no business of the fluid
    if (bodyForce_ != vector::zero)
    {
        forAll(guests, g)
        {
            impulse_[g] -= dt*guests[g].volume()*bodyForce_;
        }
    }
    step.toGrains = sum(impulse_) + orphaned;

    // SetII: the reaction of forces but drag follows below, from the cells' own fields
    if (!setI_)
    {
        forAll(guests, g)
        {
            impulse_[g] -=
                dt*(actions_[g].force - guests[g].volume()*bodyForce_);
        }
    }

    vectorField impulse(mesh_.nCells(), Zero);
    scalarField slope(mesh_.nCells(), Zero);
    scalarField& coefficient = dragCoefficient_.primitiveFieldRef();
    coefficient = Zero;
    responseTime_ = Zero;

    shares_.deposit<exchanged>
    (
        [&](const label g)
        {
            const scalar b = actions_[g].dragCoefficient;
            const scalar m = guests[g].mass;
            return exchanged{impulse_[g], b, -m/dt*std::expm1(-b*dt/m), m};
        },
        [&](const label celli, const scalar fraction, const exchanged& e)
        {
            impulse[celli] += fraction*e.impulse;
            coefficient[celli] += fraction*e.dragCoefficient;
            slope[celli] += fraction*e.slope;
            responseTime_[celli] += fraction*e.mass;
        }
    );

    if (!setI_)
    {
        impulse += dt*solidVolume_*forceDensity_.primitiveField();
    }

    responseTime_ /= coefficient + VSMALL;
    coefficient /= mesh_.V().field();
    particleMomentumSource_.primitiveFieldRef() =
        -impulse/(dt*mesh_.V().field());

    if (twoWay_)
    {
        momentum_->set(impulse, slope, dt);
    }
}


void Foam::fv::liggghtsCoupling::advance()
{
    const clockTime clock;
    couplingLog::step step;

    checkTimeStep();

    if (twoWay_)
    {
        step.toFluid = momentum_->close();
        step.owed = momentum_->owed();
    }

    guests_->locate();
    voidFractionModel_->distribute(guests_->guests(), shares_);
    fillCells(step);
    evaluateFluid(step);
    guests_->send(actions_);

    const scalar before = clock.elapsedTime();
    session_->advance(interval_);
    step.demSeconds = clock.elapsedTime() - before;

    collectMomentum(step);

    step.counts = session_->counts();
    step.outside = guests_->outside();
    step.travelling = guests_->travelling();
    step.bytes = guests_->bytes() + shares_.bytes();
    step.couplingSeconds = clock.elapsedTime() - step.demSeconds;
    log_.write(step);
}


// ************************************************************************* //
