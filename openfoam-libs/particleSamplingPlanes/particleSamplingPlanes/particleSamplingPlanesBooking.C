/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "particleSamplingPlanes.H"
#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar
Foam::functionObjects::particleSamplingPlanes::meshLength() const
{
    const vector span(mesh_.bounds().span());
    const vector& axis = frame_.axis();

    return
    (
        mag(axis.x())*span.x() + mag(axis.y())*span.y() + mag(axis.z())*span.z()
    )/frame_.diameter();
}


Foam::functionObjects::particleSamplingPlanes::gap
Foam::functionObjects::particleSamplingPlanes::gapAt(const scalar x) const
{
    const scalar* const begin = positions_.begin();
    const scalar* const end = positions_.end();
    const scalar* const ahead = std::upper_bound(begin, end, x);

    return
    {
        ahead == begin ? -VGREAT : ahead[-1],
        ahead == end ? VGREAT : *ahead
    };
}


Foam::label Foam::functionObjects::particleSamplingPlanes::sizeClass
(
    const scalar diameter
) const
{
    const scalar* const begin = sizeLimits_.begin();
    const scalar* const end = sizeLimits_.end();
    const scalar* const above = std::upper_bound(begin, end, diameter);

    return above == end ? -1 : label(above - begin) - 1;
}


void Foam::functionObjects::particleSamplingPlanes::book
(
    const passages::parcel& parcel,
    const scalar deltaT,
    const scalar end
)
{
    ringStatistics::crossing c;
    c.forward = parcel.after > parcel.before;
    c.nParticle = parcel.nParticle;
    c.mass = parcel.mass;
    c.speedOverStep = mag(parcel.way & frame_.axis())/deltaT;

    const label sizei = sizeClass(parcel.diameter);

    forAll(positions_, planei)
    {
        const scalar x = positions_[planei];

        if ((parcel.before < x) == (parcel.after < x))
        {
            continue;
        }

        const scalar fraction = (x - parcel.before)/(parcel.after - parcel.before);
        const point p(parcel.start + fraction*parcel.way);
        c.velocity = frame_.components(p, parcel.U);

        const label ring = grid_.index(frame_.radius(p));
        planes_[planei].book(ring, c, clock_.current());
        if (sizei >= 0)
        {
            planes_[planei + (sizei + 1)*positions_.size()].book
            (
                ring,
                c,
                clock_.current()
            );
        }

        if (events_.valid())
        {
            events_->append
            ({
                end - (1 - fraction)*deltaT,
                x,
                scalar(c.forward ? 1 : -1),
                scalar(parcel.origProc),
                scalar(parcel.origId),
                p.x(), p.y(), p.z(),
                c.velocity.x(), c.velocity.y(), c.velocity.z(),
                c.nParticle,
                c.mass
            });
        }
    }
}


void Foam::functionObjects::particleSamplingPlanes::book
(
    const passages& passed,
    const scalar end
)
{
    if (clock_.advance(passed.deltaT))
    {
        for (samplingPlane& plane : planes_)
        {
            plane.joinBatches();
        }
    }
    for (const passages::parcel& parcel : passed.parcels)
    {
        book(parcel, passed.deltaT, end);
    }
    jumped_ += passed.jumped;
}


Foam::passages Foam::functionObjects::particleSamplingPlanes::findPassages
(
    const scalar deltaT
)
{
    const List<point>& start = view_->start();
    const particleState& now = view_->now();
    const scalar longest = 0.5*meshLength();
    const bool watch = view_->wantsWatch();
    DynamicList<label> toWatch;
    passages passed;
    passed.deltaT = deltaT;

    // Neighbours in the list are mostly neighbours in space
    gap here(gapAt(0));

    forAll(start, i)
    {
        const scalar before = frame_.axial(start[i]);
        const scalar after = frame_.axial(now.position[i]);
        if (!here.contains(after))
        {
            here = gapAt(after);
        }

        if (mag(after - before) > longest)
        {
            ++passed.jumped;
        }
        else if (!here.contains(before))
        {
            passed.parcels.append
            (passages::parcel{
                before, after, start[i], now.position[i] - start[i], now.U[i],
                now.nParticle[i], view_->mass(i), view_->diameter(i),
                now.origProc[i], now.origId[i]
            });
        }

        if (watch && !here.contains(after + deltaT*frame_.axialPart(now.U[i])))
        {
            toWatch.append(i);
        }
    }

    if (watch)
    {
        view_->watch(toWatch);
    }
    return passed;
}


void Foam::functionObjects::particleSamplingPlanes::seeGrains(const scalar length)
{
    const scalar deltaT = time_.deltaTValue();
    if
    (
        !view_ || !view_->hasSubSteps()
     || time_.value() < timeStart_ - deltaT || time_.value() > timeEnd_ + deltaT
    )
    {
        return;
    }

    const label timeIndex = time_.timeIndex();
    if (seenTimeIndex_ != timeIndex)
    {
        if (executedTimeIndex_ != timeIndex - 1)
        {
            view_->forget();
        }
        seenTimeIndex_ = timeIndex;
        seen_.clear();
    }
    view_->setStep(length);
    if (view_->refresh())
    {
        seen_.append(findPassages(length));
    }
}


// ************************************************************************* //
