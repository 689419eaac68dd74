/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coupledPoints.H"
#include "Pstream.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class T>
void Foam::coupledPoints::sum(T* values) const
{
    List<T> arrived;
    if (Pstream::parRun())
    {
        List<List<T>> send(Pstream::nProcs());
        forAll(needed_, proci)
        {
            send[proci].setSize(needed_[proci].size());
            forAll(needed_[proci], i)
            {
                send[proci][i] = values[needed_[proci][i]];
            }
        }
        List<List<T>> received(Pstream::nProcs());
        Pstream::exchange<List<T>, T>(send, nArriving_, received);
        for (const List<T>& list : received)
        {
            arrived.append(list);
        }
    }

    for (label g = 0; g + 1 < firstMember_.size(); ++g)
    {
        T all{};
        for (label i = firstMember_[g]; i < firstMember_[g + 1]; ++i)
        {
            const label m = members_[i];
            all += (m < nPoints_ ? values[m] : arrived[m - nPoints_]);
        }
        for (label i = firstMember_[g]; i < firstMember_[g + 1]; ++i)
        {
            if (members_[i] < nPoints_)
            {
                values[members_[i]] = all;
            }
        }
    }
}


// ************************************************************************* //
