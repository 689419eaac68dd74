/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "particleSamplingPlanes.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "releases.H"
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

// Adds packed rings of another rank, ring by ring
struct mergeRings
{
    void operator()(scalarList& x, const scalarList& y) const
    {
        for (label i = 0; i < x.size(); i += ringStatistics::packedSize)
        {
            ringStatistics sum;
            ringStatistics other;
            sum.unpack(&x[i]);
            other.unpack(&y[i]);
            sum.merge(other);
            sum.pack(&x[i]);
        }
    }
};

// The position as the user wrote it: 0.1, 10, -5
static word tidyName(const scalar x)
{
    std::ostringstream buffer;
    buffer.precision(10);
    buffer << x;
    return word(buffer.str(), false);
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarList
Foam::functionObjects::particleSamplingPlanes::signature() const
{
    DynamicList<scalar> numbers;
    for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
    {
        numbers.append(frame_.origin()[cmpt]);
        numbers.append(frame_.axis()[cmpt]);
    }
    numbers.append(frame_.diameter());
    for (label i = 0; i <= grid_.size(); ++i)
    {
        numbers.append(grid_.radius(i));
    }
    numbers.append(positions_);
    numbers.append(sizeLimits_);
    return scalarList(std::move(numbers));
}


Foam::scalarList
Foam::functionObjects::particleSamplingPlanes::combinedState() const
{
    label size = 0;
    for (const samplingPlane& plane : planes_)
    {
        size += plane.packedSize();
    }

    scalarList state(size);
    scalar* next = state.begin();
    for (const samplingPlane& plane : planes_)
    {
        plane.pack(next);
        next += plane.packedSize();
    }

    Pstream::combineGather(state, mergeRings());
    releases::fromMaster(state);
    return state;
}


void Foam::functionObjects::particleSamplingPlanes::readState
(
    const dictionary& dict
)
{
    const bool found = samplingState::exists(time_, name(), time_.timeName());
    const fileName file(samplingState::path(time_, name(), time_.timeName()));

    if (dict.lookupOrDefault("reset", false))
    {
        if (found || sampledBefore())
        {
            Log << type() << ' ' << name() << ": reset yes, begins anew and"
                << " forgets what was sampled before" << endl;
        }
        return;
    }

    static const char* const remedy =
        "remove the folder of this time, so that the run goes on from an earlier"
        " one, or begin anew with\n    reset yes;\n";

    if (!found)
    {
        if (sampledBefore())
        {
            FatalIOErrorInFunction(dict)
                << "What " << name() << " has sampled before time "
                << time_.timeName() << " is missing: there is no file " << nl
                << "    " << file << nl
                << "but earlier times have theirs, or postProcessing/" << name()
                << " has tables of an earlier run." << nl
                << "The run was probably killed while writing, or went on without "
                << name() << ". Either " << remedy << exit(FatalIOError);
        }
        if (time_.value() + 0.5*time_.deltaTValue() > timeEnd_)
        {
            FatalIOErrorInFunction(dict)
                << "timeEnd " << timeEnd_ << " lies before the first step after"
                << " time " << time_.timeName() << ": nothing would be sampled"
                << exit(FatalIOError);
        }
        return;
    }

    samplingState::numbers saved;
    if
    (
        !samplingState::read(time_, name(), saved)
     || saved.clock.size() != batchClock::packedSize
    )
    {
        FatalIOErrorInFunction(dict)
            << "What " << name() << " has sampled before time "
            << time_.timeName() << " cannot be read: the file" << nl
            << "    " << file << nl
            << "is cut short. The run was probably killed while writing. Either "
            << remedy << exit(FatalIOError);
    }

    if (mag(saved.time - time_.value()) > 0.5*time_.deltaTValue())
    {
        FatalIOErrorInFunction(dict)
            << "The file" << nl << "    " << file << nl << "holds what "
            << name() << " had sampled up to time " << saved.time
            << ", not " << time_.timeName() << ". Remove it, or begin anew with"
            << nl << "    reset yes;" << exit(FatalIOError);
    }

    const scalarList wanted(signature());
    bool same = (saved.signature.size() == wanted.size());
    for (label i = 0; same && i < wanted.size(); ++i)
    {
        same =
            mag(saved.signature[i] - wanted[i]) <= 1e-12*(1 + mag(wanted[i]));
    }
    label size = 0;
    for (const samplingPlane& plane : planes_)
    {
        size += plane.packedSize();
    }
    if (!same || saved.state.size() != size)
    {
        FatalIOErrorInFunction(dict)
            << "What " << name() << " sampled before the restart has other"
            << " planes, rings or another axis (" << file << "). Give back the"
            << " former ones, or begin anew with" << nl << "    reset yes;"
            << exit(FatalIOError);
    }

    clock_.unpack(saved.clock.begin());

    // The saved numbers are those of all ranks together
    if (Pstream::master())
    {
        const scalar* next = saved.state.begin();
        for (samplingPlane& plane : planes_)
        {
            plane.unpack(next);
            next += plane.packedSize();
        }
    }

    Log << type() << ' ' << name() << ": continues with "
        << clock_.total() << " s sampled before" << endl;
}


void Foam::functionObjects::particleSamplingPlanes::keepState()
{
    const scalar margin = 0.5*time_.deltaTValue();
    const bool inWindow =
    (
        time_.timeIndex() > beginTimeIndex_
     && time_.value() >= timeStart_ - margin
     && time_.value() <= timeEnd_ + margin
    );

    // The step is over, though the function object is executed later. Whether
    // it will be at all is not known with triggers: then publish() writes again
    if (inWindow && !triggered_)
    {
        sample();
    }

    writeState(combinedState());
}


void Foam::functionObjects::particleSamplingPlanes::writeState
(
    const scalarList& combined
)
{
    scalarList clock(batchClock::packedSize);
    clock_.pack(clock.begin());

    samplingState::write
    (
        time_,
        name(),
        {time_.value(), signature(), clock, combined}
    );
    keptTimeIndex_ = time_.timeIndex();
}


Foam::fileName Foam::functionObjects::particleSamplingPlanes::folder() const
{
    return baseFileDir()/name()/Time::timeName(beginTime_);
}


void Foam::functionObjects::particleSamplingPlanes::publish()
{
    const scalarList combined(combinedState());

    if (keptTimeIndex_ == time_.timeIndex() && triggered_)
    {
        writeState(combined);
    }

    if (Pstream::master())
    {
        mkDir(folder());
        writeTables(combined);
    }
    if (events_.valid())
    {
        events_->write(folder()/"events.dat");
    }

    const label jumped = returnReduce(jumped_, sumOp<label>());
    if (jumped)
    {
        Log << type() << ' ' << name() << ": " << jumped
            << " moves through periodic boundaries not counted" << endl;
    }

    writtenTimeIndex_ = time_.timeIndex();
}


Foam::word Foam::functionObjects::particleSamplingPlanes::tableName
(
    const label i
) const
{
    const label nPositions = positions_.size();
    word name("plane_" + tidyName(positions_[i % nPositions]) + 'D', false);
    if (i >= nPositions)
    {
        name += "_size" + Foam::name(i/nPositions);
    }
    return name + ".dat";
}


void Foam::functionObjects::particleSamplingPlanes::writeTables
(
    const scalarList& combined
) const
{
    Log << type() << ' ' << name() << ": crossings";

    const label nPositions = positions_.size();
    const scalar* next = combined.begin();
    forAll(planes_, i)
    {
        samplingPlane whole(planes_[i].position(), grid_.size());
        whole.unpack(next);
        next += whole.packedSize();

        OFstream os(folder()/tableName(i));
        os.precision(writePrecision_ > 10 ? writePrecision_ : 10);
        os  << "# " << type() << ' ' << name() << ", time = "
            << time_.timeName() << " s";
        if (i < nPositions)
        {
            Log << ' ' << tidyName(positions_[i]) << "D " << whole.crossings();
        }
        else
        {
            const label sizei = i/nPositions - 1;
            os  << ", particles of diameter " << sizeLimits_[sizei] << " to "
                << sizeLimits_[sizei + 1] << " m";
        }
        os  << nl;
        whole.writeTable(os, grid_, frame_.diameter(), clock_);

        if (!os.good())
        {
            WarningInFunction
                << "The table " << os.name() << " could not be written" << endl;
        }
    }

    Log << " in " << clock_.total() << " s sampled" << endl;
}


// ************************************************************************* //
