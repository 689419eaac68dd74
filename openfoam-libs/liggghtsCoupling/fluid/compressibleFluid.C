/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "compressibleFluid.H"
#include "addToRunTimeSelectionTable.H"
#include "couplingEntries.H"
#include "fluidKinds.H"
#include "fvcDiv.H"
#include "fvcLaplacian.H"
#include "fvMatrices.H"
#include "surfaceFields.H"
#include "turbulenceModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(compressibleFluid, 0);
    addToRunTimeSelectionTable(carrierFluid, compressibleFluid, dictionary);
    const knownEntries::ofModel compressibleEntries
    (
        carrierFluid::typeName_(), compressibleFluid::typeName_()
    );
    const fluidKinds compressibleKind
    (
        compressibleFluid::typeName_(), "rhoPimpleFoam and sonicFoam", &compressibleFluid::misfit
    );
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

// Names that these solvers give to their objects
const word thermoName("thermophysicalProperties");
const word rhoName("rho");
const word phiName("phi");


bool isMassFlux(const surfaceScalarField* phi)
{
    return phi && phi->dimensions() == dimMass/dimTime;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::compressibleFluid::refuse(const string& reason) const
{
    const string solver(Foam::getEnv("FOAM_EXECUTABLE"));
    couplingEntries::onMaster
    (
        [&]()
        {
            FatalIOErrorInFunction(dict_)
                << (solver.empty() ? "This solver" : solver.c_str()) << ' ' << reason.c_str()
                << ".\n    fluid " << type() << " is for solvers for one compressible fluid that march in"
                << " time: rhoPimpleFoam and sonicFoam. They have read constant/" << thermoName
                << ", and have the fields " << UName_ << ", " << pName_ << ", " << rhoName
                << " and the flux of mass " << phiName << exit(FatalIOError);
        }
    );
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::compressibleFluid::checkSolver() const
{
    for (const word& name : mesh_.sortedNames())
    {
        if (name.compare(0, 6, "alpha.") == 0 || name == "phaseProperties")
        {
            refuse("is a multiphase solver (it has " + name + ')');
        }
        if (name.compare(0, thermoName.size() + 1, thermoName + '.') == 0)
        {
            refuse("is a multiphase solver (it has read constant/" + name + ')');
        }
        if (name == "SRFProperties")
        {
            refuse
            (
                "solves for the velocity relative to a rotating frame (it has read constant/"
              + name + "), while grains move in the frame at rest"
            );
        }
    }
    if (!mesh_.foundObject<regIOobject>(thermoName))
    {
        refuse("has not read constant/" + thermoName);
    }
    if (!mesh_.foundObject<volScalarField>(rhoName))
    {
        refuse("has no field of density (" + rhoName + ')');
    }
    if (!isMassFlux(mesh_.cfindObject<surfaceScalarField>(phiName)))
    {
        refuse("has no flux of mass (" + phiName + " in kg/s)");
    }

    const auto* control = mesh_.cfindObject<regIOobject>("solutionControl");
    if (control && control->type() == "simpleControl")
    {
        refuse("is a steady solver (its algorithm is SIMPLE), while grains need the time");
    }

    checkField<volVectorField>("U", dimVelocity);
    checkField<volScalarField>("p", dimPressure);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::compressibleFluid::compressibleFluid
(
    const dictionary& dict,
    const fvMesh& mesh,
    const knownEntries::table& entries
)
:
    carrierFluid(dict, mesh, entries)
{}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

Foam::string Foam::compressibleFluid::missing(const fvMesh& mesh)
{
    if (!mesh.foundObject<regIOobject>(thermoName))
    {
        return "it has not read constant/" + thermoName;
    }
    if (!mesh.foundObject<volScalarField>(rhoName))
    {
        return "it has no field of density, " + rhoName;
    }
    if (!isMassFlux(mesh.cfindObject<surfaceScalarField>(phiName)))
    {
        return "it has no flux of mass, " + phiName + " in kg/s";
    }
    return string();
}


Foam::string Foam::compressibleFluid::misfit(const fvMesh& mesh)
{
    const string what(missing(mesh));
    return
        what.empty() && mesh.foundObject<volScalarField>("p_rgh")
      ? string("it solves for p_rgh, the pressure without its hydrostatic part") : what;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::compressibleFluid::check() const
{
    checkSolver();
    if (mesh_.foundObject<volScalarField>("p_rgh"))
    {
        refuse("solves for p_rgh, the pressure without its hydrostatic part");
    }
}


Foam::tmp<Foam::volScalarField> Foam::compressibleFluid::rho() const
{
    return *equationRho();
}


const Foam::volScalarField* Foam::compressibleFluid::equationRho() const
{
    return &mesh_.lookupObject<volScalarField>(rhoName);
}


Foam::tmp<Foam::volVectorField> Foam::compressibleFluid::divTau() const
{
    const tmp<volScalarField> tmu(model()->mu());
    return
        fvc::laplacian(tmu(), velocity(), "laplacian((rho*nuEff)," + UName_ + ')')
      + fvc::div
        (
            tmu()*dev2(T(gradVelocity())),
            "div(((rho*nuEff)*dev2(T(grad(" + UName_ + ")))))"
        );
}


void Foam::compressibleFluid::checkEquation(const fvMatrix<vector>& eqn) const
{
    checkEquationIs(eqn, dimForce, "which holds density");
}


// ************************************************************************* //
