/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "temperatureGradient.H"
#include "addToRunTimeSelectionTable.H"
#include "fvcGrad.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(temperatureGradient, 0);
    addToRunTimeSelectionTable(fluidQuantity, temperatureGradient, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::temperatureGradient::temperatureGradient(const carrierFluid& fluid)
:
    fluidQuantity(fluid)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::temperatureGradient::missing() const
{
    return
        fluid_.mesh().foundObject<volScalarField>("T")
      ? string() : string("the solver has no field T");
}


Foam::tmp<Foam::volVectorField> Foam::temperatureGradient::vectorField() const
{
    return fvc::grad(fluid_.mesh().lookupObject<volScalarField>("T"));
}


// ************************************************************************* //
