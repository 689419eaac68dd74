/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "batchClock.H"
#include <limits>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::batchClock::batchClock()
:
    length_(0),
    current_(0),
    duration_(scalar(0))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::batchClock::advance(const scalar deltaT)
{
    if (length_ == 0)
    {
        length_ = deltaT;
    }

    // Durations are sums of steps, hence the margin
    bool joined = false;
    if (duration_[current_] >= length_*(1 - 1e-6))
    {
        ++current_;
        if (current_ == capacity)
        {
            join(duration_);
            length_ *= 2;
            current_ = capacity/2;
            joined = true;
        }
    }

    duration_[current_] += deltaT;

    return joined;
}


void Foam::batchClock::join(series& values)
{
    for (label i = 0; i < capacity/2; ++i)
    {
        values[i] = values[2*i] + values[2*i + 1];
    }
    for (label i = capacity/2; i < capacity; ++i)
    {
        values[i] = 0;
    }
}


Foam::scalar Foam::batchClock::total() const
{
    scalar sum = 0;
    for (const scalar value : duration_)
    {
        sum += value;
    }
    return sum;
}


Foam::scalar Foam::batchClock::standardError
(
    const series& x,
    const series& y
) const
{
    const label n = size();

    scalar sumX = 0;
    scalar sumY = 0;
    for (label i = 0; i < n; ++i)
    {
        sumX += x[i];
        sumY += y[i];
    }

    if (n < 2 || sumY == 0)
    {
        return std::numeric_limits<scalar>::quiet_NaN();
    }

    const scalar ratio = sumX/sumY;
    scalar sumSqr = 0;
    for (label i = 0; i < n; ++i)
    {
        sumSqr += sqr(x[i] - ratio*y[i]);
    }

    return sqrt(scalar(n)/(n - 1)*sumSqr)/mag(sumY);
}


void Foam::batchClock::pack(scalar* buffer) const
{
    buffer[0] = length_;
    buffer[1] = current_;
    for (label i = 0; i < capacity; ++i)
    {
        buffer[2 + i] = duration_[i];
    }
}


void Foam::batchClock::unpack(const scalar* buffer)
{
    length_ = buffer[0];
    current_ = label(buffer[1]);
    for (label i = 0; i < capacity; ++i)
    {
        duration_[i] = buffer[2 + i];
    }
}


// ************************************************************************* //
