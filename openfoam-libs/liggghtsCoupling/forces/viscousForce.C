/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "viscousForce.H"
#include "addToRunTimeSelectionTable.H"
#include "fvcLaplacian.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(viscousForce, 0);
    addToRunTimeSelectionTable(grainForce, viscousForce, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::viscousForce::viscousForce(const carrierFluid& fluid)
:
    grainForce(fluid)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::viscousForce::addDensity(volVectorField& density) const
{
    density.primitiveFieldRef() +=
        fluid_.rho()
       *fvc::laplacian(fluid_.nu(), fluid_.U())().primitiveField();
}


// ************************************************************************* //
