/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    A DEM step that changes while the session runs.

\*---------------------------------------------------------------------------*/

#include "liggghtsSession.H"
#include "sessionError.H"

#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wnon-virtual-dtor"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Woverloaded-virtual"
#include "lammps.h"
#include "fix.h"
#include "fix_insert.h"
#include "force.h"
#include "modify.h"
#include "pair.h"
#include "update.h"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

struct countingStyle
{
    const char* begin;      //!< of the style's name
    const char* effect;
};

// Styles of LIGGGHTS that keep the step of their beginning, or take a number of steps for a time. All others
// read the present step, or are told of it by reset_dt()
const countingStyle countingStyles[] =
{
    {"insert/", "it would insert at other times and at another rate than stated"},
    {"dt/reset", "it would set a step of its own"},
    {"deform", "it would deform the box at another rate than stated"},
    {"move", "it would move grains to other places than stated"},
    {"multisphere", "it would go on with the first step"},
    {"mesh/surface/stress/servo", "its wall would move at another speed than that of its control"},
    {"region/variable", "it would change its region at other times than stated"}
};


bool countsSteps(LAMMPS_NS::Fix* fix, const countingStyle& style)
{
    const std::string name(fix->style);
    if (std::string(style.begin) == "move")
    {
        // fix move/mesh has a clock of its own
        return name == style.begin;
    }
    if (name.compare(0, std::string(style.begin).size(), style.begin) != 0)
    {
        return false;
    }
    auto* insert = dynamic_cast<LAMMPS_NS::FixInsert*>(fix);
    return !insert || insert->ins_every() > 0;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::liggghtsSession::followSteps(const restartFile& former)
{
    for (int i = 0; i < lmp_->modify->nfix; ++i)
    {
        LAMMPS_NS::Fix* fix = lmp_->modify->fix[i];
        for (const countingStyle& style : countingStyles)
        {
            if (!countsSteps(fix, style))
            {
                continue;
            }
            std::string message =
                "Script " + script_ + ": fix " + fix->id + " of style " + fix->style
              + " counts DEM steps of one length. With adjustTimeStep yes their length changes, and "
              + style.effect + ".\n    Set adjustTimeStep to no in system/controlDict and give"
                " couplingInterval";
            if (std::string(style.begin) == "insert/")
            {
                message += ", or insert all grains at once (insert_every once)";
            }
            sessionError(message);
        }
    }

    // Forces of the last step are worked out again, some of which depend on its length
    if (former.timeStep > 0)
    {
        lmp_->update->dt = former.timeStep;
        lmp_->update->atime = former.time;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::liggghtsSession::setTimeStep(const double dt)
{
    // As fix dt/reset does
    LAMMPS_NS::Update* update = lmp_->update;
    update->update_time();
    if (dt == update->dt)
    {
        return;
    }
    update->dt = dt;
    if (lmp_->force->pair)
    {
        lmp_->force->pair->reset_dt();
    }
    for (int i = 0; i < lmp_->modify->nfix; ++i)
    {
        lmp_->modify->fix[i]->reset_dt();
    }
}


// ************************************************************************* //
