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

    const point& centre = cells_[grain.cell].position;
    const vector b = points_[corners[0]].position - centre;
    const vector r = grain.position - centre;

    for (direction i = 1; i < 3; ++i)
    {
        const label pa = corners[i];
        const label pc = corners[i + 1];
        const vector a = points_[pa].position - centre;
        const vector c = points_[pc].position - centre;

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
    corners_(locator.nFaces()),
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
                corners_[locator.firstFace(celli) + i];
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

    forAll(mesh_.cells(), i)
    {
        cells_[i].position = mesh_.cellCentres()[i];
    }
    forAll(mesh_.points(), i)
    {
        points_[i].position = mesh_.points()[i];
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
        packed& value = cells_[i];
        value.U = U[i];
        value.force = force[i];
        value.voidFraction = voidFraction[i];
    }

    const cellWeight* part = weights_.data();
    forAll(mesh_.points(), i)
    {
        packed& point = points_[i];
        point.U = Zero;
        point.force = Zero;
        point.voidFraction = 0;
        for (const cellWeight* end = weights_.data() + firstWeight_[i + 1]; part < end; ++part)
        {
            const packed& cell = cells_[part->cell];
            point.U += part->weight*cell.U;
            point.force += part->weight*cell.force;
            point.voidFraction += part->weight*cell.voidFraction;
        }
    }

    // Boundaries: other sides of coupled ones, values of patches, constraints
    const volPointInterpolation& toPoints = volPointInterpolation::New(U.mesh());
    vectorField& pU = pointU_->primitiveFieldRef();
    vectorField& pForce = pointForce_->primitiveFieldRef();
    scalarField& pVoidFraction = pointVoidFraction_->primitiveFieldRef();

    for (const label i : boundaryPoints_)
    {
        pU[i] = points_[i].U;
        pForce[i] = points_[i].force;
        pVoidFraction[i] = points_[i].voidFraction;
    }
    toPoints.interpolateBoundaryField(U, *pointU_, false);
    toPoints.interpolateBoundaryField(force, *pointForce_, false);
    toPoints.interpolateBoundaryField(voidFraction, *pointVoidFraction_, false);
    for (const label i : boundaryPoints_)
    {
        points_[i].U = pU[i];
        points_[i].force = pForce[i];
        points_[i].voidFraction = pVoidFraction[i];
    }
}


void Foam::cellPointSampler::soon(const label celli, const label pyramid) const
{
    if (pyramid >= 0)
    {
        fetch(&corners_[pyramid], sizeof(corners_[0]));
    }
    fetch(&cells_[celli], sizeof(packed));
}


void Foam::cellPointSampler::verySoon(const label pyramid) const
{
    if (pyramid >= 0 && corners_[pyramid][0] >= 0)
    {
        for (const label pointi : corners_[pyramid])
        {
            fetch(&points_[pointi], sizeof(packed));
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
