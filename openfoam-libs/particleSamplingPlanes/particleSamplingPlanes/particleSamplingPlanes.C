/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

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

void Foam::functionObjects::particleSamplingPlanes::readWindow
(
    const dictionary& dict
)
{
    timeStart_ = -VGREAT;
    timeEnd_ = VGREAT;
    if (dict.readIfPresent("timeStart", timeStart_))
    {
        timeStart_ = time_.userTimeToTime(timeStart_);
    }
    if (dict.readIfPresent("timeEnd", timeEnd_))
    {
        timeEnd_ = time_.userTimeToTime(timeEnd_);
    }
    triggered_ = dict.found("triggerStart");
    ownWriteControl_ = dict.found("writeControl") || dict.found("outputControl");
}


void Foam::functionObjects::particleSamplingPlanes::begin
(
    const dictionary& dict
)
{
    frame_ = samplingFrame(dict);

    const word binning(dict.lookupOrDefault<word>("binning", "equalWidth"));
    if (!ringGrid::binningNames.found(binning))
    {
        FatalIOErrorInFunction(dict)
            << "Unknown binning " << binning << ". Valid: "
            << flatOutput(ringGrid::binningNames.sortedToc())
            << exit(FatalIOError);
    }
    grid_ = ringGrid
    (
        dict.get<label>("radialBins"),
        dict.get<scalar>("maxRadius"),
        ringGrid::binningNames[binning]
    );

    positions_ = numbers(dict, "planes");
    sort(positions_);
    if (positions_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "planes is missing or empty; give at least one distance from the origin"
            << " in diameters" << exit(FatalIOError);
    }

    sizeLimits_ = numbers(dict, "sizeClasses");

    checkNumbers(dict);

    planes_.setSize(positions_.size()*max(sizeLimits_.size(), 1));
    forAll(planes_, i)
    {
        planes_[i] = samplingPlane
        (
            positions_[i % positions_.size()],
            grid_.size()
        );
    }

    view_ = particleView::New(mesh_, dict.get<word>("cloud"));

    if (dict.lookupOrDefault("events", false))
    {
        events_.reset(new crossingEvents);
    }

    if (postProcess)
    {
        Log << type() << ' ' << name() << ": post-processing has no particles of cloud "
            << dict.get<word>("cloud") << " at hand. Crossings are counted during"
            << " a run; the tables stay as they are" << endl;
        return;
    }

    checkMesh(dict);
    checkParticles(dict);
    if (time_.timeIndex() == time_.startTimeIndex())
    {
        readState(dict);
    }
    makeFolder(dict);
    keeper_.reset(new samplingState(time_, name(), *this));
}


void Foam::functionObjects::particleSamplingPlanes::sample()
{
    const label timeIndex = time_.timeIndex();

    if (executedTimeIndex_ == timeIndex)
    {
        return;
    }
    const bool seen = (seenTimeIndex_ == timeIndex);
    if (executedTimeIndex_ >= 0 && timeIndex != executedTimeIndex_ + 1)
    {
        WarningInFunction
            << type() << ' ' << name() << " was not executed between the steps "
            << executedTimeIndex_ << " and " << timeIndex
            << ": what crossed meanwhile is not counted" << endl;
        if (!seen)
        {
            view_->forget();
        }
    }
    executedTimeIndex_ = timeIndex;

    // With sub-steps this is the last one of the step
    const scalar end = time_.value();
    const scalar deltaT = seen ? seen_.first().deltaT : time_.deltaTValue();
    if (seen)
    {
        forAll(seen_, i)
        {
            book(seen_[i], end - (seen_.size() - i)*deltaT);
        }
        seen_.clear();
    }
    view_->setStep(deltaT);
    if (view_->refresh())
    {
        book(findPassages(deltaT), end);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::particleSamplingPlanes::particleSamplingPlanes
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, checkRegion(runTime, dict)),
    writeFile(mesh_, name),
    frame_(),
    grid_(1, 1, ringGrid::binning::equalWidth),
    planes_(),
    sizeLimits_(),
    positions_(),
    clock_(),
    view_(),
    events_(),
    timeStart_(-VGREAT),
    timeEnd_(VGREAT),
    triggered_(false),
    ownWriteControl_(false),
    beginTime_(runTime.value()),
    beginTimeIndex_(runTime.timeIndex()),
    keptTimeIndex_(-1),
    writtenTimeIndex_(-1),
    executedTimeIndex_(-1),
    seen_(),
    seenTimeIndex_(-1),
    jumped_(0),
    keeper_()
{
    if (runTime.timeIndex() == runTime.startTimeIndex())
    {
        read(dict);
        return;
    }

    // Added while the run goes on. OpenFOAM ends a run for wrong input; after
    // any other error it says so and goes on without the function object
    const bool throwing = FatalIOError.throwExceptions();
    try
    {
        read(dict);
        FatalIOError.throwExceptions(throwing);
    }
    catch (const Foam::IOerror& err)
    {
        FatalIOError.throwExceptions(throwing);
        FatalErrorInFunction
            << err.message().c_str() << nl << "file: " << err.ioFileName()
            << nl << "This run goes on without " << name << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::particleSamplingPlanes::read
(
    const dictionary& dict
)
{
    particleSamplingPlanes* before = former();

    if (!before)
    {
        fvMeshFunctionObject::read(dict);
        writeFile::read(dict);
        checkKeywords(dict);
        readWindow(dict);
        begin(dict);
        return true;
    }

    // An edit must neither end a running job nor what it has sampled
    if (before != this)
    {
        takeOver(*before);
        keeper_ = std::move(before->keeper_);
        if (!keeper_)
        {
            keeper_.reset(new samplingState(time_, name(), *this));
        }
        keeper_->setOwner(*this);
    }
    readWindow(dict);

    WarningInFunction
        << "The entries of " << name() << " in " << dict.name()
        << " have changed. They are read at the start of a run: this one goes on"
        << " as it began, but for timeStart, timeEnd, writeControl and"
        << " writeInterval, which OpenFOAM applies at once" << endl;

    // Nobody calls after timeEnd
    if
    (
        time_.value() > timeEnd_ + 0.5*time_.deltaTValue()
     && writtenTimeIndex_ != executedTimeIndex_
    )
    {
        publish();
    }

    return true;
}


bool Foam::functionObjects::particleSamplingPlanes::execute()
{
    if (postProcess)
    {
        return true;
    }

    sample();

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
