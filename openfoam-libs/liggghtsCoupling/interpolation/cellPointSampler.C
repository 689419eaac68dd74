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
    const guestGrain& grain,
    tetBatch& batch,
    const label i
) const
{
    if (!hasPyramid(grain))
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
    const point centre(locator_.block(grain.cell)->centre);
    const FixedList<label, 4> corners(corners_[grain.pyramid]);
    const vector r(grain.position - centre);
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
    const guestGrain& grain
) const
{
    weights result;
    // On a face, but outside of this cell by a few digits, extrapolation would depend on the
    // tetrahedron that is found first
    const cellPointWeight cpw
    (
        mesh_, locator_.drawnIn(grain.position, grain.cell), grain.cell
    );
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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellPointSampler::cellPointSampler(const cellLocator& locator)
:
    mesh_(locator.mesh()),
    locator_(locator),
    corners_(locator.nFaces()),
    positions_(mesh_.points().begin(), mesh_.points().end()),
    values_(mesh_)
{
    const faceList& faces = mesh_.faces();
    const labelList& bases = mesh_.tetBasePtIs();

    forAll(mesh_.cells(), celli)
    {
        const cell& cellFaces = mesh_.cells()[celli];
        forAll(cellFaces, i)
        {
            const label facei = cellFaces[i];
            const face& f = faces[facei];
            const label base = max(bases[facei], 0);

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

void Foam::cellPointSampler::update
(
    const volVectorField& U,
    const volVectorField& force,
    const volScalarField& voidFraction
)
{
    values_.update(U, force, voidFraction);
}


void Foam::cellPointSampler::soon(const label celli, const label pyramid) const
{
    if (pyramid >= 0)
    {
        __builtin_prefetch(&corners_[pyramid]);
    }
    __builtin_prefetch(&values_.inCell(celli));
    __builtin_prefetch(&locator_.block(celli)->centre);
}


void Foam::cellPointSampler::verySoon(const label pyramid) const
{
    if (pyramid >= 0 && corners_[pyramid][0] >= 0)
    {
        for (const label pointi : corners_[pyramid])
        {
            __builtin_prefetch(&values_.atPoint(pointi));
            __builtin_prefetch(&positions_[pointi]);
        }
    }
}


void Foam::cellPointSampler::at
(
    const UList<guestGrain>& grains,
    sample* fluid
) const
{
    // A point on a common face of tetrahedra may be taken for either: the
    // interpolation is continuous
    const scalar tolerance = -1e-10;

    tetBatch batch;
    for (label first = 0; first < grains.size(); first += tetBatch::size)
    {
        const label n = min(label(tetBatch::size), grains.size() - first);
        for (label i = 0; i < tetBatch::size; ++i)
        {
            put(grains[first + min(i, n - 1)], batch, i);
        }
        batch.weigh();

        for (label i = 0; i < n; ++i)
        {
            const guestGrain& grain = grains[first + i];
            weights at;
            if (hasPyramid(grain) && batch.least[i] >= tolerance)
            {
                const FixedList<label, 4>& points = corners_[grain.pyramid];
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
                at = search(grain);
            }

            typedef pointValues::packed packed;
            packed sum{};
            sum.add(at.w[0], values_.inCell(grain.cell));
            for (direction k = 0; k < 3; ++k)
            {
                sum.add(at.w[k + 1], values_.atPoint(at.points[k]));
            }
            fluid[first + i] = sample
            {
                sum.get(packed::U),
                sum.get(packed::force),
                sum.values[packed::voidFraction]
            };
        }
    }
}


// ************************************************************************* //
