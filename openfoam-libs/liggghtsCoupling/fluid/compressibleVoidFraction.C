/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "compressibleVoidFraction.H"
#include "continuedField.H"
#include "ddtScheme.H"
#include "energyExchange.H"
#include "fvcDdt.H"
#include "fvcSurfaceIntegrate.H"
#include "fvmDiv.H"
#include "fvmSup.H"
#include "fvMatrices.H"
#include "linear.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::surfaceScalarField> Foam::compressibleVoidFraction::faceVoidFraction() const
{
    return linearInterpolate(voidFraction_);
}


Foam::boolList Foam::compressibleVoidFraction::plays() const
{
    const fvMesh& mesh = fluid_.mesh();
    const scalarField& e = voidFraction_.primitiveField();
    const scalarField& e0 = voidFraction_.oldTime().primitiveField();
    const tmp<surfaceScalarField> tef(faceVoidFraction());
    const surfaceScalarField& ef = tef();

    boolList playing(mesh.nCells());
    forAll(playing, celli)
    {
        playing[celli] =
            e[celli] != 1 || e0[celli] != 1 || unpaidMass_[celli] != 0 || left_[celli] != 0;
    }
    forAll(ef, facei)
    {
        if (ef[facei] != 1)
        {
            playing[mesh.owner()[facei]] = playing[mesh.neighbour()[facei]] = true;
        }
    }
    forAll(ef.boundaryField(), patchi)
    {
        const labelUList& cells = mesh.boundary()[patchi].faceCells();
        forAll(cells, i)
        {
            if (ef.boundaryField()[patchi][i] != 1)
            {
                playing[cells[i]] = true;
            }
        }
    }
    return playing;
}


Foam::tmp<Foam::scalarField> Foam::compressibleVoidFraction::outflow
(
    const surfaceScalarField& flux
) const
{
    tmp<scalarField> tsum(new scalarField(fluid_.mesh().nCells(), Zero));
    fvc::surfaceIntegrate(tsum.ref(), flux);
    tsum.ref() *= fluid_.mesh().V();
    return tsum;
}


Foam::tmp<Foam::scalarField> Foam::compressibleVoidFraction::leftOver() const
{
    const scalarField& V = fluid_.mesh().V();
    const scalarField& e = voidFraction_.primitiveField();
    const tmp<volScalarField> trho(fluid_.rho());
    const scalarField& rho = trho().primitiveField();
    const tmp<scalarField> tout(outflow((faceVoidFraction()*fluid_.phi())()));
    const boolList playing(plays());

    tmp<scalarField> tleft(new scalarField(V.size(), Zero));
    scalarField& left = tleft.ref();
    forAll(left, celli)
    {
        if (playing[celli])
        {
            left[celli] =
                left_[celli] + dt_*(massSource_[celli] - tout()[celli])
              - (e[celli]*rho[celli]*V[celli] - startMass_[celli]);
        }
    }
    return tleft;
}


void Foam::compressibleVoidFraction::smooth()
{
    const fvMesh& mesh = fluid_.mesh();
    const scalarField& V = mesh.V();
    const scalar dt = dt_ = mesh.time().deltaTValue();
    const scalarField& e = voidFraction_.primitiveField();
    const scalarField& e0 = voidFraction_.oldTime().primitiveField();
    const scalarField& U2 = mesh.lookupObject<volScalarField>("K").primitiveField();
    const scalarField& he = mesh.lookupObject<volScalarField>(energyName_).primitiveField();
    const scalarField& p = fluid_.p().primitiveField();
    const tmp<volScalarField> tdivq
    (
        fvc::surfaceIntegrate((linearInterpolate(solidsFlux_) & mesh.Sf())())
    );
    const tmp<volScalarField> tpassages(0.5*fvc::surfaceSum(mag(fluid_.phi())));

    forAll(smoothing_, celli)
    {
        const scalar rate = (e[celli] - e0[celli])/dt - tdivq()[celli];
        const scalar mass = startRho_[celli]*V[celli]*rate;
        const scalar ofMass =
            he[celli] + U2[celli] - (enthalpy_ ? p[celli]/startRho_[celli] : 0);
        const scalar share =
            -std::expm1(-0.01*tpassages()[celli]*dt/(startRho_[celli]*V[celli]));

        unpaidMass_[celli] -= dt*mass;
        massSource_[celli] = mass + share*unpaidMass_[celli]/dt;
        unpaidMass_[celli] *= 1 - share;

        const vector kick(mass*fluidVelocity_[celli]);
        unpaid_[celli] -= dt*kick;
        smoothing_[celli] = kick + share*unpaid_[celli]/dt;
        unpaid_[celli] *= 1 - share;

        unpaidEnergy_[celli] -= dt*mass*ofMass;
        energySource_[celli] = mass*ofMass + share*unpaidEnergy_[celli]/dt;
        unpaidEnergy_[celli] *= 1 - share;
        energyTerm_[celli] =
            energySource_[celli] + (enthalpy_ ? V[celli]*rate*p[celli] : 0);
    }
    unpaid_.instance() = mesh.time().timeName();
    unpaidMass_.instance() = mesh.time().timeName();
    unpaidEnergy_.instance() = mesh.time().timeName();
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::compressibleVoidFraction::setFluidVelocity(volVectorField& u) const
{
    const volVectorField& U = fluid_.U();
    u.primitiveFieldRef() = U.primitiveField();
    forAll(u.boundaryFieldRef(), patchi)
    {
        if (!u.boundaryField()[patchi].coupled())
        {
            u.boundaryFieldRef()[patchi] = U.boundaryField()[patchi];
        }
    }
    u.correctBoundaryConditions();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::compressibleVoidFraction::compressibleVoidFraction
(
    carrierFluid& fluid,
    const volScalarField& voidFraction,
    const volVectorField& solidsFlux
)
:
    voidFractionEquations(fluid, voidFraction, solidsFlux),
    energyName_(energyExchange::fieldName(fluid.mesh())),
    enthalpy_(energyName_[0] == 'h'),
    voidDensity_
    (
        IOobject("voidDensity", fluid.mesh().time().timeName(), fluid.mesh()),
        voidFraction*fluid.rho()
    ),
    unpaidMass_
    (
        continuedField::header("massOfShares", fluid.mesh()),
        fluid.mesh(),
        dimensionedScalar(dimMass, Zero)
    ),
    unpaidEnergy_
    (
        continuedField::header("energyOfShares", fluid.mesh()),
        fluid.mesh(),
        dimensionedScalar(dimEnergy, Zero)
    ),
    left_
    (
        continuedField::header("massLeft", fluid.mesh(), IOobject::NO_WRITE),
        fluid.mesh(),
        dimensionedScalar(dimMass, Zero)
    ),
    massSource_(fluid.mesh().nCells(), Zero),
    energySource_(fluid.mesh().nCells(), Zero),
    energyTerm_(fluid.mesh().nCells(), Zero),
    startMass_(fluid.mesh().nCells(), Zero),
    startRho_(fluid.mesh().nCells(), Zero),
    mass_(0)
{
    checkCase();
    voidDensity_.oldTime();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::compressibleVoidFraction::closeStep()
{
    // Before the first step nothing has been left over
    if (dt_ > 0)
    {
        left_.field() = leftOver();
    }
    const tmp<volScalarField> trho(fluid_.rho());
    mass_ =
        sum
        (
            voidFraction_.primitiveField()*trho().primitiveField()*fluid_.mesh().V()
          + unpaidMass_.field() + left_.field()
        );
    voidFractionEquations::closeStep();
}


void Foam::compressibleVoidFraction::beginStep()
{
    const tmp<volScalarField> trho(fluid_.rho());
    startRho_ = trho().primitiveField();
    startMass_ =
        voidFraction_.oldTime().primitiveField()*startRho_*fluid_.mesh().V();
    voidDensity_.oldTime() == voidFraction_.oldTime()*trho();

    voidFractionEquations::beginStep();
}


void Foam::compressibleVoidFraction::addSup(fvMatrix<vector>& eqn) const
{
    const volVectorField& U = fluid_.U();
    const volScalarField& rho = *fluid_.equationRho();
    const surfaceScalarField& phi = fluid_.phi();
    const volScalarField::Internal share(1/voidFraction_.internalField());
    voidDensity_ == voidFraction_*rho;
    keepViscosity();

    // The solver's inertia out, that of the gas between the grains in
    eqn += inertia(phi);

    tmp<fvMatrix<vector>> town
    (
        fv::ddtScheme<vector>::New
        (
            fluid_.mesh(), fluid_.mesh().ddtScheme("ddt(" + rho.name() + ',' + U.name() + ')')
        ).ref().fvmDdt(voidDensity_, U)
    );
    fvMatrix<vector>& own = town.ref();
    own += fvm::div
    (
        (faceVoidFraction()*phi)(), U, "div(" + phi.name() + ',' + U.name() + ')'
    );
    own *= share;
    eqn -= own;

    eqn.source() -= smoothing_/voidFraction_.primitiveField();
}


void Foam::compressibleVoidFraction::addContinuitySup(fvMatrix<scalar>& eqn) const
{
    const scalarField& e = voidFraction_.primitiveField();
    const boolList playing(plays());
    const tmp<surfaceScalarField> tflux
    (
        eqn.psi().name() == fluid_.equationRho()->name() || !returnReduce(playing.found(true), orOp<bool>())
      ? tmp<surfaceScalarField>(fluid_.phi())
      : coming(eqn.psi())
    );
    const tmp<scalarField> tofGas(outflow((faceVoidFraction()*tflux())()));
    const tmp<scalarField> tofSolver(outflow(tflux()));

    scalarField& source = eqn.source();
    forAll(source, celli)
    {
        if (playing[celli])
        {
            source[celli] -=
                tofSolver()[celli]
              + (gained(celli) - tofGas()[celli])/e[celli];
        }
    }
}


void Foam::compressibleVoidFraction::addTransportSup(fvMatrix<scalar>& eqn) const
{
    const volScalarField& rho = *fluid_.equationRho();
    const boolList playing(plays());
    const tmp<volScalarField> trate(fvc::ddt(rho) + fvc::surfaceIntegrate(fluid_.phi()));
    volScalarField::Internal gain(trate().internalField());
    forAll(playing, celli)
    {
        if (!playing[celli])
        {
            gain[celli] = 0;
        }
    }
    eqn += fvm::Sp(gain, eqn.psi());
}


Foam::tmp<Foam::vectorField> Foam::compressibleVoidFraction::write()
{
    continuedField::write(left_, dt_ > 0 ? leftOver()() : left_.field());
    return voidFractionEquations::write();
}


// ************************************************************************* //
