/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainMomentum.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(grainMomentum, 0);
    defineRunTimeSelectionTable(grainMomentum, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::grainMomentum::grainMomentum(const carrierFluid& fluid)
:
    fluid_(fluid)
{}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::grainMomentum> Foam::grainMomentum::New
(
    const dictionary& dict,
    const carrierFluid& fluid
)
{
    const word model(dict.lookupOrDefault<word>("momentum", "implicit"));

    return autoPtr<grainMomentum>((*dictionaryConstructorTablePtr_)[model](fluid));
}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::grainMomentum::slope
(
    const scalar reacting,
    const scalar all,
    const scalar grain,
    const scalar added,
    const scalar dt,
    const scalar e
)
{
    if (reacting <= 0)
    {
        return 0;
    }
    const scalar mass = grain + added;
    const scalar response = -std::expm1(-all/e*dt/mass);
    return max(reacting/all*(mass/dt*response) - added/dt*response, 0.0);
}


// ************************************************************************* //
