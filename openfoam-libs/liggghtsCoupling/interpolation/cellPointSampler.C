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


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// Ask for memory that will be read: both ends, since it may lie in two cache lines
inline void fetch(const void* first, const std::size_t size)
{
    __builtin_prefetch(first);
    __builtin_prefetch(static_cast<const char*>(first) + size - 1);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::cellPointSampler::makePoints
(
    const volVectorField& U,
    const volVectorField& force,
    const volScalarField& voidFraction
)
{
    const fvMesh& mesh = U.mesh();
    const pointMesh& pMesh = pointMesh::New(mesh);
    const auto io = [&](const char* name)
    {
        return IOobject(name, mesh.time().timeName(), mesh);
    };

    pointU_.reset
    (
        new pointVectorField
        (
            io("grainPointU"), pMesh, dimensionedVector(U.dimensions(), Zero)
        )
    );
    pointForce_.reset
    (
        new pointVectorField
        (
            io("grainPointForce"), pMesh, dimensionedVector(force.dimensions(), Zero)
        )
    );
    pointVoidFraction_.reset
    (
        new pointScalarField
        (
            io("grainPointVoidFraction"), pMesh, dimensionedScalar(dimless, Zero)
        )
    );

    // volPointInterpolation keeps its weights, inverse distances over their sum, to itself.
    // The sum over this side's cells it tells as the interpolation of 1: less than 1 on
    // coupled boundaries, and nothing on others, where cells have no part
    const volScalarField one(io("one"), mesh, dimensionedScalar("one", dimless, scalar(1)));
    pointScalarField sum(io("sum"), pMesh, dimensionedScalar(dimless, Zero));
    volPointInterpolation::New(mesh).interpolateInternalField(one, sum);

    const labelListList& pointCells = mesh.pointCells();
    firstWeight_.setSize(mesh.nPoints() + 1);
    DynamicList<cellWeight> weights(8*mesh.nPoints());
    forAll(mesh_.points(), pointi)
    {
        firstWeight_[pointi] = weights.size();
        if (sum[pointi] <= 0)
        {
            continue;
        }

        scalar all = 0;
        for (const label celli : pointCells[pointi])
        {
            const scalar inverse =
                1/mag(mesh.points()[pointi] - mesh.cellCentres()[celli]);
            weights.append(cellWeight{celli, inverse});
            all += inverse;
        }
        for (label i = firstWeight_[pointi]; i < weights.size(); ++i)
        {
            weights[i].weight *= sum[pointi]/all;
        }
    }
    firstWeight_.last() = weights.size();
    weights_.assign(weights.begin(), weights.end());

    bitSet onBoundary(mesh.nPoints());
    for (label facei = mesh.nInternalFaces(); facei < mesh.nFaces(); ++facei)
    {
        onBoundary.setMany(mesh.faces()[facei].begin(), mesh.faces()[facei].end());
    }
    boundaryPoints_ = onBoundary.sortedToc();
}


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

    const point& centre = locator_.block(grain.cell)->centre;
    const vector r = grain.position - centre;
    const vector b = positions_[corners[0]] - centre;

    // The plane through centre, base and the opposite corner is between the two: first
    // the one on whose side the grain is
    const vector between = b ^ (positions_[corners[2]] - centre);
    const scalar first = between & (positions_[corners[1]] - centre);
    const bool second = (between & r)*first < 0;

    for (const label i : {1 + second, 2 - second})
    {
        const label pa = corners[i];
        const label pc = corners[i + 1];
        const vector a = positions_[pa] - centre;
        const vector c = positions_[pc] - centre;

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
            result = weights{{w0, wb, wa, wc}, {corners[0], pa, pc}};
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
    cells_(mesh_.nCells()),
    points_(mesh_.nPoints())
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
    if (!pointU_)
    {
        makePoints(U, force, voidFraction);
    }

    forAll(mesh_.cells(), i)
    {
        packed& cell = cells_[i];
        cell.set(packed::U, U[i]);
        cell.set(packed::force, force[i]);
        cell.values[packed::voidFraction] = voidFraction[i];
    }

    const cellWeight* part = weights_.data();
    forAll(mesh_.points(), i)
    {
        packed sum{};
        for (const cellWeight* end = weights_.data() + firstWeight_[i + 1]; part < end; ++part)
        {
            sum.add(part->weight, cells_[part->cell]);
        }
        points_[i] = sum;
    }

    // Boundaries: other sides of coupled ones, values of patches, constraints
    const volPointInterpolation& toPoints = volPointInterpolation::New(U.mesh());
    vectorField& pU = pointU_->primitiveFieldRef();
    vectorField& pForce = pointForce_->primitiveFieldRef();
    scalarField& pVoidFraction = pointVoidFraction_->primitiveFieldRef();

    for (const label i : boundaryPoints_)
    {
        pU[i] = points_[i].get(packed::U);
        pForce[i] = points_[i].get(packed::force);
        pVoidFraction[i] = points_[i].values[packed::voidFraction];
    }
    toPoints.interpolateBoundaryField(U, *pointU_, false);
    toPoints.interpolateBoundaryField(force, *pointForce_, false);
    toPoints.interpolateBoundaryField(voidFraction, *pointVoidFraction_, false);
    for (const label i : boundaryPoints_)
    {
        points_[i].set(packed::U, pU[i]);
        points_[i].set(packed::force, pForce[i]);
        points_[i].values[packed::voidFraction] = pVoidFraction[i];
    }
}


void Foam::cellPointSampler::soon(const label celli, const label pyramid) const
{
    if (pyramid >= 0)
    {
        fetch(&corners_[pyramid], sizeof(corners_[0]));
    }
    fetch(&cells_[celli], sizeof(packed));
    fetch(&locator_.block(celli)->centre, sizeof(point));
}


void Foam::cellPointSampler::verySoon(const label pyramid) const
{
    if (pyramid >= 0 && corners_[pyramid][0] >= 0)
    {
        for (const label pointi : corners_[pyramid])
        {
            fetch(&points_[pointi], sizeof(packed));
            fetch(&positions_[pointi], sizeof(point));
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

    packed sum{};
    sum.add(at.w[0], cells_[grain.cell]);
    for (direction k = 0; k < 3; ++k)
    {
        sum.add(at.w[k + 1], points_[at.points[k]]);
    }
    return sample
    {
        sum.get(packed::U), sum.get(packed::force), sum.values[packed::voidFraction]
    };
}


// ************************************************************************* //
