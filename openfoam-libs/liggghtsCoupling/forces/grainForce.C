/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainForce.H"
#include "couplingEntries.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(grainForce, 0);
    defineRunTimeSelectionTable(grainForce, dictionary);
}


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
    // In the short form the dictionary is not that of the case
    string longForm;
    if (!dict.name().ends_with(".forces." + needs.model()))
    {
        longForm = "forces { drag { model ...; } " + needs.model() + " {";
    }
    knownEntries::checkOnMaster(dict, entries, longForm);
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::grainForce> Foam::grainForce::New
(
    const word& name,
    const dictionary& dict,
    forceNeeds& needs
)
{
    auto cstrIter = dictionaryConstructorTablePtr_->cfind(name);

    couplingEntries::onMaster
    (
        [&]()
        {
            if (!cstrIter.found())
            {
                FatalIOErrorInFunction(dict)
                    << "Unknown force " << name << "\n\nValid forces: "
                    << flatOutput(dictionaryConstructorTablePtr_->sortedToc())
                    << "\nA library with models of your own must stand in libs of"
                    << " system/controlDict" << exit(FatalIOError);
            }
        }
    );

    needs.begin(name, dict);
    return autoPtr<grainForce>(cstrIter()(dict, needs));
}


// ************************************************************************* //
