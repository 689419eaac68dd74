/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sessionError.H"
#include "error.H"
#include <cstdlib>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::sessionError(const std::string& message)
{
    FatalErrorInFunction
        << message.c_str() << exit(FatalError);

    std::exit(1);   // not reached; tells the compiler so
}


// ************************************************************************* //
