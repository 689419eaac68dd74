/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tetCells.H"
#include "tetBases.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::tetCells::view::consider
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
        return false;
    }

    const scalar wa = (toPoint & bc)/volume;
    const scalar wb = (toPoint & (c ^ a))/volume;
    const scalar wc = (toPoint & (a ^ b))/volume;
    const scalar sum = mag(wa) + mag(wb) + mag(wc);
    if (min(wa, min(wb, wc)) < -1e-9*sum)
    {
        return false;
    }

    // Seen from the centre through the triangle; triangles side by side show the same on their
    // common edge
    const scalar h = volume/(mag((b - a) ^ (c - a)) + VSMALL);
    const scalar d = (1 - wa - wb - wc)*h;
    if (d <= depth)
    {
        return false;
    }
    depth = d;
    height = h;
    weights[0] = wa;
    weights[1] = wb;
    weights[2] = wc;
    return true;
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
    triangles
    (
        celli,
        facei,
        [&](const label a, const label b, const label c)
        {
            const bool isNew = seen.consider
            (
                points[a] - centre, points[b] - centre, points[c] - centre, toPoint
            );
            if (isNew)
            {
                seen.face = facei;
                seen.points[0] = a;
                seen.points[1] = b;
                seen.points[2] = c;
            }
        }
    );
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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::tetCells::tetCells(const polyMesh& mesh)
:
    mesh_(mesh),
    bases_(tetBases(mesh))
{
    introduce(coincidentPoints(mesh, coincidentPoints::identity::place));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::tetCells::weigh
(
    const point& p,
    const label celli,
    scalar (&weights)[4],
    label (&points)[3]
) const
{
    const view seen(look(p - mesh_.cellCentres()[celli], celli));
    if (seen.face < 0)
    {
        return false;
    }
    const scalar within =
        seen.depth < 0 ? seen.height/(seen.height - seen.depth) : 1;
    weights[0] = 1;
    for (direction k = 0; k < 3; ++k)
    {
        weights[k + 1] = within*seen.weights[k];
        weights[0] -= weights[k + 1];
        points[k] = seen.points[k];
    }
    return true;
}


Foam::label Foam::tetCells::faceTowards(const point& p, const label celli) const
{
    const view seen(look(image_.nearest(p - mesh_.cellCentres()[celli]), celli));
    return seen.face < 0 ? -1 : mesh_.cells()[celli].find(seen.face);
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
    label touched = celli;
    label here = celli;
    label before = -1;
    for (label i = 0; i < maxFaces_ && here >= 0; ++i)
    {
        seen = look(toPoint(centres[here]), here);
        if (seen.inside())
        {
            return here;
        }
        if (seen.onFace())
        {
            touched = here;
            break;
        }
        const label next =
            seen.face >= 0 && mesh_.isInternalFace(seen.face)
          ? mesh_.faceOwner()[seen.face] + mesh_.faceNeighbour()[seen.face] - here
          : -1;
        if (next == before)
        {
            break;
        }
        before = here;
        here = next;
    }

    DynamicList<label> cells(64);
    around(touched, cells);
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
