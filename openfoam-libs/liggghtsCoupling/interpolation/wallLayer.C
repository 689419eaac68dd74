/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallLayer.H"
#include "coupledPolyPatch.H"
#include "wallDistance.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::wallLayer::number(const labelUList& faces)
{
    // A point is on the wall, and belongs to the layer, on all ranks or on none
    const coupledPoints all(mesh_);
    scalarField onWall(mesh_.nPoints(), Zero);
    for (const label facei : faces)
    {
        for (const label pointi : mesh_.faces()[facei])
        {
            onWall[pointi] = 1;
        }
    }
    all.sum(onWall.data(), 1);

    scalarField inLayer(mesh_.nPoints(), Zero);
    forAll(mesh_.cells(), celli)
    {
        const labelList& points = mesh_.cellPoints()[celli];
        bool near = false;
        for (const label pointi : points)
        {
            near = near || onWall[pointi] > 0;
        }
        if (near)
        {
            cellNumber_[celli] = cells_.size();
            cells_.append(layerCell{celli, 0, 0, 0, 0, Zero});
            for (const label pointi : points)
            {
                inLayer[pointi] = 1;
            }
        }
    }
    cells_.append(layerCell{-1, 0, 0, 0, 0, Zero});
    all.sum(inLayer.data(), 1);

    forAll(inLayer, pointi)
    {
        if (inLayer[pointi] > 0)
        {
            pointNumber_[pointi] = points_.size();
            points_.append(layerPoint{pointi, onWall[pointi] > 0, false, false, 0, Zero});
        }
    }
    coupled_.reset
    (
        new coupledPoints(mesh_, coincidentPoints::identity::number, pointNumber_)
    );
}


void Foam::wallLayer::findOuter()
{
    scalarField fixed(points_.size(), Zero);
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        const bool fixes = !isA<coupledPolyPatch>(patch) && !polyPatch::constraintType(patch.type());
        for (const label pointi : patch.meshPoints())
        {
            if (fixes && pointNumber_[pointi] >= 0)
            {
                fixed[pointNumber_[pointi]] = 1;
            }
        }
    }
    coupled_->sum(fixed.data(), 1);
    forAll(points_, i)
    {
        points_[i].free = (fixed[i] == 0);
    }

    forAll(mesh_.cells(), celli)
    {
        bool touches = false;
        for (const label pointi : mesh_.cellPoints()[celli])
        {
            touches = touches || pointNumber_[pointi] >= 0;
        }
        if (touches && cellNumber_[celli] < 0)
        {
            outerCells_.append(celli);
        }
    }
}


void Foam::wallLayer::normalise(DynamicList<share>& shares) const
{
    scalarField sum(points_.size(), Zero);
    for (const share& s : shares)
    {
        sum[s.point] += s.weight;
    }
    coupled_->sum(sum.data(), 1);
    for (share& s : shares)
    {
        s.weight /= sum[s.point];
    }
}


void Foam::wallLayer::weigh(const labelUList& faces)
{
    const auto shareOf = [&](const label pointi, const point& centre)
    {
        return share{pointNumber_[pointi], 1/mag(mesh_.points()[pointi] - centre)};
    };

    for (label number = 0; number < nCells(); ++number)
    {
        const label celli = cells_[number].cell;
        cells_[number].firstPoint = cellShares_.size();
        for (const label pointi : mesh_.cellPoints()[celli])
        {
            cellShares_.append(shareOf(pointi, mesh_.cellCentres()[celli]));
        }
    }
    cells_.last().firstPoint = cellShares_.size();
    normalise(cellShares_);

    for (const label facei : faces)
    {
        firstFaceShare_.append(faceShares_.size());
        for (const label pointi : mesh_.faces()[facei])
        {
            faceShares_.append(shareOf(pointi, mesh_.faceCentres()[facei]));
        }
    }
    firstFaceShare_.append(faceShares_.size());
    normalise(faceShares_);

    for (label number = 0; number < nCells() + outerCells_.size(); ++number)
    {
        const label celli =
            number < nCells() ? cells_[number].cell : outerCells_[number - nCells()];
        firstFreeShare_.append(freeShares_.size());
        for (const label pointi : mesh_.cellPoints()[celli])
        {
            const label p = pointNumber_[pointi];
            if (p >= 0 && points_[p].free)
            {
                freeShares_.append(shareOf(pointi, mesh_.cellCentres()[celli]));
            }
        }
    }
    firstFreeShare_.append(freeShares_.size());
    normalise(freeShares_);
}


void Foam::wallLayer::measure(const labelUList& faces)
{
    // The wall is not farther away than one of the cell's points on it, or, from an outer cell, across
    // both of two cells
    boundBox within;
    scalar reach = 0;
    const auto include = [&](const label celli)
    {
        const boundBox bounds(mesh_.points(), mesh_.cellPoints()[celli], false);
        within.add(bounds);
        reach = max(reach, 2*bounds.mag());
    };
    for (label number = 0; number < nCells(); ++number)
    {
        include(cells_[number].cell);
    }
    for (const label celli : outerCells_)
    {
        include(celli);
    }
    reduce(reach, maxOp<scalar>());

    const wallDistance distance(mesh_, faces, within, reach);
    for (label number = 0; number < nCells(); ++number)
    {
        cells_[number].distance = distance.of(mesh_.cellCentres()[cells_[number].cell]);
    }

    outerDistances_.setSize(outerCells_.size());
    forAll(outerCells_, i)
    {
        outerDistances_[i] = distance.of(mesh_.cellCentres()[outerCells_[i]]);
    }

    // A point that lies beside the layer of this rank has a cell in it on another one
    scalarField shortest(points_.size(), Zero);
    scalarField count(points_.size(), Zero);
    for (const share& s : cellShares_)
    {
        count[s.point] = 1;
    }
    forAll(points_, i)
    {
        if (count[i] > 0 && !points_[i].onWall)
        {
            shortest[i] = distance.of(mesh_.points()[points_[i].point]);
        }
    }
    coupled_->sum(shortest.data(), 1);
    coupled_->sum(count.data(), 1);
    forAll(points_, i)
    {
        points_[i].distance = shortest[i]/count[i];
    }
}


void Foam::wallLayer::findNearest(const labelUList& faces)
{
    // Numbers of the faces of each cell
    List<DynamicList<label>> own(nCells());
    forAll(faces, i)
    {
        own[cellNumber_[mesh_.faceOwner()[faces[i]]]].append(i);
    }

    for (label number = 0; number < nCells(); ++number)
    {
        layerCell& c = cells_[number];
        const point& centre = mesh_.cellCentres()[c.cell];
        const auto distance = [&](const label i)
        {
            return mesh_.faces()[faces[i]].nearestPoint(centre, mesh_.points()).distance();
        };

        c.firstPlane = planes_.size();
        c.firstFace = nearestFaces_.size();
        scalar least = VGREAT;
        for (const label i : own[number])
        {
            least = min(least, distance(i));
        }
        for (const label i : own[number])
        {
            if (distance(i) <= (1 + 1e-6)*least)
            {
                nearestFaces_.append(i);
            }
            if (own[number].size() > 1)
            {
                const vector area(mesh_.faceAreas()[faces[i]]);
                planes_.append(plane{mesh_.faceCentres()[faces[i]], -area/mag(area)});
            }
        }
    }
    cells_.last().firstPlane = planes_.size();
    cells_.last().firstFace = nearestFaces_.size();
}


void Foam::wallLayer::orient(const labelUList& faces)
{
    const label width = 4;
    const auto unit = [](const vector& v)
    {
        const scalar size = mag(v);
        return size > SMALL ? v/size : vector(Zero);
    };
    const auto into = [&](const label i)
    {
        return -unit(mesh_.faceAreas()[faces[i]]);
    };

    // At points on the wall: the sum of the normals, and of their number
    List<scalar> sums(width*points_.size(), Zero);
    forAll(faces, i)
    {
        const vector n(into(i));
        for (const share& s : sharesOfFace(i))
        {
            scalar* sum = &sums[width*s.point];
            for (direction k = 0; k < 3; ++k)
            {
                sum[k] += n[k];
            }
            sum[3] += 1;
        }
    }
    coupled_->sum(sums.data(), width);

    // On both sides of a wall without thickness normals cancel: 0 of their number, or 1/2 where it
    // meets another wall. In a corner of three walls it is 0.58
    forAll(points_, i)
    {
        const scalar* sum = &sums[width*i];
        const vector n(sum[0], sum[1], sum[2]);
        points_[i].normal = unit(n);
        points_[i].twoSided = points_[i].onWall && mag(n) < 0.54*sum[3];
    }

    // In cells: of the nearest faces, else of the points on the wall
    for (label number = 0; number < nCells(); ++number)
    {
        vector n(Zero);
        for (const label i : nearestFaces(number))
        {
            n += into(i);
        }
        if (nearestFaces(number).empty())
        {
            for (const share& s : sharesOfCell(number))
            {
                n += points_[s.point].normal;
            }
        }
        cells_[number].normal = unit(n);
    }

    // At the other points: of the cells around
    sums = 0;
    for (label number = 0; number < nCells(); ++number)
    {
        for (const share& s : sharesOfCell(number))
        {
            for (direction k = 0; k < 3; ++k)
            {
                sums[width*s.point + k] += s.weight*cells_[number].normal[k];
            }
        }
    }
    coupled_->sum(sums.data(), width);
    forAll(points_, i)
    {
        if (!points_[i].onWall)
        {
            const scalar* sum = &sums[width*i];
            points_[i].normal = unit(vector(sum[0], sum[1], sum[2]));
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::wallLayer::wallLayer(const polyMesh& mesh, const labelUList& faces)
:
    mesh_(mesh),
    cellNumber_(mesh.nCells(), -1),
    pointNumber_(mesh.nPoints(), -1)
{
    number(faces);
    findOuter();
    weigh(faces);
    measure(faces);
    findNearest(faces);
    orient(faces);
}


// ************************************************************************* //
