/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellLocator.H"
#include <new>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellLocator::cellLocator(const polyMesh& mesh)
:
    mesh_(mesh),
    start_(mesh.nCells() + 1),
    next_(),
    blocks_(),
    low_(Zero),
    period_(Zero)
{
    static_assert
    (
        sizeof(point) <= centreSize_*sizeof(facePlane),
        "no room for the centre"
    );

    const cellList& cells = mesh.cells();
    const labelList& owner = mesh.faceOwner();
    const labelList& neighbour = mesh.faceNeighbour();
    const vectorField& faceCentre = mesh.faceCentres();
    const vectorField& area = mesh.faceAreas();
    const vectorField& cellCentre = mesh.cellCentres();

    label n = 0;
    forAll(cells, celli)
    {
        start_[celli] = n;
        n += cells[celli].size();
    }
    start_.last() = n;
    next_.setSize(n);

    blocks_.resize(n + centreSize_*cells.size());

    forAll(cells, celli)
    {
        const point& centre = cellCentre[celli];
        facePlane* plane = blocks_.data() + start_[celli] + centreSize_*(celli + 1);
        new (plane - centreSize_) point(centre);

        label i = start_[celli];
        for (const label facei : cells[celli])
        {
            const bool owned = (owner[facei] == celli);
            const vector normal =
                (owned ? 1 : -1)*area[facei]/(mag(area[facei]) + VSMALL);
            const scalar h = max(normal & (faceCentre[facei] - centre), VSMALL);

            // Normal numbers also for a face through the centre
            plane->h = max(h, scalar(1e-30));
            for (direction k = 0; k < 3; ++k)
            {
                plane->a[k] = normal[k]/plane->h;
            }
            ++plane;

            next_[i++] =
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
