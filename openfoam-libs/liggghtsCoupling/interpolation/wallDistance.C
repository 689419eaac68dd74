/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallDistance.H"
#include "releases.H"
#include "swapLists.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::wallDistance::wallDistance
(
    const polyMesh& mesh,
    const labelUList& faces,
    const boundBox& within,
    const scalar reach
)
:
    reach_(reach)
{
    const label me = Pstream::myProcNo();
    List<boundBox> boxes(Pstream::nProcs());
    boxes[me] = within;
    if (within.valid())
    {
        boxes[me].min() -= vector::uniform(reach);
        boxes[me].max() += vector::uniform(reach);
    }
    Pstream::gatherList(boxes);
    releases::fromMaster(boxes);

    List<DynamicList<label>> sizes(Pstream::nProcs());
    List<DynamicList<point>> corners(Pstream::nProcs());
    for (const label facei : faces)
    {
        const face& f = mesh.faces()[facei];
        const boundBox bounds(mesh.points(), f, false);
        forAll(boxes, proci)
        {
            if (boxes[proci].valid() && boxes[proci].overlaps(bounds))
            {
                sizes[proci].append(f.size());
                for (const label pointi : f)
                {
                    corners[proci].append(mesh.points()[pointi]);
                }
            }
        }
    }

    DynamicList<point> points;
    for (const DynamicList<point>& list : swapLists(corners))
    {
        points.append(list);
    }
    points_.transfer(points);
    DynamicList<face> found;
    label first = 0;
    for (const DynamicList<label>& list : swapLists(sizes))
    {
        for (const label size : list)
        {
            found.append(face(identity(size, first)));
            first += size;
        }
    }
    faces_.transfer(found);

    if (faces_.size())
    {
        typedef treeDataPrimitivePatch<primitivePatch> treeData;

        patch_.reset(new primitivePatch(SubList<face>(faces_, faces_.size()), points_));
        treeBoundBox bounds(points_);
        bounds.inflate(1e-3);
        bounds.min() -= vector::uniform(1e-3*reach);
        bounds.max() += vector::uniform(1e-3*reach);
        tree_.reset
        (
            new indexedOctree<treeData>
            (
                treeData(false, *patch_, indexedOctree<treeData>::perturbTol()),
                bounds,
                8,      // levels
                10,     // faces per leaf
                3       // duplicity
            )
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::wallDistance::of(const point& p) const
{
    if (!tree_)
    {
        return reach_;
    }
    const pointIndexHit nearest = tree_->findNearest(p, sqr(reach_));
    return nearest.hit() ? mag(p - nearest.hitPoint()) : reach_;
}


// ************************************************************************* //
