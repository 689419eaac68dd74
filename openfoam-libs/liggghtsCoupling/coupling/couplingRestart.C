/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "couplingRestart.H"
#include "IOdictionary.H"
#include "OSspecific.H"
#include "Time.H"

#include <cmath>
#include <iomanip>
#include <sstream>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(couplingRestart, 0);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::word Foam::couplingRestart::digits(const scalar number)
{
    return std::to_string(std::llround(number));
}


Foam::word Foam::couplingRestart::exact(const scalar number)
{
    std::ostringstream os;
    os  << std::setprecision(17) << number;
    return word(os.str(), false);
}


Foam::wordList Foam::couplingRestart::optionalFiles() const
{
    wordList names;
    const objectRegistry& fields = mesh_.thisDb();
    forAllConstIters(fields, iter)
    {
        const regIOobject& object = *iter();
        const word& name = object.name();
        const bool former =
            name.endsWith("_0") || name.startsWith("ddt0(");

        if
        (
            object.writeOpt() == IOobject::AUTO_WRITE
         && (former || object.readOpt() == IOobject::READ_IF_PRESENT)
         && object.instance() != mesh_.time().constant()
         && object.local().empty()
        )
        {
            names.append(name);
        }
    }
    names.append(stateFiles_);
    Foam::sort(names);
    return names;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::couplingRestart::couplingRestart
(
    const fvMesh& mesh,
    liggghtsSession& session,
    const wordList& stateFiles,
    const std::function<void()>& writeState,
    couplingLog& log,
    const formerRun& former
)
:
    releases::writtenWithFields
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
    stateFiles_(stateFiles),
    writeState_(writeState),
    log_(log),
    entries_(former.entries())
{
    if (former.continues())
    {
        session_.setInserted(former.inserted());
        log_.setRemoved(former.leftBox(), former.deleted());
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::couplingRestart::writeFiles() const
{
    const Time& time = mesh_.time();

    const auto uniform = [&time](const word& name)
    {
        return IOobject
        (
            name,
            time.timeName(),
            "uniform",
            time,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        );
    };

    // The file of grains is renamed to its name once all that belongs to it is written
    fileName path
    (
        fileHandler().objectPath(uniform(formerRun::grainsName), word::null)
    );
    releases::fromMaster(path);
    const fileName partial(path + ".partial");
    if (Pstream::master())
    {
        Foam::mkDir(path.path());
    }
    const auto grains = session_.writeRestart(time.relativePath(partial));

    writeState_();

    // Numbers of any size are written with all their digits, as words
    IOdictionary counters(uniform(formerRun::propertiesName));
    counters.add("inserted", digits(session_.counts().inserted));
    counters.add("leftBox", digits(log_.leftBox()));
    counters.add("deleted", digits(log_.deleted()));
    counters.add("demStep", digits(grains.step));
    counters.add("demTimeStep", exact(grains.timeStep));
    counters.add("demTime", exact(grains.time));
    counters.add("deltaT", exact(time.deltaTValue()));
    counters.add("grains", digits(grains.grains));
    counters.add("stamp", digits(grains.stamp));
    scalar bytes = 0;
    if (Pstream::master())
    {
        bytes = Foam::fileSize(partial);
    }
    releases::fromMaster(bytes);
    counters.add("bytes", digits(bytes));
    counters.add("sha1", formerRun::digest(partial));
    counters.add("time", word(time.timeName(), false));
    counters.add("files", optionalFiles());
    counters.merge(entries_);
    releases::writeText(counters);

    const bool renamed = !Pstream::master() || Foam::mv(partial, path);
    if (!returnReduce(renamed, andOp<bool>()))
    {
        FatalErrorInFunction
            << "Cannot write " << path << exit(FatalError);
    }

    return true;
}


// ************************************************************************* //
