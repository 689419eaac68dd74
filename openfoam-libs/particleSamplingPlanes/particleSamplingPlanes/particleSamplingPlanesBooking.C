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
    const label parceli,
    const scalar before,
    const scalar after
)
{
    const particleState& now = view_->now();
    const point& start = view_->start()[parceli];
    const vector way(now.position[parceli] - start);
    const scalar deltaT = time_.deltaTValue();

    ringStatistics::crossing c;
    c.forward = after > before;
    c.nParticle = now.nParticle[parceli];
    c.mass = view_->mass(parceli);
    c.speedOverStep = mag(way & frame_.axis())/deltaT;

    const label sizei = sizeClass(view_->diameter(parceli));

    forAll(positions_, planei)
    {
        const scalar x = positions_[planei];

        if ((before < x) == (after < x))
        {
            continue;
        }

        const scalar fraction = (x - before)/(after - before);
        const point p(start + fraction*way);
        c.velocity = frame_.components(p, now.U[parceli]);

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
                time_.value() - (1 - fraction)*deltaT,
                x,
                scalar(c.forward ? 1 : -1),
                scalar(now.origProc[parceli]),
                scalar(now.origId[parceli]),
                p.x(), p.y(), p.z(),
                c.velocity.x(), c.velocity.y(), c.velocity.z(),
                c.nParticle,
                c.mass
            });
        }
    }
}


void Foam::functionObjects::particleSamplingPlanes::bookCrossings()
{
    const List<point>& start = view_->start();
    const particleState& now = view_->now();
    const scalar longest = 0.5*meshLength();
    const scalar deltaT = time_.deltaTValue();
    const bool watch = view_->wantsWatch();
    DynamicList<label> toWatch;

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
            ++jumped_;
        }
        else if (!here.contains(before))
        {
            book(i, before, after);
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
}


// ************************************************************************* //
