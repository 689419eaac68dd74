/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "carrierFluid.H"
#include "couplingEntries.H"
#include "IOdictionary.H"
#include "turbulenceModel.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

// Wide enough for any fluid, and narrow enough that no product of such numbers overflows
const scalar smallest = 1e-15;
const scalar largest = 1e15;


// OpenFOAM aborts with a stack trace if the dimensions are wrong: pass its words on
scalar readValue(const dictionary& properties)
{
    scalar value = 0;
    string wrong;

    const bool throwing = FatalIOError.throwExceptions();
    try
    {
        value = dimensionedScalar("rho", dimDensity, properties).value();
    }
    catch (const IOerror& err)
    {
        wrong = err.message();
    }
    FatalIOError.throwExceptions(throwing);

    if (!wrong.empty())
    {
        FatalIOErrorInFunction(properties)
            << "rho, the density of the fluid, cannot be read: " << wrong.c_str()
            << "    Write, for air, rho [1 -3 0 0 0 0 0] 1.2;" << exit(FatalIOError);
    }
    return value;
}


scalar readDensity(const fvMesh& mesh)
{
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

    // The master has the lines of the file
    couplingEntries::onMaster([&](){ readValue(properties); });

    const scalar rho = readValue(properties);
    if (!(rho > smallest && rho < largest))
    {
        FatalIOErrorInFunction(properties)
            << "rho " << rho << " is not positive or out of bounds (" << smallest << " to "
            << largest << "): it is the density of the fluid in kg/m3" << exit(FatalIOError);
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


const Foam::turbulenceModel* Foam::carrierFluid::model() const
{
    return mesh_.cfindObject<turbulenceModel>(turbulenceModel::propertiesName);
}


Foam::tmp<Foam::volScalarField> Foam::carrierFluid::nu() const
{
    return model()->nu();
}


void Foam::carrierFluid::checkViscosity(const dictionary& dict) const
{
    if (!model())
    {
        FatalIOErrorInFunction(dict)
            << "The solver has no model of turbulence or of laminar flow ("
            << turbulenceModel::propertiesName << "), from which grains take the viscosity."
            << " Take a solver that has one, such as pimpleFoam or pisoFoam"
            << exit(FatalIOError);
    }

    const tmp<volScalarField> tnu(nu());
    const scalar low = gMin(tnu().primitiveField());
    const scalar high = gMax(tnu().primitiveField());
    if (!(low > smallest && high < largest))
    {
        FatalIOErrorInFunction(dict)
            << "nu, the viscosity of the fluid (" << mesh_.time().constant()
            << "/transportProperties), is " << low << " to " << high
            << " m2/s. Drag on grains needs one that is positive and within " << smallest
            << " to " << largest << exit(FatalIOError);
    }
}


// ************************************************************************* //
