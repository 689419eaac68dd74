/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellLocator.H"
#include "SubField.H"
#include "indexedOctree.H"
#include "treeDataCell.H"

#include <limits>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellLocator::cellLocator(const polyMesh& mesh)
:
    mesh_(mesh),
    bounds_(mesh.bounds()),
    blocks_(),
    firstBlock_(),
    nFaces_(0),
    nBehind_(0),
    tets_(mesh),
    low_(Zero),
    high_(Zero),
    imagesFromAnywhere_(true),
    nSearches_(0)
{
    const cellList& cells = mesh.cells();
    const labelList& owner = mesh.faceOwner();
    const labelList& neighbour = mesh.faceNeighbour();
    const vectorField& faceCentre = mesh.faceCentres();
    const vectorField& area = mesh.faceAreas();

    label nBlocks = 0;
    labelList first(cells.size());
    // A point on the boundary may lie outside by its last digit
    bounds_.inflate(1e-6);

    forAll(cells, celli)
    {
        if (cells[celli].size() > std::numeric_limits<std::uint16_t>::max())
        {
            FatalErrorInFunction
                << "Cell " << celli << " at " << mesh.cellCentres()[celli] << " has "
                << cells[celli].size() << " faces; grains can be found in cells of up to "
                << std::numeric_limits<std::uint16_t>::max()
                << ". Split it (see checkMesh)" << exit(FatalError);
        }
        first[celli] = nBlocks;
        nBlocks += (cells[celli].size() + nLanes - 1)/nLanes;
    }
    blocks_.resize(nBlocks);
    if (nBlocks > cells.size())
    {
        firstBlock_ = first;
    }

    forAll(cells, celli)
    {
        const point& centre = mesh.cellCentres()[celli];
        const label n = cells[celli].size();
        const scalar margin = marginOf(celli);
        faceBlock* block = blocks_.data() + first[celli];

        for (label i = 0; i < (n + nLanes - 1)/nLanes*nLanes; ++i)
        {
            faceBlock& faces = block[i/nLanes];
            const label lane = i % nLanes;

            faces.centre = centre;
            faces.nFaces = n;
            faces.setMargin(margin);
            faces.firstFace = nFaces_;
            faces.set(lane, Zero, 1e30, -1);

            if (i < n)
            {
                const label facei = cells[celli][i];
                const bool owned = (owner[facei] == celli);
                const vector normal =
                    (owned ? 1 : -1)*area[facei]/(mag(area[facei]) + VSMALL);

                // Normal numbers also for a face through the centre
                const scalar h =
                    max(normal & (faceCentre[facei] - centre), scalar(1e-30));
                faces.set
                (
                    lane,
                    normal/h,
                    h,
                    !mesh.isInternalFace(facei) ? -1
                  : owned ? neighbour[facei] : owner[facei]
                );
            }
        }
        nFaces_ += n;
    }

    setPeriod(Zero, Zero);

    // Built on demand by calls that all ranks must make together
    (void)mesh.tetBasePtIs();
    (void)mesh.cellTree();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::cellLocator::marginOf(const label celli) const
{
    const point& centre = mesh_.cellCentres()[celli];
    const labelList points(mesh_.cells()[celli].labels(mesh_.faces()));
    scalar off = 0;
    scalar nearest = GREAT;
    scalar radius = 0;
    for (const label facei : mesh_.cells()[celli])
    {
        const vector& area = mesh_.faceAreas()[facei];
        const point& faceCentre = mesh_.faceCentres()[facei];
        const vector normal(area/(mag(area) + VSMALL));
        const bool owned = (mesh_.faceOwner()[facei] == celli);
        const scalar h = (owned ? 1 : -1)*(normal & (faceCentre - centre));
        if (h <= VSMALL)
        {
            return GREAT;
        }
        nearest = min(nearest, h);
        for (const label pointi : mesh_.faces()[facei])
        {
            const point& p = mesh_.points()[pointi];
            off = max(off, mag(normal & (p - faceCentre))/h);
            radius = max(radius, mag(p - centre));
        }

        // Where a cell is not convex it has points beyond planes
        const vector outward((owned ? 1/h : -1/h)*normal);
        for (const label pointi : points)
        {
            off = max(off, outward & (mesh_.points()[pointi] - faceCentre));
        }
    }

    // Three products and their sum in single precision are good to 3e-7 of the terms
    return 4e-6 + off + 4e-7*radius/nearest;
}


Foam::label Foam::cellLocator::aroundBoundary
(
    const point& p,
    const label celli
) const
{
    const faceBlock* faces = block(celli);
    const vector d(fromCentre(p, *faces));

    label across = -1;
    float farthest = 0;
    for (label first = 0, n = faces->nFaces; first < n; first += nLanes, ++faces)
    {
        const lanes r(faces->relative(d));
        const lanes distance(faces->distance(r));
        for (label i = 0; i < nLanes; ++i)
        {
            if
            (
                r[i] < -tolerance_
             && distance[i] < farthest
             && faces->behind[i] != -1
            )
            {
                farthest = distance[i];
                across = faces->behind[i];
            }
        }
    }
    return across;
}


Foam::cellLocator::place Foam::cellLocator::settle
(
    const point& p,
    const label celli,
    const view seen,
    label& next
) const
{
    const label holder = tets_.holder(p, celli, seen.face);
    if (holder >= 0)
    {
        return placeIn(holder, holder == celli ? seen : look(p, holder));
    }
    next = -1;
    if (holder < -1)
    {
        next = holder - nBehind_;
    }
    else if (seen.least < 0)
    {
        // Planes may point the wrong way where the cell is not convex
        const label face = tets_.faceTowards(p, celli);
        next = face < 0 ? seen.behind : block(celli)[face/nLanes].behind[face % nLanes];
        next = next != -1 ? next : aroundBoundary(p, celli);
    }
    return place{-1, 0, -1};
}


Foam::cellLocator::place Foam::cellLocator::find
(
    const point& p,
    const label hint,
    label& end
) const
{
    const place near = walk(p, hint < mesh_.nCells() ? hint : -1, end);
    if (near.cell >= 0)
    {
        return near;
    }

    end = -1;
    const point inside(wrap(p));
    if (!mesh_.nCells() || !bounds_.contains(inside))
    {
        return {-1, 0, -1};
    }

    ++nSearches_;
    const label celli = mesh_.findCell(inside);
    if (celli >= 0)
    {
        // One of those whose tetrahedra hold it, or touch it
        const place exact = settle(inside, celli, look(inside, celli), end);
        return
            exact.cell < 0 && !isRemote(end) ? place{celli, 0, -1} : exact;
    }

    // A point on the boundary may lie outside by its last digit; a walk would have found it
    label away;
    return
        hint >= 0 ? place{-1, 0, -1}
      : walk(inside, mesh_.cellTree().findNearest(inside, GREAT).index(), away);
}


Foam::cellLocator::place Foam::cellLocator::findOrFollow
(
    const point& p,
    const label hint,
    label& end
) const
{
    const place near = walk(p, hint < mesh_.nCells() ? hint : -1, end);
    return near.cell >= 0 || isRemote(end) ? near : find(p, -1, end);
}


// ************************************************************************* //
