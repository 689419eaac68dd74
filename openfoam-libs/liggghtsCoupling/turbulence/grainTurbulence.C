/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainTurbulence.H"
#include "couplingEntries.H"
#include "entryError.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(grainTurbulence, 0);
    defineRunTimeSelectionTable(grainTurbulence, dictionary);
}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::grainTurbulence> Foam::grainTurbulence::New
(
    const dictionary& dict,
    const fvMesh& mesh
)
{
    const word model(dict.lookupOrDefault<word>("turbulenceSources", "none"));

    if (model == "none")
    {
        return autoPtr<grainTurbulence>();
    }

    couplingEntries::onMaster
    (
        [&]()
        {
            if (!couplingEntries::twoWay(dict))
            {
                FatalIOErrorInEntry(dict, "turbulenceSources")
                    << "turbulenceSources " << model << " needs coupling twoWay: with oneWay the fluid"
                    << " feels nothing of the grains" << exit(FatalIOError);
            }
        }
    );

    return autoPtr<grainTurbulence>((*dictionaryConstructorTablePtr_)[model](dict, mesh));
}


// ************************************************************************* //
