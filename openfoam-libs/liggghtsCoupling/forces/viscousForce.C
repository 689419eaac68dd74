/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "viscousForce.H"
#include "addToRunTimeSelectionTable.H"
#include "fvcLaplacian.H"
#include "surfaceFields.H"

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


// Whether the scheme is Gauss' with linear interpolation and nothing but the difference across
// the face for the normal gradient, which "corrected" is on an orthogonal mesh
bool isPlain(const tokenList& scheme, const bool orthogonal)
{
    const auto word = [&](const label i)
    {
        return
            i < scheme.size() && scheme[i].isWord()
          ? scheme[i].wordToken()
          : Foam::word();
    };
    return
        scheme.size() == 3 && word(0) == "Gauss" && word(1) == "linear"
     && (word(2) == "uncorrected" || (word(2) == "corrected" && orthogonal));
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::viscousForce::viscousForce(const carrierFluid& fluid)
:
    grainForce(fluid),
    orthogonal_(isOrthogonal(fluid.mesh())),
    flux_()
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::viscousForce::addPlain
(
    const volScalarField& nu,
    const volVectorField& U,
    vectorField& density
) const
{
    const fvMesh& mesh = fluid_.mesh();
    const labelUList& owner = mesh.owner();
    const labelUList& neighbour = mesh.neighbour();
    const surfaceScalarField& area = mesh.magSf();
    const surfaceScalarField& deltas = mesh.nonOrthDeltaCoeffs();
    const surfaceScalarField& weights = mesh.weights();

    flux_.setSize(mesh.nCells());
    flux_ = Zero;
    forAll(neighbour, facei)
    {
        const label o = owner[facei];
        const label n = neighbour[facei];
        const scalar nuf = weights[facei]*(nu[o] - nu[n]) + nu[n];
        const vector flux = area[facei]*deltas[facei]*nuf*(U[n] - U[o]);
        flux_[o] += flux;
        flux_[n] -= flux;
    }

    forAll(U.boundaryField(), patchi)
    {
        const fvPatchVectorField& pU = U.boundaryField()[patchi];
        const fvPatchScalarField& pNu = nu.boundaryField()[patchi];
        const fvsPatchScalarField& pWeights = weights.boundaryField()[patchi];
        const bool coupled = pU.coupled();

        const vectorField gradient
        (
            coupled
          ? pU.snGrad(deltas.boundaryField()[patchi])
          : pU.snGrad()
        );
        const scalarField nuf
        (
            coupled
          ? tmp<scalarField>
            (
                pWeights*pNu.patchInternalField()
              + (1 - pWeights)*pNu.patchNeighbourField()
            )
          : tmp<scalarField>(pNu)
        );
        const labelUList& cells = pU.patch().faceCells();
        const scalarField& pArea = area.boundaryField()[patchi];
        forAll(cells, i)
        {
            flux_[cells[i]] += pArea[i]*nuf[i]*gradient[i];
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

    if (isPlain(fluid_.mesh().laplacianScheme(name), orthogonal_))
    {
        addPlain(tnu(), U, f);
        return;
    }

    const tmp<volVectorField> tlaplacian(fvc::laplacian(tnu(), U, name));
    const vectorField& laplacian = tlaplacian().primitiveField();
    forAll(f, celli)
    {
        f[celli] += fluid_.rho()*laplacian[celli];
    }
}


// ************************************************************************* //
