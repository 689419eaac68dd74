/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellPointSampler.H"
#include "addToRunTimeSelectionTable.H"
#include "cellPointWeight.H"
#include "volPointInterpolation.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(cellPointSampler, 0);
    addToRunTimeSelectionTable(fluidSampler, cellPointSampler, dictionary);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::cellPointSampler::inPyramid
(
    const guestGrain& grain,
    weights& result
) const
{
    if (grain.pyramid < 0)
    {
        return false;
    }

    // A point on a common face of tetrahedra may be taken for either: the
    // interpolation is continuous
    const scalar tolerance = -1e-10;

    const face& f = mesh_.faces()[grain.pyramid];
    const label base = max(mesh_.tetBasePtIs()[grain.pyramid], 0);
    const pointField& points = mesh_.points();

    const point& centre = mesh_.cellCentres()[grain.cell];
    const vector b = points[f[base]] - centre;
    const vector r = grain.position - centre;

    for (label i = 1; i < f.size() - 1; ++i)
    {
        const label pa = f[(base + i)%f.size()];
        const label pc = f[(base + i + 1)%f.size()];
        const vector a = points[pa] - centre;
        const vector c = points[pc] - centre;

        // Cramer's rule for r = wb b + wa a + wc c
        const vector ac = a ^ c;
        const scalar inverse = 1/(b & ac);
        const vector rb = r ^ b;
        const scalar wb = (r & ac)*inverse;
        const scalar wa = (rb & c)*(-inverse);
        const scalar wc = (rb & a)*inverse;
        const scalar w0 = 1 - wa - wb - wc;

        if (min(min(wa, wb), min(wc, w0)) >= tolerance)
        {
            result = weights{{w0, wb, wa, wc}, {f[base], pa, pc}};
            return true;
        }
    }
    return false;
}


void Foam::cellPointSampler::search
(
    const guestGrain& grain,
    weights& result
) const
{
    const cellPointWeight cpw(mesh_, grain.position, grain.cell);
    for (direction k = 0; k < 4; ++k)
    {
        result.w[k] = cpw.weights()[k];
    }
    for (direction k = 0; k < 3; ++k)
    {
        result.points[k] = cpw.faceVertices()[k];
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellPointSampler::cellPointSampler(const fvMesh& mesh)
:
    mesh_(mesh),
    cells_(mesh.nCells()),
    points_(mesh.nPoints())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::cellPointSampler::update
(
    const volVectorField& U,
    const volVectorField& force,
    const volScalarField& voidFraction
)
{
    const volPointInterpolation& toPoints = volPointInterpolation::New(mesh_);

    const tmp<pointVectorField> pU(toPoints.interpolate(U));
    const tmp<pointVectorField> pForce(toPoints.interpolate(force));
    const tmp<pointScalarField> pVoidFraction(toPoints.interpolate(voidFraction));

    forAll(cells_, i)
    {
        cells_[i] = {U[i], force[i], voidFraction[i]};
    }
    forAll(points_, i)
    {
        points_[i] = {pU()[i], pForce()[i], pVoidFraction()[i]};
    }
}


Foam::fluidSampler::sample Foam::cellPointSampler::at
(
    const guestGrain& grain
) const
{
    weights at;
    if (!inPyramid(grain, at))
    {
        search(grain, at);
    }

    const packed& cell = cells_[grain.cell];
    sample result
    {
        at.w[0]*cell.U, at.w[0]*cell.force, at.w[0]*cell.voidFraction
    };
    for (direction k = 0; k < 3; ++k)
    {
        const packed& value = points_[at.points[k]];
        result.U += at.w[k + 1]*value.U;
        result.force += at.w[k + 1]*value.force;
        result.voidFraction += at.w[k + 1]*value.voidFraction;
    }
    return result;
}


// ************************************************************************* //
