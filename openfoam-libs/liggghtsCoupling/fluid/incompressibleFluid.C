/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "incompressibleFluid.H"
#include "addToRunTimeSelectionTable.H"
#include "couplingEntries.H"
#include "entryError.H"
#include "fvcLaplacian.H"
#include "fvMatrices.H"
#include "IOdictionary.H"
#include "OSspecific.H"
#include "surfaceFields.H"
#include "turbulenceModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(incompressibleFluid, 0);
    addToRunTimeSelectionTable(carrierFluid, incompressibleFluid, dictionary);
    const knownEntries::ofModel incompressibleEntries
    (
        carrierFluid::typeName_(), incompressibleFluid::typeName_()
    );
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

// Wide enough for any fluid, and narrow enough that no product of such numbers overflows
const scalar smallest = 1e-15;
const scalar largest = 1e15;


const char* const fitting =
    "Grains can be coupled to solvers for one incompressible fluid that march in time, such as"
    " pimpleFoam and pisoFoam";


bool beginsWith(const std::string& text, const std::string& start)
{
    return text.compare(0, start.size(), start) == 0;
}


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
        FatalIOErrorInEntry(properties, "rho")
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


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::string Foam::incompressibleFluid::misfit() const
{
    for (const word& name : mesh_.sortedNames())
    {
        if (beginsWith(name, "alpha."))
        {
            return "is a multiphase solver (it has the phase fraction " + name + ')';
        }
        if (name == "phaseProperties")
        {
            return "is a multiphase solver (it has read constant/phaseProperties)";
        }
    }
    for (const word& name : mesh_.sortedNames())
    {
        if (beginsWith(name, "thermophysicalProperties"))
        {
            return "is a compressible solver (it has read constant/" + name + ')';
        }
        if (name == "SRFProperties")
        {
            return "solves for the velocity relative to a rotating frame (it has read"
                " constant/SRFProperties), while grains move in the frame at rest";
        }
    }

    const auto* phi = mesh_.cfindObject<surfaceScalarField>("phi");
    if (phi && phi->dimensions() == dimMass/dimTime)
    {
        return "is a compressible solver (its flux phi is one of mass)";
    }
    if (mesh_.foundObject<volScalarField>("rho"))
    {
        return "is a compressible or multiphase solver (it has a field of density, rho)";
    }

    const auto* control = mesh_.cfindObject<regIOobject>("solutionControl");
    if (control && control->type() == "simpleControl")
    {
        return "is a steady solver (its algorithm is SIMPLE), while grains need the time";
    }
    return string();
}


const Foam::fvMesh& Foam::incompressibleFluid::checkedMesh() const
{
    const string solver(Foam::getEnv("FOAM_EXECUTABLE"));
    const string reason(misfit());

    if (!reason.empty())
    {
        FatalIOErrorInFunction(dict_)
            << (solver.empty() ? "This solver" : solver.c_str()) << ' ' << reason.c_str()
            << ", which liggghtsCoupling does not support.\n    " << fitting
            << exit(FatalIOError);
    }

    // Local or no time steps: cells would have other times than the grains
    const dictionary& schemes = mesh_.schemesDict().subOrEmptyDict("ddtSchemes");
    for (const word& key : {word("ddt(" + UName_ + ')'), word("default")})
    {
        if (schemes.found(key))
        {
            const tokenList& scheme = schemes.lookup(key);
            for (const token& t : scheme)
            {
                if
                (
                    t.isWord()
                 && wordHashSet({"steadyState", "localEuler", "SLTS", "CoEuler"})
                   .found(t.wordToken())
                )
                {
                    FatalIOErrorInEntry(schemes, key)
                        << "ddtSchemes: " << key << ' ' << t.wordToken()
                        << " has no time that all cells and the grains share, which"
                        << " liggghtsCoupling does not support. Take, for instance, Euler.\n    "
                        << fitting << exit(FatalIOError);
                }
            }
            break;
        }
    }
    return mesh_;
}


template<class FieldType>
void Foam::incompressibleFluid::checkField
(
    const word& key,
    const dimensionSet& dimensions,
    const bool required
) const
{
    const word name(dict_.lookupOrDefault<word>(key, key));
    const FieldType* field = mesh_.cfindObject<FieldType>(name);

    if (!field)
    {
        if (required || dict_.found(key))
        {
            couplingEntries::onMaster
            (
                [&]()
                {
                    FatalIOErrorInEntry(dict_, key)
                        << key << ' ' << name << ": there is no " << FieldType::typeName
                        << " of this name. Those that the solver has are "
                        << flatOutput(mesh_.sortedNames<FieldType>())
                        << exit(FatalIOError);
                }
            );
        }
        return;
    }
    if (field->dimensions() != dimensions)
    {
        couplingEntries::onMaster
        (
            [&]()
            {
                FatalIOErrorInEntry(dict_, key)
                    << key << ' ' << name << ": the field has the dimensions "
                    << field->dimensions() << " instead of " << dimensions
                    << ", those of an incompressible solver. See the entry dimensions of "
                    << mesh_.time().timeName(mesh_.time().startTime().value())/name
                    << exit(FatalIOError);
            }
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::incompressibleFluid::incompressibleFluid
(
    const dictionary& dict,
    const fvMesh& mesh,
    const knownEntries::table& entries
)
:
    carrierFluid(dict, mesh, entries),
    rhoValue_(readDensity(checkedMesh())),
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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::incompressibleFluid::check() const
{
    checkField<volVectorField>("U", dimVelocity, true);
    checkField<volScalarField>("p", dimPressure/dimDensity, true);
}


void Foam::incompressibleFluid::checkViscosity() const
{
    if (!model())
    {
        FatalIOErrorInFunction(dict_)
            << "The solver has no model of turbulence or of laminar flow ("
            << turbulenceModel::propertiesName << "), from which grains take the viscosity."
            << " Take a solver that has one, such as pimpleFoam or pisoFoam"
            << exit(FatalIOError);
    }

    const tmp<volScalarField> tnu(nu());
    const scalar low = gMin(tnu().primitiveField());
    const scalar high = gMax(tnu().primitiveField());
    if (!(low >= smallest && high <= largest))
    {
        couplingEntries::onMaster
        (
            [&]()
            {
                FatalIOErrorInFunction(dict_)
                    << "nu, the viscosity of the fluid (" << mesh_.time().constant()
                    << "/transportProperties), is " << low << " to " << high
                    << " m2/s. Drag on grains needs one that is positive and within " << smallest
                    << " to " << largest << exit(FatalIOError);
            }
        );
    }
}


const Foam::volVectorField& Foam::incompressibleFluid::U() const
{
    return mesh_.lookupObject<volVectorField>(UName_);
}


const Foam::volScalarField& Foam::incompressibleFluid::p() const
{
    return mesh_.lookupObject<volScalarField>(pName_);
}


Foam::tmp<Foam::volScalarField> Foam::incompressibleFluid::rho() const
{
    return rho_;
}


Foam::tmp<Foam::volScalarField> Foam::incompressibleFluid::nu() const
{
    return model()->nu();
}


Foam::tmp<Foam::volVectorField> Foam::incompressibleFluid::divTau() const
{
    const tmp<volScalarField> tnu(nu());
    const word scheme("laplacian(" + tnu().name() + ',' + UName_ + ')');
    return rho_*fvc::laplacian(tnu(), velocity(), scheme);
}


void Foam::incompressibleFluid::checkEquation(const fvMatrix<vector>& eqn) const
{
    if (eqn.dimensions() != dimVelocity/dimTime*dimVolume)
    {
        FatalIOErrorInFunction(dict_)
            << "The momentum equation has the dimensions " << eqn.dimensions()
            << ": liggghtsCoupling needs an incompressible solver, whose equation"
            << " is divided by density" << exit(FatalIOError);
    }
    if (mesh_.changing())
    {
        FatalIOErrorInFunction(dict_)
            << "liggghtsCoupling needs a mesh that does not move or change"
            << exit(FatalIOError);
    }
}


// ************************************************************************* //
