/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "couplingEntries.H"
#include "grainTurbulence.H"
#include "knownEntries.H"
#include "OSspecific.H"
#include "repeatedEntry.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

typedef knownEntries::valueType valueType;

typedef knownEntries::table entryTable;

entryTable ofTheCoupling()
{
    entryTable table
    ({
        {"script", {valueType::FILE, knownEntries::REQUIRED}},
        {"couplingInterval", {valueType::COUNT, knownEntries::REQUIRED}},
        {"coupling", valueType::WORD},
        {"voidFraction", valueType::DICTIONARY},
        {"drag", valueType::WORD},
        {"forces", valueType::ANY},
        {"interpolation", valueType::WORD},
        {"wallLaw", valueType::SWITCH},
        {"turbulentDispersion", valueType::ANY},
        {"selfDisturbance", valueType::SWITCH},
        {"formulation", valueType::WORD},
        {"momentum", valueType::WORD},
        {"turbulenceSources", valueType::WORD},
        {"fluid", valueType::ANY},
        {"U", valueType::WORD},
        {"p", valueType::WORD},
        {"log", valueType::FILE}
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
            setName(e.dict(), name + '.' + e.keyword());
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


void Foam::couplingEntries::checkKnown(const word& type, const dictionary& dict)
{
    // Entries may lie in a sub-dictionary of the option's own name
    const word sub(type + "Coeffs");
    const bool apart = dict.isDict(sub);
    const dictionary& coeffs = apart ? dict.subDict(sub) : dict;

    entryTable known(ofEveryOption());
    if (apart)
    {
        known.insert(sub, valueType::DICTIONARY);
        knownEntries::check(coeffs, ofTheCoupling());
    }
    else
    {
        const entryTable entries(ofTheCoupling());
        forAllConstIters(entries, iter)
        {
            known.insert(iter.key(), *iter);
        }
    }
    knownEntries::check(dict, known);
    twoWay(coeffs);
    setI(coeffs);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::couplingEntries::isFirst
(
    const dictionary& dict,
    const word& key,
    const word& first,
    const word& second
)
{
    const word value(dict.lookupOrDefault<word>(key, first));

    if (value != first && value != second)
    {
        FatalIOErrorInFunction(dict)
            << key << ' ' << value << " must be " << first << " or " << second
            << exit(FatalIOError);
    }
    return value == first;
}


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
            checkKnown(type, dict);
        }
    );
    Pstream::scatter(location);

    dictionary result(dict);
    setName(result, location);
    return result;
}


// ************************************************************************* //
