/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nearWalls.H"
#include "meshWavePatchDistMethod.H"
#include "bitSet.H"
#include "emptyPolyPatch.H"
#include "symmetryPlanePolyPatch.H"
#include "symmetryPolyPatch.H"
#include "volFields.H"
#include "wallPolyPatch.H"
#include "wedgePolyPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

typedef nearWalls::plane plane;


// Planes of all faces of patches in the cells beside them
void addOwn
(
    const polyMesh& mesh,
    const labelHashSet& patches,
    List<DynamicList<plane>>& planes
)
{
    for (const label patchi : patches)
    {
        const polyPatch& patch = mesh.boundaryMesh()[patchi];
        forAll(patch, i)
        {
            const vector n(normalised(patch.faceAreas()[i]));
            planes[patch.faceCells()[i]].append(plane{n, n & patch.faceCentres()[i]});
        }
    }
}


// In cells without a face of the patches: the plane of the nearest one. Collective
void addNearest
(
    const fvMesh& mesh,
    const labelHashSet& patches,
    List<DynamicList<plane>>& planes
)
{
    bitSet beside(mesh.nCells());
    label nFaces = 0;
    for (const label patchi : patches)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        nFaces += patch.size();
        beside.set(patch.faceCells());
    }
    if (!returnReduce(nFaces, sumOp<label>()))
    {
        return;
    }

    const auto temporary = [&](const word& name)
    {
        return IOobject
        (
            name, mesh.time().timeName(), mesh, IOobject::NO_READ, IOobject::NO_WRITE, false
        );
    };
    volScalarField y
    (
        temporary("nearWalls:y"), mesh, dimensionedScalar(dimLength, Zero)
    );
    volVectorField n
    (
        temporary("nearWalls:n"), mesh, dimensionedVector(dimless, Zero)
    );
    for (const label patchi : patches)
    {
        n.boundaryFieldRef()[patchi] == mesh.boundary()[patchi].nf();
    }
    patchDistMethods::meshWave(mesh, patches).correct(y, n);

    forAll(planes, celli)
    {
        if (!beside.test(celli) && magSqr(n[celli]) > 0.5)
        {
            planes[celli].append(plane{n[celli], y[celli] + (n[celli] & mesh.C()[celli])});
        }
    }
}

} // End anonymous namespace
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::nearWalls::nearWalls(const fvMesh& mesh)
{
    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    const labelHashSet walls(patches.findPatchIDs<wallPolyPatch>());

    labelHashSet symmetries(patches.findPatchIDs<symmetryPlanePolyPatch>());
    symmetries |= patches.findPatchIDs<symmetryPolyPatch>();

    // These have a face in each cell
    labelHashSet sides(patches.findPatchIDs<wedgePolyPatch>());
    sides |= patches.findPatchIDs<emptyPolyPatch>();

    List<DynamicList<plane>> planes(mesh.nCells());
    for (const labelHashSet& kind : {walls, symmetries, sides})
    {
        addOwn(mesh, kind, planes);
    }
    addNearest(mesh, walls, planes);
    addNearest(mesh, symmetries, planes);

    first_.setSize(mesh.nCells() + 1, 0);
    forAll(planes, celli)
    {
        planes_.append(planes[celli]);
        first_[celli + 1] = planes_.size();
    }
}


// ************************************************************************* //
