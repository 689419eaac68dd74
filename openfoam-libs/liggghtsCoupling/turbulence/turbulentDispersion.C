/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "turbulentDispersion.H"
#include "couplingEntries.H"
#include "turbulenceField.H"
#include "turbulenceModel.H"

#include "physics/turbulence/wall_reflection.h"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(turbulentDispersion, 0);
    defineRunTimeSelectionTable(turbulentDispersion, dictionary);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

const char* const entryName = "turbulentDispersion";


// The dictionary of the model, from either form of the entry; empty for none
dictionary entriesOfModel(const dictionary& dict)
{
    dictionary entries;
    entries.name() = dict.name();
    if (dict.isDict(entryName))
    {
        entries = dict.subDict(entryName);
    }
    else if (dict.found(entryName))
    {
        entries.add("model", dict.get<word>(entryName));
    }
    return entries;
}


knownEntries::table withCommon(const knownEntries::table& entries)
{
    knownEntries::table all(entries);
    all.insert("model", knownEntries::valueType::WORD);
    all.insert
    (
        "seed",
        knownEntries::rule(knownEntries::valueType::COUNT)
       .means("another one gives another sample of the same turbulence").like("1")
    );
    return all;
}


// The entries of a model that does not state them by knownEntries::ofModel
void checkUnstated(const dictionary& dict, const knownEntries::table& entries)
{
    if (!knownEntries::stated(turbulentDispersion::typeName_(), dict.get<word>("model")))
    {
        knownEntries::checkOnMaster(dict, withCommon(entries));
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::turbulentDispersion::isTurbulent
(
    const dictionary& dict,
    const carrierFluid& fluid,
    const word& name
)
{
    const turbulenceModel& model = *fluid.model();
    const word type(model.get<word>("simulationType"));

    couplingEntries::onMaster
    (
        [&]()
        {
            if (type != "laminar" && type != "RAS")
            {
                FatalIOErrorInEntry(dict, entryName)
                    << entryName << ' ' << name << " needs the k of a RAS model, but this case has "
                    << model.type() << " (simulationType " << type << ", "
                    << fluid.mesh().time().constant() << '/' << turbulenceModel::propertiesName
                    << "), whose resolved eddies move the grains already. Set " << entryName
                    << " to none" << exit(FatalIOError);
            }
        }
    );
    if (type == "RAS")
    {
        const string entry(entryName);
        turbulenceField::require
        (
            fluid, "k", dict, entryName, entry + ' ' + name, entry + " none"
        );
    }
    return type == "RAS";
}


bool Foam::turbulentDispersion::isLong(grainBatch& grains, const label i) const
{
    const scalar rate = (*grains.state(rate_))[i];
    const scalar time = eddyTime(grains, i);
    return rate > 0 && sqr(dt_) > 0.04*time*(time + 1/rate);
}


void Foam::turbulentDispersion::mirror
(
    grainBatch& grains,
    const label i,
    const scalar rate,
    vector& fluctuation,
    vector& mean
) const
{
    const grainjet::turbulence::GrainWay parts(dt_, max(rate, scalar(0)));
    const point place(grainBatch::get(grains.position, i));
    vector way
    (
        parts.fluid*(grainBatch::get(grains.fluidVelocity, i) + mean)
      + parts.own_velocity*grainBatch::get(grains.velocity, i)
    );

    for (const nearWalls::plane& wall : walls_->at(grains.cell[i]))
    {
        const bool met = grainjet::turbulence::reflect_at_wall
        (
            wall.distance(place) - grains.radius[i],
            wall.normal.cdata(),
            way.data(),
            fluctuation.data(),
            mean.data()
        );
        if (met)
        {
            mirrored(grains, i, wall.normal);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::turbulentDispersion::turbulentDispersion
(
    const dictionary& dict,
    const carrierFluid& fluid,
    const knownEntries::table& entries
)
:
    dict_(dict),
    fluid_(fluid),
    seed_
    (
        (
            checkUnstated(dict, entries),
            dict.lookupOrDefault<label>("seed", 1)
        )
    ),
    nGrains_(0),
    nLong_(0),
    warned_(false)
{}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::turbulentDispersion> Foam::turbulentDispersion::New
(
    const dictionary& dict,
    forceNeeds& needs
)
{
    couplingEntries::onMaster([&](){ checkEntries(dict); });
    const dictionary entries(entriesOfModel(dict));
    const word name(entries.lookupOrDefault<word>("model", "none"));

    if (name == "none")
    {
        return nullptr;
    }

    autoPtr<turbulentDispersion> model
    (
        (*dictionaryConstructorTablePtr_)[name](entries, needs.fluid())
    );
    if (!isTurbulent(dict, needs.fluid(), name))
    {
        Info<< "    " << entryName << ' ' << name
            << " has nothing to do: the flow is laminar" << endl;
        return nullptr;
    }
    needs.begin(name, entries);
    model->ask(needs);
    model->fluctuation_ = needs.state("fluctuation", scalarList(3, Zero));
    model->rate_ = needs.state("rate", scalarList(1, -1.0));
    model->walls_.reset(new nearWalls(needs.mesh()));
    return model;
}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

void Foam::turbulentDispersion::checkEntries(const dictionary& dict)
{
    wordList names(1, "none");
    names.append(dictionaryConstructorTablePtr_->sortedToc());
    const knownEntries::rule models
    (
        knownEntries::rule(names, knownEntries::REQUIRED).like("Langevin")
    );
    if (dict.isDict(entryName))
    {
        knownEntries::checkModel(dict.subDict(entryName), models);
    }
    else if (dict.found(entryName))
    {
        knownEntries::checkValue(dict, entryName, models);
    }

    const dictionary model(entriesOfModel(dict));
    const word name(model.lookupOrDefault<word>("model", "none"));
    const knownEntries::table* entries = knownEntries::stated(typeName_(), name);
    if (entries || name == "none")
    {
        knownEntries::check(model, withCommon(entries ? *entries : knownEntries::table()));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::turbulentDispersion::summary() const
{
    return type() + ", seed " + Foam::name(seed_);
}


void Foam::turbulentDispersion::disperse(grainBatch& grains)
{
    dt_ = fluid_.interval();

    lane* state = grains.state(fluctuation_);
    const lane& rate = *grains.state(rate_);

    nGrains_ += grains.n;
    for (label i = 0; i < grains.n; ++i)
    {
        nLong_ += isLong(grains, i);
        const random numbers(seed_, grains.id[i], fluid_.intervalIndex());
        vector fluctuation(grainBatch::get(state, i));
        if (isNew(grains, i))
        {
            scalar four[4];
            numbers.normals(0, four);
            fluctuation = vector(four[0], four[1], four[2]);
        }

        vector mean;
        advance
        (
            grains, i, numbers, rate[i] > 1e-30 ? 1/rate[i] : 1e30, fluctuation, mean
        );
        mirror(grains, i, rate[i], fluctuation, mean);

        for (direction k = 0; k < 3; ++k)
        {
            state[k][i] = fluctuation[k];
            mean_[k][i] = mean[k];
        }
    }

    // Behind the last grain its numbers are repeated
    for (direction k = 0; k < 3; ++k)
    {
        for (label i = 0; i < grainBatch::size; ++i)
        {
            const label from = min(i, grains.n - 1);
            state[k][i] = state[k][from];
            mean_[k][i] = mean_[k][from];
            grains.fluidVelocity[k][i] += mean_[k][i];
        }
    }
}


void Foam::turbulentDispersion::remember(grainBatch& grains) const
{
    lane& rate = *grains.state(rate_);
    for (label i = 0; i < grainBatch::size; ++i)
    {
        rate[i] =
            (grains.Sp[i] + grains.nonReactingSp[i])/(grains.mass[i] + grains.addedMass[i]);
        keep(grains, i, exp(-rate[i]*dt_), grainBatch::get(mean_, i));
    }
}


void Foam::turbulentDispersion::checkInterval()
{
    // Once per fluid step, when all of its intervals have been seen
    if (fluid_.intervalIndex()%fluid_.subSteps() != 0)
    {
        return;
    }
    if (!warned_)
    {
        vector2D counts(nLong_, nGrains_);
        reduce(counts, sumOp<vector2D>());
        const scalar share = counts.x()/max(counts.y(), scalar(1));
        warned_ = share > 0.1;
        if (warned_)
        {
            IOWarningInFunction(dict_)
                << entryName << ' ' << type() << ": "
                << (fluid_.subSteps() > 1 ? "deltaT/subSteps " : "deltaT ") << dt_ << " s is long for "
                << label(100*share + 0.5) << " % of the grains: in an interval eddies move them by more"
                << " than a fifth of the eddy. They keep the velocity of the fluid where they come"
                << " from, which is wrong near walls. Shorten deltaT, and couplingInterval with it."
                << " This is said once" << endl;
        }
    }
    nGrains_ = nLong_ = 0;
}


// ************************************************************************* //
