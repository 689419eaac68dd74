/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Scalars that change with the grains while the fluid stays as it is, see pointValues.H.

\*---------------------------------------------------------------------------*/

#include "pointValues.H"
#include "emptyPolyPatch.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::largeVector<Foam::scalar>& Foam::pointValues::change(const sampledFields::field& field)
{
    const label nCells = mesh_.nCells();
    largeVector<scalar>& values = former_[field.lane];
    scalar* row = cells_.data() + field.lane;
    if (values.empty())
    {
        values.resize(nCells + mesh_.nBoundaryFaces());
        for (scalar& value : values)
        {
            value = *row;
            row += width_;
        }
    }

    const auto mark = [&](const labelUList& points)
    {
        for (const label pointi : points)
        {
            if ((everywhere_ || isFresh_.test(pointi)) && isChanged_.set(pointi))
            {
                changedPoints_.append(pointi);
            }
        }
    };
    const auto take = [&](const label i, const scalar value)
    {
        const bool changed = (value != values[i]);
        if (changed)
        {
            values[i] = cells_[width_*i + field.lane] = value;
        }
        return changed;
    };

    const scalarField& inCells = field.scalar->primitiveField();
    forAll(inCells, celli)
    {
        if (take(celli, inCells[celli]))
        {
            mark(mesh_.cellPoints()[celli]);
        }
    }
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (isA<coupledPolyPatch>(patch) || isA<emptyPolyPatch>(patch))
        {
            continue;
        }
        const scalarField& onFaces = field.scalar->boundaryField()[patch.index()];
        forAll(patch, i)
        {
            if (take(nCells + patch.start() - mesh_.nInternalFaces() + i, onFaces[i]))
            {
                mark(patch[i]);
            }
        }
    }
    return values;
}


void Foam::pointValues::updateLane(const sampledFields::field& field)
{
    // Sums over sides begin anew with the parts of this one
    isChanged_.resize(mesh_.nPoints());
    isChanged_.reset();
    changedPoints_ = coupledHere_;
    isChanged_.set(coupledHere_);

    const largeVector<scalar>& values = change(field);
    for (const label pointi : changedPoints_)
    {
        scalar sum = 0;
        for (label part = firstPart_[pointi]; part < firstPart_[pointi + 1]; ++part)
        {
            sum += weights_[part]*values[parts_[part]];
        }
        points_[width_*pointi + field.lane] = sum;
    }

    coupled_.sum(points_.data() + field.lane, 1, width_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::pointValues::scalarsAlone(const sampledFields& fields) const
{
    return matching_ && unmatched_.empty() && std::none_of
    (
        fields.fields.begin(), fields.fields.end(),
        [](const sampledFields::field& field) { return field.withGrains && field.vector; }
    );
}


// ************************************************************************* //
