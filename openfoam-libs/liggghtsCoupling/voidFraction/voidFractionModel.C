/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "voidFractionModel.H"
#include "couplingEntries.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(voidFractionModel, 0);
    defineRunTimeSelectionTable(voidFractionModel, dictionary);
}


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
    typedef knownEntries::valueType valueType;
    knownEntries::table known(entries);
    known.insert("model", valueType::WORD);
    known.insert("minimum", valueType::FRACTION);
    known.insert("equations", valueType::WORD);
    knownEntries::checkOnMaster(dict, known);
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::voidFractionModel> Foam::voidFractionModel::New
(
    const dictionary& dict,
    const cellLocator& locator
)
{
    word model;
    couplingEntries::onMaster([&](){ model = dict.get<word>("model"); });
    Pstream::scatter(model);

    auto cstrIter = dictionaryConstructorTablePtr_->cfind(model);

    couplingEntries::onMaster
    (
        [&]()
        {
            if (!cstrIter.found())
            {
                FatalIOErrorInLookup
                (
                    dict,
                    "model",
                    model,
                    *dictionaryConstructorTablePtr_
                ) << exit(FatalIOError);
            }
        }
    );

    return autoPtr<voidFractionModel>(cstrIter()(dict, locator));
}


// ************************************************************************* //
