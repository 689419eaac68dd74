/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "givenViscosityFluid.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(givenViscosityFluid, 0);
    addToRunTimeSelectionTable(carrierFluid, givenViscosityFluid, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::givenViscosityFluid::givenViscosityFluid
(
    const dictionary& dict,
    const fvMesh& mesh
)
:
    incompressibleFluid
    (
        dict,
        mesh,
        {{"nu", {knownEntries::valueType::POSITIVE, knownEntries::REQUIRED}}}
    ),
    nu_
    (
        IOobject("givenViscosity", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("nu", dimViscosity, coeffs_.get<scalar>("nu"))
    )
{}


// ************************************************************************* //
