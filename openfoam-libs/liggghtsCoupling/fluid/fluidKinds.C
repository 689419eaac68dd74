/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluidKinds.H"
#include "couplingEntries.H"
#include "entryError.H"
#include "OSspecific.H"
#include "volFields.H"

#include <map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

// Made when the first kind states its signs, whatever the order in which libraries and their objects
// are made
std::map<word, fluidKinds::signs>& table()
{
    static std::map<word, fluidKinds::signs> kinds;
    return kinds;
}


// Why no kind can work with the solver, and what to take instead; empty if one may
string unfit(const fvMesh& mesh)
{
    const word phase(fluidKinds::beginsWith(mesh, "alpha."));
    const word thermo(fluidKinds::beginsWith(mesh, "thermophysicalProperties"));

    if (mesh.foundObject<regIOobject>("phaseProperties"))
    {
        return "is a multiphase solver with a velocity for each phase (it has read"
            " constant/phaseProperties), while grains need one fluid. For a fluid with grains take"
            " pimpleFoam, for two fluids with a surface between them interFoam";
    }
    if (!phase.empty() && !thermo.empty())
    {
        return "is a compressible multiphase solver (it has the phase fraction " + phase
          + " and has read constant/" + thermo + "). Take interFoam, whose phases are incompressible,"
            " or rhoPimpleFoam for a gas alone";
    }
    if (mesh.foundObject<regIOobject>("SRFProperties"))
    {
        return "solves for the velocity relative to a rotating frame (it has read"
            " constant/SRFProperties), while grains move in the frame at rest. Take pimpleFoam";
    }

    const auto* control = mesh.cfindObject<regIOobject>("solutionControl");
    if (control && control->type() == "simpleControl")
    {
        const bool buoyant = mesh.foundObject<volScalarField>("p_rgh");
        return "is a steady solver (its algorithm is SIMPLE), while grains need the time. Take "
          + string
            (
                thermo.empty()
              ? (buoyant ? "buoyantBoussinesqPimpleFoam" : "pimpleFoam")
              : (buoyant ? "buoyantPimpleFoam" : "rhoPimpleFoam")
            );
    }
    return string();
}


// Local or no time steps: cells would have other times than the grains
void checkTimeScheme(const dictionary& dict, const fvMesh& mesh)
{
    const word U(dict.lookupOrDefault<word>("U", "U"));
    const dictionary& schemes = mesh.schemesDict().subOrEmptyDict("ddtSchemes");
    for (const word& key : {word("ddt(" + U + ')'), word("ddt(rho," + U + ')'), word("default")})
    {
        if (!schemes.found(key))
        {
            continue;
        }
        for (const token& t : static_cast<const tokenList&>(schemes.lookup(key)))
        {
            if
            (
                t.isWord()
             && wordHashSet({"steadyState", "localEuler", "SLTS", "CoEuler"}).found(t.wordToken())
            )
            {
                couplingEntries::onMaster
                (
                    [&]()
                    {
                        FatalIOErrorInEntry(schemes, key)
                            << "ddtSchemes: " << key << ' ' << t.wordToken()
                            << " has no time that all cells and the grains share, which"
                            << " liggghtsCoupling does not support. Take, for instance, Euler"
                            << exit(FatalIOError);
                    }
                );
            }
        }
        if (key != "default")
        {
            break;
        }
    }
}


void checkSolver(const dictionary& dict, const fvMesh& mesh)
{
    const string reason(unfit(mesh));
    if (!reason.empty())
    {
        couplingEntries::onMaster
        (
            [&]()
            {
                FatalIOErrorInFunction(dict)
                    << fluidKinds::solver().c_str() << ' ' << reason.c_str() << exit(FatalIOError);
            }
        );
    }
    checkTimeScheme(dict, mesh);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fluidKinds::fluidKinds
(
    const word& kind,
    const string& solvers,
    string (*misfit)(const fvMesh&),
    void (*watch)(const fvMesh&)
)
{
    table()[kind] = signs{solvers, misfit, watch};
}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

Foam::string Foam::fluidKinds::solver()
{
    const string name(Foam::getEnv("FOAM_EXECUTABLE"));
    return name.empty() ? string("This solver") : name;
}


Foam::word Foam::fluidKinds::beginsWith(const fvMesh& mesh, const std::string& start)
{
    for (const word& name : mesh.sortedNames())
    {
        if (name.compare(0, start.size(), start) == 0)
        {
            return name;
        }
    }
    return word();
}


Foam::word Foam::fluidKinds::find(const dictionary& dict, const fvMesh& mesh)
{
    checkSolver(dict, mesh);

    string reasons;
    for (const auto& kind : table())
    {
        const string reason(kind.second.misfit(mesh));
        if (reason.empty())
        {
            return kind.first;
        }
        reasons += "\n    " + kind.first + " (" + kind.second.solvers + "): " + reason;
    }

    couplingEntries::onMaster
    (
        [&]()
        {
            FatalIOErrorInFunction(dict)
                << solver().c_str() << " has no kind of fluid that grains can be coupled to. Looked for"
                << reasons.c_str() << "\n    Found: scalar fields "
                << flatOutput(mesh.sortedNames<volScalarField>())
                << "\n    Take one of the solvers in brackets" << exit(FatalIOError);
        }
    );
    return word();
}


void Foam::fluidKinds::check(const word& kind, const dictionary& dict, const fvMesh& mesh)
{
    checkSolver(dict, mesh);

    const auto found = table().find(kind);
    if (found == table().end())
    {
        return;
    }
    const string reason(found->second.misfit(mesh));
    if (!reason.empty())
    {
        couplingEntries::onMaster
        (
            [&]()
            {
                FatalIOErrorInFunction(dict)
                    << "fluid " << kind << " is for " << found->second.solvers.c_str() << ", but "
                    << solver().c_str() << " does not fit: " << reason.c_str()
                    << ". Without the entry fluid the kind is found out" << exit(FatalIOError);
            }
        );
    }
}


void Foam::fluidKinds::watch(const fvMesh& mesh)
{
    for (const auto& kind : table())
    {
        if (kind.second.watch && kind.second.misfit(mesh).empty())
        {
            kind.second.watch(mesh);
        }
    }
}


// ************************************************************************* //
