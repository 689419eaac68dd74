/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
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

void Foam::tetCells::view::consider
(
    const vector& a,
    const vector& b,
    const vector& c,
    const vector& toPoint
)
{
    // A tetrahedron that is flat or turned inside out holds nothing
    const vector bc(b ^ c);
    const scalar volume = a & bc;
    if (volume <= 0)
    {
        return;
    }

    const scalar wa = (toPoint & bc)/volume;
    const scalar wb = (toPoint & (c ^ a))/volume;
    const scalar wc = (toPoint & (a ^ b))/volume;
    const scalar sum = mag(wa) + mag(wb) + mag(wc);
    if (min(wa, min(wb, wc)) < -1e-9*sum)
    {
        return;
    }

    // Seen from the centre through the triangle; triangles side by side show the same on their
    // common edge
    const scalar h = volume/(mag((b - a) ^ (c - a)) + VSMALL);
    const scalar d = (1 - wa - wb - wc)*h;
    if (d > depth)
    {
        depth = d;
        height = h;
    }
}


template<class Visit>
void Foam::tetCells::triangles
(
    const label celli,
    const label facei,
    const Visit& visit
) const
{
    const face& f = mesh_.faces()[facei];
    const label base = max(mesh_.tetBasePtIs()[facei], 0);
    const bool owned = mesh_.faceOwner()[facei] == celli;
    for (label k = 1; k + 1 < f.size(); ++k)
    {
        const label b = f[(base + k)%f.size()];
        const label c = f[(base + k + 1)%f.size()];
        visit(f[base], owned ? b : c, owned ? c : b);
    }
}


inline void Foam::tetCells::lookAt
(
    const vector& toPoint,
    const label celli,
    const label facei,
    view& seen
) const
{
    const pointField& points = mesh_.points();
    const point& centre = mesh_.cellCentres()[celli];
    const scalar before = seen.depth;
    triangles
    (
        celli,
        facei,
        [&](const label a, const label b, const label c)
        {
            seen.consider
            (
                points[a] - centre, points[b] - centre, points[c] - centre, toPoint
            );
        }
    );
    seen.face = (seen.depth > before ? facei : seen.face);
}


Foam::tetCells::view Foam::tetCells::look
(
    const vector& toPoint,
    const label celli
) const
{
    view seen;
    for (const label facei : mesh_.cells()[celli])
    {
        lookAt(toPoint, celli, facei, seen);
    }
    return seen;
}


Foam::tetCells::view Foam::tetCells::look
(
    const vector& toPoint,
    const neighbourCell& cell
) const
{
    view seen;
    for (label i = cell.first; i < cell.first + 3*cell.nTriangles; i += 3)
    {
        seen.consider
        (
            corners_[i] - cell.centre,
            corners_[i + 1] - cell.centre,
            corners_[i + 2] - cell.centre,
            toPoint
        );
    }
    return seen;
}


void Foam::tetCells::around(const label celli, DynamicList<label>& cells) const
{
    const labelListList& pointCells = mesh_.pointCells();
    DynamicList<label> points(32);
    cells.clear();
    cells.append(celli);
    const auto add = [&](const labelUList& more)
    {
        for (const label i : more)
        {
            if (!cells.found(i))
            {
                cells.append(i);
            }
        }
    };

    for (const label facei : mesh_.cells()[celli])
    {
        for (const label pointi : mesh_.faces()[facei])
        {
            if (points.found(pointi))
            {
                continue;
            }
            points.append(pointi);
            add(pointCells[pointi]);
            const auto more = beyond_.cfind(pointi);
            if (more.found())
            {
                add(more.val());
            }
        }
    }
}


bool Foam::tetCells::lower(const vector& a, const vector& b)
{
    // Equal but for round-off is equal
    const scalar tolerance = 1e-6*(mag(a) + mag(b));
    for (direction k = 0; k < 3; ++k)
    {
        if (mag(a[k] - b[k]) > tolerance)
        {
            return a[k] < b[k];
        }
    }
    return false;
}


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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::tetCells::tetCells(const polyMesh& mesh)
:
    mesh_(mesh)
{
    // Built on demand by a call that all ranks must make together
    (void)mesh.tetBasePtIs();
    introduce(coincidentPoints(mesh, coincidentPoints::identity::place));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::point Foam::tetCells::drawnIn(const point& p, const label celli) const
{
    const point& centre = mesh_.cellCentres()[celli];
    const view seen(look(p - centre, celli));
    const bool outside = (seen.depth < 0 && seen.depth > -GREAT);
    return
        outside
      ? centre + seen.height/(seen.height - seen.depth)*(p - centre) : p;
}


Foam::label Foam::tetCells::holder
(
    const point& p,
    const label celli,
    const label face
) const
{
    const auto toPoint = [&](const point& centre)
    {
        return image_.nearest(p - centre);
    };
    const vectorField& centres = mesh_.cellCentres();

    // Mostly a point near a warped face: this cell holds it, or one behind the face through which it
    // is seen
    const label facei = mesh_.cells()[celli][face];
    view seen;
    lookAt(toPoint(centres[celli]), celli, facei, seen);
    if (seen.inside())
    {
        return celli;
    }
    label here = celli;
    for (label i = 0; i < maxFaces_ && here >= 0; ++i)
    {
        seen = look(toPoint(centres[here]), here);
        if (seen.inside())
        {
            return here;
        }
        here =
            seen.face >= 0 && mesh_.isInternalFace(seen.face)
          ? mesh_.faceOwner()[seen.face] + mesh_.faceNeighbour()[seen.face] - here
          : -1;
    }

    DynamicList<label> cells(64);
    around(celli, cells);
    List<view> views(cells.size());
    List<vector> to(cells.size());
    label deepest = 0;
    forAll(cells, i)
    {
        const bool isMine = (cells[i] >= 0);
        const label k = isMine ? cells[i] : -2 - cells[i];
        to[i] = toPoint(isMine ? centres[k] : neighbourCells_[k].centre);
        views[i] = isMine ? look(to[i], k) : look(to[i], neighbourCells_[k]);
        if (views[i].depth > views[deepest].depth)
        {
            deepest = i;
        }
    }

    const scalar tolerance = onFace_*views[deepest].height;
    if (views[deepest].depth < -tolerance)
    {
        return -1;
    }
    label lowest = deepest;
    forAll(cells, i)
    {
        if
        (
            views[i].depth >= views[deepest].depth - tolerance
         && lower(-to[i], -to[lowest])
        )
        {
            lowest = i;
        }
    }
    return cells[lowest];
}


// ************************************************************************* //
