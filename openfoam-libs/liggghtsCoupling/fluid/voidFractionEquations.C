/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "voidFractionEquations.H"
#include "calculatedFvPatchFields.H"
#include "continuedField.H"
#include "convectionScheme.H"
#include "ddtScheme.H"
#include "fvcDdt.H"
#include "fvcSurfaceIntegrate.H"
#include "fvmDdt.H"
#include "fvmDiv.H"
#include "fvMatrices.H"
#include "linear.H"
#include "wallFvPatch.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::voidFractionEquations::setFluidVelocity(volVectorField& u) const
{
    const volVectorField& U = fluid_.U();
    u.primitiveFieldRef() =
        (U.primitiveField() - solidsFlux_.primitiveField())/voidFraction_.primitiveField();

    forAll(u.boundaryFieldRef(), patchi)
    {
        fvPatchVectorField& ub = u.boundaryFieldRef()[patchi];
        const fvPatchVectorField& Ub = U.boundaryField()[patchi];
        if (ub.type() != calculatedFvPatchVectorField::typeName)
        {
            continue;
        }

        // At a wall without slip the fluid between the grains has the velocity of the wall
        const bool wall = isA<wallFvPatch>(Ub.patch());
        if (wall && Ub.fixesValue())
        {
            ub = vectorField(Ub);
            continue;
        }

        vectorField between
        (
            (Ub - solidsFlux_.boundaryField()[patchi])
           /voidFraction_.boundaryField()[patchi]
        );
        if (wall)
        {
            const vectorField n(Ub.patch().nf());
            between -= n*(n & between);
        }
        ub = between;
    }
    u.correctBoundaryConditions();
}


Foam::tmp<Foam::surfaceScalarField> Foam::voidFractionEquations::fluxOfSolids() const
{
    tmp<surfaceScalarField> tflux(linearInterpolate(solidsFlux_) & fluid_.mesh().Sf());
    return
        fluid_.equationRho()
      ? linearInterpolate(*fluid_.equationRho())*tflux
      : tflux;
}


Foam::tmp<Foam::fvMatrix<Foam::vector>> Foam::voidFractionEquations::inertia
(
    const surfaceScalarField& flux
) const
{
    const volVectorField& U = fluid_.U();
    const volScalarField* rho = fluid_.equationRho();

    tmp<fvMatrix<vector>> tinertia(rho ? fvm::ddt(*rho, U) : fvm::ddt(U));
    tinertia.ref() += fvm::div
    (
        flux, U, "div(" + fluid_.momentumFlux().name() + ',' + fluid_.UName() + ')'
    );
    return tinertia;
}


template<class FieldType>
Foam::tmp<FieldType> Foam::voidFractionEquations::rateOfChange(const FieldType& field) const
{
    const fvMesh& mesh = fluid_.mesh();
    const volScalarField* rho = fluid_.equationRho();
    const word name
    (
        "ddt(" + (rho ? rho->name() + ',' : word()) + fluid_.UName() + ')'
    );
    const auto tscheme
    (
        fv::ddtScheme<typename FieldType::value_type>::New(mesh, mesh.ddtScheme(name))
    );
    return rho ? tscheme.constCast().fvcDdt(*rho, field) : tscheme.constCast().fvcDdt(field);
}


Foam::tmp<Foam::vectorField> Foam::voidFractionEquations::kicks() const
{
    const volScalarField& e = voidFraction_;
    const volVectorField& q = solidsFlux_;
    tmp<volScalarField> tchange(rateOfChange(e));
    if (fluid_.equationRho())
    {
        // What the solver's continuity equation has done is no kick
        tchange = tchange - fvc::ddt(*fluid_.equationRho());
    }
    const tmp<volScalarField> tdivq(fvc::surfaceIntegrate(fluxOfSolids()));

    // A cell that grains are just about to enter has those next to it alone
    const tmp<volVectorField> tqAround
    (
        fvc::surfaceSum(linearInterpolate(q + q.oldTime()))
    );
    const tmp<volScalarField> taAround
    (
        fvc::surfaceSum(linearInterpolate(2 - e - e.oldTime()))
    );

    tmp<vectorField> tkicks(new vectorField(e.size(), Zero));
    vectorField& kicks = tkicks.ref();
    forAll(kicks, celli)
    {
        const scalar a = 2 - e[celli] - e.oldTime()[celli];
        if (a > VSMALL)
        {
            kicks[celli] = tchange()[celli]/a*(q[celli] + q.oldTime()[celli]);
        }
        if (taAround()[celli] > VSMALL)
        {
            kicks[celli] -= tdivq()[celli]/taAround()[celli]*tqAround()[celli];
        }
    }
    return tkicks;
}


void Foam::voidFractionEquations::update()
{
    setFluidVelocity(fluidVelocity_);
}


void Foam::voidFractionEquations::smooth()
{
    const fvMesh& mesh = fluid_.mesh();
    const scalarField& V = mesh.V();
    const scalar dt = dt_ = mesh.time().deltaTValue();
    const tmp<vectorField> tkicks(kicks());
    const tmp<volScalarField> tpassages(0.5*fvc::surfaceSum(mag(fluid_.phi())));

    forAll(smoothing_, celli)
    {
        const vector kick(fluid_.equationDensity(celli)*V[celli]*tkicks()[celli]);
        vector& unpaid = unpaid_[celli];
        unpaid -= dt*kick;

        const scalar share =
            -std::expm1(-0.01*tpassages()[celli]*dt/V[celli]);
        smoothing_[celli] = kick + share*unpaid/dt;
        unpaid -= share*unpaid;
    }
    unpaid_.instance() = mesh.time().timeName();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::voidFractionEquations::voidFractionEquations
(
    carrierFluid& fluid,
    const volScalarField& voidFraction,
    const volVectorField& solidsFlux
)
:
    fluid_(fluid),
    voidFraction_(voidFraction),
    solidsFlux_(solidsFlux),
    fluidVelocity_
    (
        IOobject
        (
            "fluidVelocity",
            fluid.mesh().time().timeName(),
            fluid.mesh()
        ),
        fluid.mesh(),
        dimensionedVector(dimVelocity, Zero)
    ),
    feltGradP_
    (
        continuedField::header("feltPressureGradient", fluid.mesh()),
        fluid.mesh(),
        dimensionedVector(dimPressure/dimLength, Zero),
        zeroGradientFvPatchVectorField::typeName
    ),
    feltDivTau_
    (
        continuedField::header("feltViscousStress", fluid.mesh()),
        fluid.mesh(),
        dimensionedVector(dimForce/dimVolume, Zero),
        zeroGradientFvPatchVectorField::typeName
    ),
    hasFelt_
    (
        continuedField::header("feltPressureGradient", fluid.mesh()).typeHeaderOk<volVectorField>(true)
    ),
    stress_(fluid.mesh().nCells(), Zero),
    unpaid_
    (
        continuedField::header("momentumOfShares", fluid.mesh()),
        fluid.mesh(),
        dimensionedVector(dimForce*dimTime, Zero)
    ),
    smoothing_(fluid.mesh().nCells(), Zero),
    dt_(0)
{
    checkConvection(fluid, fluid.UName());
    fluid.setFluidBetweenGrains(fluidVelocity_, voidFraction_, feltGradP_, feltDivTau_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::voidFractionEquations::closeStep()
{
    update();
    stress_ = presentStress();
    follow(feltGradP_, fluid_.gradP());
    follow(feltDivTau_, fluid_.divTau());
    hasFelt_ = true;
}


void Foam::voidFractionEquations::beginStep()
{
    update();
    smooth();
}


Foam::vector Foam::voidFractionEquations::received() const
{
    return sum(smoothing_)*dt_;
}


Foam::vector Foam::voidFractionEquations::owed() const
{
    return sum(unpaid_.field());
}


void Foam::voidFractionEquations::addSup(fvMatrix<vector>& eqn) const
{
    fluid_.keepStress();

    const volVectorField& U = fluid_.U();
    const surfaceScalarField& flux = fluid_.momentumFlux();
    const surfaceScalarField fluidFlux
    (
        (flux - fluxOfSolids())/linearInterpolate(voidFraction_)
    );
    const volScalarField::Internal share(1/voidFraction_.internalField());

    // The solver's inertia out, that of the fluid between the grains in
    eqn += inertia(flux);

    const tmp<fvMatrix<vector>> town(inertia(fluidFlux));
    town.constCast() *= share;
    eqn -= town();

    const tmp<volVectorField> inertiaOfSolids
    (
        rateOfChange(solidsFlux_)
      + fvc::surfaceIntegrate(fluidFlux*linearInterpolate(solidsFlux_))
    );
    eqn += share*inertiaOfSolids().internalField();

    keepViscosity();
    volVectorField difference("velocityDifference", fluidVelocity_);
    setFluidVelocity(difference);
    difference -= U;
    const tmp<volVectorField> tviscous(viscousStress(difference));
    eqn += tviscous().internalField();

    // Of the present U so far. What a new one adds is implicit, or large viscosities would not be stable
    const tmp<fvMatrix<vector>> tchange(viscousChange());
    eqn += tchange();
    eqn -= (tchange() & U)().internalField();

    vectorField& source = eqn.source();
    forAll(source, celli)
    {
        source[celli] -=
            smoothing_[celli]/(fluid_.equationDensity(celli)*voidFraction_[celli]);
    }
}


Foam::tmp<Foam::vectorField> Foam::voidFractionEquations::write()
{
    // What function objects see does not depend on the steps that are written
    const volVectorField ofBeginning(fluidVelocity_);
    update();
    fluidVelocity_.instance() = fluid_.mesh().time().timeName();
    fluidVelocity_.write();
    tmp<vectorField> tstress(presentStress());
    fluidVelocity_ == ofBeginning;
    return tstress;
}


// ************************************************************************* //
