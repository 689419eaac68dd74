/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluidSampler.H"
#include "couplingEntries.H"
#include "interpolation.H"
#include "knownEntries.H"
#include "schemeSampler.H"
#include "wallLawSampler.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(fluidSampler, 0);
    defineRunTimeSelectionTable(fluidSampler, dictionary);
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::fluidSampler> Foam::fluidSampler::New
(
    const dictionary& dict,
    const carrierFluid& fluid,
    const cellLocator& locator
)
{
    if (!dict.lookupOrDefault<bool>("wallLaw", false))
    {
        return New(dict, locator);
    }

    const word scheme(dict.lookupOrDefault<word>("interpolation", "cellPoint"));
    couplingEntries::onMaster
    (
        [&]()
        {
            if (scheme != cellPointSampler::typeName)
            {
                FatalIOErrorInEntry(dict, "wallLaw")
                    << "wallLaw yes with interpolation " << scheme << ": the law of the wall goes"
                    << " together with cellPoint only. Write interpolation cellPoint, or remove"
                    << " wallLaw" << exit(FatalIOError);
            }
        }
    );
    if (wallFunctions::laminar(fluid))
    {
        Info<< "liggghtsCoupling: wallLaw changes nothing, since the flow is laminar" << endl;
        return New(dict, locator);
    }
    return autoPtr<fluidSampler>(new wallLawSampler(dict, fluid, locator));
}


Foam::autoPtr<Foam::fluidSampler> Foam::fluidSampler::New
(
    const dictionary& dict,
    const cellLocator& locator
)
{
    const word scheme(dict.lookupOrDefault<word>("interpolation", "cellPoint"));

    couplingEntries::onMaster
    (
        [&]()
        {
            if (dict.found("interpolation"))
            {
                knownEntries::checkValue(dict, "interpolation", names());
            }
        }
    );
    auto cstrIter = dictionaryConstructorTablePtr_->cfind(scheme);

    return autoPtr<fluidSampler>
    (
        cstrIter.found() ? cstrIter()(locator).ptr() : new schemeSampler(scheme)
    );
}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::fluidSampler::names()
{
    wordHashSet all(dictionaryConstructorTablePtr_->toc());
    all.insert(interpolation<vector>::dictionaryConstructorTablePtr_->toc());
    return all.sortedToc();
}


// ************************************************************************* //
