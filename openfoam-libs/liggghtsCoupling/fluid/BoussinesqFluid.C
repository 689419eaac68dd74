/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "BoussinesqFluid.H"
#include "addToRunTimeSelectionTable.H"
#include "fluidKinds.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(BoussinesqFluid, 0);
    addToRunTimeSelectionTable(carrierFluid, BoussinesqFluid, dictionary);
    const knownEntries::ofModel BoussinesqEntries
    (
        carrierFluid::typeName_(), BoussinesqFluid::typeName_()
    );
    const fluidKinds BoussinesqKind
    (
        BoussinesqFluid::typeName_(), "buoyantBoussinesqPimpleFoam", &BoussinesqFluid::misfit
    );
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const char* const weightName = "rhok";

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::BoussinesqFluid::BoussinesqFluid(const dictionary& dict, const fvMesh& mesh)
:
    incompressibleFluid(dict, mesh),
    pressure_(mesh)
{}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

Foam::string Foam::BoussinesqFluid::misfit(const fvMesh& mesh)
{
    if (!mesh.foundObject<volScalarField>(weightName))
    {
        return string("it has no density for buoyancy, ") + weightName;
    }
    return hydrostaticPressure::missing(mesh);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::volVectorField> Foam::BoussinesqFluid::weight() const
{
    return
        rho()*pressure_.ofSameTime(mesh_.lookupObject<volScalarField>(weightName))
       *dimensionedVector("g", dimAcceleration, pressure_.g());
}


Foam::tmp<Foam::volVectorField> Foam::BoussinesqFluid::gradP() const
{
    return rho()*pressure_.gradient
    (
        pressure_.ofSameTime(mesh_.lookupObject<volScalarField>(weightName))
    );
}


// ************************************************************************* //
