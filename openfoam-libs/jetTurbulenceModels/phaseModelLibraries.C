/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// Opens the library with the models for the phases of a solver where the
// stock library of these phases is loaded. Linked to this one they would load
// the phases of every solver into all others, and some have classes of the
// same names.

#include "OSspecific.H"
#include "fileNameList.H"
#include "messageStream.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

const char* const thisLibrary = "libjetTurbulenceModels.so";

// The stock library that holds kEpsilon for some phases, and the library with
// jetKEpsilon for the same
const struct { const char* stock; const char* ours; } libraries[] =
{
    {
        "libVoFphaseCompressibleTurbulenceModels.so",
        "libjetVoFphaseTurbulenceModels.so"
    },
    {
        "libCompressibleTwoPhaseMixtureTurbulenceModels.so",
        "libjetTwoPhaseMixtureTurbulenceModels.so"
    },
    {
        // Its name from v2012 on
        "libcompressibleTwoPhaseMixtureTurbulenceModels.so",
        "libjetTwoPhaseMixtureTurbulenceModels.so"
    },
    {
        "libtwoPhaseReactingTurbulenceModels.so",
        "libjetReactingPhaseTurbulenceModels.so"
    },
    {
        "libmultiphaseReactingTurbulenceModels.so",
        "libjetReactingPhaseTurbulenceModels.so"
    },
    {
        // Holds them from v2012 on
        "libreactingMultiphaseSystem.so",
        "libjetReactingPhaseTurbulenceModels.so"
    }
};


struct openLibraries
{
    openLibraries()
    {
        const fileNameList loaded(dlLoaded());

        // Ours lie beside this one
        fileName folder;
        for (const fileName& path : loaded)
        {
            if (path.name() == thisLibrary)
            {
                folder = path.path();
            }
        }

        for (const auto& library : libraries)
        {
            for (const fileName& path : loaded)
            {
                if (path.name() == library.stock)
                {
                    open(folder/library.ours);
                }
            }
        }
    }

    static void open(const fileName& library)
    {
        std::string fault;
        if (!dlOpen(library, fault))
        {
            WarningInFunction
                << library << " cannot be opened, so that the phases of this"
                << " solver know no jetKEpsilon: " << fault.c_str() << endl;
        }
    }
};

const openLibraries openLibraries_;

} // End anonymous namespace
} // End namespace Foam


// ************************************************************************* //
