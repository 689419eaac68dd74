/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "couplingRestart.H"
#include "IOdictionary.H"
#include "OSspecific.H"
#include "Time.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(couplingRestart, 0);
}

const Foam::word Foam::couplingRestart::properties_("liggghtsCouplingProperties");


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fileName Foam::couplingRestart::grainFile(const fileName& timePath)
{
    return timePath/"uniform"/"liggghts.restart";
}


bool Foam::couplingRestart::foundElsewhere(const Time& time)
{
    for (const instant& i : time.times())
    {
        if (isFile(grainFile(time.path()/i.name()), false))
        {
            return true;
        }
    }
    return false;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::couplingRestart::couplingRestart
(
    const fvMesh& mesh,
    liggghtsSession& session,
    const grainMomentum& momentum,
    couplingLog& log
)
:
    regIOobject
    (
        IOobject
        (
            "couplingRestart",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        )
    ),
    mesh_(mesh),
    session_(session),
    momentum_(momentum),
    log_(log)
{
    const IOdictionary former
    (
        IOobject
        (
            properties_,
            mesh.time().timeName(),
            "uniform",
            mesh.time(),
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    );
    scalar inserted = 0;
    if (former.readIfPresent("inserted", inserted))
    {
        session_.setInserted(inserted);
        log_.setLeft(former.get<scalar>("left"));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fileName Foam::couplingRestart::startFile(const Time& time)
{
    fileName file;

    if (Pstream::master())
    {
        file = grainFile(time.timePath());
        if (!isFile(file, false))
        {
            file = foundElsewhere(time) ? "missing" : "";
        }
    }
    Pstream::scatter(file);

    if (file == "missing" && time.value() > 0)
    {
        FatalErrorInFunction
            << "The grains of time " << time.timeName() << " are missing: there is no"
            << " complete file " << grainFile(time.timePath())
            << ", while other times of this case have theirs.\n"
            << "    The run was probably killed while writing. Remove the folder of this"
            << " time, or set startTime to a complete one" << exit(FatalError);
    }

    return file == "missing" ? fileName() : file;
}


bool Foam::couplingRestart::writeObject
(
    IOstream::streamFormat,
    IOstream::versionNumber,
    IOstream::compressionType,
    const bool
) const
{
    const Time& time = mesh_.time();

    momentum_.write();

    IOdictionary counters
    (
        IOobject
        (
            properties_,
            time.timeName(),
            "uniform",
            time,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        )
    );
    counters.add("inserted", session_.counts().inserted);
    counters.add("left", log_.left());
    counters.regIOobject::write();

    fileName file(grainFile(time.timePath()));
    Pstream::scatter(file);
    session_.writeRestart(time.relativePath(file));

    return true;
}


// ************************************************************************* //
