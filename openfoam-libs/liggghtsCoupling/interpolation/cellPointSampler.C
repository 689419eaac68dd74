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


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// Ask for memory that will be read: both ends, since it may lie in two cache lines
inline void fetch(const Foam::point& p)
{
    __builtin_prefetch(&p);
    __builtin_prefetch(&p.z());
}

} // End anonymous namespace


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

    const FixedList<label, 4>& corners = corners_[grain.pyramid];
    if (corners[0] < 0)
    {
        return false;
    }

    // Both tetrahedra have the centre, the base b and the opposite corner d, and each one of the
    // corners beside them, q: r = wb b + wd d + wq q by Cramer's rule
    const point& centre = locator_.block(grain.cell)->centre;
    const vector r = grain.position - centre;
    const vector b = positions_[corners[0]] - centre;
    const vector d = positions_[corners[2]] - centre;
    const vector between = b ^ d;
    const vector rb = r ^ b;
    const vector dr = d ^ r;
    const scalar side = between & r;

    // First the one on whose side the grain is: a number rather than a branch, of which half
    // would be foretold wrong. A triangle has but one
    const bool triangle = (corners[3] == corners[2]);
    const bool other = (between & (positions_[corners[1]] - centre))*side < 0;
    label beside = 1 + 2*(other && !triangle);

    for (label i = 0; i < 2 - triangle; ++i, beside = 4 - beside)
    {
        const vector q = positions_[corners[beside]] - centre;
        const scalar inverse = 1/(between & q);
        const scalar wb = -(dr & q)*inverse;
        const scalar wd = -(rb & q)*inverse;
        const scalar wq = side*inverse;
        const scalar w0 = 1 - wb - wd - wq;

        if (min(min(wb, wd), min(wq, w0)) >= tolerance)
        {
            result = weights
            {
                {w0, wb, wd, wq}, {corners[0], corners[2], corners[beside]}
            };
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
    fetch(locator_.block(celli)->centre);
}


void Foam::cellPointSampler::verySoon(const label pyramid) const
{
    if (pyramid >= 0 && corners_[pyramid][0] >= 0)
    {
        for (const label pointi : corners_[pyramid])
        {
            __builtin_prefetch(&values_.atPoint(pointi));
            fetch(positions_[pointi]);
        }
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

    typedef pointValues::packed packed;
    packed sum{};
    sum.add(at.w[0], values_.inCell(grain.cell));
    for (direction k = 0; k < 3; ++k)
    {
        sum.add(at.w[k + 1], values_.atPoint(at.points[k]));
    }
    return sample
    {
        sum.get(packed::U), sum.get(packed::force), sum.values[packed::voidFraction]
    };
}


// ************************************************************************* //
