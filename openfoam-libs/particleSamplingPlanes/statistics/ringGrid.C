/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ringGrid.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::ringGrid::binning> Foam::ringGrid::binningNames
({
    { binning::equalWidth, "equalWidth" },
    { binning::equalArea, "equalArea" },
});


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::ringGrid::ringGrid
(
    const label size,
    const scalar maxRadius,
    const binning bins
)
:
    size_(size),
    maxRadius_(maxRadius),
    binning_(bins)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::ringGrid::radius(const label i) const
{
    const scalar part = scalar(i)/size_;
    return maxRadius_*(binning_ == binning::equalWidth ? part : sqrt(part));
}


Foam::label Foam::ringGrid::index(const scalar radius) const
{
    const scalar ratio = radius/maxRadius_;
    if (!(ratio < 1))
    {
        return size_;
    }

    const scalar part = binning_ == binning::equalWidth ? ratio : sqr(ratio);
    return min(label(part*size_), size_ - 1);
}


// ************************************************************************* //
