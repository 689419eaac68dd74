/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "unmatchedPoints.H"
#include "cyclicAMIPolyPatch.H"

#include <vector>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarField Foam::unmatchedPoints::onFaces
(
    const side& from,
    const scalar* values,
    const label width,
    const label lane
)
{
    const cyclicAMIPolyPatch& patch = *from.patch;
    scalarField means(patch.size(), Zero);
    forAll(patch, i)
    {
        for (const label pointi : patch[i])
        {
            means[i] += values[width*pointi + lane];
        }
        means[i] /= patch[i].size();
    }
    return means;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::unmatchedPoints::unmatchedPoints(const polyMesh& mesh)
:
    cut_(mesh, coincidentPoints::identity::cut),
    nPoints_(mesh.nPoints())
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        const auto* ami = isA<cyclicAMIPolyPatch>(patch);
        if (ami && patch.type() == cyclicAMIPolyPatch::typeName && ami->owner())
        {
            sides_.append(side{ami, {}});
            sides_.append(side{&ami->neighbPatch(), {}});
        }
    }

    // Inverse distances from the face centres, over their sum on all ranks
    for (side& s : sides_)
    {
        const cyclicAMIPolyPatch& patch = *s.patch;
        std::vector<scalar> sum(nPoints_, 0);
        s.weights.setSize(patch.size());
        forAll(patch, i)
        {
            const face& f = patch[i];
            s.weights[i].setSize(f.size());
            forAll(f, k)
            {
                s.weights[i][k] =
                    1/mag(mesh.points()[f[k]] - f.centre(mesh.points()));
                sum[f[k]] += s.weights[i][k];
            }
        }
        cut_.sum(sum.data(), 1);
        forAll(patch, i)
        {
            forAll(patch[i], k)
            {
                s.weights[i][k] /= sum[patch[i][k]];
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::unmatchedPoints::add(scalar* values, const label width) const
{
    addAcross(values, width);
    forAll(points_, i)
    {
        scalar* row = values + width*points_[i];
        for (label lane = 0; lane < width; ++lane)
        {
            row[lane] *= factors_[i];
        }
    }
}


void Foam::unmatchedPoints::normaliseBy(const scalar* ones)
{
    std::vector<scalar> values(ones, ones + nPoints_);
    addAcross(values.data(), 1);
    std::vector<scalar> onSides(nPoints_, 0);
    for (const side& s : sides_)
    {
        for (const face& f : static_cast<const polyPatch&>(*s.patch))
        {
            for (const label pointi : f)
            {
                onSides[pointi] = 1;
            }
        }
    }

    // A rank that has a point but no face of its side needs the factor, too
    cut_.sum(onSides.data(), 1);

    DynamicList<label> points;
    DynamicList<scalar> factors;
    for (label pointi = 0; pointi < nPoints_; ++pointi)
    {
        if (onSides[pointi] > 0)
        {
            points.append(pointi);
            factors.append(1/values[pointi]);
        }
    }
    points_.transfer(points);
    factors_.transfer(factors);
}


void Foam::unmatchedPoints::addAcross(scalar* values, const label width) const
{
    for (label pair = 0; pair < sides_.size(); pair += 2)
    {
        std::vector<scalar> added(width*nPoints_, 0);
        for (label lane = 0; lane < width; ++lane)
        {
            const scalarField faces[2] =
            {
                onFaces(sides_[pair], values, width, lane),
                onFaces(sides_[pair + 1], values, width, lane)
            };
            for (const label i : {0, 1})
            {
                const side& to = sides_[pair + i];
                const cyclicAMIPolyPatch& patch = *to.patch;
                const UList<scalar> ifUncovered
                (
                    patch.applyLowWeightCorrection()
                  ? UList<scalar>(faces[i]) : UList<scalar>()
                );
                const scalarField across
                (
                    patch.interpolate(faces[1 - i], ifUncovered)
                );
                forAll(patch, facei)
                {
                    const face& f = patch[facei];
                    forAll(f, k)
                    {
                        added[width*f[k] + lane] +=
                            to.weights[facei][k]*across[facei];
                    }
                }
            }
        }
        cut_.sum(added.data(), width);
        for (label i = 0; i < width*nPoints_; ++i)
        {
            values[i] += added[i];
        }
    }
}


// ************************************************************************* //
