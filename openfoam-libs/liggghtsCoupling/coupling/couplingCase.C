/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "couplingCase.H"
#include "couplingEntries.H"
#include "entryError.H"
#include "OSspecific.H"
#include "Time.H"

#include <fstream>
#include <sstream>
#include <unistd.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

bool beginsWith(const std::string& text, const std::string& start)
{
    return text.compare(0, start.size(), start) == 0;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::couplingCase::checkMesh() const
{
    const wordHashSet fixedMeshes({"polyMesh", "fvMesh", "staticFvMesh"});

    const word& type = static_cast<const polyMesh&>(mesh_).type();

    if (!fixedMeshes.found(type) || mesh_.changing())
    {
        couplingEntries::onMaster
        (
            [&]()
            {
                FatalIOErrorInFunction(dict_)
                    << "The mesh is a " << type << " (entry dynamicFvMesh of "
                    << mesh_.time().constant() << "/dynamicMeshDict), but liggghtsCoupling needs"
                    << " a mesh that does not move or change. Remove that file, or set"
                    << " dynamicFvMesh to staticFvMesh" << exit(FatalIOError);
            }
        );
    }
}


void Foam::couplingCase::checkScript() const
{
    const Time& time = mesh_.time();
    const fileName script(dict_.get<fileName>("script"));
    const fileName path(script.isAbsolute() ? script : time.globalPath()/script);

    const auto refuse = [&](const char* why)
    {
        FatalIOErrorInEntry(dict_, "script")
            << "script " << script << ' ' << why << " (" << path << ')'
            << exit(FatalIOError);
    };

    if (script.empty())
    {
        refuse("names no file: give the input script of LIGGGHTS, relative to the case");
    }
    if (isDir(path))
    {
        refuse("is a folder, not an input script of LIGGGHTS");
    }
    if (!isFile(path, false))
    {
        refuse("not found: there is no such file");
    }

    std::ifstream file(path, std::ios::binary);
    std::ostringstream content;
    content << file.rdbuf();
    const std::string text(content.str());

    if (!file.is_open() || access(path.c_str(), R_OK))
    {
        refuse("cannot be read: see its permissions");
    }
    if (text.find_first_not_of(" \t\r\n\f\v") == std::string::npos)
    {
        refuse("is empty: it holds no command of LIGGGHTS");
    }
    if (beginsWith(text, "\xEF\xBB\xBF"))
    {
        refuse
        (
            "begins with a byte order mark (UTF-8 with BOM), which LIGGGHTS takes for a part of"
            " the first command. Save it as plain UTF-8 or ASCII"
        );
    }
    if (text.find('\0') != std::string::npos)
    {
        refuse("is not a text file: it holds zero bytes (binary, or saved as UTF-16)");
    }
    for
    (
        auto at = text.find('\r'); at != std::string::npos; at = text.find('\r', at + 1)
    )
    {
        if (at + 1 < text.size() && text[at + 1] != '\n')
        {
            refuse
            (
                "has carriage returns within lines, which LIGGGHTS does not take for the end of"
                " a line. Save it with line ends of Unix"
            );
        }
    }
}


void Foam::couplingCase::checkLog() const
{
    const fileName log(dict_.lookupOrDefault<fileName>("log", "log.liggghts"));
    const fileName path(log.isAbsolute() ? log : mesh_.time().globalPath()/log);

    const auto refuse = [&](const char* why)
    {
        FatalIOErrorInEntry(dict_, "log")
            << "log " << log << ' ' << why << " (" << path << ')' << exit(FatalIOError);
    };

    // LIGGGHTS' own word for no log
    if (log == "none")
    {
        return;
    }
    if (log.empty())
    {
        refuse("names no file: give the log file of LIGGGHTS, relative to the case, or none");
    }
    if (isDir(path))
    {
        refuse("is a folder, so LIGGGHTS cannot write its log there");
    }
    if (!isDir(path.path()))
    {
        refuse("lies in a folder that does not exist, so LIGGGHTS cannot write its log there");
    }
    if (!isFile(path, false))
    {
        if (access(path.path().c_str(), W_OK))
        {
            refuse("cannot be written: see the permissions of its folder");
        }
        return;
    }

    // A run begins its log with the version of LIGGGHTS, a continued one that finds none with the
    // variable that liggghtsSession sets
    std::ifstream file(path, std::ios::binary);
    std::string start;
    if
    (
        std::getline(file, start)
     && !beginsWith(start, "LIGGGHTS") && start != "variable continued equal 1"
    )
    {
        refuse
        (
            "is a file that exists and is not a log of LIGGGHTS. It would be overwritten: give"
            " another name or remove it"
        );
    }
    if (access(path.c_str(), W_OK))
    {
        refuse("cannot be written: see its permissions");
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::couplingCase::couplingCase(const dictionary& dict, const fvMesh& mesh)
:
    mesh_(mesh),
    dict_(dict)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::couplingCase::check() const
{
    checkMesh();

    couplingEntries::onMaster
    (
        [&]()
        {
            checkScript();
            checkLog();
        }
    );
}


// ************************************************************************* //
