/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "viscousForce.H"
#include "addToRunTimeSelectionTable.H"
#include "laplacianScheme.H"

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


// The case's scheme, without the correction where there is nothing to correct
tokenList scheme(const fvMesh& mesh, const word& name, const bool orthogonal)
{
    const tokenList& stated = mesh.laplacianScheme(name);
    tokenList words(stated);
    token& last = words.last();
    if (orthogonal && last.isWord() && last.wordToken() == "corrected")
    {
        last = token(word("uncorrected"));
    }
    return words;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::viscousForce::viscousForce(const carrierFluid& fluid)
:
    grainForce(fluid),
    orthogonal_(isOrthogonal(fluid.mesh()))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::viscousForce::addDensity(volVectorField& density) const
{
    const volScalarField nu(fluid_.nu());
    const volVectorField& U = fluid_.U();
    const word name("laplacian(" + nu.name() + ',' + U.name() + ')');

    ITstream is(name, scheme(fluid_.mesh(), name, orthogonal_));
    const tmp<volVectorField> tlaplacian
    (
        fv::laplacianScheme<vector, scalar>::New(fluid_.mesh(), is).ref()
       .fvcLaplacian(nu, U)
    );
    const vectorField& laplacian = tlaplacian().primitiveField();

    vectorField& f = density.primitiveFieldRef();
    forAll(f, celli)
    {
        f[celli] += fluid_.rho()*laplacian[celli];
    }
}


// ************************************************************************* //
