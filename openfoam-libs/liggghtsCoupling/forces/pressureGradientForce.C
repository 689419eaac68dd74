/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pressureGradientForce.H"
#include "addToRunTimeSelectionTable.H"
#include "fvcGrad.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(pressureGradientForce, 0);
    addToRunTimeSelectionTable(grainForce, pressureGradientForce, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pressureGradientForce::pressureGradientForce(const carrierFluid& fluid)
:
    grainForce(fluid)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::pressureGradientForce::addDensity(volVectorField& density) const
{
    const tmp<volVectorField> tgradp(fvc::grad(fluid_.p()));
    const vectorField& gradp = tgradp().primitiveField();

    vectorField& f = density.primitiveFieldRef();
    forAll(f, celli)
    {
        f[celli] -= fluid_.rho()*gradp[celli];
    }
}


// ************************************************************************* //
