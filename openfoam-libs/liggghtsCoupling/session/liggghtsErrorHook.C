/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    LIGGGHTS reports an error on its own screen and ends the process. Here it runs
    inside a fluid solver whose user reads the solver's log, so these definitions of
    its error functions take precedence over its own (this library comes before
    libliggghts in the search order) and pass the message on as a FatalError. Warnings
    go to the solver's log as well, see sessionWarnings.

    Not taken over: Error::message, which says nothing to act upon and stays in
    LIGGGHTS' log, and Error::cg, which calls one of the others.

\*---------------------------------------------------------------------------*/

#include "sessionError.H"
#include "sessionWarnings.H"
#include "host/expose_member.h"

#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wnon-virtual-dtor"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#include "lammps.h"
#include "error.h"
#include "fix.h"
#include "compute.h"
#include "abstract_mesh.h"
#include "fix_mesh.h"
#include "input.h"
#include "modify.h"

#include <cstdio>
#include <cstring>
#include <fstream>
#include <sstream>
#include <unistd.h>

// * * * * * * * * * * * * * Members of the Parser * * * * * * * * * * * * * //

namespace grainjet
{

struct InputLine
{
    using type = char* LAMMPS_NS::Input::*;
    friend type member(InputLine);
};

struct LabelActive
{
    using type = int LAMMPS_NS::Input::*;
    friend type member(LabelActive);
};

struct LabelText
{
    using type = char* LAMMPS_NS::Input::*;
    friend type member(LabelText);
};

template struct Expose<InputLine, &LAMMPS_NS::Input::line>;
template struct Expose<LabelActive, &LAMMPS_NS::Input::label_active>;
template struct Expose<LabelText, &LAMMPS_NS::Input::labelstr>;

} // End namespace grainjet


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// The line as the input parser has read it last: text of the script, or a command within `if`
std::string lineOf(LAMMPS_NS::Input* input)
{
    const char* line = input->*member(grainjet::InputLine());
    return line ? line : "";
}


// The label that `jump` is looking for, or nothing
std::string wantedLabel(LAMMPS_NS::Input* input)
{
    return
        input->*member(grainjet::LabelActive())
      ? input->*member(grainjet::LabelText()) : "";
}


// How many line ends an open file has before the place that is read next
long linesRead(FILE* file)
{
    const long end = std::ftell(file);
    long count = 0;
    std::rewind(file);
    for (long i = 0; i < end; ++i)
    {
        const int c = std::getc(file);
        count += (c == '\n');
        if (i == end - 1 && c != '\n')
        {
            ++count;    // the last line has no end
        }
    }
    return count;
}


// The name of an open file, from the folder that LIGGGHTS works in
std::string nameOf(FILE* file)
{
    char name[4096];
    const std::string link("/proc/self/fd/" + std::to_string(fileno(file)));
    const ssize_t n = readlink(link.c_str(), name, sizeof(name));
    if (n <= 0 || n == ssize_t(sizeof(name)))
    {
        return "";
    }
    const std::string path(name, n);

    const ssize_t nHere =
        getcwd(name, sizeof(name)) ? ssize_t(std::strlen(name)) : 0;
    return
        nHere > 0 && path.compare(0, nHere, name) == 0 && path[nHere] == '/'
      ? path.substr(nHere + 1) : path;
}


// Where in the script LIGGGHTS is, as lines of a message
std::string place(LAMMPS_NS::Input* input, FILE* infile)
{
    using Foam::sessionPlace;

    if (!sessionPlace::inScript)
    {
        return sessionPlace::script.empty()
          ? "" : "\n    script " + sessionPlace::script + " (its lines have been read)";
    }

    // Only rank 0 has the file
    std::string result("\n    script ");
    const std::string name(infile ? nameOf(infile) : "");
    result += name.empty() ? sessionPlace::script : name;
    if (infile)
    {
        result += ", line " + std::to_string(linesRead(infile));
    }

    const std::string text(lineOf(input));
    result += ": " + text;
    const std::string label(wantedLabel(input));
    if (!label.empty())
    {
        result += "\n    label that jump looks for: " + label;
    }
    for (const char c : text)
    {
        if (static_cast<unsigned char>(c) >= 128)
        {
            result +=
                "\n    This line holds characters that are not plain ASCII, which may be"
                " invisible, such as a byte order mark or a fixed space";
            break;
        }
    }
    return result;
}


// The file that a fix mesh/surface was made of: LIGGGHTS keeps no name, but its log has the line
std::string meshFile(const std::string& id)
{
    std::ifstream log(Foam::sessionPlace::log);
    std::string line;
    std::string file;
    while (std::getline(log, line))
    {
        std::istringstream words(line);
        std::string word;
        words >> word;
        if (word != "fix" || !(words >> word) || word != id)
        {
            continue;
        }
        while (words >> word)
        {
            if (word == "file")
            {
                words >> file;
            }
        }
    }
    return file;
}


// All meshes of walls, for errors that LIGGGHTS finds after the script without saying in which
std::string meshes(LAMMPS_NS::Modify* modify)
{
    std::string result;
    for (int i = 0; i < modify->nfix; ++i)
    {
        auto* fix = dynamic_cast<LAMMPS_NS::FixMesh*>(modify->fix[i]);
        if (fix && fix->mesh())
        {
            result +=
                std::string("\n    fix ") + fix->id + ' ' + fix->style + ": "
              + std::to_string(fix->mesh()->sizeLocal()) + " elements from "
              + meshFile(fix->id);
        }
    }
    return result;
}


// Both places a user may look at: the solver's log and LIGGGHTS' own
[[noreturn]] void report
(
    LAMMPS_NS::LAMMPS* lmp,
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
        "LIGGGHTS stopped: " + message + place(lmp->input, lmp->infile)
      + (message.compare(0, 10, "Mesh error") ? "" : meshes(lmp->modify))
      + "\n    log of LIGGGHTS " + Foam::sessionPlace::log
      + ", source " + file + ":" + std::to_string(line)
    );
}


// LIGGGHTS' log has all warnings of rank 0, the solver's log each one once
void warn
(
    LAMMPS_NS::LAMMPS* lmp,
    FILE* logfile,
    const char* text,
    const char* file,
    int line
)
{
    if (logfile)
    {
        std::fprintf(logfile, "WARNING: %s (%s:%d)\n", text, file, line);
    }

    const char* slash = std::strrchr(file, '/');
    Foam::sessionWarnings::add
    (
        text,
        std::string(slash ? slash + 1 : file) + ':' + std::to_string(line),
        Foam::sessionPlace::inScript ? place(lmp->input, lmp->infile) : ""
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
    report(lmp, logfile, text, file, line);
}

void Error::universe_one(const char* file, int line, const char* text)
{
    report(lmp, logfile, text, file, line);
}

void Error::all(const char* file, int line, const char* text)
{
    report(lmp, logfile, text, file, line);
}

void Error::one(const char* file, int line, const char* text)
{
    report(lmp, logfile, text, file, line);
}

void Error::fix_error(const char* file, int line, Fix* fix, const char* text)
{
    report(lmp, logfile, styled("fix", fix->style, fix->id, text), file, line);
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
    report(lmp, logfile, styled("fix", style, fix->id, text), file, line);
}

void Error::compute_error
(
    const char* file,
    int line,
    Compute* compute,
    const char* text
)
{
    report(lmp, logfile, styled("compute", compute->style, compute->id, text), file, line);
}

void Error::universe_warn(const char* file, int line, const char* text)
{
    warn(lmp, logfile, text, file, line);
}

void Error::warning(const char* file, int line, const char* text, int logflag)
{
    warn(lmp, logflag ? logfile : nullptr, text, file, line);
}

// Called on all ranks with one text
void Error::warningAll(const char* file, int line, const char* text, int logflag)
{
    int me;
    MPI_Comm_rank(world, &me);
    if (me == 0)
    {
        warn(lmp, logflag ? logfile : nullptr, text, file, line);
    }
}

// The command quit: the stock program ends here, but the fluid has not begun
void Error::done()
{
    Foam::sessionError
    (
        "The script ended LIGGGHTS with the command quit, so that there are no grains to be"
        " coupled. Remove it" + place(input, infile)
    );
}

} // End namespace LAMMPS_NS


// ************************************************************************* //
