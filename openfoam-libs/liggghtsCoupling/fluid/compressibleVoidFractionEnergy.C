/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The energy equation of the gas between the grains, see compressibleVoidFraction.H.

\*---------------------------------------------------------------------------*/

#include "compressibleVoidFraction.H"
#include "ddtScheme.H"
#include "fvcDdt.H"
#include "fvcDiv.H"
#include "fvcSurfaceIntegrate.H"
#include "fvmDdt.H"
#include "fvmDiv.H"
#include "fvmLaplacian.H"
#include "fvMatrices.H"
#include "gasThermo.H"
#include "linear.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

// Time scheme of the solver for rho times a scalar
tmp<fv::ddtScheme<scalar>> schemeOf(const volScalarField& rho, const word& name)
{
    const fvMesh& mesh = rho.mesh();
    return fv::ddtScheme<scalar>::New
    (
        mesh, mesh.ddtScheme("ddt(" + rho.name() + ',' + name + ')')
    );
}


// Effective diffusivity of the energy at faces [kg/m s]
tmp<surfaceScalarField> diffusivity(const fvMesh& mesh)
{
    const auto* alphat = mesh.cfindObject<volScalarField>("alphat");
    const tmp<volScalarField> tnone
    (
        alphat
      ? tmp<volScalarField>(*alphat)
      : volScalarField::New("alphat", mesh, dimensionedScalar(dimDensity*dimViscosity, Zero))
    );
    return linearInterpolate(gasThermo::of(mesh).alphaEff(tnone()));
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::compressibleVoidFraction::addEnergySup(fvMatrix<scalar>& eqn) const
{
    const fvMesh& mesh = fluid_.mesh();
    const volScalarField& he = mesh.lookupObject<volScalarField>(energyName_);
    const volScalarField& K = mesh.lookupObject<volScalarField>("K");
    const volScalarField& rho = *fluid_.equationRho();
    const volScalarField& p = fluid_.p();
    const surfaceScalarField& phi = fluid_.phi();
    const surfaceScalarField gasFlux(faceVoidFraction()*phi);
    const surfaceScalarField solids(linearInterpolate(solidsFlux_) & mesh.Sf());
    const volScalarField::Internal share(1/voidFraction_.internalField());
    const surfaceScalarField alpha(diffusivity(mesh));
    const word convection("div(" + phi.name() + ',' + he.name() + ')');
    const word conduction("laplacian(alphaEff," + he.name() + ')');
    const word convectionOfK("div(" + phi.name() + ",K)");
    voidDensity_ == voidFraction_*rho;

    // The solver's terms out, those of the gas between the grains in
    eqn += fvm::ddt(rho, he);
    eqn += fvm::div(phi, he, convection);
    eqn -= fvm::laplacian(alpha, he, conduction);
    tmp<fvMatrix<scalar>> town(schemeOf(rho, he.name()).ref().fvmDdt(voidDensity_, he));
    fvMatrix<scalar>& own = town.ref();
    own += fvm::div(gasFlux, he, convection);
    own -= fvm::laplacian((faceVoidFraction()*alpha)(), he, conduction);
    own *= share;
    eqn -= own;

    tmp<volScalarField> tsolver(fvc::ddt(rho, K) + fvc::div(phi, K, convectionOfK));
    tmp<volScalarField> tgas
    (
        schemeOf(rho, K.name()).ref().fvcDdt(voidDensity_, K)
      + fvc::div(gasFlux, K, convectionOfK)
    );
    if (enthalpy_)
    {
        tgas.ref() += fvc::div(solids, p, "div(phiv,p)") - p.oldTime()*fvc::surfaceIntegrate(solids);
    }
    else
    {
        const word pressureWork("div(phiv,p)");
        const surfaceScalarField phiv(phi/fvc::interpolate(rho));
        tsolver.ref() += fvc::div(phiv, p, pressureWork);
        tgas.ref() += fvc::div((faceVoidFraction()*phiv + solids)(), p, pressureWork);
    }
    eqn += tsolver().internalField();
    eqn -= share*tgas().internalField();

    eqn.source() -= energyTerm_/voidFraction_.primitiveField();
}


// ************************************************************************* //
