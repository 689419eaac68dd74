/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Sums over the parts of points, of all or where grains are, see pointValues.H.

\*---------------------------------------------------------------------------*/

#include "pointValues.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// n numbers of a point: the sum over its parts, from the first to the one before the last
template<Foam::label n>
inline void sumPoint
(
    const Foam::scalar* cells,
    const Foam::label width,
    const Foam::scalar* weights,
    const Foam::label* parts,
    const Foam::label first,
    const Foam::label last,
    Foam::scalar* row
)
{
    Foam::scalar sum[n] = {};
    for (Foam::label part = first; part < last; ++part)
    {
        const Foam::scalar weight = weights[part];
        const Foam::scalar* values = cells + width*parts[part];
        for (Foam::label k = 0; k < n; ++k)
        {
            sum[k] += weight*values[k];
        }
    }
    std::copy_n(sum, n, row);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<Foam::label nBlocks>
void Foam::pointValues::sumPoints(const label firstBlock)
{
    constexpr label n = nBlocks*blockSize;
    const scalar* cells = cells_.data() + blockSize*firstBlock;
    scalar* row = points_.data() + blockSize*firstBlock;
    const label nPoints = mesh_.nPoints();
    for (label i = 0; i < nPoints; ++i)
    {
        sumPoint<n>(cells, width_, weights_.data(), parts_.data(), firstPart_[i], firstPart_[i + 1], row);
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
        sumPoint<n>
        (
            cells, width_, weights_.data(), parts_.data(), firstPart_[pointi], firstPart_[pointi + 1],
            points_.data() + width_*pointi + blockSize*firstBlock
        );
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
