/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "particleSamplingPlanes.H"
#include "localEulerDdtScheme.H"
#include "OSspecific.H"
#include "PstreamReduceOps.H"
#include "releases.H"
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// What the rings of all planes may take of the memory: about 100 MB
static const label maxRings = 100000;


static void require
(
    const dictionary& dict,
    const word& keyword,
    const scalar low,
    const scalar high
)
{
    scalar value = low;
    if (dict.readIfPresent(keyword, value) && !(value >= low && value <= high))
    {
        FatalIOErrorInFunction(dict)
            << keyword << ' ' << value << " must lie between " << low << " and "
            << high << exit(FatalIOError);
    }
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarList Foam::functionObjects::particleSamplingPlanes::numbers
(
    const dictionary& dict,
    const word& keyword
)
{
    if (!dict.found(keyword))
    {
        return scalarList();
    }

    const ITstream& tokens = dict.lookup(keyword);
    if (tokens.size() && tokens.last() != token::END_LIST)
    {
        FatalIOErrorInFunction(dict)
            << keyword << " must be a list of numbers in parentheses, for"
            << " instance (1 2)" << exit(FatalIOError);
    }

    return dict.get<scalarList>(keyword);
}


const Foam::dictionary&
Foam::functionObjects::particleSamplingPlanes::checkRegion
(
    const Time& runTime,
    const dictionary& dict
)
{
    // Other errors than those of input only make OpenFOAM leave a function
    // object out: right while the run goes on, not at its start
    const word region
    (
        dict.lookupOrDefault<word>("region", polyMesh::defaultRegion)
    );
    if
    (
        runTime.timeIndex() == runTime.startTimeIndex()
     && !runTime.foundObject<fvMesh>(region)
    )
    {
        FatalIOErrorInFunction(dict)
            << "region " << region << " is not a mesh of this run. There are "
            << flatOutput(runTime.sortedNames<fvMesh>()) << exit(FatalIOError);
    }

    return dict;
}


void Foam::functionObjects::particleSamplingPlanes::checkKeywords
(
    const dictionary& dict
) const
{
    const wordHashSet own
    ({
        "cloud", "origin", "axis", "diameter", "planes", "radialBins",
        "maxRadius", "binning", "sizeClasses", "events", "reset"
    });
    const wordHashSet ofEveryFunctionObject
    ({
        "type", "libs", "functionObjectLibs", "enabled", "log", "region",
        "timeStart", "timeEnd", "writeControl", "writeInterval",
        "outputControl", "outputInterval", "executeControl", "executeInterval",
        "triggerStart", "triggerEnd", "controlMode", "deltaTCoeff",
        "nStepsToStartTimeChange", "writePrecision", "writeToFile",
        "useUserTime"
    });

    for (const entry& e : dict)
    {
        const word& keyword = e.keyword();

        if (!own.found(keyword) && !ofEveryFunctionObject.found(keyword))
        {
            FatalIOErrorInFunction(dict)
                << "Unknown entry " << keyword << ". Entries of " << type()
                << " are " << own.sortedToc()
                << " and those of every function object"
                << exit(FatalIOError);
        }
    }

    if (dict.found("executeControl") || dict.found("executeInterval"))
    {
        FatalIOErrorInFunction(dict)
            << "executeControl and executeInterval cannot be used with "
            << type() << ", which must see every step; remove them"
            << exit(FatalIOError);
    }
}


void Foam::functionObjects::particleSamplingPlanes::checkNumbers
(
    const dictionary& dict
) const
{
    require(dict, "radialBins", 1, 10000);
    require(dict, "maxRadius", 1e-6, 1e6);
    require(dict, "timeStart", -1e15, 1e15);
    require(dict, "writePrecision", 1, 17);

    // OpenFOAM divides by it, and counts the intervals
    for (const char* keyword : {"writeInterval", "outputInterval"})
    {
        require(dict, keyword, 1e-3*min(time_.deltaTValue(), 1.0), 1e15);
    }

    if (timeStart_ >= timeEnd_)
    {
        FatalIOErrorInFunction(dict)
            << "timeEnd " << timeEnd_ << " must lie after timeStart "
            << timeStart_ << exit(FatalIOError);
    }
    if (timeStart_ > time_.endTime().value())
    {
        IOWarningInFunction(dict)
            << "timeStart " << timeStart_ << " lies after the endTime "
            << time_.endTime().value() << " of this run: nothing is sampled"
            << endl;
    }

    const label n = positions_.size()*max(sizeLimits_.size(), 1);
    if (n > maxRings/(grid_.size() + 1))
    {
        FatalIOErrorInFunction(dict)
            << "radialBins " << grid_.size() << " on " << n << " planes and"
            << " classes of size are more than " << maxRings << " rings"
            << exit(FatalIOError);
    }

    for (label i = 1; i < positions_.size(); ++i)
    {
        if (positions_[i] == positions_[i - 1])
        {
            FatalIOErrorInFunction(dict)
                << "planes has " << positions_[i] << " twice"
                << exit(FatalIOError);
        }
        if (tableName(i) == tableName(i - 1))
        {
            std::ostringstream message;
            message.precision(17);
            message
                << "planes " << positions_[i - 1] << " and " << positions_[i]
                << " give the same file, ";
            FatalIOErrorInFunction(dict)
                << message.str().c_str() << tableName(i)
                << exit(FatalIOError);
        }
    }

    for (label i = 0; i < sizeLimits_.size(); ++i)
    {
        if
        (
            sizeLimits_.size() < 2
         || (i && !(sizeLimits_[i] > sizeLimits_[i - 1]))
        )
        {
            FatalIOErrorInFunction(dict)
                << "sizeClasses " << flatOutput(sizeLimits_) << " must be at"
                << " least two diameters in ascending order [m]"
                << exit(FatalIOError);
        }
        if (!(sizeLimits_[i] >= 0 && sizeLimits_[i] <= 1000))
        {
            FatalIOErrorInFunction(dict)
                << "sizeClasses has " << sizeLimits_[i] << ", must lie between 0"
                << " and 1000 m" << exit(FatalIOError);
        }
    }
}


void Foam::functionObjects::particleSamplingPlanes::checkMesh
(
    const dictionary& dict
) const
{
    if (mesh_.steady() || fv::localEulerDdt::enabled(mesh_))
    {
        FatalIOErrorInFunction(dict)
            << type() << " samples in time, but ddtSchemes of "
            << mesh_.name() << " in system/fvSchemes is steadyState or"
            << " localEuler, whose steps are no time. Use a transient solver, or"
            << " remove " << name() << " from the functions"
            << exit(FatalIOError);
    }

    // Of all ranks; a rank may have no part of the mesh
    scalar lower = VGREAT;
    scalar upper = -VGREAT;
    for (const point& p : mesh_.points())
    {
        const scalar x = frame_.axial(p);
        lower = min(lower, x);
        upper = max(upper, x);
    }
    reduce(lower, minOp<scalar>());
    reduce(upper, maxOp<scalar>());

    const scalar margin = 1e-6*(upper - lower);
    for (const scalar x : positions_)
    {
        if (!(x >= lower - margin && x <= upper + margin))
        {
            FatalIOErrorInFunction(dict)
                << "planes has " << x << ", outside the mesh, which reaches from "
                << lower << " to " << upper << " along the axis (in diameters of "
                << frame_.diameter() << " m from the origin): no particle can"
                << " cross there" << exit(FatalIOError);
        }
    }

    const boundBox& bounds = mesh_.bounds();
    const scalar reach = 0.5*bounds.mag()/frame_.diameter();
    const scalar distance = frame_.radius(bounds.midpoint());
    if (distance - reach > grid_.radius(grid_.size()))
    {
        FatalIOErrorInFunction(dict)
            << "The axis passes the mesh at more than maxRadius "
            << grid_.radius(grid_.size()) << " diameters: no particle can cross"
            << " a ring. Check origin " << frame_.origin() << " and axis "
            << frame_.axis() << "; the bounds of the mesh are " << bounds
            << exit(FatalIOError);
    }
}


void Foam::functionObjects::particleSamplingPlanes::makeFolder
(
    const dictionary& dict
) const
{
    // Also tells a later restart that this run has sampled
    bool made = true;
    if (Pstream::master())
    {
        const bool throwing = FatalError.throwExceptions();
        try
        {
            mkDir(folder());
        }
        catch (const Foam::error&)
        {}
        FatalError.throwExceptions(throwing);

        made = isDir(folder());
    }
    releases::fromMaster(made);

    if (!made)
    {
        FatalIOErrorInFunction(dict)
            << "The folder " << folder() << " for the tables of " << name()
            << " cannot be made" << exit(FatalIOError);
    }
}


void Foam::functionObjects::particleSamplingPlanes::checkParticles
(
    const dictionary& dict
)
{
    const bool throwing = FatalError.throwExceptions();
    string problem;

    try
    {
        view_->begin();
    }
    catch (const Foam::error& err)
    {
        problem = err.message();
    }

    FatalError.throwExceptions(throwing);

    if (!problem.empty())
    {
        FatalIOErrorInFunction(dict) << problem.c_str() << exit(FatalIOError);
    }
}


bool Foam::functionObjects::particleSamplingPlanes::sampledBefore() const
{
    const scalar start = time_.value();
    const scalar margin = 1e-3*time_.deltaTValue();

    // Where the window opens later nothing can have been sampled
    if (start < timeStart_ - 0.5*time_.deltaTValue())
    {
        return false;
    }

    wordList earlier;
    for (const instant& i : time_.times())
    {
        if (i.name() != time_.constant() && i.value() < start - margin)
        {
            earlier.append(i.name());
        }
    }
    releases::fromMaster(earlier);

    for (const word& timeName : earlier)
    {
        if (samplingState::exists(time_, name(), timeName))
        {
            return true;
        }
    }

    // Times may have been purged, tables not
    bool tables = false;
    if (Pstream::master())
    {
        for
        (
            const fileName& dir
          : readDir(baseFileDir()/name(), fileName::DIRECTORY)
        )
        {
            scalar value;
            tables = tables || (readScalar(dir, value) && value < start - margin);
        }
    }
    releases::fromMaster(tables);

    return tables;
}


// ************************************************************************* //
