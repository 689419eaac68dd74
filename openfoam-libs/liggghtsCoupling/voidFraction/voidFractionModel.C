/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "voidFractionModel.H"
#include "couplingEntries.H"
#include "grainFilter.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(voidFractionModel, 0);
    defineRunTimeSelectionTable(voidFractionModel, dictionary);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// With the entries of all models
Foam::knownEntries::table withCommon(const Foam::knownEntries::table& entries)
{
    typedef Foam::knownEntries knownEntries;
    knownEntries::table known(entries);
    known.insert("model", knownEntries::valueType::WORD);
    known.insert
    (
        "minimum",
        knownEntries::rule(knownEntries::valueType::FRACTION)
       .means("lower limit of the void fraction").like("0.3")
    );
    known.insert
    (
        "equations",
        knownEntries::rule(Foam::wordList({"full", "neglected"}))
       .means("the void fraction in the fluid's equations").like("full")
    );
    known.insert
    (
        "filter",
        knownEntries::rule(knownEntries::valueType::DICTIONARY).like("{ length 0; }")
    );
    return known;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::voidFractionModel::voidFractionModel
(
    const dictionary& dict,
    const cellLocator& locator,
    const knownEntries::table& entries
)
:
    minimum_(dict.lookupOrDefault<scalar>("minimum", 0.3)),
    locator_(locator)
{
    if (!knownEntries::stated(typeName_(), dict.get<word>("model")))
    {
        knownEntries::checkOnMaster(dict, withCommon(entries));
    }
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::voidFractionModel> Foam::voidFractionModel::New
(
    const dictionary& dict,
    const cellLocator& locator
)
{
    couplingEntries::onMaster([&](){ checkEntries(dict); });
    const word model(dict.get<word>("model"));

    return autoPtr<voidFractionModel>((*dictionaryConstructorTablePtr_)[model](dict, locator));
}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

void Foam::voidFractionModel::checkEntries(const dictionary& dict)
{
    knownEntries::checkModel
    (
        dict,
        knownEntries::rule
        (
            dictionaryConstructorTablePtr_->sortedToc()
        ).like("divided")
    );
    const knownEntries::table* entries = knownEntries::stated
    (
        typeName_(), dict.lookupOrDefault<word>("model", usual())
    );
    if (entries)
    {
        knownEntries::check(dict, withCommon(*entries));
    }
    grainFilter::checkEntries(dict);
}


// ************************************************************************* //
