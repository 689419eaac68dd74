/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dragLaw.H"
#include "couplingEntries.H"

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

    // In the short form the dictionary is not that of the case
    string longForm;
    if (!dict.name().ends_with(".forces.drag"))
    {
        longForm = "forces { drag { model " + dict.lookupOrDefault<word>("model", "...") + ";";
    }
    knownEntries::checkOnMaster(dict, known, longForm);
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dragLaw> Foam::dragLaw::New
(
    const dictionary& dict,
    forceNeeds& needs
)
{
    word name;
    const auto read = [&]()
    {
        name = dict.lookupOrDefault<word>("model", "Gidaspow");
        if (!dictionaryConstructorTablePtr_->found(name))
        {
            FatalIOErrorInFunction(dict)
                << "Unknown drag " << name << "\n\nValid drag laws: "
                << flatOutput(dictionaryConstructorTablePtr_->sortedToc())
                << "\nA library with laws of your own must stand in libs of"
                << " system/controlDict" << exit(FatalIOError);
        }
    };
    couplingEntries::onMaster(read);
    read();

    return autoPtr<dragLaw>((*dictionaryConstructorTablePtr_)[name](dict, needs));
}


// ************************************************************************* //
