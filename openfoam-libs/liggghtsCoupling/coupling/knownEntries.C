/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "knownEntries.H"
#include "couplingEntries.H"
#include "Switch.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

typedef knownEntries::valueType valueType;

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
        case valueType::NUMBER:
        {
            checkNumber
            (
                dict, key, mag(dict.get<scalar>(key)) < million, "a number below 1e6"
            );
            break;
        }
        case valueType::POSITIVE:
        {
            const scalar x = dict.get<scalar>(key);
            checkNumber
            (
                dict, key, x > 1e-15 && x < million, "positive, from 1e-15 to 1e6"
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

// How to write a model of the short form so that it has what it needs
std::string withRoom
(
    const dictionary& dict,
    const knownEntries::table& known,
    const std::string& longForm
)
{
    if (longForm.empty())
    {
        return std::string();
    }
    std::string text("\nThe short form has no room for it. Write\n    " + longForm);
    for (const word& key : known.sortedToc())
    {
        if (known[key].needed == knownEntries::REQUIRED && !dict.found(key))
        {
            text += " " + key + " ...;";
        }
    }
    const auto opened =
        std::count(text.begin(), text.end(), '{') - std::count(text.begin(), text.end(), '}');
    for (label i = 0; i < opened; ++i)
    {
        text += " }";
    }
    return text;
}

} // End anonymous namespace
} // End namespace Foam


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

void Foam::knownEntries::check
(
    const dictionary& dict,
    const table& known,
    const string& longForm
)
{
    for (const entry& e : dict)
    {
        const auto type = known.cfind(e.keyword());
        if (!type.found())
        {
            FatalIOErrorInFunction(dict)
                << "Unknown entry " << e.keyword() << " in " << dict.dictName() << ". ";
            if (known.empty())
            {
                FatalIOError << "It takes none";
            }
            else
            {
                FatalIOError << "Valid: " << flatOutput(known.sortedToc());
            }
            FatalIOError << exit(FatalIOError);
        }
        readValue(dict, e.keyword(), (*type).type);
    }
    for (const word& key : known.sortedToc())
    {
        if (known[key].needed == REQUIRED && !dict.found(key))
        {
            FatalIOErrorInFunction(dict)
                << "Entry " << key << " is missing in " << dict.dictName() << ". Valid: "
                << flatOutput(known.sortedToc()) << withRoom(dict, known, longForm).c_str()
                << exit(FatalIOError);
        }
    }
}


void Foam::knownEntries::checkOnMaster
(
    const dictionary& dict,
    const table& known,
    const string& longForm
)
{
    couplingEntries::onMaster([&](){ check(dict, known, longForm); });
}


// ************************************************************************* //
