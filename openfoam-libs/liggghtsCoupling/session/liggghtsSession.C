/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "liggghtsSession.H"
#include "inFolder.H"
#include "sessionError.H"
#include "sessionWarnings.H"
#include "fluid-force/fluid_force_exchange.h"
#include "host/grainjet_version.h"

#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wnon-virtual-dtor"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#include "lammps.h"
#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "fix.h"
#include "fix_gravity.h"
#include "force.h"
#include "input.h"
#include "integrate.h"
#include "modify.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

double Foam::liggghtsSession::insertedByFixes() const
{
    double sum = 0;
    for (int i = 0; i < lmp_->modify->nfix; ++i)
    {
        LAMMPS_NS::Fix* fix = lmp_->modify->fix[i];
        if (std::strncmp(fix->style, "insert/", 7) == 0)
        {
            sum += fix->compute_vector(0);
        }
    }
    return sum;
}


void Foam::liggghtsSession::check() const
{
    const std::string in = "Script " + script_ + ": ";

    // What follows is set-up and steps, whose errors belong to no line of the script
    sessionPlace::inScript = false;

    if (!lmp_->domain->box_exist)
    {
        sessionError(in + "no simulation box; add create_box or read_restart");
    }
    if (std::strcmp(lmp_->update->unit_style, "si") != 0)
    {
        sessionError
        (
            in + "units " + lmp_->update->unit_style
          + " cannot be coupled to OpenFOAM; use units si"
        );
    }
    if (!lmp_->atom->radius_flag || !lmp_->atom->rmass_flag)
    {
        sessionError(in + "grains need a radius and a mass; use atom_style granular");
    }
    if (std::strncmp(lmp_->update->integrate_style, "verlet", 6) != 0)
    {
        sessionError
        (
            in + "run_style " + lmp_->update->integrate_style
          + " cannot be coupled; use run_style verlet"
        );
    }
    const double dt = lmp_->update->dt;
    if (!(dt > 0) || !std::isfinite(dt))
    {
        sessionError
        (
            in + "timestep " + std::to_string(dt) + " is not a positive number of seconds"
        );
    }
}


void Foam::liggghtsSession::checkVersion
(
    LAMMPS_NS::Fix* fix,
    const char* name
) const
{
    // The layout of the exchange belongs to a version. The loader looks at plugins, but the
    // one in this process may be older, and the fix may be compiled into LIGGGHTS.
    int dim = 0;
    const void* stated = fix->extract(name, dim);
    const std::string version =
        stated ? static_cast<const char*>(stated) : "earlier than versions are stated";

    if (version != GRAINJET_VERSION)
    {
        sessionError
        (
            "Script " + script_ + ": its fix " + fix->style + " comes from Grainjet " + version
          + ", but this coupling is of Grainjet " GRAINJET_VERSION
            ". Let plugin load, LIGGGHTS_PLUGIN_PATH and FOAM_USER_LIBBIN lead to"
            " one of them only, or " GRAINJET_ANEW
        );
    }
}


void Foam::liggghtsSession::findFixes()
{
    for (int i = 0; i < lmp_->modify->nfix; ++i)
    {
        LAMMPS_NS::Fix* fix = lmp_->modify->fix[i];
        int dim = 0;

        if (!std::strcmp(fix->style, "hertz/cg"))
        {
            contact_ = fix;
        }
        else if
        (
            !std::strcmp(fix->style, "fluid/force")
         && fix->extract("fluid_force_exchange", dim)
        )
        {
            fluidForce_ = fix;
            checkVersion(fix, "fluid_force_version");
        }
        else if
        (
            !std::strcmp(fix->style, "fluid/heat")
         && fix->extract("fluid_heat_exchange", dim)
        )
        {
            fluidHeat_ = fix;
            checkVersion(fix, "fluid_heat_version");
        }
    }
    if (!fluidForce_)
    {
        sessionError
        (
            "Script " + script_ + ": no fix fluid/force coupled, so the grains cannot"
            " feel the fluid; add\n    plugin load fluidforceplugin.so\n"
            "    fix f all fluid/force coupled"
        );
    }
    checkHeat();
}


void Foam::liggghtsSession::request()
{
    LAMMPS_NS::FluidForceExchange& exchange = fluidForce();
    if (requested_.nonReacting)
    {
        exchange.useNonReacting(&exchange);
    }
    if (requested_.torque)
    {
        exchange.useTorque(&exchange);
    }
    if (requested_.addedMass)
    {
        exchange.useAddedMass(&exchange);
    }
    if (requested_.work)
    {
        exchange.useWork(&exchange);
    }
    for (const requests::state& state : requested_.states)
    {
        stateIndex_.push_back
        (
            exchange.addState
            (
                &exchange, state.name.c_str(), state.initial.size(), state.initial.data()
            )
        );
    }
}


void Foam::liggghtsSession::setup()
{
    // What the run command does, but with an end that is never reached, so that output
    // and insertion are scheduled once and go on over all coupling intervals
    LAMMPS_NS::Update* update = lmp_->update;
    const LAMMPS_NS::bigint unlimited =
        std::numeric_limits<LAMMPS_NS::bigint>::max()/8;
    update->whichflag = 1;
    update->nsteps = std::numeric_limits<int>::max();
    update->firststep = update->beginstep = update->ntimestep;
    update->laststep = update->endstep = update->ntimestep + unlimited;

    lmp_->init();
    update->integrate->setup();
    running_ = true;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::liggghtsSession::start
(
    const std::string& script,
    const restartFile& former,
    const requests& needed,
    const bool changes
)
{
    requested_ = needed;
    inFolder here(folder_);
    script_ = script;
    sessionPlace::script = script;
    sessionPlace::inScript = true;

    const bool continued = !former.file.empty();
    openLog(continued);
    for
    (
        const std::string& variable :
        {
            std::string("continued equal ") + (continued ? "1" : "0"),
            "restart string " + (continued ? former.file : std::string("none"))
        }
    )
    {
        lmp_->input->one(("variable " + variable).c_str());
    }
    lmp_->input->file(script.c_str());

    check();
    findFixes();

    if (continued)
    {
        checkContinued(former);
    }
    scriptTimeStep_ = timeStep();
    if (changes)
    {
        followSteps(former);
    }

    cg_.assign(1, 1);
    for (int type = 1; type <= lmp_->atom->ntypes; ++type)
    {
        cg_.push_back(lmp_->force->cg(type));
    }

    request();
    setup();

    insertedOffset_ = lmp_->atom->natoms - insertedByFixes();
    sessionWarnings::gather();
}


void Foam::liggghtsSession::setInserted(const double inserted)
{
    insertedOffset_ = inserted - insertedByFixes();
}


void Foam::liggghtsSession::advance(const int n)
{
    inFolder here(folder_);

    // A fix grain/motion may run ahead of the last step by half a step, but for this one
    for (int i = 0; i < lmp_->modify->nfix; ++i)
    {
        int dim = 0;
        LAMMPS_NS::Fix* fix = lmp_->modify->fix[i];
        if (std::strcmp(fix->style, "grain/motion") == 0)
        {
            *static_cast<LAMMPS_NS::bigint*>(fix->extract("grain_motion_until", dim)) = lmp_->update->ntimestep + n;
        }
    }
    lmp_->update->integrate->run(n);
}


double Foam::liggghtsSession::timeStep() const
{
    return lmp_->update->dt;
}


Foam::liggghtsSession::grainArrays Foam::liggghtsSession::grains() const
{
    const LAMMPS_NS::Atom& atom = *lmp_->atom;
    return
    {
        atom.nlocal, atom.x, atom.v, atom.omega, atom.radius, atom.rmass, atom.tag, atom.type,
        cg_.data()
    };
}


LAMMPS_NS::FluidForceExchange& Foam::liggghtsSession::fluidForce() const
{
    int dim = 0;
    return *static_cast<LAMMPS_NS::FluidForceExchange*>
    (
        fluidForce_->extract("fluid_force_exchange", dim)
    );
}


Foam::liggghtsSession::fluidArrays Foam::liggghtsSession::fluidForces() const
{
    LAMMPS_NS::FluidForceExchange& exchange = fluidForce();
    fluidArrays arrays
    {
        exchange.fluidVelocity, exchange.explicitForce, exchange.impulse,
        exchange.startPosition, exchange.owner, exchange.dragCoefficient,
        exchange.nonReactingCoefficient, exchange.nonReactingForce,
        exchange.nonReactingImpulse, exchange.fluidSpin, exchange.spinCoefficient,
        exchange.explicitTorque, exchange.addedMass, exchange.work, {}
    };
    for (const int index : stateIndex_)
    {
        arrays.states.push_back(exchange.state(&exchange, index));
    }
    return arrays;
}


bool Foam::liggghtsSession::gravity(double (&g)[3]) const
{
    for (int i = 0; i < lmp_->modify->nfix; ++i)
    {
        auto* fix = dynamic_cast<LAMMPS_NS::FixGravity*>(lmp_->modify->fix[i]);
        if (fix)
        {
            fix->get_gravity(g);
            return true;
        }

        int dim = 0;
        LAMMPS_NS::Fix* motion = lmp_->modify->fix[i];
        const void* given = std::strcmp(motion->style, "grain/motion") == 0
          ? motion->extract("grain_motion_gravity", dim) : nullptr;
        if (given)
        {
            std::copy_n(static_cast<const double*>(given), 3, g);
            return true;
        }
    }
    return false;
}


Foam::liggghtsSession::simulationBox Foam::liggghtsSession::box() const
{
    const LAMMPS_NS::Domain& domain = *lmp_->domain;
    simulationBox result;
    for (int k = 0; k < 3; ++k)
    {
        result.low[k] = domain.boxlo[k];
        result.high[k] = domain.boxhi[k];
        result.periodic[k] = domain.periodicity[k];
    }
    return result;
}


Foam::liggghtsSession::grainCounts Foam::liggghtsSession::counts() const
{
    grainCounts result(countsHere());
    const double local = result.present;
    MPI_Allreduce(&local, &result.present, 1, MPI_DOUBLE, MPI_SUM, lmp_->world);
    return result;
}


Foam::liggghtsSession::grainCounts Foam::liggghtsSession::countsHere() const
{
    grainCounts result;
    result.present = lmp_->atom->nlocal;
    result.inserted = insertedOffset_ + insertedByFixes();
    result.contacts = contact_ ? contact_->compute_vector(0) : -1;
    result.rayleigh = contact_ ? contact_->compute_vector(3) : -1;
    return result;
}


// ************************************************************************* //
