/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vofFluid.H"
#include "addToRunTimeSelectionTable.H"
#include "fluidKinds.H"
#include "fvcDiv.H"
#include "fvcLaplacian.H"
#include "fvcSnGrad.H"
#include "fvMatrices.H"
#include "IOdictionary.H"
#include "surfaceInterpolate.H"
#include "surfaceTensionModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(vofFluid, 0);
    addToRunTimeSelectionTable(carrierFluid, vofFluid, dictionary);
    const knownEntries::ofModel vofEntries(carrierFluid::typeName_(), vofFluid::typeName_());
    const fluidKinds vofKind
    (
        vofFluid::typeName_(), "interFoam and interIsoFoam", &vofFluid::misfit, &vofFluid::watch
    );
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

const word curvatureName("interfaceProperties:K");


// The fraction of the first phase, whose gradient the surface tension acts along
const volScalarField* fraction(const fvMesh& mesh)
{
    const auto* properties = mesh.cfindObject<IOdictionary>("transportProperties");
    const wordList phases
    (
        properties ? properties->lookupOrDefault("phases", wordList()) : wordList()
    );
    return phases.empty() ? nullptr : mesh.cfindObject<volScalarField>("alpha." + phases[0]);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::surfaceScalarField> Foam::vofFluid::surfaceTension() const
{
    const auto& model = mesh_.lookupObject<surfaceTensionModel>(surfaceTensionModel::typeName);
    const volScalarField& curvature =
        pressure_.ofSameTime(mesh_.lookupObject<volScalarField>(curvatureName));

    return
        fvc::interpolate(model.sigma()*curvature)
       *fvc::snGrad(pressure_.ofSameTime(*fraction(mesh_)));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::vofFluid::vofFluid(const dictionary& dict, const fvMesh& mesh)
:
    carrierFluid(dict, mesh),
    pressure_(mesh)
{}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

Foam::string Foam::vofFluid::misfit(const fvMesh& mesh)
{
    if (fluidKinds::beginsWith(mesh, "alpha.").empty())
    {
        return "it has no phase fraction alpha.<phase>";
    }
    if (!mesh.foundObject<volScalarField>("rho"))
    {
        return "it has no density of the mixture, rho";
    }
    if (!mesh.foundObject<surfaceScalarField>("rhoPhi"))
    {
        return "it has no mass flux of the mixture, rhoPhi";
    }
    const string missing(hydrostaticPressure::missing(mesh));
    if (!missing.empty())
    {
        return missing;
    }
    if (!mesh.foundObject<volScalarField>(curvatureName) || !fraction(mesh))
    {
        return "it has no surface between two phases (" + curvatureName + ')';
    }
    return string();
}


void Foam::vofFluid::watch(const fvMesh& mesh)
{
    // Fields whose old time has been asked for are kept from step to step
    mesh.lookupObject<volScalarField>(curvatureName).oldTime();
    fraction(mesh)->oldTime();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::vofFluid::check() const
{
    checkField<volVectorField>("U", dimVelocity);
    checkField<volScalarField>("p", dimPressure);
}


Foam::tmp<Foam::volScalarField> Foam::vofFluid::rho() const
{
    return *equationRho();
}


Foam::tmp<Foam::volVectorField> Foam::vofFluid::divTau() const
{
    const tmp<volScalarField> trho(rho());
    const volScalarField mu("mu", trho()*nu());
    return
        fvc::laplacian(mu, velocity(), "laplacian((rho*nuEff)," + UName_ + ')')
      + fvc::div
        (
            mu*dev2(T(gradVelocity())),
            "div(((rho*nuEff)*dev2(T(grad(" + UName_ + ")))))"
        );
}


Foam::tmp<Foam::volVectorField> Foam::vofFluid::weight() const
{
    return
        pressure_.ofSameTime(*equationRho())
       *dimensionedVector("g", dimAcceleration, pressure_.g());
}


Foam::tmp<Foam::volVectorField> Foam::vofFluid::gradP() const
{
    return pressure_.gradient
    (
        pressure_.ofSameTime(*equationRho()), surfaceTension()
    );
}


void Foam::vofFluid::keepStress() const
{
    // Without old times a field has no time of its own
    pressure_.p_rgh().oldTime();
}


const Foam::volScalarField* Foam::vofFluid::equationRho() const
{
    return &mesh_.lookupObject<volScalarField>("rho");
}


const Foam::surfaceScalarField& Foam::vofFluid::momentumFlux() const
{
    return mesh_.lookupObject<surfaceScalarField>("rhoPhi");
}


void Foam::vofFluid::checkEquation(const fvMatrix<vector>& eqn) const
{
    checkEquationIs(eqn, dimForce, "which holds density");
}


// ************************************************************************* //
