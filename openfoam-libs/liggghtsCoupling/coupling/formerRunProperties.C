/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    What a former run says of itself in uniform/liggghtsCouplingProperties, see formerRun.H.

\*---------------------------------------------------------------------------*/

#include "formerRun.H"
#include "couplingEntries.H"
#include "heatTransfer.H"
#include "entryError.H"
#include "IOdictionary.H"
#include "OSspecific.H"
#include "releases.H"
#include "Time.H"
#include "voidFractionEquations.H"
#include "volFields.H"

#include <sstream>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::formerRun::readProperties(const wordList& traces)
{
    const fileName path(found(startName_));
    grains_.file = mesh_.time().relativePath(path);

    const IOdictionary dict(header(propertiesName, "uniform"));

    for (const char* key : {"time", "demStep", "grains", "stamp", "bytes", "sha1", "files"})
    {
        if (!dict.found(key))
        {
            FatalIOErrorInFunction(dict)
                << "Entry " << key << " is missing in " << dict.objectPath()
                << ": the grains of time " << startName_
                << " were written by an older version of liggghtsCoupling and cannot be"
                << " continued. Continue them with that version"
                << exit(FatalIOError);
        }
    }

    const scalar written = dict.get<scalar>("time");
    if (mag(written - startTime_) > 0.5*mesh_.time().deltaTValue())
    {
        FatalIOErrorInEntry(dict, "time")
            << "The grains in time " << startName_ << " were written at time "
            << written << ". They belong to the fields of that time: copy them there, or, if"
            << " all of this folder is of that time and the run shall go on from here, set"
            << " the entry time of " << dict.objectPath() << " to "
            << startName_ << exit(FatalIOError);
    }

    inserted_ = dict.get<scalar>("inserted");
    leftBox_ = dict.get<scalar>("leftBox");
    deleted_ = dict.get<scalar>("deleted");
    grains_.stamp = dict.get<scalar>("stamp");
    grains_.step = dict.get<scalar>("demStep");
    grains_.grains = dict.get<scalar>("grains");

    // A former run with fixed steps may not have written them
    dict.readIfPresent("demTimeStep", grains_.timeStep);
    dict.readIfPresent("demTime", grains_.time);
    dict.readIfPresent("deltaT", deltaT_);

    scalar bytes = 0;
    if (Pstream::master())
    {
        bytes = Foam::fileSize(path);
    }
    releases::fromMaster(bytes);
    const scalar expected = dict.get<scalar>("bytes");
    if (bytes != expected)
    {
        std::ostringstream message;
        message.precision(16);
        message << "The file of grains " << grains_.file << " has " << bytes << " bytes instead of "
            << expected;
        incomplete(message.str(), traces);
    }

    if (digest(path) != dict.get<string>("sha1"))
    {
        incomplete("The file of grains " + grains_.file + " is damaged: its checksum differs", traces);
    }

    checkFiles(dict.get<wordList>("files"), traces);
    couplingEntries::onMaster([&](){ checkEntries(dict); });
}


void Foam::formerRun::checkFiles(wordList names, const wordList& traces) const
{
    // Reading a header may be collective
    releases::fromMaster(names);
    fileNameList missing(Pstream::nProcs());

    for (const word& name : names)
    {
        IOobject io(header(name, fileName()));
        if (!io.typeHeaderOk<volScalarField>(false, false, false))
        {
            missing[Pstream::myProcNo()] = mesh_.time().relativePath(io.objectPath());
        }
    }
    Pstream::gatherList(missing);
    releases::fromMaster(missing);

    for (const fileName& file : missing)
    {
        if (!file.empty())
        {
            incomplete("There is no readable file " + file, traces);
        }
    }
}


void Foam::formerRun::checkEntries(const dictionary& former) const
{
    const dictionary present(entries(dict_));
    const word equations(present.get<word>("equations"));
    const word momentum(present.get<word>("momentum"));

    // Older runs did not say it, but wrote a field that only the full equations or the implicit source have
    const wordList files(former.get<wordList>("files"));
    const word formerEquations
    (
        former.lookupOrDefault<word>
        (
            "equations", files.found("momentumOfShares") ? "full" : "neglected"
        )
    );
    const word formerMomentum
    (
        former.lookupOrDefault<word>
        (
            "momentum", files.found("particleMomentumOwed") ? "implicit" : "none"
        )
    );

    if (equations != formerEquations)
    {
        const dictionary& place =
            dict_.isDict("voidFraction") ? dict_.subDict("voidFraction") : dict_;

        FatalIOErrorInEntry(place, "equations")
            << "voidFraction: equations " << equations << ", but time " << startName_
            << " was written by a run with equations " << formerEquations << ". The solver's velocity"
            << " means the flux of fluid and grains with full, that of the fluid alone with"
            << " neglected, and nothing converts it. Set equations " << formerEquations
            << ", or start from a time without grains" << exit(FatalIOError);
    }
    if (momentum == "explicit" && formerMomentum == "implicit")
    {
        FatalIOErrorInEntry(dict_, "momentum")
            << "momentum " << momentum << ", but time " << startName_
            << " was written by a run with momentum " << formerMomentum << ": what the fluid is"
            << " still owed (particleMomentumOwed) would be lost. Set momentum "
            << formerMomentum << exit(FatalIOError);
    }
    if (couplingEntries::twoWay(dict_) && !heatTransfer::acts(dict_) && files.found("particleHeatOwed"))
    {
        FatalIOErrorInEntry(dict_, "forces")
            << "forces without the model heat, but time " << startName_ << " was written by a run with it: heat"
            << " on its way between gas and grains (particleHeatOwed) would be lost. Add the model heat to"
            << " forces" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

Foam::dictionary Foam::formerRun::entries(const dictionary& dict)
{
    dictionary result;
    result.add
    (
        "equations",
        word(voidFractionEquations::full(dict) ? "full" : "neglected")
    );
    result.add
    (
        "momentum",
        couplingEntries::twoWay(dict)
      ? dict.lookupOrDefault<word>("momentum", "implicit")
      : word("none")
    );
    return result;
}


// ************************************************************************* //
