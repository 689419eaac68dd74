/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainForce.H"
#include "releases.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(grainForce, 0);
    defineRunTimeSelectionTable(grainForce, dictionary);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// Empty if the dictionary is that of the case: in the short form it is not
Foam::string longForm(const Foam::word& name, const Foam::dictionary& dict)
{
    return
        Foam::releases::isWithin(dict, "forces", name)
      ? Foam::string() : "forces { drag { model ...; } " + name + " {";
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::grainForce::grainForce
(
    const dictionary& dict,
    const forceNeeds& needs,
    checkedElsewhere
)
:
    dict_(dict),
    fluid_(needs.fluid())
{}


Foam::grainForce::grainForce
(
    const dictionary& dict,
    const forceNeeds& needs,
    const knownEntries::table& entries
)
:
    dict_(dict),
    fluid_(needs.fluid())
{
    if (!knownEntries::stated(typeName_(), needs.model()))
    {
        knownEntries::checkOnMaster(dict, entries, longForm(needs.model(), dict));
    }
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::grainForce> Foam::grainForce::New
(
    const word& name,
    const dictionary& dict,
    forceNeeds& needs
)
{
    needs.begin(name, dict);
    return autoPtr<grainForce>((*dictionaryConstructorTablePtr_)[name](dict, needs));
}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

void Foam::grainForce::checkEntries(const word& name, const dictionary& dict)
{
    const knownEntries::table* entries = knownEntries::stated(typeName_(), name);
    if (entries)
    {
        knownEntries::check(dict, *entries, longForm(name, dict));
    }
}


// ************************************************************************* //
