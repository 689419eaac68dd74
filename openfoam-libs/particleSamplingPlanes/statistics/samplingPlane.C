/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "samplingPlane.H"
#include "mathematicalConstants.H"
#include <limits>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// The columns up to stderr_... come first and in this order by agreement with
// those who read the files by column
static const char* columnNames =
    "r/D"
    "\tcrossings"
    "\tflux_weighted_mean_axial"
    "\tflux_weighted_mean_radial"
    "\tflux_weighted_rms_axial"
    "\tflux_weighted_rms_radial"
    "\tflux_weighted_rms_tangential"
    "\tnumber_flux"
    "\tmass_flux"
    "\tstderr_flux_weighted_mean_axial"
    "\tstderr_number_flux"
    "\tflux_weighted_mean_tangential"
    "\tconcentration_weighted_mean_axial"
    "\tconcentration_weighted_mean_radial"
    "\tconcentration_weighted_mean_tangential"
    "\tconcentration_weighted_rms_axial"
    "\tconcentration_weighted_rms_radial"
    "\tconcentration_weighted_rms_tangential"
    "\tU/Uc"
    "\tG/Gmean"
    "\tforward"
    "\tbackward"
    "\tr_inner/D"
    "\tr_outer/D";

// Division that says that there is nothing to divide by
static scalar ratio(const scalar a, const scalar b)
{
    return b == 0 ? std::numeric_limits<scalar>::quiet_NaN() : a/b;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::samplingPlane::samplingPlane(const scalar position, const label nRings)
:
    position_(position),
    rings_(nRings + 1)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::samplingPlane::joinBatches()
{
    for (ringStatistics& ring : rings_)
    {
        ring.joinBatches();
    }
}


int64_t Foam::samplingPlane::crossings() const
{
    int64_t sum = 0;
    for (const ringStatistics& ring : rings_)
    {
        sum += ring.crossings();
    }
    return sum;
}


void Foam::samplingPlane::pack(scalar* buffer) const
{
    for (const ringStatistics& ring : rings_)
    {
        ring.pack(buffer);
        buffer += ringStatistics::packedSize;
    }
}


void Foam::samplingPlane::unpack(const scalar* buffer)
{
    for (ringStatistics& ring : rings_)
    {
        ring.unpack(buffer);
        buffer += ringStatistics::packedSize;
    }
}


void Foam::samplingPlane::writeTable
(
    Ostream& os,
    const ringGrid& grid,
    const scalar diameter,
    const batchClock& clock
) const
{
    const scalar time = clock.total();

    // Mass flow through the whole plane over the cross-section of the nozzle
    scalar allMass = 0;
    int64_t allForward = 0;
    int64_t allBackward = 0;
    scalar allParticles = 0;
    for (const ringStatistics& ring : rings_)
    {
        allMass += ring.netMass();
        allParticles += ring.netParticles();
        allForward += ring.forward();
        allBackward += ring.backward();
    }
    const scalar nozzleArea = constant::mathematical::pi/4*sqr(diameter);
    const scalar meanMassFlux = allMass/(nozzleArea*max(time, VSMALL));
    const scalar axisVelocity = rings_[0].flux().mean().x();
    const ringStatistics& beyond = rings_[grid.size()];

    os  << "# plane at x/D = " << position_
        << ", diameter D = " << diameter << " m, sampled time = " << time
        << " s, batches = " << clock.size() << nl
        << "# whole plane: crossings = " << (allForward + allBackward)
        << ", forward = " << allForward
        << ", backward = " << allBackward
        << ", number rate = " << allParticles/max(time, VSMALL)
        << " 1/s, mass rate = " << allMass/max(time, VSMALL) << " kg/s" << nl
        << "# beyond the last ring: crossings = " << beyond.crossings()
        << ", forward = " << beyond.forward()
        << ", backward = " << beyond.backward() << nl
        << "# crossings count parcels (grains), fluxes real particles; velocities"
        << " in m/s, number_flux in 1/(m2 s), mass_flux in kg/(m2 s)" << nl
        << "# U/Uc: flux_weighted_mean_axial over that of the innermost ring;"
        << " G/Gmean: mass_flux over mass rate/(pi D^2/4)" << nl
        << "# " << columnNames << nl;

    for (label i = 0; i < grid.size(); ++i)
    {
        const ringStatistics& ring = rings_[i];
        const scalar inner = grid.radius(i);
        const scalar outer = grid.radius(i + 1);
        const scalar area =
            constant::mathematical::pi
           *(sqr(outer) - sqr(inner))*sqr(diameter);

        const vector meanF(ring.flux().mean());
        const vector rmsF(ring.flux().rms());
        const vector meanC(ring.concentration().mean());
        const vector rmsC(ring.concentration().rms());
        const scalar perAreaAndTime = 1/(area*max(time, VSMALL));
        const scalar massFlux = ring.netMass()*perAreaAndTime;

        os  << 0.5*(inner + outer)
            << tab << ring.crossings()
            << tab << meanF.x() << tab << meanF.y()
            << tab << rmsF.x() << tab << rmsF.y() << tab << rmsF.z()
            << tab << ring.netParticles()*perAreaAndTime
            << tab << massFlux
            << tab << ring.axialError(clock)
            << tab << ring.rateError(clock)/area
            << tab << meanF.z()
            << tab << meanC.x() << tab << meanC.y() << tab << meanC.z()
            << tab << rmsC.x() << tab << rmsC.y() << tab << rmsC.z()
            << tab << ratio(meanF.x(), axisVelocity)
            << tab << ratio(massFlux, meanMassFlux)
            << tab << ring.forward()
            << tab << ring.backward()
            << tab << inner << tab << outer << nl;
    }
}


// ************************************************************************* //
