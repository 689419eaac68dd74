/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pointValues.H"
#include "cyclicAMIPolyPatch.H"
#include "cyclicPolyPatch.H"
#include "emptyPolyPatch.H"
#include "pointConstraints.H"
#include "pointMesh.H"
#include "processorPolyPatch.H"
#include "volPointInterpolation.H"

#include <algorithm>

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
    List<scalar> sum(mesh_.nPoints(), Zero);

    // Points of walls, inlets, outlets take the values of faces there, others those of cells
    forAll(boundary, bFacei)
    {
        if (onPatch(bFacei))
        {
            for (const label pointi : boundary[bFacei])
            {
                sum[pointi] = 1;
            }
        }
    }
    coupled_.sum(sum.data(), 1);

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

        if (sum[pointi] > 0)
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

        sum[pointi] = 0;
        for (label i = firstPart_[pointi]; i < weights.size(); ++i)
        {
            sum[pointi] += weights[i];
        }
    }
    firstPart_.last() = parts.size();
    coupled_.sum(sum.data(), 1);
    unmatched_.add(sum.data(), 1);

    forAll(points, pointi)
    {
        for (label i = firstPart_[pointi]; i < firstPart_[pointi + 1]; ++i)
        {
            weights[i] /= sum[pointi];
        }
    }
    parts_.assign(parts.begin(), parts.end());
    weights_.assign(weights.begin(), weights.end());

    // What these make of a field that is one everywhere
    forAll(points, pointi)
    {
        sum[pointi] = 0;
        for (label i = firstPart_[pointi]; i < firstPart_[pointi + 1]; ++i)
        {
            sum[pointi] += weights_[i];
        }
    }
    coupled_.sum(sum.data(), 1);
    unmatched_.normaliseBy(sum.data());

    if (constrained_)
    {
        boundaryPoints_ = boundary.meshPoints();
    }
}


void Foam::pointValues::packCells(const sampledFields::field& field)
{
    scalar* row = cells_.data() + field.lane;
    if (field.scalar)
    {
        for (const scalar value : field.scalar->primitiveField())
        {
            *row = value;
            row += width_;
        }
    }
    else
    {
        for (const vector& value : field.vector->primitiveField())
        {
            row[0] = value.x();
            row[1] = value.y();
            row[2] = value.z();
            row += width_;
        }
    }
}


void Foam::pointValues::packPatches(const sampledFields& fields)
{
    scalar* rows = cells_.data() + width_*mesh_.nCells();
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        const label patchi = patch.index();
        const bool empty = isA<emptyPolyPatch>(patch);
        if (!isA<coupledPolyPatch>(patch) && !empty)
        {
            const label start = patch.start() - mesh_.nInternalFaces();
            forAll(patch, i)
            {
                packRow
                (
                    fields,
                    [&](const auto& field) -> const auto&
                    {
                        return field.boundaryField()[patchi][i];
                    },
                    rows + width_*(start + i)
                );
            }
        }
    }
}


void Foam::pointValues::constrain(const sampledFields& fields)
{
    for (const sampledFields::field& field : fields.fields)
    {
        if (!field.vector)
        {
            continue;
        }
        if (!pointVector_)
        {
            const fvMesh& mesh = field.vector->mesh();
            pointVector_.reset
            (
                new pointVectorField
                (
                    IOobject("grainPointVector", mesh.time().timeName(), mesh),
                    pointMesh::New(mesh),
                    dimensionedVector(dimless, Zero)
                )
            );
        }
        pointVectorField& values = *pointVector_;
        for (const label pointi : boundaryPoints_)
        {
            const scalar* row = atPoint(pointi) + field.lane;
            values[pointi] = vector(row[0], row[1], row[2]);
        }
        pointConstraints::New(values.mesh()).constrain(values, false);
        for (const label pointi : boundaryPoints_)
        {
            std::copy_n
            (
                values[pointi].cdata(), 3, &points_[width_*pointi + field.lane]
            );
        }
    }
}


void Foam::pointValues::interpolate(const sampledFields& fields)
{
    for (const sampledFields::field& field : fields.fields)
    {
        const fvMesh& mesh = field.scalar ? field.scalar->mesh() : field.vector->mesh();
        const volPointInterpolation& toPoints = volPointInterpolation::New(mesh);
        scalar* row = points_.data() + field.lane;
        if (field.scalar)
        {
            const tmp<pointScalarField> tvalues(toPoints.interpolate(*field.scalar));
            for (const scalar value : tvalues().primitiveField())
            {
                *row = value;
                row += width_;
            }
        }
        else
        {
            const tmp<pointVectorField> tvalues(toPoints.interpolate(*field.vector));
            for (const vector& value : tvalues().primitiveField())
            {
                std::copy_n(value.cdata(), 3, row);
                row += width_;
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pointValues::pointValues(const polyMesh& mesh)
:
    mesh_(mesh),
    nLanes_(0),
    width_(0),
    everywhere_(true),
    matching_(true),
    coupled_(mesh),
    coupledHere_(coupled_.own()),
    unmatched_(mesh),
    constrained_(false)
{
    // Sides that are rotated are left to OpenFOAM, and those of other kinds. By type, since a cyclicAMI
    // patch does not call itself coupled. Of patches that constrain, empty ones do not touch vectors
    // at points
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<coupledPolyPatch>(patch))
        {
            matching_ =
                matching_
             && (
                    isA<processorPolyPatch>(patch)
                 || isA<cyclicPolyPatch>(patch)
                 || patch.type() == cyclicAMIPolyPatch::typeName
                )
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

void Foam::pointValues::update(const sampledFields& fields, const labelUList* cells)
{
    if (nLanes_ != fields.nLanes)
    {
        nLanes_ = fields.nLanes;
        width_ = (nLanes_ + blockSize - 1)/blockSize*blockSize;
        cells_.assign(width_*(mesh_.nCells() + mesh_.nBoundaryFaces()), 0);
        points_.assign(width_*mesh_.nPoints(), 0);
    }

    if (!fields.newFluid && scalarsAlone(fields))
    {
        for (const sampledFields::field& field : fields.fields)
        {
            if (field.withGrains)
            {
                updateLane(field);
            }
        }
        if (!everywhere_)
        {
            fill(fields, *cells);
        }
        return;
    }

    former_.clear();
    if (!matching_)
    {
        for (const sampledFields::field& field : fields.fields)
        {
            packCells(field);
        }
        interpolate(fields);
        return;
    }

    packPatches(fields);
    everywhere_ = !cells || constrained_ || !unmatched_.empty() || !begin(fields, *cells);
    if (everywhere_)
    {
        fillAll(fields);
    }
    coupled_.sum(points_.data(), width_);
    unmatched_.add(points_.data(), width_);
    if (constrained_)
    {
        constrain(fields);
    }
}


// ************************************************************************* //
