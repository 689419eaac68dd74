/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Stress of the fluid between the grains, see voidFractionEquations.H.

\*---------------------------------------------------------------------------*/

#include "voidFractionEquations.H"
#include "fvcDiv.H"
#include "fvcLaplacian.H"
#include "fvmLaplacian.H"
#include "fvMatrices.H"
#include "gradScheme.H"

// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::voidFractionEquations::keepViscosity() const
{
    tmp<volScalarField> tviscosity(fluid_.effectiveViscosity());
    if (viscosity_)
    {
        *viscosity_ == tviscosity;
        return;
    }
    const fvMesh& mesh = fluid_.mesh();
    const IOobject header
    (
        tviscosity().name(), mesh.time().timeName(), mesh, IOobject::NO_READ, IOobject::NO_WRITE, false
    );
    viscosity_.reset(new volScalarField(header, tviscosity));
}


Foam::tmp<Foam::volVectorField> Foam::voidFractionEquations::viscousStress
(
    const volVectorField& velocity
) const
{
    const word& name = fluid_.UName();
    const tmp<volScalarField> tviscosity
    (
        viscosity_ ? tmp<volScalarField>(*viscosity_) : fluid_.effectiveViscosity()
    );
    const tmp<volTensorField> tgradient
    (
        // Not from the cache, where the gradient of U has this name
        fv::gradScheme<vector>::New
        (
            fluid_.mesh(), fluid_.mesh().gradScheme("grad(" + name + ')')
        )().calcGrad(velocity, "grad(" + velocity.name() + ')')
    );
    return
        fvc::laplacian
        (
            tviscosity(), velocity, "laplacian(" + tviscosity().name() + ',' + name + ')'
        )
      + fvc::div
        (
            tviscosity()*dev2(T(tgradient)),
            "div((" + tviscosity().name() + "*dev2(T(grad(" + name + ")))))"
        );
}


void Foam::voidFractionEquations::follow
(
    volVectorField& felt,
    const volVectorField& present
) const
{
    const scalarField& e = voidFraction_.primitiveField();
    felt.primitiveFieldRef() =
        hasFelt_
      ? tmp<vectorField>(e*present.primitiveField() + (1 - e)*felt.primitiveField())
      : tmp<vectorField>(present.primitiveField());
    felt.correctBoundaryConditions();
    felt.instance() = felt.time().timeName();
}


Foam::tmp<Foam::fvMatrix<Foam::vector>> Foam::voidFractionEquations::viscousChange() const
{
    const volVectorField& U = fluid_.U();
    const tmp<volScalarField> tviscosity(fluid_.effectiveViscosity());
    tmp<fvMatrix<vector>> tmatrix
    (
        fvm::laplacian
        (
            tviscosity(), U, "laplacian(" + tviscosity().name() + ',' + fluid_.UName() + ')'
        )
    );
    fvMatrix<vector>& matrix = tmatrix.ref();

    // Acts on (1/e - 1) U: each coefficient belongs to the cell that it multiplies
    const volScalarField factor(1/voidFraction_ - 1);
    const lduAddressing& address = matrix.lduAddr();
    scalarField& lower = matrix.lower();
    scalarField& upper = matrix.upper();
    forAll(upper, facei)
    {
        upper[facei] *= factor[address.upperAddr()[facei]];
        lower[facei] *= factor[address.lowerAddr()[facei]];
    }
    matrix.diag() *= factor.primitiveField();
    matrix.source() = Zero;
    forAll(factor.boundaryField(), patchi)
    {
        const fvPatchScalarField& patch = factor.boundaryField()[patchi];
        matrix.internalCoeffs()[patchi] *= patch.patchInternalField();
        if (patch.coupled())
        {
            matrix.boundaryCoeffs()[patchi] *= patch.patchNeighbourField();
        }
    }
    return tmatrix;
}


Foam::tmp<Foam::vectorField> Foam::voidFractionEquations::presentStress() const
{
    const tmp<volVectorField> tviscous(viscousStress(fluidVelocity_));
    const tmp<volVectorField> tgradP(fluid_.gradP());
    tmp<vectorField> tstress(new vectorField(-tgradP().primitiveField()));
    vectorField& stress = tstress.ref();
    forAll(stress, celli)
    {
        stress[celli] += fluid_.equationDensity(celli)*tviscous()[celli];
    }
    return tstress;
}


// ************************************************************************* //
