/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellLocator.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellLocator::cellLocator(const polyMesh& mesh)
:
    mesh_(mesh),
    start_(mesh.nCells() + 1),
    planes_(),
    tolerance_(1e-9*mesh.bounds().mag()),
    low_(Zero),
    period_(Zero)
{
    const cellList& cells = mesh.cells();
    const labelList& owner = mesh.faceOwner();
    const labelList& neighbour = mesh.faceNeighbour();
    const vectorField& centre = mesh.faceCentres();
    const vectorField& area = mesh.faceAreas();
    const vectorField& cellCentre = mesh.cellCentres();

    label n = 0;
    forAll(cells, celli)
    {
        start_[celli] = n;
        n += cells[celli].size();
    }
    start_.last() = n;
    planes_.setSize(n);

    n = 0;
    forAll(cells, celli)
    {
        for (const label facei : cells[celli])
        {
            const bool owned = (owner[facei] == celli);

            facePlane& plane = planes_[n++];
            plane.n = (owned ? 1 : -1)*area[facei]/(mag(area[facei]) + VSMALL);
            plane.d = plane.n & centre[facei];
            plane.inverseHeight =
                1/max(plane.d - (plane.n & cellCentre[celli]), VSMALL);
            plane.face = facei;
            plane.next =
                !mesh.isInternalFace(facei) ? -1
              : owned ? neighbour[facei] : owner[facei];
        }
    }

    // Built on demand by calls that all ranks must make together
    (void)mesh.tetBasePtIs();
    (void)mesh.cellTree();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::cellLocator::setPeriod(const point& low, const vector& period)
{
    low_ = low;
    period_ = period;
}


Foam::cellLocator::place Foam::cellLocator::find
(
    const point& p,
    const label hint
) const
{
    if (hint >= 0 && hint < mesh_.nCells())
    {
        const place near = walk(p, hint);
        if (near.cell >= 0)
        {
            return near;
        }
    }

    if (!mesh_.nCells() || !mesh_.bounds().contains(p))
    {
        return {-1, 0, -1};
    }

    const label celli = mesh_.findCell(p);
    if (celli < 0)
    {
        return {-1, 0, -1};
    }

    // On warped faces tetrahedra and planes differ a little: the tetrahedra decide
    const place exact = walk(p, celli);
    return exact.cell == celli ? exact : place{celli, 0, -1};
}


// ************************************************************************* //
