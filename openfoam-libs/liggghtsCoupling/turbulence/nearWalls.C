/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nearWalls.H"
#include "meshWavePatchDistMethod.H"
#include "volFields.H"
#include "wallPolyPatch.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::nearWalls::nearWalls(const fvMesh& mesh)
{
    const labelHashSet patches
    (
        mesh.boundaryMesh().findPatchIDs<wallPolyPatch>()
    );

    label nFaces = 0;
    for (const label patchi : patches)
    {
        nFaces += mesh.boundary()[patchi].size();
    }
    if (!returnReduce(nFaces, sumOp<label>()))
    {
        return;
    }

    // Distance of each cell from the nearest wall face, and that face's normal
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

    // Wall faces of cells
    List<DynamicList<plane>> own(mesh.nCells());
    for (const label patchi : patches)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        const vectorField nf(patch.nf());
        forAll(nf, i)
        {
            own[patch.faceCells()[i]].append(plane{nf[i], nf[i] & patch.Cf()[i]});
        }
    }

    first_.setSize(mesh.nCells() + 1, 0);
    forAll(own, celli)
    {
        if (own[celli].size())
        {
            planes_.append(own[celli]);
        }
        else if (magSqr(n[celli]) > 0.5)
        {
            planes_.append(plane{n[celli], y[celli] + (n[celli] & mesh.C()[celli])});
        }
        first_[celli + 1] = planes_.size();
    }
}


// ************************************************************************* //
