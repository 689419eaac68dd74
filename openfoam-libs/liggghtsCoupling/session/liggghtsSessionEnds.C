/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    How a session begins and ends.

\*---------------------------------------------------------------------------*/

#include "liggghtsSession.H"
#include "inFolder.H"
#include "noFloatTraps.H"
#include "sessionError.H"
#include "sessionWarnings.H"
#include "loader/host_build.h"
#include "loader/interposition.h"
#include "loader/plugin_command.h"
#include "loader/style_maps.h"

#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wnon-virtual-dtor"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#include "lammps.h"
#include "integrate.h"
#include "library.h"
#include "update.h"

#include <cstdio>
#include <exception>
#include <unistd.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// What liggghtsErrorHook.C defines
const grainjet::interposition::Function errorFunctions[] =
{
    {"Error::universe_all", "_ZN9LAMMPS_NS5Error12universe_allEPKciS2_"},
    {"Error::universe_one", "_ZN9LAMMPS_NS5Error12universe_oneEPKciS2_"},
    {"Error::universe_warn", "_ZN9LAMMPS_NS5Error13universe_warnEPKciS2_"},
    {"Error::all", "_ZN9LAMMPS_NS5Error3allEPKciS2_"},
    {"Error::one", "_ZN9LAMMPS_NS5Error3oneEPKciS2_"},
    {"Error::fix_error", "_ZN9LAMMPS_NS5Error9fix_errorEPKciPNS_3FixES2_"},
    {"Error::fix_error", "_ZN9LAMMPS_NS5Error9fix_errorEPKciPNS_3FixES2_S2_"},
    {"Error::compute_error", "_ZN9LAMMPS_NS5Error13compute_errorEPKciPNS_7ComputeES2_"},
    {"Error::warning", "_ZN9LAMMPS_NS5Error7warningEPKciS2_i"},
    {"Error::warningAll", "_ZN9LAMMPS_NS5Error10warningAllEPKciS2_i"},
    {"Error::done", "_ZN9LAMMPS_NS5Error4doneEv"},
    {nullptr, nullptr}
};

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::liggghtsSession::checkHost()
{
    std::string fault = grainjet::interposition::loader_fault();
    if (fault.empty())
    {
        fault = grainjet::interposition::fault(errorFunctions);
    }
    if (!fault.empty())
    {
        sessionError
        (
            "The coupling does not work in this process: " + fault + ".\n    LIGGGHTS, or a"
            " library with functions of LIGGGHTS, has been loaded before the coupling, by"
            " LD_PRELOAD or by an earlier entry of libs in system/controlDict. Leave it out, or"
            " name libliggghtsCoupling.so first"
        );
    }

    const std::string misfit = grainjet::host_build::misfit(LIGGGHTSPLUGIN_HOST);
    if (!misfit.empty())
    {
        sessionError("The coupling " + misfit);
    }
}


void Foam::liggghtsSession::checkHooks() const
{
    // The command that the loader's part of this library enters while LIGGGHTS opens
    using namespace grainjet;
    if (style_maps::find(lmp_, plugin_command) == style_maps::Entry::FREE)
    {
        sessionError(interposition::own_calls);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::liggghtsSession::liggghtsSession
(
    const std::string& folder,
    const std::string& log
)
:
    folder_(folder),
    log_(log),
    lock_(-1),
    lmp_(nullptr),
    fluidForce_(nullptr),
    fluidHeat_(nullptr),
    contact_(nullptr),
    scriptTimeStep_(0),
    insertedOffset_(0),
    running_(false)
{
    checkHost();

    inFolder here(folder_);
    sessionPlace::log = log;

    // A screen is needed (some commands print to it unasked), an open log is not
    // wanted in the solver's output. start() knows how the log is to be opened
    std::string words[] = {"liggghts", "-log", "none", "-screen", "/dev/null"};
    char* arguments[5];
    for (int i = 0; i < 5; ++i)
    {
        arguments[i] = &words[i][0];
    }

    // LIGGGHTS keeps the communicator: its messages must never meet the solver's
    MPI_Comm world;
    MPI_Comm_dup(MPI_COMM_WORLD, &world);

    void* instance = nullptr;
    lammps_open(5, arguments, world, &instance);
    lmp_ = static_cast<LAMMPS_NS::LAMMPS*>(instance);

    checkHooks();
}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

Foam::liggghtsSession::~liggghtsSession()
{
    // An exception leaves some ranks behind: nothing that all have to do together
    if (!std::uncaught_exceptions())
    {
        finish();
    }

    inFolder here(folder_);

    MPI_Comm world = lmp_->world;
    lammps_close(lmp_);
    MPI_Comm_free(&world);
    if (lock_ >= 0)
    {
        close(lock_);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::liggghtsSession::checkRanks(const int solver)
{
    int ranks, me;
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    MPI_Comm_rank(MPI_COMM_WORLD, &me);
    if (ranks == solver)
    {
        return;
    }

    // Each solver takes itself for the first rank. One of them is heard, and ends all
    if (me > 0)
    {
        sleep(2);
    }
    sessionError
    (
        "mpirun has started " + std::to_string(ranks) + " ranks, but the solver computes on "
      + std::to_string(solver) + ": each would compute the whole flow with a part of the grains."
        "\n    Give the solver the option -parallel, after decomposePar, or start it without mpirun"
    );
}


void Foam::liggghtsSession::finish()
{
    if (!running_)
    {
        return;
    }
    running_ = false;

    inFolder here(folder_);
    const noFloatTraps asInTheStockProgram;

    // As the command run does behind its last step
    LAMMPS_NS::Update* update = lmp_->update;
    update->integrate->cleanup();
    update->whichflag = 0;
    update->firststep = update->laststep = 0;
    update->beginstep = update->endstep = 0;

    std::fflush(nullptr);
    sessionWarnings::summarise();
}


// ************************************************************************* //
