/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/
// Edits of controlDict for which OpenFOAM replaces the function object. Up to
// v2006 it makes the new one before it destroys the former one, then after

#include "particleSamplingPlanes.H"

#include <memory>

// * * * * * * * * * * * * * * * Local Variables * * * * * * * * * * * * * * //

namespace
{

// What the last one that was destroyed in a run had done
std::unique_ptr<Foam::functionObjects::particleSamplingPlanes> takenOut;

}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::functionObjects::particleSamplingPlanes::takeOver
(
    particleSamplingPlanes& former
)
{
    frame_ = former.frame_;
    grid_ = former.grid_;
    planes_ = former.planes_;
    sizeLimits_ = former.sizeLimits_;
    positions_ = former.positions_;
    clock_ = former.clock_;
    view_ = std::move(former.view_);
    events_ = std::move(former.events_);
    beginTime_ = former.beginTime_;
    keptTimeIndex_ = former.keptTimeIndex_;
    writtenTimeIndex_ = former.writtenTimeIndex_;
    executedTimeIndex_ = former.executedTimeIndex_;
    jumped_ = former.jumped_;
}


Foam::functionObjects::particleSamplingPlanes*
Foam::functionObjects::particleSamplingPlanes::former()
{
    if (planes_.size())
    {
        return this;
    }
    if
    (
        takenOut && &takenOut->time_ == &time_ && takenOut->name() == name()
     && takenOut->beginTimeIndex_ == time_.timeIndex()
    )
    {
        return takenOut.get();
    }
    return samplingState::owner(time_, name());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::particleSamplingPlanes::particleSamplingPlanes
(
    particleSamplingPlanes& destroyed
)
:
    fvMeshFunctionObject(destroyed.name(), destroyed.mesh_, dictionary::null),
    writeFile(mesh_, destroyed.name()),
    frame_(),
    grid_(destroyed.grid_),
    timeStart_(-VGREAT),
    timeEnd_(VGREAT),
    triggered_(false),
    ownWriteControl_(false),
    beginTimeIndex_(time_.timeIndex()),
    seenTimeIndex_(-1)
{
    takeOver(destroyed);
}


// * * * * * * * * * * * * * * * * Destructor  * * * * * * * * * * * * * * * //

Foam::functionObjects::particleSamplingPlanes::~particleSamplingPlanes()
{
    // One that has been replaced, or holds what another one has done
    if (!keeper_)
    {
        return;
    }

    // At the end of a program there is no mesh any more
    const HashTable<const fvMesh*> meshes(time_.lookupClass<fvMesh>());
    forAllConstIters(meshes, iter)
    {
        if (iter.val() == &mesh_)
        {
            keeper_.reset(nullptr);
            takenOut.reset(new particleSamplingPlanes(*this));
            return;
        }
    }
}


// ************************************************************************* //
