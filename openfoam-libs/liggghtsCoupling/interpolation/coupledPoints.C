/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coupledPoints.H"
#include "Pstream.H"

#include <algorithm>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::coupledPoints::coupledPoints
(
    const polyMesh& mesh,
    const coincidentPoints::identity by,
    const labelUList& number
)
:
    members_(),
    firstMember_(),
    nPoints_(number.empty() ? mesh.nPoints() : max(number) + 1),
    needed_(Pstream::nProcs()),
    nArriving_(Pstream::nProcs(), Zero)
{
    typedef coincidentPoints::rankPoint rankPoint;
    const label me = Pstream::myProcNo();
    const coincidentPoints same(mesh, by);
    const auto numberOf = [&](const label pointi)
    {
        return number.empty() ? pointi : number[pointi];
    };

    // Where values from a rank begin is known once all of them are counted
    DynamicList<rankPoint> arriving;
    for (const List<rankPoint>& group : same.groups())
    {
        const auto own = std::find_if
        (
            group.begin(), group.end(), [&](const rankPoint& p){ return p.first() == me; }
        );
        if (numberOf(own->second()) < 0)
        {
            continue;
        }
        firstMember_.append(members_.size());
        for (const rankPoint& p : group)
        {
            if (p.first() == me)
            {
                members_.append(numberOf(p.second()));
            }
            else
            {
                arriving.append(rankPoint(p.first(), members_.size()));
                members_.append(nArriving_[p.first()]++);
            }
        }
        DynamicList<label> ranks;
        for (const rankPoint& p : group)
        {
            if (p.first() != me && !ranks.found(p.first()))
            {
                ranks.append(p.first());
                for (const rankPoint& q : group)
                {
                    if (q.first() == me)
                    {
                        needed_[p.first()].append(numberOf(q.second()));
                    }
                }
            }
        }
    }
    firstMember_.append(members_.size());

    labelList start(Pstream::nProcs(), nPoints_);
    for (label proci = 1; proci < Pstream::nProcs(); ++proci)
    {
        start[proci] = start[proci - 1] + nArriving_[proci - 1];
    }
    for (const rankPoint& a : arriving)
    {
        members_[a.second()] += start[a.first()];
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::coupledPoints::sum(scalar* values, const label width, label stride) const
{
    stride = (stride ? stride : width);
    List<scalar> arrived;
    if (Pstream::parRun())
    {
        List<List<scalar>> send(Pstream::nProcs());
        labelList nArriving(nArriving_);
        forAll(needed_, proci)
        {
            nArriving[proci] *= width;
            send[proci].setSize(width*needed_[proci].size());
            forAll(needed_[proci], i)
            {
                std::copy_n
                (
                    values + stride*needed_[proci][i], width, &send[proci][width*i]
                );
            }
        }
        List<List<scalar>> received(Pstream::nProcs());
        Pstream::exchange<List<scalar>, scalar>(send, nArriving, received);
        for (const List<scalar>& list : received)
        {
            arrived.append(list);
        }
    }

    List<scalar> all(width);
    for (label g = 0; g + 1 < firstMember_.size(); ++g)
    {
        all = 0;
        for (label i = firstMember_[g]; i < firstMember_[g + 1]; ++i)
        {
            const label m = members_[i];
            const scalar* member =
                m < nPoints_ ? values + stride*m : &arrived[width*(m - nPoints_)];
            for (label k = 0; k < width; ++k)
            {
                all[k] += member[k];
            }
        }
        for (label i = firstMember_[g]; i < firstMember_[g + 1]; ++i)
        {
            if (members_[i] < nPoints_)
            {
                std::copy_n(all.cdata(), width, values + stride*members_[i]);
            }
        }
    }
}


Foam::labelList Foam::coupledPoints::own() const
{
    DynamicList<label> points;
    for (const label m : members_)
    {
        if (m < nPoints_)
        {
            points.append(m);
        }
    }
    return labelList(points);
}


// ************************************************************************* //
