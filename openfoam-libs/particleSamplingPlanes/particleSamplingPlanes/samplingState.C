/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "samplingState.H"
#include "particleSamplingPlanes.H"
#include "IOdictionary.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(samplingState, 0);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::IOobject Foam::samplingState::file
(
    const Time& time,
    const word& name,
    const word& timeName
)
{
    return IOobject
    (
        name,
        timeName,
        "uniform"/word("particleSamplingPlanes"),
        time,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::samplingState::samplingState
(
    const Time& time,
    const word& name,
    functionObjects::particleSamplingPlanes& owner
)
:
    releases::writtenWithFields
    (
        IOobject
        (
            registered(name),
            time.timeName(),
            time,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        )
    ),
    owner_(&owner)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::functionObjects::particleSamplingPlanes* Foam::samplingState::owner
(
    const Time& time,
    const word& name
)
{
    const samplingState* present =
        time.cfindObject<samplingState>(registered(name));

    return present ? present->owner_ : nullptr;
}


Foam::fileName Foam::samplingState::path
(
    const Time& time,
    const word& name,
    const word& timeName
)
{
    return file(time, name, timeName).objectPath();
}


bool Foam::samplingState::exists
(
    const Time& time,
    const word& name,
    const word& timeName
)
{
    const fileName found
    (
        file(time, name, timeName).globalFilePath(IOdictionary::typeName, false)
    );

    return returnReduce(!found.empty(), orOp<bool>());
}


bool Foam::samplingState::read
(
    const Time& time,
    const word& name,
    numbers& content
)
{
    // A file that was being written when the run was killed ends anywhere
    const bool throwing = FatalError.throwExceptions();
    const bool throwingIO = FatalIOError.throwExceptions();
    bool good = false;

    try
    {
        const IOdictionary dict(file(time, name, time.timeName()));

        content.time = dict.get<scalar>("time");
        content.signature = dict.get<scalarList>("signature");
        content.clock = dict.get<scalarList>("clock");
        content.state = dict.get<scalarList>("state");
        good = dict.lookupOrDefault("complete", false);
    }
    catch (const Foam::error&)
    {}

    FatalError.throwExceptions(throwing);
    FatalIOError.throwExceptions(throwingIO);

    return returnReduce(good, andOp<bool>());
}


void Foam::samplingState::write
(
    const Time& time,
    const word& name,
    const numbers& content
)
{
    IOobject io(file(time, name, time.timeName()));
    io.readOpt() = IOobject::NO_READ;

    IOdictionary dict(io);
    dict.add("time", content.time);
    dict.add("signature", content.signature);
    dict.add("clock", content.clock);
    dict.add("state", content.state);

    // The last entry tells a whole file from one cut short
    dict.add("complete", true);

    // All digits, whatever the run writes its fields with
    const unsigned int precision = IOstream::defaultPrecision(17);
    releases::writeText(dict);
    IOstream::defaultPrecision(precision);
}


void Foam::samplingState::seeGrains(const scalar length) const
{
    owner_->seeGrains(length);
}


bool Foam::samplingState::writeFiles() const
{
    owner_->keepState();
    return true;
}


// ************************************************************************* //
