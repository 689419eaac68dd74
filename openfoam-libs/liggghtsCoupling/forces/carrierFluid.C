/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "carrierFluid.H"
#include "IOdictionary.H"
#include "turbulenceModel.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::scalar readDensity(const Foam::fvMesh& mesh)
{
    using namespace Foam;

    const IOdictionary properties
    (
        IOobject
        (
            "transportProperties",
            mesh.time().constant(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );

    if (!properties.found("rho"))
    {
        FatalIOErrorInFunction(properties)
            << "Entry rho (density of the fluid) not found; grains need it although"
            << " an incompressible solver does not. Add, for air,\n"
            << "    rho     [1 -3 0 0 0 0 0] 1.2;"
            << exit(FatalIOError);
    }

    const scalar rho
    (
        dimensionedScalar("rho", dimDensity, properties).value()
    );
    if (rho <= 0)
    {
        FatalIOErrorInFunction(properties)
            << "rho " << rho << " is not positive: it is the density of the fluid"
            << " in kg/m3" << exit(FatalIOError);
    }
    return rho;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::carrierFluid::carrierFluid(const dictionary& dict, const fvMesh& mesh)
:
    mesh_(mesh),
    UName_(dict.lookupOrDefault<word>("U", "U")),
    pName_(dict.lookupOrDefault<word>("p", "p")),
    rho_(readDensity(mesh)),
    g_(Zero)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::volVectorField& Foam::carrierFluid::U() const
{
    return mesh_.lookupObject<volVectorField>(UName_);
}


const Foam::volScalarField& Foam::carrierFluid::p() const
{
    return mesh_.lookupObject<volScalarField>(pName_);
}


Foam::tmp<Foam::volScalarField> Foam::carrierFluid::nu() const
{
    return mesh_.lookupObject<turbulenceModel>
    (
        turbulenceModel::propertiesName
    ).nu();
}


// ************************************************************************* //
