/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    LIGGGHTS reports an error on its own screen and ends the process. Here it runs
    inside a fluid solver whose user reads the solver's log, so these definitions of
    its error functions take precedence over its own (this library comes before
    libliggghts in the search order) and pass the message on as a FatalError.

\*---------------------------------------------------------------------------*/

#include "sessionError.H"

#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wnon-virtual-dtor"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#include "lammps.h"
#include "error.h"
#include "fix.h"
#include "compute.h"
#include "input.h"

#include <cstdio>
#include <cstring>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// Both places a user may look at: the solver's log and LIGGGHTS' own
[[noreturn]] void report
(
    FILE* logfile,
    const std::string& message,
    const char* file,
    int line
)
{
    if (logfile)
    {
        std::fprintf(logfile, "ERROR: %s (%s:%d)\n", message.c_str(), file, line);
        std::fflush(logfile);
    }

    Foam::sessionError
    (
        "LIGGGHTS stopped: " + message
      + "\n    (" + file + ":" + std::to_string(line)
      + "; the input up to there is in the log file of LIGGGHTS)"
    );
}


// The wording of LIGGGHTS: an empty or one-letter text means a syntax error
std::string styled
(
    const char* kind,
    const char* style,
    const char* id,
    const char* text
)
{
    if (std::strlen(text) > 2)
    {
        return std::string(kind) + " " + style + " (id " + id + "): " + text;
    }
    return std::string("Illegal ") + kind + " " + style + " (id " + id + ") command";
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

namespace LAMMPS_NS
{

void Error::universe_all(const char* file, int line, const char* text)
{
    report(logfile, text, file, line);
}

void Error::universe_one(const char* file, int line, const char* text)
{
    report(logfile, text, file, line);
}

void Error::all(const char* file, int line, const char* text)
{
    report(logfile, text, file, line);
}

void Error::one(const char* file, int line, const char* text)
{
    report(logfile, text, file, line);
}

void Error::fix_error(const char* file, int line, Fix* fix, const char* text)
{
    report(logfile, styled("fix", fix->style, fix->id, text), file, line);
}

void Error::fix_error
(
    const char* file,
    int line,
    Fix* fix,
    const char* style,
    const char* text
)
{
    report(logfile, styled("fix", style, fix->id, text), file, line);
}

void Error::compute_error
(
    const char* file,
    int line,
    Compute* compute,
    const char* text
)
{
    report(logfile, styled("compute", compute->style, compute->id, text), file, line);
}

} // End namespace LAMMPS_NS


// ************************************************************************* //
