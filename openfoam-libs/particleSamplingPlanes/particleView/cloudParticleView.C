/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cloudParticleView.H"
#include "IOField.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(cloudParticleView, 0);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::cloud& Foam::cloudParticleView::lookupCloud() const
{
    const cloud* cloudPtr = mesh_.cfindObject<cloud>(cloudName_);

    if (!cloudPtr)
    {
        FatalErrorInFunction
            << "No cloud " << cloudName_ << " on mesh " << mesh_.name()
            << " to sample. Clouds there: "
            << flatOutput(mesh_.sortedNames<cloud>()) << nl
            << "    Give one of them as entry cloud of the function object. A"
            << " cloud made by another function object must stand before it"
            << exit(FatalError);
    }

    return *cloudPtr;
}


template<class Type>
Foam::List<Type> Foam::cloudParticleView::take
(
    objectRegistry& published,
    const word& name
) const
{
    IOField<Type>* fieldPtr = published.getObjectPtr<IOField<Type>>(name);

    if (!fieldPtr)
    {
        FatalErrorInFunction
            << "Cloud " << cloudName_ << " publishes no field " << name
            << ", without which it cannot be sampled. It publishes "
            << published.sortedNames()
            << exit(FatalError);
    }

    List<Type> values;
    values.transfer(*fieldPtr);
    return values;
}


bool Foam::cloudParticleView::readCloud(List<scalar>& age)
{
    const cloud& particles = lookupCloud();

    // The fields live only as long as this registry
    objectRegistry published
    (
        IOobject
        (
            cloudName_ + "SamplingRegistry",
            mesh_.time().timeName(),
            cloud::prefix,
            mesh_.time(),
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        )
    );
    particles.writeObjects(published);

    now_.position = take<point>(published, "position");
    now_.U = take<vector>(published, "U");
    now_.origId = take<label>(published, "origId");
    now_.origProc = take<label>
    (
        published,
        published.found("origProcId") ? "origProcId" : "origProc"
    );

    if (published.found("nParticle"))
    {
        now_.nParticle = take<scalar>(published, "nParticle");
    }
    else
    {
        now_.nParticle.setSize(now_.size());
        now_.nParticle = 1;
    }

    now_.d = take<scalar>(published, "d");
    now_.rho = take<scalar>(published, "rho");

    if (needsPositionOld() || published.found("positionOld"))
    {
        start_ = take<point>(published, "positionOld");
        return true;
    }

    if (published.found("age"))
    {
        age = take<scalar>(published, "age");
    }
    return false;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cloudParticleView::cloudParticleView
(
    const fvMesh& mesh,
    const word& cloudName
)
:
    particleView(mesh, cloudName),
    tracker_(),
    watch_(),
    knowsStart_(false),
    nPresent_(0),
    trackedTimeIndex_(-1)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::cloudParticleView::begin()
{
    lookupCloud();

    if (!needsPositionOld())
    {
        List<scalar> age;
        if (!readCloud(age))
        {
            tracker_.remember(now_);
            trackedTimeIndex_ = mesh_.time().timeIndex();
        }
    }
}


bool Foam::cloudParticleView::refresh()
{
    const Time& time = mesh_.time();
    List<scalar> age;

    knowsStart_ = readCloud(age);
    nPresent_ = now_.size();
    if (knowsStart_)
    {
        particleState gone(watch_.gone(now_));
        if (gone.size())
        {
            start_.append(gone.position);
            gone.flyOn(deltaT_, mesh_.bounds());
            now_.append(gone);
        }
        return true;
    }

    const bool known = (trackedTimeIndex_ == time.timeIndex() - 1);
    trackedTimeIndex_ = time.timeIndex();

    if (!known)
    {
        tracker_.remember(now_);
        start_ = now_.position;
        return false;
    }

    start_ = tracker_.startPoints
    (
        now_,
        age,
        deltaT_,
        mesh_.bounds()
    );
    return true;
}


void Foam::cloudParticleView::watch(const UList<label>& parcels)
{
    DynamicList<label> present(parcels.size());
    for (const label i : parcels)
    {
        if (i < nPresent_)
        {
            present.append(i);
        }
    }
    watch_.watch(now_.subset(present));
}


// ************************************************************************* //
