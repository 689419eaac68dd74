/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "knownEntries.H"
#include "couplingEntries.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

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
            const string& example = known[key].example;
            text += " " + key + ' ' + (example.empty() ? "..." : example) + ';';
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


void refuseMissing
(
    const dictionary& dict,
    const word& key,
    const knownEntries::rule& known,
    const std::string& room
)
{
    // A dictionary that the short form makes has no lines
    const label start = dict.startLineNumber();
    FatalIOError
    (
        FUNCTION_NAME,
        __FILE__,
        __LINE__,
        dict.name(),
        start > 0 ? start : -1,
        start > 0 ? dict.endLineNumber() : -1
    )
        << "Entry " << key << " is missing in " << dict.dictName() << ". It must be "
        << knownEntries::mustBe(key, known).c_str() << room.c_str() << exit(FatalIOError);
}


// All statements, by base class and model
HashTable<HashTable<knownEntries::table>>& statements()
{
    static HashTable<HashTable<knownEntries::table>> all;
    return all;
}

} // End anonymous namespace
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::knownEntries::ofModel::ofModel
(
    const char* base,
    const char* model,
    const table& entries
)
{
    statements()(base).set(model, entries);
}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

const Foam::knownEntries::table* Foam::knownEntries::stated
(
    const char* base,
    const word& model
)
{
    const auto ofBase = statements().cfind(base);
    if (!ofBase.found())
    {
        return nullptr;
    }
    const auto ofModel = (*ofBase).cfind(model);
    return ofModel.found() ? &*ofModel : nullptr;
}


void Foam::knownEntries::check
(
    const dictionary& dict,
    const table& known,
    const string& longForm
)
{
    for (const entry& e : dict)
    {
        const auto rule = known.cfind(e.keyword());
        if (!rule.found())
        {
            FatalIOErrorInEntry(dict, e.keyword())
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
        checkValue(dict, e.keyword(), *rule);
    }
    for (const word& key : known.sortedToc())
    {
        if (known[key].needed == REQUIRED && !dict.found(key))
        {
            refuseMissing(dict, key, known[key], withRoom(dict, known, longForm));
        }
    }
}


void Foam::knownEntries::checkModel(const dictionary& dict, const rule& known)
{
    if (dict.found("model"))
    {
        checkValue(dict, "model", known);
    }
    else if (known.needed == REQUIRED)
    {
        refuseMissing(dict, "model", known, string());
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
