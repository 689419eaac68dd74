/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainForces.H"
#include "cellSampler.H"
#include "couplingEntries.H"
#include "selfDisturbance.H"
#include "voidFractionEquations.H"

#include <algorithm>
#include <limits>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::List<Foam::Tuple2<Foam::word, Foam::dictionary>>
Foam::grainForces::readModels(const dictionary& dict)
{
    typedef Tuple2<word, dictionary> model;
    DynamicList<model> models;

    if (dict.isDict("forces"))
    {
        const dictionary& forces = dict.subDict("forces");
        if (dict.found("drag"))
        {
            FatalIOErrorInEntry(dict, "drag")
                << "drag " << dict.get<word>("drag") << " and a dictionary of forces: drag is"
                << " stated there. Remove the entry drag, and write in forces\n"
                << "    drag { model " << dict.get<word>("drag") << "; }"
                << exit(FatalIOError);
        }
        for (const entry& e : forces)
        {
            if (!e.isDict())
            {
                FatalIOErrorInEntry(forces, e.keyword())
                    << "forces: " << e.keyword() << " has no dictionary of its entries."
                    << " Write " << e.keyword()
                    << (e.keyword() == "drag" ? " { model Gidaspow; }, or another law" : " { }")
                    << exit(FatalIOError);
            }
            models.append(model(e.keyword(), e.dict()));
        }
        return List<model>(models);
    }

    // The short form: drag always acts
    dictionary drag;
    drag.name() = dict.name();
    drag.add("model", dict.lookupOrDefault<word>("drag", "Gidaspow"));
    models.append(model("drag", drag));

    dictionary none;
    none.name() = dict.name();
    wordHashSet names;
    for (const word& name : dict.lookupOrDefault<wordList>("forces", wordList()))
    {
        if (name == "drag")
        {
            FatalIOErrorInEntry(dict, "forces")
                << "forces: drag stands in the list, but it acts anyway. Remove it, and set"
                << " the law by the entry drag" << exit(FatalIOError);
        }
        if (!names.insert(name))
        {
            FatalIOErrorInEntry(dict, "forces")
                << "forces: " << name << " stands in the list twice, and would act twice."
                << " Remove one of both" << exit(FatalIOError);
        }
        models.append(model(name, none));
    }
    return List<model>(models);
}


void Foam::grainForces::fill
(
    grainBatch& batch,
    const ownedGrains& grains,
    const label first
) const
{
    const bool spin = requests().spin;
    const bool impulse = requests().impulse;
    const bool temperature = requests().needsTemperature();
    const label nStates = batch.nStateLanes();
    List<scalar> state(nStates);

    batch.n = min(grainBatch::size, grains.size() - first);
    for (label i = 0; i < grainBatch::size; ++i)
    {
        const label g = first + min(i, batch.n - 1);
        const grainData grain = grains.grain(g);

        for (direction k = 0; k < 3; ++k)
        {
            batch.position[k][i] = grain.position[k];
            batch.velocity[k][i] = grain.velocity[k];
        }
        batch.radius[i] = grain.radius;
        batch.mass[i] = grain.mass;
        batch.volume[i] = grain.volume();
        batch.particles[i] = pow3(grain.cg);
        batch.particleDiameter[i] = grain.particleDiameter();
        batch.id[i] = grain.id;
        batch.cell[i] = grain.cell;
        batch.pyramid[i] = grain.pyramid;

        if (spin)
        {
            const vector omega(grains.spin(g));
            for (direction k = 0; k < 3; ++k)
            {
                batch.spin[k][i] = omega[k];
            }
        }
        if (temperature)
        {
            batch.temperature[i] = grains.temperature(g);
            batch.heatCapacity[i] = grains.heatCapacity(g);
        }
        if (impulse)
        {
            const vector given(grains.impulse(g));
            for (direction k = 0; k < 3; ++k)
            {
                batch.impulse[k][i] = given[k];
            }
        }
        if (nStates)
        {
            grains.getState(g, state.data());
            forAll(state, k)
            {
                batch.stateLanes()[k][i] = state[k];
            }
        }
    }
}


void Foam::grainForces::letFluidChange(grainBatch& batch) const
{
    const grainBatch::lane& e = *batch.fluid(voidFraction_);

    for (label i = 0; i < grainBatch::size; ++i)
    {
        batch.Sp[i] /= e[i];
        batch.nonReactingSp[i] /= e[i];
        for (direction k = 0; k < 3; ++k)
        {
            const scalar v = batch.velocity[k][i];
            batch.fluidVelocity[k][i] = v + e[i]*(batch.fluidVelocity[k][i] - v);
        }
    }
}


void Foam::grainForces::setActions
(
    grainBatch& batch,
    ownedGrains& grains,
    const label first
) const
{
    const bool nonReacting = requests().nonReacting;
    const bool torque = requests().torque;
    const label nStates = batch.nStateLanes();
    List<scalar> state(nStates);

    for (label i = 0; i < batch.n; ++i)
    {
        fluidAction action;
        action.velocity = grainBatch::get(batch.fluidVelocity, i);
        action.dragCoefficient = batch.Sp[i];
        action.force = grainBatch::get(batch.Su, i);
        if (nonReacting)
        {
            action.nonReactingCoefficient = batch.nonReactingSp[i];
            action.nonReactingForce = grainBatch::get(batch.nonReactingSu, i);
        }
        if (torque)
        {
            action.spin = grainBatch::get(batch.fluidSpin, i);
            action.spinCoefficient = batch.spinCoefficient[i];
            action.torque = grainBatch::get(batch.torque, i);
        }
        action.addedMass = batch.addedMass[i];
        action.temperature = batch.fluidTemperature[i];
        action.heatTransferCoefficient = batch.heatTransferCoefficient[i];
        grains.set(first + i, action);

        if (nStates)
        {
            forAll(state, k)
            {
                state[k] = batch.stateLanes()[k][i];
            }
            grains.setState(first + i, state.cdata());
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::grainForces::grainForces
(
    const dictionary& dict,
    const carrierFluid& fluid,
    const cellLocator& locator
)
:
    quantities_(fluid),
    needs_
    (
        dict,
        fluid,
        quantities_,
        couplingEntries::setI(dict)
    ),
    voidFraction_(-1)
{
    needs_.begin("coupling", dict);
    U_ = needs_.quantity("U");
    if (voidFractionEquations::full(dict) && !fluid.compressible())
    {
        voidFraction_ = needs_.quantity("voidFraction");
    }

    couplingEntries::onMaster([&](){ checkEntries(dict); });
    for (const Tuple2<word, dictionary>& model : readModels(dict))
    {
        forces_.append(grainForce::New(model.first(), model.second(), needs_));
    }
    selfDisturbance::check(dict, forces_);
    dispersion_ = turbulentDispersion::New(dict, needs_);
    warnOfWalls(dict);
    sampler_ = fluidSampler::New(dict, fluid, locator);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::grainForces::report(Ostream& os) const
{
    os  << "    Forces:";
    for (const grainForce& force : forces_)
    {
        const string summary(force.summary());
        os  << ' ' << force.type();
        if (!summary.empty())
        {
            os  << " (" << summary.c_str() << ')';
        }
    }
    os  << (forces_.empty() ? " none" : "") << nl;
    if (dispersion_)
    {
        os  << "    Turbulent dispersion: " << dispersion_->summary().c_str() << nl;
    }
    sampler_->report(os);
}


Foam::scalar Foam::grainForces::act
(
    ownedGrains& grains,
    DynamicList<record>& records,
    const bool newFluid
)
{
    for (grainForce& force : forces_)
    {
        force.prepare();
    }
    quantities_.update(newFluid);

    const label n = grains.size();
    labelList cells(n);
    forAll(cells, g)
    {
        cells[g] = grains.cell(g);
    }
    sampler_->sampleIn(cells);
    sampler_->update(quantities_.interpolated());

    ownedGrains::makeRoom(records, n);
    records.setSize(n);

    scalar slipSum = 0;
    grainBatch batch(quantities_.firstLane(), needs_.firstState());
    batch.clearSums(true, true, true, true);

    // A model that reads these without asking for them gets no number, which the fixes refuse
    const auto fillWithNoNumber = [](grainBatch::lane& lane)
    {
        std::fill_n(lane.values, grainBatch::size, std::numeric_limits<scalar>::quiet_NaN());
    };
    if (!requests().spin)
    {
        for (grainBatch::lane& spin : batch.spin)
        {
            fillWithNoNumber(spin);
        }
    }
    if (!requests().needsTemperature())
    {
        fillWithNoNumber(batch.temperature);
        fillWithNoNumber(batch.heatCapacity);
    }
    const bool heat = requests().heat;
    for (label first = 0; first < n; first += grainBatch::size)
    {
        fill(batch, grains, first);
        sampler_->at(batch, batch.fluidLanes());
        cellSampler::ofCells(quantities_.ofCells(), batch, batch.fluidLanes());

        batch.clearSums
        (
            requests().nonReacting, requests().torque, requests().addedMass, heat
        );
        const grainBatch::lane* U = batch.fluid(U_);
        for (direction k = 0; k < 3; ++k)
        {
            batch.fluidVelocity[k] = U[k];
        }
        if (dispersion_)
        {
            dispersion_->disperse(batch);
        }
        for (const grainForce& force : forces_)
        {
            force.add(batch);
        }
        if (dispersion_)
        {
            dispersion_->remember(batch);
        }
        for (const grainForce& force : forces_)
        {
            force.remember(batch);
        }
        checkCoefficients(batch);

        for (label i = 0; i < batch.n; ++i)
        {
            const label g = first + i;
            const vector slip
            (
                grainBatch::get(batch.fluidVelocity, i) - grainBatch::get(batch.velocity, i)
            );
            records[g] = record
            {
                batch.Sp[i], batch.Sp[i] + batch.nonReactingSp[i], batch.mass[i],
                batch.addedMass[i],
                voidFraction_ < 0 ? 1 : batch.fluid(voidFraction_)[0][i],
                batch.heatTransferCoefficient[i], heat ? batch.heatCapacity[i] : 0,
                batch.undisturbedTemperature[i],
                heat ? batch.fluidTemperature[i] - batch.temperature[i] : 0,
                slip
            };
            slipSum += mag(slip);
        }

        if (voidFraction_ >= 0)
        {
            letFluidChange(batch);
        }
        setActions(batch, grains, first);
    }
    checkRequested(batch);
    if (dispersion_)
    {
        dispersion_->checkInterval();
    }
    grains.send();
    return slipSum;
}


Foam::vector Foam::grainForces::stressDensity(const label celli) const
{
    vector sum(Zero);
    for (const grainForce& force : forces_)
    {
        sum += force.stressDensity(celli);
    }
    return sum;
}


// ************************************************************************* //
