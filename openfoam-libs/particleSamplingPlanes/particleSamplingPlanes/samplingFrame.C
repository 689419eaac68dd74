/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "samplingFrame.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::samplingFrame::samplingFrame()
:
    origin_(Zero),
    axis_(0, 0, 1),
    axisPerDiameter_(0, 0, 1),
    diameter_(1)
{}


Foam::samplingFrame::samplingFrame(const dictionary& dict)
:
    origin_(dict.get<point>("origin")),
    axis_(dict.get<vector>("axis")),
    axisPerDiameter_(Zero),
    diameter_(dict.get<scalar>("diameter"))
{
    // Scaled first, for lengths whose square is no number
    const scalar largest = cmptMax(cmptMag(axis_));
    if (!(largest > 0))
    {
        FatalIOErrorInFunction(dict)
            << "axis " << axis_ << " has no direction;"
            << " give a vector that points downstream"
            << exit(FatalIOError);
    }

    if (!(diameter_ >= 1e-9 && diameter_ <= 1e6))
    {
        FatalIOErrorInFunction(dict)
            << "diameter " << diameter_ << " must lie between 1e-9 and 1e6 m"
            << exit(FatalIOError);
    }

    if (!(cmptMax(cmptMag(origin_)) <= 1e9))
    {
        FatalIOErrorInFunction(dict)
            << "origin " << origin_ << " is too far away: coordinates in m, at"
            << " most 1e9" << exit(FatalIOError);
    }

    axis_ /= largest;
    axis_ /= mag(axis_);
    axisPerDiameter_ = axis_/diameter_;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::samplingFrame::radius(const point& p) const
{
    const vector r(p - origin_);
    return mag(r - (r & axis_)*axis_)/diameter_;
}


Foam::vector Foam::samplingFrame::components
(
    const point& p,
    const vector& v
) const
{
    const vector r(p - origin_);
    vector radial(r - (r & axis_)*axis_);

    if (mag(radial) < ROOTVSMALL)
    {
        // Normal to the axis and to the coordinate direction furthest from it
        vector across(Zero);
        direction furthest = vector::X;
        for (direction cmpt = 1; cmpt < vector::nComponents; ++cmpt)
        {
            if (mag(axis_[cmpt]) < mag(axis_[furthest]))
            {
                furthest = cmpt;
            }
        }
        across[furthest] = 1;
        radial = axis_ ^ across;
    }
    radial /= mag(radial);

    return vector(v & axis_, v & radial, v & (axis_ ^ radial));
}


// ************************************************************************* //
