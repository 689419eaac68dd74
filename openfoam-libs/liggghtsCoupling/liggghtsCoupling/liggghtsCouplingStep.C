/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    One step of the coupling.

\*---------------------------------------------------------------------------*/

#include "liggghtsCoupling.H"
#include "noFloatTraps.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fv::liggghtsCoupling::emptyCells()
{
    scalarField& eps = voidFraction_.primitiveFieldRef();
    vectorField& velocity = particleVelocity_.primitiveFieldRef();

    for (const label celli : occupied_.former())
    {
        if (!occupied_.holds(celli))
        {
            eps[celli] = 1;
            velocity[celli] = Zero;
            dragCoefficient_[celli] = 0;
            particleMomentumSource_[celli] = Zero;
            responseTime_[celli] = 0;
        }
    }
}


void Foam::fv::liggghtsCoupling::locateGrains()
{
    const auto content = [](const guestGrain& grain)
    {
        return cellContent
        {
            grain.volume(), grain.mass, grain.mass*grain.velocity
        };
    };
    const auto add =
        [&](const label celli, const scalar fraction, const cellContent& c)
        {
            cellContent& sum = occupied_.sum(contents_, celli);
            sum.volume += fraction*c.volume;
            sum.mass += fraction*c.mass;
            sum.momentum += fraction*c.momentum;
        };

    occupied_.clear();
    contents_.clear();

    // What is read of a grain to find its cell serves for the cell's sums as well
    shares_.clear();
    guests_->locate
    (
        [&](const label first, const UList<guestGrain>& guests)
        {
            label part = shares_.size();
            voidFractionModel_->share(first, guests, shares_);
            forAll(guests, i)
            {
                const guestGrain& guest = guests[i];
                part = shares_.depositOne
                (
                    part, first + i, guest.cell, content(guest), add
                );
            }
        }
    );
    shares_.settle([&](const label g){ return guests_->cell(g); });
    shares_.depositRest<cellContent>
    (
        [&](const label g){ return content(guests_->guest(g)); },
        add
    );
}


void Foam::fv::liggghtsCoupling::fillCells(couplingLog::step& step)
{
    scalarField& eps = voidFraction_.primitiveFieldRef();
    vectorField& velocity = particleVelocity_.primitiveFieldRef();
    const scalarField& V = mesh_.V();

    forAll(contents_, i)
    {
        const label celli = occupied_.cells()[i];
        const cellContent& c = contents_[i];
        const scalar solid = c.volume/V[celli];
        scalar cut = 0;

        velocity[celli] = c.momentum/c.mass;
        eps[celli] = voidFractionModel_->limited(solid, cut);
        step.volumeCut += cut*V[celli];
        step.maxSolidFraction = max(step.maxSolidFraction, solid);
    }
    voidFraction_.correctBoundaryConditions();
}


void Foam::fv::liggghtsCoupling::evaluateFluid(couplingLog::step& step)
{
    forceDensity_.primitiveFieldRef() = Zero;
    for (const grainForce& force : forces_)
    {
        force.addDensity(forceDensity_);
    }
    forceDensity_.correctBoundaryConditions();
    sampler_->update(fluid_.U(), forceDensity_, voidFraction_);

    const tmp<volScalarField> tnu(fluid_.nu());
    const scalarField& nu = tnu();

    const label n = guests_->size();
    guestGrains::makeRoom(records_, n);
    records_.setSize(n);
    guestGrains::makeRoom(force_, setI_ ? 0 : n);
    force_.setSize(setI_ ? 0 : n);

    // Many guests at once, since interpolation and the drag law take many. Memory that the next
    // ones need is asked for while these are at work
    typedef grainjet::drag::Batch Batch;
    Batch batch(fluid_.rho());
    fluidSampler::sample fluid[Batch::SIZE];
    guestGrain grains[Batch::SIZE];

    for (label first = 0; first < n; first += Batch::SIZE)
    {
        const label last = min(first + Batch::SIZE, n);
        for (label g = first; g < last; ++g)
        {
            if (g + 2*Batch::SIZE < n)
            {
                const label far = g + 2*Batch::SIZE;
                sampler_->soon(guests_->cell(far), guests_->pyramid(far));
                __builtin_prefetch(&nu[guests_->cell(far)]);
            }
            grains[g - first] = guests_->guest(g);
        }
        sampler_->at(UList<guestGrain>(grains, last - first), fluid);

        for (label g = first; g < last; ++g)
        {
            const label i = g - first;
            const guestGrain& grain = grains[i];
            records_[g].mass = grain.mass;
            records_[g].volume = grain.volume();

            batch.voidFraction[i] = fluid[i].voidFraction;
            batch.slipSpeed[i] = mag(fluid[i].U - grain.velocity);
            batch.diameter[i] = grain.particleDiameter();
            batch.viscosity[i] = nu[grain.cell];
            step.slipSum += batch.slipSpeed[i];
        }

        drag_(batch);

        for (label g = first; g < last; ++g)
        {
            if (g + Batch::SIZE < n)
            {
                sampler_->verySoon(guests_->pyramid(g + Batch::SIZE));
            }

            const label i = g - first;
            const scalar volume = records_[g].volume;
            const scalar dragCoefficient = batch.drag[i]*volume;
            records_[g].dragCoefficient = dragCoefficient;
            guests_->give
            (
                g,
                fluidAction
                {
                    fluid[i].U, dragCoefficient, volume*(fluid[i].force + bodyForce_)
                }
            );
            if (!setI_)
            {
                force_[g] = volume*fluid[i].force;
            }
        }
    }
    step.guests = n;
    guests_->send();
}


void Foam::fv::liggghtsCoupling::collectMomentum(couplingLog::step& step)
{
    const scalar dt = mesh_.time().deltaTValue();
    const scalarField& V = mesh_.V();

    exchanged_.clear();
    exchanged_.setSize(occupied_.cells().size(), cellExchange{});

    step.toGrains = guests_->receiveImpulse
    (
        impulse_,
        [&](const label celli, const vector& impulse)
        {
            occupied_.sum(exchanged_, celli).impulse += impulse;
        }
    );

    // Forces without reaction are no business of the fluid
    if (bodyForce_ != vector::zero)
    {
        forAll(impulse_, g)
        {
            const vector ownImpulse = dt*records_[g].volume*bodyForce_;
            impulse_[g] -= ownImpulse;
            step.toGrains -= ownImpulse;
        }
    }

    // SetII: the reaction of forces but drag follows below, from the cells' own fields
    forAll(force_, g)
    {
        impulse_[g] -= dt*force_[g];
    }

    shares_.deposit<cellExchange>
    (
        guests_->size(),
        [&](const label g){ return guests_->cell(g); },
        [&](const label g)
        {
            const scalar b = records_[g].dragCoefficient;
            const scalar m = records_[g].mass;
            return cellExchange
            {
                impulse_[g], b, twoWay_ ? -m/dt*std::expm1(-b*dt/m) : 0, m
            };
        },
        [&](const label celli, const scalar fraction, const cellExchange& e)
        {
            cellExchange& sum = occupied_.sum(exchanged_, celli);
            sum.impulse += fraction*e.impulse;
            sum.dragCoefficient += fraction*e.dragCoefficient;
            sum.slope += fraction*e.slope;
            sum.mass += fraction*e.mass;
        }
    );

    const labelUList& cells = occupied_.cells();
    if (!setI_)
    {
        forAll(contents_, i)
        {
            exchanged_[i].impulse +=
                dt*contents_[i].volume*forceDensity_[cells[i]];
        }
    }

    vectorField impulse(cells.size());
    scalarField slope(cells.size());
    forAll(cells, i)
    {
        const label celli = cells[i];
        const cellExchange& e = exchanged_[i];

        impulse[i] = e.impulse;
        slope[i] = e.slope;
        responseTime_[celli] = e.mass/(e.dragCoefficient + VSMALL);
        dragCoefficient_[celli] = e.dragCoefficient/V[celli];
        particleMomentumSource_[celli] = -e.impulse/(dt*V[celli]);
    }

    if (twoWay_)
    {
        momentum_->set(cells, impulse, slope, dt);
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

    locateGrains();
    emptyCells();
    fillCells(step);
    evaluateFluid(step);

    const scalar before = clock.elapsedTime();
    {
        const noFloatTraps asInTheStockProgram;
        session_->advance(interval_);
    }
    // What the other ranks wait for the slowest is time of DEM, not of the coupling
    returnReduce(label(0), maxOp<label>());
    step.demSeconds = clock.elapsedTime() - before;

    collectMomentum(step);

    step.counts = session_->counts();
    step.left = guests_->left();
    step.outside = guests_->outside();
    step.travelling = guests_->travelling();
    step.searches = locator_.searches();
    step.bytes = guests_->bytes() + shares_.bytes();
    step.couplingSeconds = clock.elapsedTime() - step.demSeconds;
    log_.write(step);
}


// ************************************************************************* //
