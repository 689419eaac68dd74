/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Stops solvers that never ask for options, and so would run without grains and without a word: when
    this library is loaded, if the case has a coupling that is not switched off. Says what to take
    instead.

\*---------------------------------------------------------------------------*/

#include "couplingEntries.H"
#include "entryError.H"
#include "fluidKinds.H"
#include "IFstream.H"
#include "OSspecific.H"

#include <map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

const char* const sonic = "rhoPimpleFoam with transonic yes in PIMPLE of fvSolution, or sonicFoam";

const std::map<std::string, const char*> instead
({
    {"rhoCentralFoam", sonic},
    {"rhoCentralDyMFoam", sonic},
    {"sonicLiquidFoam", "sonicFoam or rhoPimpleFoam"},
    {"icoFoam", "pimpleFoam or pisoFoam with simulationType laminar"},
    {"nonNewtonianIcoFoam", "pimpleFoam with simulationType laminar"},
    {"twoLiquidMixingFoam", "interFoam, or pimpleFoam for one liquid"},
    {"cavitatingFoam", "interFoam, or pimpleFoam for a liquid without cavities"}
});


// The options of a case, from the file that OpenFOAM reads them from. A file that cannot be read is left
// to OpenFOAM
dictionary options()
{
    const fileName folder(Foam::getEnv("FOAM_CASE"));
    for (const char* place : {"constant", "system"})
    {
        const fileName path(folder/place/"fvOptions");
        if (!Foam::isFile(path))
        {
            continue;
        }
        dictionary found;
        const bool throwing = FatalIOError.throwExceptions();
        try
        {
            IFstream is(path);
            found = dictionary(is);
        }
        catch (const IOerror&)
        {}
        FatalIOError.throwExceptions(throwing);
        return found;
    }
    return dictionary();
}


void refuseDeafSolver()
{
    const auto found = instead.find(fluidKinds::solver());
    if (found == instead.end())
    {
        return;
    }
    couplingEntries::onMaster
    (
        [&]()
        {
            const dictionary all(options());
            for (const entry& e : all)
            {
                if
                (
                    e.isDict()
                 && e.dict().lookupOrDefault<word>("type", word()) == "liggghtsCoupling"
                 && e.dict().lookupOrDefault<Switch>("active", true)
                )
                {
                    FatalIOErrorInEntry(e.dict(), "type")
                        << found->first.c_str() << " never asks for the options of a case, so the"
                        << " grains of " << e.keyword() << " would never move.\n    Take "
                        << found->second << exit(FatalIOError);
                }
            }
        }
    );
}


const struct deafSolvers
{
    deafSolvers()
    {
        refuseDeafSolver();
    }
} loaded;

} // End anonymous namespace


// ************************************************************************* //
