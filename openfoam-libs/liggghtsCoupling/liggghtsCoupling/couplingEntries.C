/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "couplingEntries.H"
#include "OSspecific.H"
#include "repeatedEntry.H"
#include "Switch.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

// Numbers are finite, and below a million
enum class valueType
{
    WORD, WORDS, FILE, SWITCH, DICTIONARY, ANY,
    COUNT,          // a whole number from 1 on
    POSITIVE,       // a number above zero
    NOT_NEGATIVE,
    FRACTION        // a number above 0 and below 1
};

typedef HashTable<valueType> entryTable;

const entryTable& ofTheCoupling()
{
    static const entryTable table
    ({
        {"script", valueType::FILE},
        {"couplingInterval", valueType::COUNT},
        {"coupling", valueType::WORD},
        {"voidFraction", valueType::DICTIONARY},
        {"drag", valueType::WORD},
        {"forces", valueType::WORDS},
        {"interpolation", valueType::WORD},
        {"formulation", valueType::WORD},
        {"momentum", valueType::WORD},
        {"turbulenceSources", valueType::WORD},
        {"ChenWoodCoeffs", valueType::DICTIONARY},
        {"U", valueType::WORD},
        {"p", valueType::WORD},
        {"log", valueType::FILE}
    });
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


const entryTable& ofVoidFraction()
{
    static const entryTable table
    ({
        {"model", valueType::WORD},
        {"minimum", valueType::FRACTION}
    });
    return table;
}


const entryTable& ofChenWood()
{
    static const entryTable table
    ({
        {"B", valueType::NOT_NEGATIVE},
        {"Ce", valueType::POSITIVE},
        {"C3", valueType::NOT_NEGATIVE}
    });
    return table;
}


void checkNumber
(
    const dictionary& dict,
    const word& key,
    const bool good,
    const char* expected
)
{
    if (!good)
    {
        FatalIOErrorInFunction(dict)
            << key << ' ' << dict.lookup(key).first() << " in " << dict.dictName()
            << " must be " << expected
            << exit(FatalIOError);
    }
}


// Read a value and drop it: OpenFOAM's own functions say what is wrong with it, and where
void readValue(const dictionary& dict, const word& key, const valueType type)
{
    if (dict.isDict(key) != (type == valueType::DICTIONARY) && type != valueType::ANY)
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << key << " in " << dict.dictName()
            << (dict.isDict(key) ? " is" : " is not") << " a dictionary. Write "
            << key << (dict.isDict(key) ? " value;" : " { ... }")
            << exit(FatalIOError);
    }
    const scalar million = 1e6;
    switch (type)
    {
        case valueType::WORD: dict.get<word>(key); break;
        case valueType::WORDS: dict.get<wordList>(key); break;
        case valueType::FILE:
        {
            // Read as a file name, OpenFOAM ends the run for a blank without naming the entry
            const ITstream& is = dict.lookup(key);
            if (is.size() == 1 && is[0].isString())
            {
                const string path(is[0].stringToken());
                if (!string::valid<fileName>(path))
                {
                    FatalIOErrorInFunction(dict)
                        << key << ' ' << path << " holds a character that OpenFOAM does"
                        << " not allow in a file name, such as a blank or a quote"
                        << exit(FatalIOError);
                }
            }
            dict.get<fileName>(key);
            break;
        }
        case valueType::SWITCH: dict.get<Switch>(key); break;
        case valueType::DICTIONARY: break;
        case valueType::ANY: break;

        case valueType::COUNT:
        {
            checkNumber(dict, key, dict.get<label>(key) > 0, "a whole number from 1 on");
            break;
        }
        case valueType::POSITIVE:
        {
            const scalar x = dict.get<scalar>(key);
            checkNumber
            (
                dict, key, x > 1/million && x < million, "positive, from 1e-6 to 1e6"
            );
            break;
        }
        case valueType::NOT_NEGATIVE:
        {
            const scalar x = dict.get<scalar>(key);
            checkNumber
            (
                dict, key, x >= 0 && x < million, "not negative, and below 1e6"
            );
            break;
        }
        case valueType::FRACTION:
        {
            const scalar x = dict.get<scalar>(key);
            checkNumber(dict, key, x > 0 && x < 1, "above 0 and below 1");
            break;
        }
    }
}


void checkTable(const dictionary& dict, const entryTable& known)
{
    for (const entry& e : dict)
    {
        const auto type = known.cfind(e.keyword());
        if (!type.found())
        {
            FatalIOErrorInFunction(dict)
                << "Unknown entry " << e.keyword() << " in " << dict.dictName()
                << ". Valid: " << flatOutput(known.sortedToc())
                << exit(FatalIOError);
        }
        readValue(dict, e.keyword(), *type);
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
        checkTable(coeffs, ofTheCoupling());
    }
    else
    {
        forAllConstIters(ofTheCoupling(), iter)
        {
            known.insert(iter.key(), *iter);
        }
    }
    checkTable(dict, known);
    checkTable(coeffs.subOrEmptyDict("voidFraction"), ofVoidFraction());
    checkTable(coeffs.subOrEmptyDict("ChenWoodCoeffs"), ofChenWood());

    wordHashSet forces;
    for (const word& force : coeffs.lookupOrDefault<wordList>("forces", wordList()))
    {
        if (!forces.insert(force))
        {
            FatalIOErrorInFunction(coeffs)
                << "forces: " << force << " stands in the list twice, and would act twice."
                << " Remove one of both" << exit(FatalIOError);
        }
    }
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
            checkKnown(type, dict);
        }
    );
    Pstream::scatter(location);

    dictionary result(dict);
    result.name() = location;
    for (entry& e : result)
    {
        if (e.isDict())
        {
            e.dict().name() = location + '.' + e.keyword();
        }
    }
    return result;
}


// ************************************************************************* //
