/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Sums over the parts of points, of all or where grains are, see pointValues.H.

\*---------------------------------------------------------------------------*/

#include "pointValues.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<Foam::label nBlocks>
void Foam::pointValues::sumPoints(const label firstBlock)
{
    constexpr label n = nBlocks*blockSize;
    const scalar* cells = cells_.data() + blockSize*firstBlock;
    scalar* row = points_.data() + blockSize*firstBlock;
    const label nPoints = mesh_.nPoints();
    label part = 0;
    for (label i = 0; i < nPoints; ++i)
    {
        scalar sum[n] = {};
        for (const label end = firstPart_[i + 1]; part < end; ++part)
        {
            const scalar weight = weights_[part];
            const scalar* values = cells + width_*parts_[part];
            for (label k = 0; k < n; ++k)
            {
                sum[k] += weight*values[k];
            }
        }
        std::copy_n(sum, n, row);
        row += width_;
    }
}


template<Foam::label nBlocks>
void Foam::pointValues::sumSome(const label firstBlock)
{
    constexpr label n = nBlocks*blockSize;
    const scalar* cells = cells_.data() + blockSize*firstBlock;
    for (const label pointi : toSum_)
    {
        scalar sum[n] = {};
        for (label part = firstPart_[pointi]; part < firstPart_[pointi + 1]; ++part)
        {
            const scalar weight = weights_[part];
            const scalar* values = cells + width_*parts_[part];
            for (label k = 0; k < n; ++k)
            {
                sum[k] += weight*values[k];
            }
        }
        std::copy_n(sum, n, points_.data() + width_*pointi + blockSize*firstBlock);
    }
}


void Foam::pointValues::fillAll(const sampledFields& fields)
{
    for (const sampledFields::field& field : fields.fields)
    {
        packCells(field);
    }
    forBlocks
    (
        [&](const auto n, const label first) { sumPoints<n>(first); }
    );
}


void Foam::pointValues::enter(const labelUList& cells)
{
    for (const label celli : cells)
    {
        if (hasPoints_.set(celli))
        {
            toEnter_.append(celli);
        }
    }
}


bool Foam::pointValues::begin(const sampledFields& fields, const labelUList& cells)
{
    for (bitSet* marks : {&hasRow_, &hasPoints_})
    {
        marks->resize(mesh_.nCells());
        marks->reset();
    }
    isFresh_.resize(mesh_.nPoints());
    isFresh_.reset();

    toEnter_.clear();
    enter(always_);
    enter(cells);
    if (toEnter_.size() > few*mesh_.nCells())
    {
        return false;
    }
    toSum_ = coupledHere_;
    isFresh_.set(coupledHere_);
    sumEntered(fields);
    return true;
}


void Foam::pointValues::fill(const sampledFields& fields, const labelUList& cells)
{
    toEnter_.clear();
    toSum_.clear();
    enter(cells);
    sumEntered(fields);
}


void Foam::pointValues::sumEntered(const sampledFields& fields)
{
    const auto takeRow = [&](const label celli)
    {
        if (celli < mesh_.nCells() && hasRow_.set(celli))
        {
            packRow
            (
                fields,
                [&](const auto& field) -> const auto& { return field[celli]; },
                cells_.data() + width_*celli
            );
        }
    };

    for (const label celli : toEnter_)
    {
        takeRow(celli);
        for (const label pointi : mesh_.cellPoints()[celli])
        {
            if (isFresh_.set(pointi))
            {
                toSum_.append(pointi);
            }
        }
    }
    for (const label pointi : toSum_)
    {
        for (label part = firstPart_[pointi]; part < firstPart_[pointi + 1]; ++part)
        {
            takeRow(parts_[part]);
        }
    }
    forBlocks
    (
        [&](const auto n, const label first) { sumSome<n>(first); }
    );
}


// ************************************************************************* //
