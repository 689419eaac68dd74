/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    What must be true before the first step of a coupled run.

\*---------------------------------------------------------------------------*/

#include "liggghtsCoupling.H"
#include "turbulenceModel.H"
#include <cmath>
#include <iomanip>
#include <sstream>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::fv::liggghtsCoupling::readSwitch
(
    const dictionary& dict,
    const word& key,
    const word& on,
    const word& off
)
{
    const word value(dict.lookupOrDefault<word>(key, on));

    if (value != on && value != off)
    {
        FatalIOErrorInFunction(dict)
            << "Unknown " << key << ' ' << value << "\n\nValid: " << on << ", "
            << off << exit(FatalIOError);
    }
    return value == on;
}


void Foam::fv::liggghtsCoupling::checkModel()
{
    fluid_.checkViscosity(coeffs_);
    if (turbulence_)
    {
        turbulence_->check(coeffs_, *fluid_.model());
    }
    checkedModel_ = true;
}


void Foam::fv::liggghtsCoupling::checkSources() const
{
    const bool firstStep = (timeIndex_ == mesh_.time().startTimeIndex());
    for (label i = 1; i < applied_.size(); ++i)
    {
        if (!firstStep && !applied_[i])
        {
            FatalIOErrorInFunction(coeffs_)
                << "turbulenceSources " << turbulence_->type() << ": the turbulence model "
                << fluid_.model()->type() << " has not asked for the sources of "
                << fieldNames_[i] << ", so they would have no effect. Set"
                << " turbulenceSources to none, or change the model"
                << exit(FatalIOError);
        }
    }
}


void Foam::fv::liggghtsCoupling::checkTimeStep() const
{
    const scalar fluid = mesh_.time().deltaTValue();
    const scalar dem = session_->timeStep();

    // Both are typed decimal numbers: equal up to their representation
    if (mag(fluid - interval_*dem) > 1e-9*fluid)
    {
        // As the user typed them, whatever the case's writePrecision
        std::ostringstream message;
        message
            << std::setprecision(10)
            << "The fluid step is not couplingInterval DEM steps: deltaT " << fluid
            << " s (system/controlDict), couplingInterval " << interval_
            << ", timestep " << dem << " s (" << script_ << "), product "
            << interval_*dem << " s.\n    Set deltaT to " << interval_*dem;
        if (std::round(fluid/dem) >= 1 && fluid/dem < labelMax)
        {
            message << " or couplingInterval to " << fluid/dem;
        }

        FatalIOErrorInFunction(coeffs_)
            << message.str().c_str() << exit(FatalIOError);
    }
}


void Foam::fv::liggghtsCoupling::checkOverlap() const
{
    const liggghtsSession::simulationBox box = session_->box();
    const boundBox dem
    (
        point(box.low[0], box.low[1], box.low[2]),
        point(box.high[0], box.high[1], box.high[2])
    );

    if (!dem.overlaps(mesh_.bounds()))
    {
        FatalIOErrorInFunction(coeffs_)
            << "No grain can ever meet the fluid: the box of " << script_ << ' '
            << dem << " and the mesh " << mesh_.bounds()
            << " have no part in common. Both are in metres"
            << exit(FatalIOError);
    }
}


void Foam::fv::liggghtsCoupling::checkGrains() const
{
    // Far beyond any grain, and far from where products of such numbers overflow
    const scalar smallRadius = 1e-12, largeRadius = 1e6;
    const scalar smallMass = 1e-30, largeMass = 1e30;
    const scalar largeSpeed = 1e9;

    const liggghtsSession::grainArrays grains = session_->grains();
    label odd = labelMax;
    for (label i = 0; i < grains.n; ++i)
    {
        const scalar r = grains.radius[i];
        const scalar m = grains.mass[i];
        const double* v = grains.velocity[i];
        const scalar speed = mag(v[0]) + mag(v[1]) + mag(v[2]);
        if
        (
            !(r > smallRadius && r < largeRadius && m > smallMass && m < largeMass)
         || !(speed < largeSpeed)
        )
        {
            odd = min(odd, label(grains.id[i]));
        }
    }
    reduce(odd, minOp<label>());

    if (odd != labelMax)
    {
        FatalIOErrorInFunction(coeffs_)
            << "script " << script_ << ": grain " << odd << " has a radius outside of "
            << smallRadius << " to " << largeRadius << " m, a mass outside of " << smallMass
            << " to " << largeMass << " kg, or a speed above " << largeSpeed
            << " m/s. See its diameter, density and velocity" << exit(FatalIOError);
    }
}


void Foam::fv::liggghtsCoupling::setGravity()
{
    double g[3];
    const bool hasGravity = session_->gravity(g);
    if (hasGravity)
    {
        const vector gravity(g[0], g[1], g[2]);
        const scalar large = 1e9;
        if (!(mag(gravity.x()) + mag(gravity.y()) + mag(gravity.z()) < large))
        {
            FatalIOErrorInFunction(coeffs_)
                << "script " << script_ << ": fix gravity of " << gravity
                << " m/s2 is out of bounds, " << large << exit(FatalIOError);
        }
        fluid_.setGravity(gravity);
    }
    for (const grainForce& force : forces_)
    {
        bodyForce_ += force.bodyForce();
        if (force.type() == "buoyancy" && !hasGravity)
        {
            FatalIOErrorInFunction(coeffs_)
                << "forces: buoyancy needs gravity, but " << script_
                << " has no fix gravity. Add it there, for instance\n"
                << "    fix g all gravity 9.81 vector 0 0 -1\n"
                << "or take buoyancy out of the list" << exit(FatalIOError);
        }
    }
}


void Foam::fv::liggghtsCoupling::setPeriod()
{
    const liggghtsSession::simulationBox box = session_->box();
    vector period(Zero);
    point low;
    for (direction k = 0; k < 3; ++k)
    {
        low[k] = box.low[k];
        if (box.periodic[k])
        {
            period[k] = box.high[k] - box.low[k];
        }
    }
    locator_.setPeriod(low, period);
}


// ************************************************************************* //
