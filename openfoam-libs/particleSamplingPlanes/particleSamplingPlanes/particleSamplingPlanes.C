/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "particleSamplingPlanes.H"
#include "addToRunTimeSelectionTable.H"
#include "ListOps.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(particleSamplingPlanes, 0);

    addToRunTimeSelectionTable
    (
        functionObject,
        particleSamplingPlanes,
        dictionary
    );
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

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


void Foam::functionObjects::particleSamplingPlanes::checkContinuity()
{
    const label timeIndex = time_.timeIndex();

    if (executedTimeIndex_ >= 0 && timeIndex != executedTimeIndex_ + 1)
    {
        FatalErrorInFunction
            << type() << ' ' << name() << " was not executed between the steps "
            << executedTimeIndex_ << " and " << timeIndex
            << ", crossings are lost" << exit(FatalError);
    }

    executedTimeIndex_ = timeIndex;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::particleSamplingPlanes::particleSamplingPlanes
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(mesh_, name),
    frame_(),
    grid_(1, 1, ringGrid::binning::equalWidth),
    planes_(),
    sizeLimits_(),
    positions_(),
    clock_(),
    view_(),
    events_(),
    timeEnd_(VGREAT),
    ownWriteControl_(false),
    writtenTimeIndex_(-1),
    executedTimeIndex_(-1),
    jumped_(0)
{
    read(dict);
    readState(dict);
    view_->begin();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::particleSamplingPlanes::read
(
    const dictionary& dict
)
{
    fvMeshFunctionObject::read(dict);
    writeFile::read(dict);
    checkKeywords(dict);

    const scalarList before(planes_.size() ? signature() : scalarList());

    frame_ = samplingFrame(dict);

    const label nRings = dict.get<label>("radialBins");
    const scalar maxRadius = dict.get<scalar>("maxRadius");
    if (nRings < 1 || maxRadius <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "radialBins " << nRings << " must be at least 1 and maxRadius "
            << maxRadius << " positive (in diameters)"
            << exit(FatalIOError);
    }
    grid_ = ringGrid
    (
        nRings,
        maxRadius,
        ringGrid::binningNames.getOrDefault
        (
            "binning",
            dict,
            ringGrid::binning::equalWidth
        )
    );

    scalarList positions(dict.get<scalarList>("planes"));
    sort(positions);
    if (positions.empty())
    {
        FatalIOErrorInFunction(dict)
            << "planes is empty; give at least one distance from the origin"
            << " in diameters" << exit(FatalIOError);
    }
    for (label i = 1; i < positions.size(); ++i)
    {
        if (positions[i] == positions[i - 1])
        {
            FatalIOErrorInFunction(dict)
                << "planes has " << positions[i] << " twice"
                << exit(FatalIOError);
        }
    }

    sizeLimits_ = dict.lookupOrDefault("sizeClasses", scalarList());
    for (label i = 0; i < sizeLimits_.size(); ++i)
    {
        if (sizeLimits_.size() < 2 || (i && sizeLimits_[i] <= sizeLimits_[i - 1]))
        {
            FatalIOErrorInFunction(dict)
                << "sizeClasses " << sizeLimits_ << " must be at least two"
                << " diameters in ascending order [m]" << exit(FatalIOError);
        }
    }

    timeEnd_ = dict.lookupOrDefault<scalar>("timeEnd", VGREAT);
    ownWriteControl_ = dict.found("writeControl") || dict.found("outputControl");

    if (before.empty())
    {
        positions_ = positions;
        planes_.setSize(positions.size()*max(sizeLimits_.size(), 1));
        forAll(planes_, i)
        {
            planes_[i] = samplingPlane
            (
                positions[i % positions.size()],
                nRings
            );
        }

        view_ = particleView::New(mesh_, dict.get<word>("cloud"));

        if (dict.lookupOrDefault("events", false))
        {
            events_.reset(new crossingEvents);
        }
    }
    else if (before != signature() || positions != positions_)
    {
        FatalIOErrorInFunction(dict)
            << "planes, rings and axis of " << name()
            << " cannot be changed during a run" << exit(FatalIOError);
    }

    return true;
}


bool Foam::functionObjects::particleSamplingPlanes::execute()
{
    if (postProcess)
    {
        Log << type() << ' ' << name() << ": nothing to do in post-processing,"
            << " crossings can only be seen during the run" << endl;
        return true;
    }

    checkContinuity();

    if (view_->refresh())
    {
        if (clock_.advance(time_.deltaTValue()))
        {
            for (samplingPlane& plane : planes_)
            {
                plane.joinBatches();
            }
        }

        bookCrossings();
    }

    // After timeEnd nobody calls again, so the last step inside is a time to write
    const bool last =
        time_.value() + time_.deltaTValue()
      > timeEnd_ + 0.5*time_.deltaTValue();

    if (time_.writeTime() || last)
    {
        publish();
    }

    return true;
}


bool Foam::functionObjects::particleSamplingPlanes::write()
{
    if
    (
        ownWriteControl_
     && !postProcess
     && writtenTimeIndex_ != time_.timeIndex()
    )
    {
        publish();
    }

    return true;
}


bool Foam::functionObjects::particleSamplingPlanes::end()
{
    if (!postProcess && writtenTimeIndex_ != time_.timeIndex())
    {
        publish();
    }

    return true;
}


// ************************************************************************* //
