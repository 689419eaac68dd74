/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellPointSampler.H"
#include "addToRunTimeSelectionTable.H"
#include "cellPointWeight.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(cellPointSampler, 0);
    addToRunTimeSelectionTable(fluidSampler, cellPointSampler, dictionary);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

inline void Foam::cellPointSampler::put
(
    const grainBatch& grains,
    const label i,
    tetBatch& batch
) const
{
    if (!hasPyramid(grains, i))
    {
        // The tetrahedron of the three axes
        for (direction k = 0; k < 3; ++k)
        {
            batch.r[k][i] = 0;
            batch.b[k][i] = (k == 0);
            batch.q[k][i] = (k == 1);
            batch.d[k][i] = batch.other[k][i] = (k == 2);
        }
        return;
    }

    // All is read before the first is written, as the compiler can't know that they differ
    const point centre(locator_.block(grains.cell[i])->centre);
    const FixedList<label, 4> corners(corners_[grains.pyramid[i]]);
    const vector r(position(grains, i) - centre);
    const vector b(positions_[corners[0]] - centre);
    const vector q(positions_[corners[1]] - centre);
    const vector d(positions_[corners[2]] - centre);
    const vector other(positions_[corners[3]] - centre);
    for (direction k = 0; k < 3; ++k)
    {
        batch.r[k][i] = r[k];
        batch.b[k][i] = b[k];
        batch.q[k][i] = q[k];
        batch.d[k][i] = d[k];
        batch.other[k][i] = other[k];
    }
}


Foam::cellPointSampler::weights Foam::cellPointSampler::search
(
    const point& p,
    const label celli
) const
{
    weights result;
    if (locator_.tets().weigh(p, celli, result.w, result.points))
    {
        return result;
    }
    const cellPointWeight cpw(mesh_, p, celli);
    for (direction k = 0; k < 4; ++k)
    {
        result.w[k] = cpw.weights()[k];
    }
    for (direction k = 0; k < 3; ++k)
    {
        result.points[k] = cpw.faceVertices()[k];
    }
    return result;
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::cellPointSampler::weigh(const grainBatch& grains, weights* places) const
{
    // A point on a common face of tetrahedra may be taken for either: the
    // interpolation is continuous
    const scalar tolerance = -1e-10;

    static_assert(tetBatch::size == grainBatch::size, "one point per grain");
    tetBatch batch;
    for (label i = 0; i < grainBatch::size; ++i)
    {
        put(grains, i, batch);
    }
    batch.weigh();

    for (label i = 0; i < grainBatch::size; ++i)
    {
        weights& at = places[i];
        if (i >= grains.n)
        {
            at = places[grains.n - 1];
        }
        else if (hasPyramid(grains, i) && batch.least[i] >= tolerance)
        {
            const FixedList<label, 4>& points = corners_[grains.pyramid[i]];
            for (label k = 0; k < 4; ++k)
            {
                at.w[k] = batch.weights[k][i];
            }
            at.points[0] = points[0];
            at.points[1] = points[2];
            at.points[2] = points[1 + 2*label(batch.isOther[i])];
        }
        else
        {
            at = search(position(grains, i), grains.cell[i]);
        }
    }
}


void Foam::cellPointSampler::interpolate
(
    const grainBatch& grains,
    const weights* places,
    grainBatch::lane* lanes
) const
{
    values_.forBlocks
    (
        [&](const auto nBlocks, const label firstBlock)
        {
            constexpr label n = nBlocks*pointValues::blockSize;
            const label first = firstBlock*pointValues::blockSize;

            // First grain by grain, as the compiler then works on several numbers at once
            scalar rows[grainBatch::size][n];
            for (label i = 0; i < grainBatch::size; ++i)
            {
                const weights& at = places[i];
                const scalar* v0 = values_.inCell(grains.cell[i]) + first;
                const scalar* v1 = values_.atPoint(at.points[0]) + first;
                const scalar* v2 = values_.atPoint(at.points[1]) + first;
                const scalar* v3 = values_.atPoint(at.points[2]) + first;
                for (label k = 0; k < n; ++k)
                {
                    rows[i][k] =
                        at.w[0]*v0[k] + at.w[1]*v1[k] + at.w[2]*v2[k] + at.w[3]*v3[k];
                }
            }

            // The last ones of a row may be no lane: there is room for them
            for (label i = 0; i < grainBatch::size; ++i)
            {
                for (label k = 0; k < n; ++k)
                {
                    lanes[first + k][i] = rows[i][k];
                }
            }
        }
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellPointSampler::cellPointSampler(const cellLocator& locator)
:
    mesh_(locator.mesh()),
    locator_(locator),
    corners_(locator.nFaces()),
    positions_(mesh_.points().begin(), mesh_.points().end()),
    values_(mesh_),
    sampled_(nullptr)
{
    const faceList& faces = mesh_.faces();
    const labelList& bases = locator_.tets().bases();

    forAll(mesh_.cells(), celli)
    {
        const cell& cellFaces = mesh_.cells()[celli];
        forAll(cellFaces, i)
        {
            const label facei = cellFaces[i];
            const face& f = faces[facei];
            const label base = bases[facei];

            FixedList<label, 4>& corners =
                corners_[locator.block(celli)->firstFace + i];
            corners = -1;
            if (f.size() <= 4)
            {
                for (label k = 0; k < 4; ++k)
                {
                    corners[k] = f[(base + min(k, f.size() - 1))%f.size()];
                }
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::cellPointSampler::update(const sampledFields& fields)
{
    values_.update(fields, sampled_);
    sampled_ = nullptr;
}


void Foam::cellPointSampler::at(const grainBatch& grains, grainBatch::lane* lanes) const
{
    weights places[grainBatch::size];
    weigh(grains, places);
    interpolate(grains, places, lanes);
}


// ************************************************************************* //
