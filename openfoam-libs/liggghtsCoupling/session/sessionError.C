/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sessionError.H"
#include "sessionWarnings.H"
#include "error.H"
#include "Pstream.H"
#include <cstdlib>
#include <unistd.h>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

std::string Foam::sessionPlace::script;
std::string Foam::sessionPlace::log;
bool Foam::sessionPlace::inScript = false;


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::sessionError(const std::string& message)
{
    // The message of rank 0 knows most. It ends all ranks; the others speak if it does not come
    if (!Pstream::master())
    {
        sleep(2);
    }

    FatalErrorInFunction
        << message.c_str() << sessionWarnings::waiting().c_str() << exit(FatalError);

    std::exit(1);   // not reached; tells the compiler so
}


// ************************************************************************* //
