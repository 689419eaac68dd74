/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "hydrostaticPressure.H"
#include "couplingEntries.H"
#include "fvcReconstruct.H"
#include "fvcSnGrad.H"
#include "Time.H"
#include "uniformDimensionedFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

// OpenFOAM keeps it with the time, older solvers with the mesh
const uniformDimensionedVectorField* gravity(const fvMesh& mesh)
{
    const auto* g = mesh.time().cfindObject<uniformDimensionedVectorField>("g");
    return g ? g : mesh.cfindObject<uniformDimensionedVectorField>("g");
}


// Stop if the solver cannot get a velocity from its flux. Collective
void checkReconstruct(const fvMesh& mesh)
{
    vector u(1, 2, 3);
    forAll(u, k)
    {
        u[k] *= mesh.geometricD()[k] > 0;
    }
    const surfaceScalarField flux(mesh.Sf() & dimensionedVector("u", dimless, u));
    const tmp<volVectorField> tvelocity(fvc::reconstruct(flux));
    scalar wrong = 0;
    for (vector v : tvelocity().primitiveField())
    {
        forAll(v, k)
        {
            v[k] *= mesh.geometricD()[k] > 0;
        }
        wrong = max(wrong, mag(v - u));
    }
    reduce(wrong, maxOp<scalar>());
    if (wrong > 1e-3)
    {
        couplingEntries::onMaster
        (
            [&]()
            {
                FatalErrorInFunction
                    << "On this mesh fvc::reconstruct of this build of OpenFOAM is wrong: of the flux of"
                    << " the velocity " << u << " it makes another one. Solvers with p_rgh get U by it."
                    << " Known of OpenFOAM 1912 in Debian 12 (g++ 12), in cells whose faces are not"
                    << " normal to the axes. Take a mesh whose faces are normal to them (constant/polyMesh;"
                    << " blockMesh without curved or oblique edges), or another build of OpenFOAM"
                    << exit(FatalError);
            }
        );
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::hydrostaticPressure::hydrostaticPressure(const fvMesh& mesh)
:
    mesh_(mesh)
{
    checkReconstruct(mesh);
}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

Foam::string Foam::hydrostaticPressure::missing(const fvMesh& mesh)
{
    if (!mesh.foundObject<volScalarField>("p_rgh"))
    {
        return "it has no field p_rgh, the pressure without the hydrostatic part";
    }
    if (!gravity(mesh))
    {
        return "it has no gravity g (constant/g)";
    }
    return string();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::volScalarField& Foam::hydrostaticPressure::p_rgh() const
{
    return mesh_.lookupObject<volScalarField>("p_rgh");
}


const Foam::vector& Foam::hydrostaticPressure::g() const
{
    return gravity(mesh_)->value();
}


const Foam::volScalarField& Foam::hydrostaticPressure::ofSameTime(const volScalarField& field) const
{
    return field.timeIndex() > p_rgh().timeIndex() ? field.oldTime() : field;
}


Foam::tmp<Foam::volVectorField> Foam::hydrostaticPressure::gradient
(
    const volScalarField& rho,
    const tmp<surfaceScalarField>& force
) const
{
    const uniformDimensionedVectorField& g = *gravity(mesh_);

    // As the solvers' gh.H has it
    dimensionedScalar ghRef(g.dimensions()*dimLength, Zero);
    const auto* hRef = mesh_.cfindObject<uniformDimensionedScalarField>("hRef");
    if (hRef && mag(g.value()) > SMALL)
    {
        ghRef = g & (cmptMag(g.value())/mag(g.value()))*(*hRef);
    }
    const surfaceScalarField ghf((g & mesh_.Cf()) - ghRef);

    tmp<surfaceScalarField> tgradient(ghf*fvc::snGrad(rho) + fvc::snGrad(p_rgh()));
    if (force.valid())
    {
        tgradient.ref() -= force();
    }
    return rho*g + fvc::reconstruct(tgradient*mesh_.magSf());
}


// ************************************************************************* //
