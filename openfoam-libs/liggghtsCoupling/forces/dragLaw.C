/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dragLaw.H"
#include "couplingEntries.H"
#include "releases.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(dragLaw, 0);
    defineRunTimeSelectionTable(dragLaw, dictionary);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::word nameOf(const Foam::dictionary& dict)
{
    return dict.lookupOrDefault<Foam::word>("model", "Gidaspow");
}


void check(const Foam::dictionary& dict, const Foam::knownEntries::table& entries)
{
    Foam::knownEntries::table known(entries);
    known.insert("model", Foam::knownEntries::valueType::WORD);

    // In the short form the dictionary is not that of the case
    Foam::string longForm;
    if (!Foam::releases::isWithin(dict, "forces", "drag"))
    {
        longForm = "forces { drag { model " + nameOf(dict) + ";";
    }
    Foam::knownEntries::check(dict, known, longForm);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dragLaw::dragLaw(const dictionary& dict, const knownEntries::table& entries)
{
    if (!knownEntries::stated(typeName_(), nameOf(dict)))
    {
        couplingEntries::onMaster([&](){ check(dict, entries); });
    }
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dragLaw> Foam::dragLaw::New
(
    const dictionary& dict,
    forceNeeds& needs
)
{
    return autoPtr<dragLaw>((*dictionaryConstructorTablePtr_)[nameOf(dict)](dict, needs));
}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

void Foam::dragLaw::checkEntries(const dictionary& dict)
{
    knownEntries::checkModel
    (
        dict,
        knownEntries::rule(dictionaryConstructorTablePtr_->sortedToc())
       .means("A library with laws of your own must stand in libs of system/controlDict")
    );
    const knownEntries::table* entries = knownEntries::stated(typeName_(), nameOf(dict));
    if (entries)
    {
        check(dict, *entries);
    }
}


// ************************************************************************* //
