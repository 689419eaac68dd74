/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ringStatistics.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// A parcel that turned round within the step has no meaningful axial velocity
// at its end: below this part of the mean speed over the step it is not believed
static const scalar leastSpeedRatio = 0.1;

static void copy(const batchClock::series& from, scalar*& to)
{
    for (const scalar value : from)
    {
        *to++ = value;
    }
}

static void copy(const scalar*& from, batchClock::series& to)
{
    for (scalar& value : to)
    {
        value = *from++;
    }
}

static void add(batchClock::series& to, const batchClock::series& from)
{
    forAll(to, i)
    {
        to[i] += from[i];
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::ringStatistics::ringStatistics()
:
    forward_(0),
    backward_(0),
    netMass_(0),
    particles_(scalar(0)),
    axialSum_(scalar(0)),
    netParticles_(scalar(0))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::ringStatistics::book(const crossing& c, const label batch)
{
    ++(c.forward ? forward_ : backward_);

    const scalar sign = c.forward ? 1 : -1;
    netMass_ += sign*c.mass;

    const scalar axial = c.velocity.x();
    const scalar speed = max(mag(axial), leastSpeedRatio*c.speedOverStep);
    flux_.add(c.velocity, c.nParticle);
    concentration_.add(c.velocity, c.nParticle/speed);

    particles_[batch] += c.nParticle;
    axialSum_[batch] += c.nParticle*axial;
    netParticles_[batch] += sign*c.nParticle;
}


void Foam::ringStatistics::joinBatches()
{
    batchClock::join(particles_);
    batchClock::join(axialSum_);
    batchClock::join(netParticles_);
}


void Foam::ringStatistics::merge(const ringStatistics& other)
{
    forward_ += other.forward_;
    backward_ += other.backward_;
    netMass_ += other.netMass_;
    flux_.merge(other.flux_);
    concentration_.merge(other.concentration_);
    add(particles_, other.particles_);
    add(axialSum_, other.axialSum_);
    add(netParticles_, other.netParticles_);
}


Foam::scalar Foam::ringStatistics::netParticles() const
{
    scalar sum = 0;
    for (const scalar value : netParticles_)
    {
        sum += value;
    }
    return sum;
}


void Foam::ringStatistics::pack(scalar* buffer) const
{
    // Exact below 2^53
    *buffer++ = scalar(forward_);
    *buffer++ = scalar(backward_);
    *buffer++ = netMass_;
    flux_.pack(buffer);
    buffer += weightedMoments::packedSize;
    concentration_.pack(buffer);
    buffer += weightedMoments::packedSize;
    copy(particles_, buffer);
    copy(axialSum_, buffer);
    copy(netParticles_, buffer);
}


void Foam::ringStatistics::unpack(const scalar* buffer)
{
    forward_ = int64_t(*buffer++);
    backward_ = int64_t(*buffer++);
    netMass_ = *buffer++;
    flux_.unpack(buffer);
    buffer += weightedMoments::packedSize;
    concentration_.unpack(buffer);
    buffer += weightedMoments::packedSize;
    copy(buffer, particles_);
    copy(buffer, axialSum_);
    copy(buffer, netParticles_);
}


// ************************************************************************* //
