/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshFigures.H"
#include "polyMeshTetDecomposition.H"

// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

Foam::meshFigures::depth Foam::meshFigures::depthIn
(
    const polyMesh& mesh,
    const point& p,
    const label celli
)
{
    depth result{-GREAT, 0};
    for (const tetIndices& tet : polyMeshTetDecomposition::cellTetIndices(mesh, celli))
    {
        const scalar volume = tet.tet(mesh).mag();
        const barycentric b(tet.tet(mesh).pointToBarycentric(p));
        const scalar least = min(min(b[0], b[1]), min(b[2], b[3]));
        result.nHolding += (mag(volume) > 0 && least >= -1e-10);
        if (volume > 0)
        {
            result.largest = max(result.largest, least);
        }
    }
    return result;
}


void Foam::meshFigures::print(const polyMesh& mesh)
{
    label maxPoints = 0;
    label nWarped = 0;
    scalar warp = 0;
    forAll(mesh.faces(), facei)
    {
        const face& f = mesh.faces()[facei];
        const vector normal(mesh.faceAreas()[facei]/mag(mesh.faceAreas()[facei]));
        scalar off = 0;
        for (const label pointi : f)
        {
            off = max(off, mag(normal & (mesh.points()[pointi] - mesh.faceCentres()[facei])));
        }
        off /= sqrt(mag(mesh.faceAreas()[facei]));
        maxPoints = max(maxPoints, f.size());
        nWarped += (off > 1e-6);
        warp = max(warp, off);
    }

    label maxFaces = 0;
    label nNotConvex = 0;
    label nInverted = 0;
    forAll(mesh.cells(), celli)
    {
        const point& centre = mesh.cellCentres()[celli];
        const labelList points(mesh.cells()[celli].labels(mesh.faces()));
        maxFaces = max(maxFaces, mesh.cells()[celli].size());
        bool convex = true;
        for (const label facei : mesh.cells()[celli])
        {
            const scalar sign = (mesh.faceOwner()[facei] == celli ? 1 : -1);
            const vector normal(sign*mesh.faceAreas()[facei]/mag(mesh.faceAreas()[facei]));
            const scalar h = normal & (mesh.faceCentres()[facei] - centre);
            scalar own = 0;
            for (const label pointi : mesh.faces()[facei])
            {
                own = max(own, normal & (mesh.points()[pointi] - mesh.faceCentres()[facei]));
            }
            for (const label pointi : points)
            {
                const scalar out = normal & (mesh.points()[pointi] - mesh.faceCentres()[facei]);
                convex = convex && out < own + 1e-6*mag(h);
            }
        }
        nNotConvex += !convex;
        for (const tetIndices& tet : polyMeshTetDecomposition::cellTetIndices(mesh, celli))
        {
            nInverted += (tet.tet(mesh).mag() <= 0);
        }
    }

    reduce(maxPoints, maxOp<label>());
    reduce(maxFaces, maxOp<label>());
    reduce(warp, maxOp<scalar>());
    const auto all = [](const label n){ return returnReduce(n, sumOp<label>()); };
    Info<< "result cells " << all(mesh.nCells()) << nl
        << "result facesOfCell " << maxFaces << nl
        << "result pointsOfFace " << maxPoints << nl
        << "result warpedFaces " << scalar(all(nWarped))/all(mesh.nFaces()) << nl
        << "result warp " << warp << nl
        << "result cellsNotConvex " << scalar(all(nNotConvex))/all(mesh.nCells()) << nl
        << "result invertedTetrahedra " << all(nInverted) << endl;
}


// ************************************************************************* //
