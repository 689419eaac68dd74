/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "couplingEntries.H"
#include "decompositionWeights.H"
#include "demSteps.H"
#include "dragLaw.H"
#include "fluidSampler.H"
#include "grainFilter.H"
#include "grainForces.H"
#include "grainMomentum.H"
#include "grainTurbulence.H"
#include "knownEntries.H"
#include "OSspecific.H"
#include "releases.H"
#include "repeatedEntry.H"
#include "Time.H"
#include "voidFractionEquations.H"
#include "voidFractionModel.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

typedef knownEntries::valueType valueType;

typedef knownEntries::table entryTable;

// Words for the models of a run-time table. A coupling that is switched off needs no library of theirs
template<class Table>
wordList models(const Table& table, const bool on, const wordList& others = wordList())
{
    wordList words;
    if (on)
    {
        words = others;
        words.append(table.sortedToc());
    }
    return words;
}


entryTable ofTheCoupling(const bool on, const bool adjusted)
{
    typedef knownEntries::rule rule;
    const wordList none(1, "none");
    const string ofYourOwn
    (
        "A library with models of your own must stand in libs of system/controlDict"
    );

    entryTable table
    ({
        {
            "script",
            rule(valueType::FILE, knownEntries::REQUIRED)
           .means("the input script of LIGGGHTS, relative to the case")
           .like("\"constant/in.particles\"")
        },
        {
            "couplingInterval",
            rule(valueType::COUNT, adjusted ? knownEntries::OPTIONAL : knownEntries::REQUIRED)
           .means("DEM steps per fluid step, or per sub-step of it").like("10")
        },
        {
            "subSteps",
            rule(valueType::COUNT)
           .means("exchanges with the grains per fluid step").like("1")
        },
        {"coupling", wordList({"twoWay", "oneWay"})},
        {"voidFraction", rule(valueType::DICTIONARY).like("{ model divided; }")},
        {
            "drag",
            rule(models(*dragLaw::dictionaryConstructorTablePtr_, on)).means(ofYourOwn)
        },
        {"forces", rule(valueType::WORDS_OR_DICTIONARY).like("(pressureGradient viscous)")},
        {"interpolation", on ? fluidSampler::names() : wordList()},
        {"wallLaw", valueType::SWITCH},
        {
            "turbulentDispersion",
            rule
            (
                models(*turbulentDispersion::dictionaryConstructorTablePtr_, on, none),
                knownEntries::OPTIONAL,
                valueType::WORD_OR_DICTIONARY
            ).like("Langevin")
        },
        {"selfDisturbance", valueType::SWITCH},
        {"formulation", wordList({"SetI", "SetII"})},
        {"momentum", models(*grainMomentum::dictionaryConstructorTablePtr_, on)},
        {
            "turbulenceSources",
            models(*grainTurbulence::dictionaryConstructorTablePtr_, on, none)
        },
        {
            "fluid",
            rule
            (
                models(*carrierFluid::dictionaryConstructorTablePtr_, on),
                knownEntries::OPTIONAL,
                valueType::WORD_OR_DICTIONARY
            ).means(ofYourOwn)
        },
        {"decompositionWeights", rule(valueType::DICTIONARY).like("{ grainCost 1; }")},
        {"U", rule(valueType::WORD).means("the name of the velocity").like("U")},
        {"p", rule(valueType::WORD).means("the name of the pressure").like("p")},
        {"log", rule(valueType::FILE).means("the log file of LIGGGHTS").like("log.liggghts")}
    });

    // Coefficients of models of turbulence sources, also of those of a user's library, and of one that
    // is not selected now
    for (const word& model : grainTurbulence::dictionaryConstructorTablePtr_->toc())
    {
        table.insert(model + "Coeffs", valueType::DICTIONARY);
    }
    return table;
}


const entryTable& ofEveryOption()
{
    static const entryTable table
    ({
        {"type", valueType::WORD},
        {"active", valueType::SWITCH},
        {"libs", valueType::ANY}
    });
    return table;
}


// What was received from the master has no names
void setName(dictionary& dict, const fileName& name)
{
    dict.name() = name;
    for (entry& e : dict)
    {
        if (e.isDict())
        {
            setName(e.dict(), name + releases::inDictionary + e.keyword());
        }
    }
}

} // End anonymous namespace
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::couplingEntries::checkOnlyOne
(
    const word& name,
    const word& type,
    const dictionary& dict
)
{
    for (const entry& e : dict.parent())
    {
        word other;
        if
        (
            e.isDict() && e.keyword() != name
         && e.dict().readIfPresent("type", other) && other == type
        )
        {
            FatalIOErrorInFunction(dict.parent())
                << "Two options of type " << type << ": " << name << " and " << e.keyword()
                << ". Both would use the same log, restart files and fields, so there can"
                << " be only one, also if it is switched off by active. Put all grains into"
                << " one script and remove the other option" << exit(FatalIOError);
        }
    }
}


void Foam::couplingEntries::checkRepeated
(
    const word& name,
    const dictionary& dict,
    const fileName& file
)
{
    label line = 0;
    const word key(firstRepeatedEntry(file, name, line));

    if (!key.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << key << " of " << name << " stands in " << file
            << " twice, for the second time in line " << line
            << ". Only one of both can count: remove the other" << exit(FatalIOError);
    }
}


void Foam::couplingEntries::checkKnown
(
    const word& type,
    const dictionary& dict,
    const Time& time
)
{
    // Entries may lie in a sub-dictionary of the option's own name
    const word sub(type + "Coeffs");
    const bool apart = dict.isDict(sub);
    const dictionary& coeffs = apart ? dict.subDict(sub) : dict;

    knownEntries::checkValue(dict, "active", valueType::SWITCH);
    const bool on = dict.lookupOrDefault<Switch>("active", true);
    const entryTable entries(ofTheCoupling(on, demSteps::adjusted(time)));

    entryTable known(ofEveryOption());
    if (apart)
    {
        known.insert(sub, valueType::DICTIONARY);
        knownEntries::check(coeffs, entries);
    }
    else
    {
        forAllConstIters(entries, iter)
        {
            known.insert(iter.key(), *iter);
        }
    }
    knownEntries::check(dict, known);
    if (on)
    {
        demSteps::checkEntries(coeffs, time);
        carrierFluid::checkEntries(coeffs);
        if (coeffs.found("voidFraction"))
        {
            voidFractionModel::checkEntries(coeffs.subDict("voidFraction"));
        }
        grainForces::checkEntries(coeffs);
        turbulentDispersion::checkEntries(coeffs);
        voidFractionEquations::checkEntries(coeffs);
        grainFilter::checkCoupling(coeffs);
        decompositionWeights::checkEntries(coeffs);
    }
}


void Foam::couplingEntries::waitForMaster()
{
    bool passed = true;
    releases::fromMaster(passed);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fileName Foam::couplingEntries::file(const fvMesh& mesh)
{
    fileName used;
    for (const word& instance : {mesh.time().constant(), mesh.time().system()})
    {
        const fileName path
        (
            mesh.time().globalPath()/instance/mesh.dbDir()/"fvOptions"
        );
        if (!isFile(path))
        {
            continue;
        }
        if (used.empty())
        {
            used = path;
        }
        else
        {
            WarningInFunction
                << "OpenFOAM reads " << used << ", and " << path
                << " is never read. Remove one of both" << endl;
        }
    }
    return used;
}


Foam::dictionary Foam::couplingEntries::checked
(
    const word& name,
    const word& type,
    const dictionary& dict,
    const fvMesh& mesh
)
{
    fileName location(dict.name());
    onMaster
    (
        [&]()
        {
            checkOnlyOne(name, type, dict);
            checkRepeated(name, dict, file(mesh));
            checkKnown(type, dict, mesh.time());
        }
    );
    releases::fromMaster(location);

    dictionary result(dict);
    setName(result, location);
    return result;
}


// ************************************************************************* //
