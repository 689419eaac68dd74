/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    What lies behind the boundary of this rank's mesh: periodic sides and other ranks.

\*---------------------------------------------------------------------------*/

#include "cellLocator.H"
#include "cyclicPolyPatch.H"
#include "processorCyclicPolyPatch.H"
#include "swapLists.H"
#include "syncTools.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::cellLocator::isPeriod(const vector& apart) const
{
    for (direction k = 0; k < 3; ++k)
    {
        vector period(Zero);
        period[k] = sign(apart[k])*image_.period[k];
        if (image_.half[k] < VGREAT && mag(apart - period) < 1e-6*image_.period[k])
        {
            return true;
        }
    }
    return false;
}


void Foam::cellLocator::setBehind(const label facei, const label behind)
{
    const label celli = mesh_.faceOwner()[facei];
    const label face = mesh_.cells()[celli].find(facei);
    faceBlock& faces = blocks_[block(celli) - blocks_.data() + face/nLanes];
    faces.behind[face % nLanes] = behind;
}


void Foam::cellLocator::link(const cyclicPolyPatch& side)
{
    // Other periods than that of the DEM box are none for grains
    const cyclicPolyPatch& other = side.neighbPatch();
    forAll(side, i)
    {
        if (isPeriod(other.faceCentres()[i] - side.faceCentres()[i]))
        {
            setBehind(side.start() + i, other.faceCells()[i]);
        }
    }
}


void Foam::cellLocator::link
(
    const processorPolyPatch& side,
    const labelUList& cells
)
{
    const bool periodic = isA<processorCyclicPolyPatch>(side);
    forAll(side, i)
    {
        const label facei = side.start() + i;
        if
        (
            !periodic
         || isPeriod(side.neighbFaceCentres()[i] - side.faceCentres()[i])
        )
        {
            setBehind(facei, -2 - remote_.size());
            remote_.append
            (
                remoteCell
                {
                    side.neighbProcNo(), cells[facei - mesh_.nInternalFaces()]
                }
            );
        }
    }
}


void Foam::cellLocator::swapBlocks()
{
    // Each cell once for each rank that has a cell behind one of its faces
    List<DynamicList<label>> cells(Pstream::nProcs());
    List<DynamicList<faceBlock>> blocks(Pstream::nProcs());
    for (label celli = 0; celli < mesh_.nCells(); ++celli)
    {
        DynamicList<label> ranks;
        const faceBlock* faces = block(celli);
        for (label i = 0; i < faces->nFaces; ++i)
        {
            const label behind = faces[i/nLanes].behind[i % nLanes];
            if (isRemote(behind) && !ranks.found(remote(behind).rank))
            {
                ranks.append(remote(behind).rank);
            }
        }
        for (const label rank : ranks)
        {
            faceBlock copy(*faces);
            for (label& behind : copy.behind)
            {
                const bool theirs =
                    isRemote(behind) && remote(behind).rank == rank;
                behind = theirs ? remote(behind).cell : -1;
            }
            cells[rank].append(celli);
            blocks[rank].append(copy);
        }
    }

    const List<DynamicList<label>> cellsHere(swapLists(cells));
    const List<DynamicList<faceBlock>> blocksHere(swapLists(blocks));
    List<Map<label>> number(Pstream::nProcs());
    forAll(cellsHere, proci)
    {
        forAll(cellsHere[proci], i)
        {
            number[proci].insert(cellsHere[proci][i], i);
        }
    }
    remoteBlocks_.resize(nBehind_);
    for (label i = 0; i < nBehind_; ++i)
    {
        const remoteCell& cell = remote_[i];
        remoteBlocks_[i] = blocksHere[cell.rank][number[cell.rank][cell.cell]];
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::cellLocator::setPeriod(const point& low, const vector& period)
{
    low_ = low;
    high_ = low + period;
    image_ = periodicImage{period, period/2};
    imagesFromAnywhere_ = true;
    for (direction k = 0; k < 3; ++k)
    {
        if (period[k] <= 0)
        {
            low_[k] = -VGREAT;
            high_[k] = VGREAT;
        }

        // A mesh that is longer than the period has no place for images
        const bool longer = mesh_.bounds().span()[k] > (1 + 1e-6)*period[k];
        if (period[k] <= 0 || longer)
        {
            image_.half[k] = VGREAT;
        }
        if (period[k] > 0 && longer)
        {
            imagesFromAnywhere_ = false;
        }
    }

    tets_.setImages(image_);

    remote_.clear();
    labelList cells;
    syncTools::swapBoundaryCellList(mesh_, identity(mesh_.nCells()), cells);
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (isA<cyclicPolyPatch>(patch))
        {
            link(refCast<const cyclicPolyPatch>(patch));
        }
        else if (isA<processorPolyPatch>(patch))
        {
            link(refCast<const processorPolyPatch>(patch), cells);
        }
    }

    nBehind_ = remote_.size();
    swapBlocks();
    for (const tetCells::neighbourCell& cell : tets_.neighbourCells())
    {
        remote_.append(remoteCell{cell.rank, cell.cell});
    }
}


// ************************************************************************* //
