/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    How a session continues a former one, and is itself made ready to be continued.

\*---------------------------------------------------------------------------*/

#include "liggghtsSession.H"
#include "inFolder.H"
#include "noFloatTraps.H"
#include "sessionError.H"
#include "sessionWarnings.H"
#include "fluid-force/fluid_force_exchange.h"

#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wnon-virtual-dtor"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#include "lammps.h"
#include "atom.h"
#include "comm.h"
#include "fix.h"
#include "input.h"
#include "modify.h"
#include "universe.h"
#include "update.h"
#include "write_restart.h"

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

std::string number(const double value)
{
    return std::to_string(std::llround(value));
}


// The part of a script that reads grains, as the docs have it
const char* const reads =
    "\n"
    "\n    if \"${continued}\" then \"jump SELF continued\""
    "\n    region box block ...             # what makes the box and the first grains"
    "\n    create_box 1 box"
    "\n    jump SELF ready"
    "\n    label continued"
    "\n    read_restart ${restart}"
    "\n    label ready\n";

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::liggghtsSession::openLog(const bool continued)
{
    // The lock is on the folder and ends with the process, however that ends. File systems that have
    // no locks have none
    enum {FREE, TAKEN, FAILED};
    int state[2] = {FREE, 0};
    if (lmp_->comm->me == 0)
    {
        lock_ = open(".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (lock_ >= 0 && flock(lock_, LOCK_EX | LOCK_NB) && errno == EWOULDBLOCK)
        {
            state[0] = TAKEN;
        }
        else if (log_ != "none")
        {
            const int file = open(log_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
            state[0] = file < 0 ? FAILED : FREE;
            state[1] = errno;
            if (file >= 0)
            {
                close(file);
            }
        }
    }
    MPI_Bcast(state, 2, MPI_INT, 0, lmp_->world);

    if (state[0] == FAILED)
    {
        sessionError
        (
            "Cannot write the log file " + log_ + " of LIGGGHTS: "
          + std::strerror(state[1]) + ". Entry log gives its name, relative to the case"
        );
    }
    if (state[0] == TAKEN)
    {
        sessionError
        (
            "Another run works in " + folder_ + ": two runs in one case would destroy each"
            " other's results. Stop the other one, or copy the case"
        );
    }
    if (log_ == "none")
    {
        return;
    }

    lmp_->input->one(("log \"" + log_ + "\"" + (continued ? " append" : "")).c_str());

    // The command alone begins no log as the program does, by which a log is known
    if (!continued && lmp_->logfile)
    {
        std::fprintf(lmp_->logfile, "LIGGGHTS (%s)\n", lmp_->universe->version);
    }
}


std::int64_t Foam::liggghtsSession::step() const
{
    return lmp_->update->ntimestep;
}


void Foam::liggghtsSession::checkContinued(const restartFile& former) const
{
    const LAMMPS_NS::GrainFile read = fluidForce().read;
    const double step = lmp_->update->ntimestep;
    const double grains = lmp_->atom->natoms;
    const std::string in =
        "Script " + script_ + ": the run continues a former one, but the script ";

    if (read.stamp < 0)
    {
        sessionError
        (
            in + "has not read its grains from " + former.file
          + ", or gives fix fluid/force another ID than the run that wrote them, so that"
            " they are without what the fluid does to them.\n    Have it read them instead"
            " of making new ones:" + reads
        );
    }
    if (read.stamp != former.stamp)
    {
        sessionError
        (
            in + "has read other grains than those of " + former.file + ": they are of"
            " DEM step " + number(read.step) + ", not " + number(former.step)
          + (read.step == former.step ? ", of another run" : "")
          + ".\n    Have it read what ${restart} says:" + reads
        );
    }
    if (step != former.step)
    {
        sessionError
        (
            in + "goes from DEM step " + number(former.step) + " of " + former.file
          + " to step " + number(step) + ": it has a run or reset_timestep that is made"
            " again at each start.\n    Let it do so at the first start only:"
            "\n\n    if \"${continued} == 0\" then \"run 1000\"\n"
        );
    }
    if (grains != former.grains)
    {
        sessionError
        (
            in + "makes " + number(grains) + " grains of the " + number(former.grains)
          + " of " + former.file + ": it has a command (such as delete_atoms) that is"
            " carried out again at each start.\n    Let it do so at the first start only:"
            "\n\n    if \"${continued} == 0\" then \"delete_atoms ...\"\n"
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::liggghtsSession::restartFile Foam::liggghtsSession::writeRestart
(
    const std::string& file
)
{
    inFolder here(folder_);
    const noFloatTraps asInTheStockProgram;

    // pair_style gran keeps contacts in its list of neighbours and with the grains only when
    // a new list is made; LIGGGHTS writes those of the grains
    for (int i = 0; i < lmp_->modify->nfix; ++i)
    {
        if (!std::strcmp(lmp_->modify->fix[i]->style, "contacthistory"))
        {
            lmp_->modify->fix[i]->pre_exchange();
        }
    }

    // As `restart N` does in the middle of a run. The command write_restart would set up
    // the run anew, and so change it
    std::vector<char> name(file.c_str(), file.c_str() + file.size() + 1);
    LAMMPS_NS::WriteRestart(lmp_).write(name.data());

    // Lines of fix print, fix massflow/mesh, the log and their like that wait in memory
    std::fflush(nullptr);
    sessionWarnings::gather();

    const LAMMPS_NS::GrainFile written = fluidForce().written;
    const LAMMPS_NS::Update& update = *lmp_->update;
    return
    {
        file, written.stamp, written.step, written.grains, update.dt, update.get_cur_time()
    };
}


// ************************************************************************* //
