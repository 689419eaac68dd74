/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dragLaw.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(dragLaw, 0);
    defineRunTimeSelectionTable(dragLaw, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dragLaw::dragLaw(const dictionary& dict, const knownEntries::table& entries)
{
    knownEntries::table known(entries);
    known.insert("model", knownEntries::valueType::WORD);
    knownEntries::checkOnMaster(dict, known);
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dragLaw> Foam::dragLaw::New
(
    const dictionary& dict,
    forceNeeds& needs
)
{
    const word name(dict.lookupOrDefault<word>("model", "Gidaspow"));

    auto cstrIter = dictionaryConstructorTablePtr_->cfind(name);

    if (!cstrIter.found())
    {
        FatalIOErrorInFunction(dict)
            << "Unknown drag " << name << "\n\nValid drag laws: "
            << flatOutput(dictionaryConstructorTablePtr_->sortedToc())
            << exit(FatalIOError);
    }
    return autoPtr<dragLaw>(cstrIter()(dict, needs));
}


// ************************************************************************* //
