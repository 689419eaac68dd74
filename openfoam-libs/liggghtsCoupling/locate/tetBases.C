/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tetBases.H"
#include "labelIOList.H"
#include "polyMeshTetDecomposition.H"
#include "processorCyclicPolyPatch.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

// The first point of a face, in one direction or the other, that gives good tetrahedra on both
// sides; 0 if there is none
label firstGood
(
    const polyMesh& mesh,
    const label facei,
    const point& behind,
    const bool forward
)
{
    const label n = mesh.faces()[facei].size();
    const point& here = mesh.cellCentres()[mesh.faceOwner()[facei]];
    for (label i = 0; i < n; ++i)
    {
        const label base = (forward ? i : (n - i) % n);
        const scalar quality = min
        (
            polyMeshTetDecomposition::minQuality(mesh, here, facei, true, base),
            polyMeshTetDecomposition::minQuality(mesh, behind, facei, false, base)
        );
        if (quality > polyMeshTetDecomposition::minTetQuality)
        {
            return base;
        }
    }
    return 0;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

Foam::labelList Foam::tetBases(const polyMesh& mesh)
{
    labelList bases(mesh.tetBasePtIs());
    for (label& base : bases)
    {
        base = max(base, 0);
    }
    if (!Pstream::parRun())
    {
        return bases;
    }

    // Numbers of the faces in the undecomposed mesh, from 1 on, negative if the face was turned
    const labelIOList numbers
    (
        IOobject
        (
            "faceProcAddressing",
            mesh.facesInstance(),
            mesh.meshSubDir,
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    );
    if (returnReduce(numbers.size() != mesh.nFaces(), orOp<bool>()))
    {
        return bases;
    }

    pointField behind(mesh.nBoundaryFaces());
    forAll(behind, i)
    {
        behind[i] = mesh.cellCentres()[mesh.faceOwner()[mesh.nInternalFaces() + i]];
    }
    syncTools::swapBoundaryFacePositions(mesh, behind);

    const polyBoundaryMesh& patches = mesh.boundaryMesh();
    for (const polyPatch& patch : patches)
    {
        if (!isA<processorPolyPatch>(patch))
        {
            continue;
        }

        // Faces of a periodic side are not turned; OpenFOAM goes by its first side
        const bool periodic = isA<processorCyclicPolyPatch>(patch);
        const bool isFirst =
            periodic
         && refCast<const coupledPolyPatch>
            (
                patches[refCast<const processorCyclicPolyPatch>(patch).referPatchID()]
            ).owner();
        forAll(patch, i)
        {
            const label facei = patch.start() + i;
            bases[facei] = firstGood
            (
                mesh,
                facei,
                behind[facei - mesh.nInternalFaces()],
                periodic ? isFirst : numbers[facei] > 0
            );
        }
    }
    return bases;
}


// ************************************************************************* //
