/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ownerRoute.H"
#include "releases.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::List<Foam::boundBox> Foam::ownerRoute::meshBoxes(const polyMesh& mesh)
{
    List<boundBox> boxes(Pstream::nProcs());

    boundBox& mine = boxes[Pstream::myProcNo()];
    mine = boundBox(mesh.points(), false);
    if (mesh.nCells())
    {
        mine.inflate(1e-6);
    }

    Pstream::gatherList(boxes);
    releases::fromMaster(boxes);

    return boxes;
}


Foam::label Foam::ownerRoute::nextCandidate
(
    const point& p,
    const label last
) const
{
    const label n = boxes_.size();
    const label me = Pstream::myProcNo();
    const label start = (last < 0 ? 0 : (last - me + n)%n);

    // A rank never asks itself: what it owns it has found before
    for (label k = start + 1; k < n; ++k)
    {
        const label proci = (me + k)%n;
        if (boxes_[proci].contains(p))
        {
            return proci;
        }
    }
    return -1;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::ownerRoute::ownerRoute(const polyMesh& mesh)
:
    boxes_(meshBoxes(mesh)),
    sent_(Pstream::nProcs()),
    received_(Pstream::nProcs()),
    bytes_(0)
{}


// ************************************************************************* //
