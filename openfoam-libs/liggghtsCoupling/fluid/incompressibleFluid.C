/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "incompressibleFluid.H"
#include "addToRunTimeSelectionTable.H"
#include "couplingEntries.H"
#include "entryError.H"
#include "fluidKinds.H"
#include "fvcLaplacian.H"
#include "fvMatrices.H"
#include "IOdictionary.H"
#include "StringStream.H"
#include "surfaceFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(incompressibleFluid, 0);
    addToRunTimeSelectionTable(carrierFluid, incompressibleFluid, dictionary);
    const knownEntries::ofModel incompressibleEntries
    (
        carrierFluid::typeName_(), incompressibleFluid::typeName_()
    );
    const fluidKinds incompressibleKind
    (
        incompressibleFluid::typeName_(), "pimpleFoam and pisoFoam", &incompressibleFluid::misfit
    );
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

// OpenFOAM aborts with a stack trace if the dimensions are wrong or there is a dictionary, which cannot be caught
// from v2112 on: these are looked for here
string unreadable(const dictionary& properties, scalar& value)
{
    if (properties.isDict("rho"))
    {
        return "it is a dictionary\n";
    }
    try
    {
        ITstream& is = properties.lookup("rho");
        token first(is);
        if (first.isWord())
        {
            is >> first;
        }
        if (first == token::BEGIN_SQR)
        {
            is.putBack(first);
            dimensionSet dimensions(dimless);
            scalar multiplier;
            dimensions.read(is, multiplier);
            if (dimensions != dimDensity)
            {
                OStringStream os;
                os  << "its dimensions are " << dimensions << ", not " << dimDensity << nl;
                return os.str();
            }
        }
        value = dimensionedScalar("rho", dimDensity, properties).value();
        return string();
    }
    catch (const IOerror& err)
    {
        return err.message();
    }
}


scalar readValue(const dictionary& properties)
{
    scalar value = 0;
    const bool throwing = FatalIOError.throwExceptions();
    const string wrong(unreadable(properties, value));
    FatalIOError.throwExceptions(throwing);

    if (!wrong.empty())
    {
        couplingEntries::onMaster
        (
            [&]()
            {
                FatalIOErrorInEntry(properties, "rho")
                    << "rho, the density of the fluid, cannot be read: " << wrong.c_str()
                    << "    Write, for air, rho [1 -3 0 0 0 0 0] 1.2;" << exit(FatalIOError);
            }
        );
    }
    return value;
}


scalar readDensity(const fvMesh& mesh, const scalar smallest, const scalar largest)
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
        couplingEntries::onMaster
        (
            [&]()
            {
                FatalIOErrorInFunction(properties)
                    << "Entry rho (density of the fluid) not found; grains need it although"
                    << " an incompressible solver does not. Add, for air,\n"
                    << "    rho     [1 -3 0 0 0 0 0] 1.2;"
                    << exit(FatalIOError);
            }
        );
    }

    // The master has the lines of the file
    couplingEntries::onMaster([&](){ readValue(properties); });

    const scalar rho = readValue(properties);
    if (!(rho >= smallest && rho <= largest))
    {
        couplingEntries::onMaster
        (
            [&]()
            {
                FatalIOErrorInEntry(properties, "rho")
                    << "rho " << rho << " is not positive or out of bounds (" << smallest << " to "
                    << largest << "): it is the density of the fluid in kg/m3"
                    << exit(FatalIOError);
            }
        );
    }
    return rho;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::incompressibleFluid::incompressibleFluid
(
    const dictionary& dict,
    const fvMesh& mesh,
    const knownEntries::table& entries
)
:
    carrierFluid(dict, mesh, entries),
    rhoValue_(readDensity(mesh, smallest, largest)),
    rho_
    (
        IOobject
        (
            "rho",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh,
        dimensionedScalar("rho", dimDensity, rhoValue_)
    )
{}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

Foam::string Foam::incompressibleFluid::misfit(const fvMesh& mesh)
{
    const word phase(fluidKinds::beginsWith(mesh, "alpha."));
    if (!phase.empty())
    {
        return "it is a multiphase solver (it has the phase fraction " + phase + ')';
    }
    const word thermo(fluidKinds::beginsWith(mesh, "thermophysicalProperties"));
    if (!thermo.empty())
    {
        return "it is a compressible solver (it has read constant/" + thermo + ')';
    }
    const auto* phi = mesh.cfindObject<surfaceScalarField>("phi");
    if (phi && phi->dimensions() == dimMass/dimTime)
    {
        return "it is a compressible solver (its flux phi is one of mass)";
    }
    for (const char* density : {"rho", "rhok"})
    {
        if (mesh.foundObject<volScalarField>(density))
        {
            return string("its density is not uniform (it has a field ") + density + ')';
        }
    }
    return string();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::incompressibleFluid::check() const
{
    checkField<volVectorField>("U", dimVelocity);
    checkField<volScalarField>("p", dimPressure/dimDensity);
}


Foam::tmp<Foam::volScalarField> Foam::incompressibleFluid::rho() const
{
    return rho_;
}


Foam::tmp<Foam::volVectorField> Foam::incompressibleFluid::divTau() const
{
    const tmp<volScalarField> tnu(nu());
    const word scheme("laplacian(" + tnu().name() + ',' + UName_ + ')');
    return rho_*fvc::laplacian(tnu(), velocity(), scheme);
}


void Foam::incompressibleFluid::checkEquation(const fvMatrix<vector>& eqn) const
{
    checkEquationIs(eqn, dimForce/dimDensity, "which is divided by density");
}


// ************************************************************************* //
