/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The cells of other ranks that touch this rank's.

\*---------------------------------------------------------------------------*/

#include "tetCells.H"
#include "HashSet.H"
#include "labelPairHashes.H"
#include "swapLists.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

// What a rank is told: a cell of another one touches this point of its mesh
struct touchingCell
{
    label point;
    label cell;
};

} // End anonymous namespace

template<> struct is_contiguous<touchingCell> : std::true_type {};
template<> struct is_contiguous<tetCells::neighbourCell> : std::true_type {};

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::tetCells::introduce(const coincidentPoints& same)
{
    const label me = Pstream::myProcNo();
    const labelListList& pointCells = mesh_.pointCells();

    List<DynamicList<touchingCell>> touches(Pstream::nProcs());
    List<DynamicList<neighbourCell>> cells(Pstream::nProcs());
    List<DynamicList<point>> corners(Pstream::nProcs());
    HashSet<labelPair, Hash<labelPair>> told;

    const auto tell = [&](const label celli, const label rank, const label pointi)
    {
        touches[rank].append(touchingCell{pointi, celli});
        if (!told.insert(labelPair(rank, celli)))
        {
            return;
        }
        DynamicList<point>& list = corners[rank];
        const label first = list.size();
        for (const label facei : mesh_.cells()[celli])
        {
            triangles
            (
                celli,
                facei,
                [&](const label a, const label b, const label c)
                {
                    list.append(mesh_.points()[a]);
                    list.append(mesh_.points()[b]);
                    list.append(mesh_.points()[c]);
                }
            );
        }
        cells[rank].append
        (
            neighbourCell
            {
                me, celli, mesh_.cellCentres()[celli], first, (list.size() - first)/3
            }
        );
    };

    for (const List<coincidentPoints::rankPoint>& group : same.groups())
    {
        for (const coincidentPoints::rankPoint& mine : group)
        {
            if (mine.first() != me)
            {
                continue;
            }
            for (const coincidentPoints::rankPoint& other : group)
            {
                for (const label celli : pointCells[mine.second()])
                {
                    if (other.first() != me)
                    {
                        tell(celli, other.first(), other.second());
                    }
                    else if (other.second() != mine.second())
                    {
                        beyond_(other.second()).append(celli);
                    }
                }
            }
        }
    }

    const List<DynamicList<touchingCell>> touchesHere(swapLists(touches));
    const List<DynamicList<neighbourCell>> cellsHere(swapLists(cells));
    const List<DynamicList<point>> cornersHere(swapLists(corners));
    forAll(cellsHere, proci)
    {
        Map<label> number;
        for (neighbourCell cell : cellsHere[proci])
        {
            cell.first += corners_.size();
            number.insert(cell.cell, -2 - neighbourCells_.size());
            neighbourCells_.append(cell);
        }
        corners_.append(cornersHere[proci]);
        for (const touchingCell& t : touchesHere[proci])
        {
            beyond_(t.point).append(number[t.cell]);
        }
    }
}


// ************************************************************************* //
