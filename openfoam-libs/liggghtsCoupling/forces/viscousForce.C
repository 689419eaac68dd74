/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "viscousForce.H"
#include "addToRunTimeSelectionTable.H"
#include "fvcGrad.H"
#include "fvcLaplacian.H"
#include "surfaceFields.H"
#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(viscousForce, 0);
    addToRunTimeSelectionTable(grainForce, viscousForce, dictionary);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

// The correction vectors are unit normals less the direction between cell centres. Faces between
// ranks count like inner ones, so that a case is the same on any number of ranks
bool isOrthogonal(const fvMesh& mesh)
{
    const scalar roundOff = 1e-9;
    const surfaceVectorField& correction = mesh.nonOrthCorrectionVectors();

    scalar largest = 0;
    for (const vector& v : correction.primitiveField())
    {
        largest = max(largest, mag(v));
    }
    for (const fvsPatchVectorField& patch : correction.boundaryField())
    {
        for (const vector& v : patch)
        {
            largest = max(largest, mag(v));
        }
    }
    return returnReduce(largest, maxOp<scalar>()) < roundOff;
}


// Whether the scheme is "Gauss linear" with this surface normal gradient
bool isGaussLinear(const tokenList& scheme, const char* normalGradient)
{
    const char* words[3] = {"Gauss", "linear", normalGradient};
    bool same = (scheme.size() == 3);
    for (label i = 0; same && i < 3; ++i)
    {
        same = scheme[i].isWord() && scheme[i].wordToken() == words[i];
    }
    return same;
}


// Interpolate to a patch; patches that are not coupled have their values
template<class Type>
tmp<Field<Type>> onPatch
(
    const fvPatchField<Type>& values,
    const scalarField& weights
)
{
    if (!values.coupled())
    {
        return values;
    }
    return
        weights*values.patchInternalField()
      + (1 - weights)*values.patchNeighbourField();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::viscousForce::viscousForce(const carrierFluid& fluid)
:
    grainForce(fluid),
    orthogonal_(isOrthogonal(fluid.mesh())),
    areaOverDistance_
    (
        fluid.mesh().magSf().primitiveField()
       *fluid.mesh().nonOrthDeltaCoeffs().primitiveField()
    ),
    flux_()
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::viscousForce::addGaussLinear
(
    const volScalarField& nu,
    const volVectorField& U,
    const volTensorField* gradU,
    vectorField& density
) const
{
    const fvMesh& mesh = fluid_.mesh();
    const labelUList& owner = mesh.owner();
    const labelUList& neighbour = mesh.neighbour();
    const surfaceScalarField& area = mesh.magSf();
    const surfaceScalarField& deltas = mesh.nonOrthDeltaCoeffs();
    const surfaceScalarField& weights = mesh.weights();
    const surfaceVectorField* corrections =
        gradU ? &mesh.nonOrthCorrectionVectors() : nullptr;

    // What a face lies between then need not be read for each of them
    const bool uniform = std::all_of
    (
        nu.begin(), nu.end(), [&](const scalar v){ return v == nu[0]; }
    );

    flux_.setSize(mesh.nCells());
    flux_ = Zero;
    forAll(neighbour, facei)
    {
        const label o = owner[facei];
        const label n = neighbour[facei];

        vector flux(areaOverDistance_[facei]*(U[n] - U[o]));
        if (gradU)
        {
            const scalar w = weights[facei];
            const vector& c = (*corrections)[facei];
            flux +=
                area[facei]*(w*(c & (*gradU)[o]) + (1 - w)*(c & (*gradU)[n]));
        }
        if (uniform)
        {
            flux *= nu[0];
        }
        else
        {
            const scalar w = weights[facei];
            flux *= w*nu[o] + (1 - w)*nu[n];
        }
        flux_[o] += flux;
        flux_[n] -= flux;
    }

    forAll(U.boundaryField(), patchi)
    {
        const fvPatchVectorField& pU = U.boundaryField()[patchi];
        const scalarField& pWeights = weights.boundaryField()[patchi];

        vectorField normalGradient
        (
            pU.coupled()
          ? pU.snGrad(deltas.boundaryField()[patchi])
          : pU.snGrad()
        );
        if (gradU && pU.coupled())
        {
            normalGradient +=
                corrections->boundaryField()[patchi]
              & onPatch(gradU->boundaryField()[patchi], pWeights);
        }
        const tmp<scalarField> tnu(onPatch(nu.boundaryField()[patchi], pWeights));
        const scalarField& pNu = tnu();
        const scalarField& pArea = area.boundaryField()[patchi];
        const labelUList& cells = pU.patch().faceCells();
        forAll(cells, i)
        {
            flux_[cells[i]] += pArea[i]*pNu[i]*normalGradient[i];
        }
    }

    const scalarField& V = mesh.V();
    forAll(density, celli)
    {
        density[celli] += fluid_.rho()/V[celli]*flux_[celli];
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::viscousForce::addDensity(volVectorField& density) const
{
    const tmp<volScalarField> tnu(fluid_.nu());
    const volVectorField& U = fluid_.U();
    vectorField& f = density.primitiveFieldRef();

    const word name("laplacian(" + tnu().name() + ',' + U.name() + ')');
    const tokenList& scheme = fluid_.mesh().laplacianScheme(name);
    const bool corrected = isGaussLinear(scheme, "corrected");

    if (corrected && !orthogonal_)
    {
        const tmp<volTensorField> tgradU(fvc::grad(U));
        addGaussLinear(tnu(), U, &tgradU(), f);
    }
    else if (corrected || isGaussLinear(scheme, "uncorrected"))
    {
        addGaussLinear(tnu(), U, nullptr, f);
    }
    else
    {
        const tmp<volVectorField> tlaplacian(fvc::laplacian(tnu(), U, name));
        const vectorField& laplacian = tlaplacian().primitiveField();
        forAll(f, celli)
        {
            f[celli] += fluid_.rho()*laplacian[celli];
        }
    }
}


// ************************************************************************* //
