/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pointValues.H"
#include "cyclicPolyPatch.H"
#include "emptyPolyPatch.H"
#include "pointConstraints.H"
#include "pointMesh.H"
#include "processorPolyPatch.H"
#include "volPointInterpolation.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::pointValues::onPatch(const label bFacei) const
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    const polyPatch& patch = patches[patches.patchID()[bFacei]];
    return !isA<coupledPolyPatch>(patch) && !isA<emptyPolyPatch>(patch);
}


void Foam::pointValues::makeWeights()
{
    const label nCells = mesh_.nCells();
    const label nInner = mesh_.nInternalFaces();
    const pointField& points = mesh_.points();
    const primitivePatch boundary
    (
        SubList<face>(mesh_.faces(), mesh_.nBoundaryFaces(), nInner),
        points
    );
    const auto sum = [&](const label pointi) -> scalar&
    {
        return points_[pointi].values[packed::voidFraction];
    };

    // Points of walls, inlets, outlets take the values of faces there, others those of cells
    for (packed& p : points_)
    {
        p = packed{};
    }
    forAll(boundary, bFacei)
    {
        if (onPatch(bFacei))
        {
            for (const label pointi : boundary[bFacei])
            {
                sum(pointi) = 1;
            }
        }
    }
    coupled_.sum(points_.data());

    // Inverse distances, as volPointInterpolation, over their sum on all sides
    DynamicList<label> parts(8*mesh_.nPoints());
    DynamicList<scalar> weights(8*mesh_.nPoints());
    firstPart_.setSize(mesh_.nPoints() + 1);
    forAll(points, pointi)
    {
        firstPart_[pointi] = parts.size();
        const auto append = [&](const label part, const point& centre)
        {
            parts.append(part);
            weights.append(1/mag(points[pointi] - centre));
        };

        if (sum(pointi) > 0)
        {
            for
            (
                const label bFacei :
                boundary.pointFaces()[boundary.whichPoint(pointi)]
            )
            {
                if (onPatch(bFacei))
                {
                    append(nCells + bFacei, mesh_.faceCentres()[nInner + bFacei]);
                }
            }
        }
        else
        {
            for (const label celli : mesh_.pointCells()[pointi])
            {
                append(celli, mesh_.cellCentres()[celli]);
            }
        }

        sum(pointi) = 0;
        for (label i = firstPart_[pointi]; i < weights.size(); ++i)
        {
            sum(pointi) += weights[i];
        }
    }
    firstPart_.last() = parts.size();
    coupled_.sum(points_.data());

    forAll(points, pointi)
    {
        for (label i = firstPart_[pointi]; i < firstPart_[pointi + 1]; ++i)
        {
            weights[i] /= sum(pointi);
        }
    }
    parts_.assign(parts.begin(), parts.end());
    weights_.assign(weights.begin(), weights.end());

    if (constrained_)
    {
        boundaryPoints_ = boundary.meshPoints();
    }
}


void Foam::pointValues::makePointFields
(
    const volVectorField& U,
    const volVectorField& force
)
{
    const fvMesh& mesh = U.mesh();
    const pointMesh& pMesh = pointMesh::New(mesh);
    const auto make = [&](const char* name, const dimensionSet& dimensions)
    {
        return new pointVectorField
        (
            IOobject(name, mesh.time().timeName(), mesh),
            pMesh,
            dimensionedVector(dimensions, Zero)
        );
    };
    pointU_.reset(make("grainPointU", U.dimensions()));
    pointForce_.reset(make("grainPointForce", force.dimensions()));
}


void Foam::pointValues::packPatches
(
    const volVectorField& U,
    const volVectorField& force,
    const volScalarField& voidFraction
)
{
    packed* values = cells_.data() + mesh_.nCells();
    forAll(U.boundaryField(), patchi)
    {
        const fvPatchVectorField& pU = U.boundaryField()[patchi];
        const fvPatchVectorField& pForce = force.boundaryField()[patchi];
        const fvPatchScalarField& pVoidFraction = voidFraction.boundaryField()[patchi];
        if (!pU.coupled())
        {
            const label start =
                mesh_.boundaryMesh()[patchi].start() - mesh_.nInternalFaces();
            forAll(pU, i)
            {
                values[start + i].set(pU[i], pForce[i], pVoidFraction[i]);
            }
        }
    }
}


void Foam::pointValues::constrain()
{
    const auto apply = [&](pointVectorField& field, const label first)
    {
        for (const label pointi : boundaryPoints_)
        {
            field[pointi] = points_[pointi].get(first);
        }
        pointConstraints::New(field.mesh()).constrain(field, false);
        for (const label pointi : boundaryPoints_)
        {
            points_[pointi].set(first, field[pointi]);
        }
    };
    apply(*pointU_, packed::U);
    apply(*pointForce_, packed::force);
}


void Foam::pointValues::interpolate
(
    const volVectorField& U,
    const volVectorField& force,
    const volScalarField& voidFraction
)
{
    const volPointInterpolation& toPoints = volPointInterpolation::New(U.mesh());
    toPoints.interpolate(U, *pointU_);
    toPoints.interpolate(force, *pointForce_);
    const tmp<pointScalarField> tpVoidFraction(toPoints.interpolate(voidFraction));
    forAll(mesh_.points(), i)
    {
        points_[i].set((*pointU_)[i], (*pointForce_)[i], tpVoidFraction()[i]);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pointValues::pointValues(const polyMesh& mesh)
:
    mesh_(mesh),
    cells_(mesh.nCells() + mesh.nBoundaryFaces()),
    points_(mesh.nPoints()),
    matching_(true),
    coupled_(mesh),
    constrained_(false)
{
    // By type, since a cyclicAMI patch does not call itself coupled. Of patches that constrain,
    // empty ones do not touch vectors at points
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<coupledPolyPatch>(patch))
        {
            matching_ =
                matching_
             && (isA<processorPolyPatch>(patch) || isA<cyclicPolyPatch>(patch))
             && refCast<const coupledPolyPatch>(patch).parallel();
        }
        else if (polyPatch::constraintType(patch.type()))
        {
            constrained_ = constrained_ || !isA<emptyPolyPatch>(patch);
        }
    }

    // A rank knows its own sides only
    matching_ = returnReduce(matching_, andOp<bool>());
    makeWeights();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::pointValues::update
(
    const volVectorField& U,
    const volVectorField& force,
    const volScalarField& voidFraction
)
{
    if (!pointU_ && (!matching_ || constrained_))
    {
        makePointFields(U, force);
    }

    forAll(mesh_.cells(), i)
    {
        cells_[i].set(U[i], force[i], voidFraction[i]);
    }
    if (!matching_)
    {
        interpolate(U, force, voidFraction);
        return;
    }

    packPatches(U, force, voidFraction);
    label part = 0;
    forAll(mesh_.points(), i)
    {
        packed sum{};
        for (const label end = firstPart_[i + 1]; part < end; ++part)
        {
            sum.add(weights_[part], cells_[parts_[part]]);
        }
        points_[i] = sum;
    }
    coupled_.sum(points_.data());
    if (constrained_)
    {
        constrain();
    }
}


// ************************************************************************* //
