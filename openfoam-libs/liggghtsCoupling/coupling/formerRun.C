/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "formerRun.H"
#include "couplingEntries.H"
#include "IFstream.H"
#include "OSspecific.H"
#include "releases.H"
#include "SHA1.H"
#include "Time.H"

#include <fstream>
#include <sstream>
#include <vector>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::word Foam::formerRun::grainsName("liggghts.restart");
const Foam::word Foam::formerRun::propertiesName("liggghtsCouplingProperties");


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::IOobject Foam::formerRun::header(const word& name, const fileName& local) const
{
    const Time& time = mesh_.time();
    const objectRegistry& db =
        local.empty()
      ? static_cast<const objectRegistry&>(mesh_)
      : static_cast<const objectRegistry&>(time);

    return IOobject
    (
        name,
        startName_,
        local,
        db,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
}


Foam::fileName Foam::formerRun::found(const word& timeName) const
{
    // The first rank looks for it alone: file handlers may search on all ranks together, but
    // only if these ask for the same paths. Like them it prefers processors<N>[_0-...]
    const Time& time = mesh_.time();
    const fileName local(timeName/"uniform"/grainsName);
    fileName file;

    if (Pstream::master())
    {
        DynamicList<fileName> places;
        if (time.processorCase())
        {
            const word all("processors" + std::to_string(Pstream::nProcs()));
            for
            (
                const fileName& folder
              : Foam::readDir(time.globalPath(), fileName::DIRECTORY)
            )
            {
                if (folder == all || folder.startsWith(all + "_0-"))
                {
                    places.append(time.globalPath()/folder/local);
                }
            }
        }
        places.append(time.path()/local);

        for (const fileName& place : places)
        {
            if (file.empty() && Foam::isFile(place, false))
            {
                file = place;
            }
        }
    }
    releases::fromMaster(file);
    return file;
}


Foam::string Foam::formerRun::digest(const fileName& file)
{
    string result;
    if (Pstream::master())
    {
        SHA1 sum;
        std::ifstream is(file, std::ios::binary);
        std::vector<char> buffer(1 << 20);
        while (is)
        {
            is.read(buffer.data(), buffer.size());
            sum.append(buffer.data(), is.gcount());
        }
        result = sum.str();
    }
    releases::fromMaster(result);
    return result;
}


bool Foam::formerRun::anywhere(const word& name, const fileName& local) const
{
    const IOobject io(header(name, local));
    return returnReduce
    (
        !fileHandler().filePath(false, io, word::null, false).empty(),
        orOp<bool>()
    );
}


Foam::wordList Foam::formerRun::traces() const
{
    wordList names;

    if (!found(startName_).empty())
    {
        names.append("uniform/" + grainsName);
    }
    if (anywhere(propertiesName, "uniform"))
    {
        names.append("uniform/" + propertiesName);
    }
    for
    (
        const char* field
      : {
            "voidFraction", "particleVelocity", "dragCoefficient", "particleMomentumSource",
            "particleMomentumOwed", "momentumOfLostGrains", "particleEnergySource", "particleEnergyOwed",
            "energyOfLostGrains", "particleTemperature", "particleHeatSource", "particleHeatOwed",
            "heatOfLostGrains", "solidsFlux", "feltPressureGradient", "feltViscousStress",
            "momentumOfShares", "massOfShares", "massLeft", "energyOfShares"
        }
    )
    {
        if (anywhere(field, fileName()))
        {
            names.append(field);
        }
    }
    return names;
}


bool Foam::formerRun::earlierTimes() const
{
    bool any = false;
    for (const instant& i : mesh_.time().times())
    {
        // Later ones may be of a former try that began here
        const bool earlier =
            i.value() < startTime_ - 0.5*mesh_.time().deltaTValue();
        any = (earlier && !found(i.name()).empty()) || any;
    }
    return any;
}


Foam::fileName Foam::formerRun::table() const
{
    const Time& time = mesh_.time();
    const scalar start = startTime_;
    fileName reached;

    if (Pstream::master())
    {
        const fileName folder
        (
            time.globalPath()/"postProcessing"/"liggghtsCoupling"
        );
        for (const fileName& begin : Foam::readDir(folder, fileName::DIRECTORY))
        {
            scalar from = 0;
            if (!readScalar(begin, from) || from > start - 0.5*time.deltaTValue())
            {
                continue;
            }

            // Printed with six digits
            const fileName file(folder/begin/"balance.dat");
            IFstream is(file);
            string line;
            while (is.good() && reached.empty())
            {
                is.getLine(line);
                std::istringstream words(line);
                scalar t = 0;
                if (words >> t && t >= start - 1e-6*mag(start))
                {
                    reached = file;
                }
            }
        }
    }
    releases::fromMaster(reached);
    return reached;
}


void Foam::formerRun::incomplete
(
    const std::string& what,
    const wordList& traces
) const
{
    // The solver is in its first step already: its present time is not that of the folder
    const Time& time = mesh_.time();
    const fileName folder(time.relativePath(time.path()/startName_));

    couplingEntries::onMaster
    (
        [&]()
        {
            FatalErrorInFunction
                << what.c_str() << ".\n"
                << "    Time " << startName_ << " was written by a coupled run, which was"
                << " probably killed while writing, or the file was not copied with the"
                << " others. Remove the folder " << folder
                << " or set startTime in system/controlDict to a complete time.\n"
                << "    To begin with new grains in this flow, remove what belongs to the"
                << " former ones: ";
            if (traces.empty())
            {
                FatalError << "the files " << grainsName << " of earlier times";
            }
            else
            {
                FatalError << "the files " << traces << " in " << folder;
            }
            FatalError << exit(FatalError);
        }
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::formerRun::formerRun(const dictionary& dict, const fvMesh& mesh)
:
    dict_(dict),
    mesh_(mesh),
    startTime_(mesh.time().startTime().value()),
    startName_(mesh.time().timeName(startTime_)),
    grains_{"", -1, 0, 0, 0, 0},
    inserted_(0),
    leftBox_(0),
    deleted_(0),
    deltaT_(0)
{
    const Time& time = mesh.time();
    const fileName expected
    (
        time.relativePath(time.path()/startName_/"uniform"/grainsName)
    );
    const wordList names(traces());

    if (names.found("uniform/" + grainsName))
    {
        if (!names.found("uniform/" + propertiesName))
        {
            incomplete
            (
                "Beside the grains of time " + startName_ + " there is no file uniform/"
              + propertiesName,
                names
            );
        }
        readProperties(names);
        return;
    }

    // Nothing of a coupled run lies at a first time, whatever later times hold
    const std::string what
    (
        "The grains of time " + startName_ + " are missing: there is no complete file "
      + expected
    );
    if (names.size())
    {
        incomplete(what, names);
    }
    if (earlierTimes())
    {
        incomplete(what + ", while earlier times of this case have theirs", names);
    }
    const fileName reached(table());
    if (!reached.empty())
    {
        incomplete
        (
            what + ", while " + reached + " says that a coupled run has come up to"
            " this time (remove that, too, to begin with new grains)",
            names
        );
    }
}


// ************************************************************************* //
