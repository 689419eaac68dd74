/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallLawSampler.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::wallLawSampler::divide
(
    const vector& U,
    const vector& wall,
    const vector& normal,
    scalar* row
) const
{
    const vector linear(wall + normal*(normal & (U - wall)));
    const scalar F = length(row[DISTANCE], row[FRICTION]);
    setVector(linear, row + LINEAR);
    setVector((U - linear)/F, row + OVER_LAW);
}


Foam::List<Foam::wallFunctions::faceState> Foam::wallLawSampler::atPoints
(
    const UList<wallFunctions::faceState>& faces
) const
{
    typedef wallFunctions::faceState faceState;
    static_assert(sizeof(faceState) == 4*sizeof(scalar), "summed as four numbers");

    List<faceState> points(layer_.points().size(), faceState{0, Zero});
    forAll(faces, f)
    {
        for (const wallLayer::share& s : layer_.sharesOfFace(f))
        {
            points[s.point].frictionOverNu += s.weight*faces[f].frictionOverNu;
            points[s.point].velocity += s.weight*faces[f].velocity;
        }
    }
    layer_.sum(reinterpret_cast<scalar*>(points.data()), 4);
    return points;
}


Foam::List<Foam::wallFunctions::faceState> Foam::wallLawSampler::atCells
(
    const UList<wallFunctions::faceState>& faces,
    const UList<wallFunctions::faceState>& points
) const
{
    List<wallFunctions::faceState> cells(layer_.nCells());
    forAll(cells, number)
    {
        wallFunctions::faceState& state = cells[number];
        state = {-1, Zero};
        for (const label f : layer_.nearestFaces(number))
        {
            if (faces[f].frictionOverNu > state.frictionOverNu)
            {
                state = faces[f];
            }
        }
        if (state.frictionOverNu < 0)
        {
            label n = 0;
            state = {0, Zero};
            for (const wallLayer::share& s : layer_.sharesOfCell(number))
            {
                if (layer_.points()[s.point].onWall)
                {
                    state.frictionOverNu += points[s.point].frictionOverNu;
                    state.velocity += points[s.point].velocity;
                    ++n;
                }
            }
            state.frictionOverNu /= n;
            state.velocity /= n;
        }
    }
    return cells;
}


void Foam::wallLawSampler::setCells(const UList<wallFunctions::faceState>& cells)
{
    forAll(cells, number)
    {
        const wallLayer::layerCell& cell = layer_.cell(number);
        scalar* row = cellRow(number);
        row[DISTANCE] = cell.distance;
        row[FRICTION] = cells[number].frictionOverNu;
        divide
        (
            vectorAt(values().inCell(cell.cell) + U_), cells[number].velocity, cell.normal, row
        );
        if (scalars_.size())
        {
            row[TURBULENT_FRICTION] =
                turbulentFriction(cell.cell, cell.distance, row[FRICTION]);
            forAll(scalars_, s)
            {
                row[SCALARS + s] =
                    (*scalars_[s].field)[cell.cell]
                   /shape(scalars_[s], cell.distance*row[TURBULENT_FRICTION]);
            }
        }
        if (ownWall_[number] >= 0)
        {
            scalar* own = rows_.data() + width_*ownWall_[number];
            std::copy_n(row, width_, own);
            own[DISTANCE] = 0;
            setVector(cells[number].velocity, own + LINEAR);
        }
    }
}


Foam::scalar Foam::wallLawSampler::turbulentFriction
(
    const label celli,
    const scalar distance,
    const scalar friction
) const
{
    const scalar ofK =
        k_
      ? std::pow(walls_.Cmu(), 0.25)*std::sqrt(max((*k_)[celli], scalar(0)))/nu_()[celli]
      : friction;
    return max(ofK, turbulence_.edgeOfK()/distance);
}


Foam::List<Foam::scalar> Foam::wallLawSampler::meanShapes() const
{
    const label width = 1 + scalars_.size();
    List<scalar> mean(width*layer_.points().size(), Zero);
    const auto add = [&]
    (
        const label number,
        const scalar distance,
        const scalar friction,
        const scalar turbulent
    )
    {
        const scalar F = length(distance, friction);
        for (const wallLayer::share& s : layer_.freeShares(number))
        {
            scalar* sum = &mean[width*s.point];
            sum[0] += s.weight*F;
            forAll(scalars_, k)
            {
                sum[1 + k] += s.weight*shape(scalars_[k], distance*turbulent);
            }
        }
    };

    for (label number = 0; number < layer_.nCells(); ++number)
    {
        const scalar* row = rows_.data() + width_*number;
        add
        (
            number, row[DISTANCE], row[FRICTION],
            scalars_.size() ? row[TURBULENT_FRICTION] : 0
        );
    }
    forAll(layer_.outerDistances(), i)
    {
        const label number = layer_.nCells() + i;
        const SubList<wallLayer::share> shares(layer_.freeShares(number));
        if (shares.empty())
        {
            continue;
        }
        scalar friction = 0;
        for (const wallLayer::share& s : shares)
        {
            friction += rows_[width_*(layer_.nCells() + s.point) + FRICTION]/shares.size();
        }
        const scalar distance = layer_.outerDistances()[i];
        add
        (
            number, distance, friction,
            scalars_.size() ? turbulentFriction(layer_.outerCell(i), distance, friction) : 0
        );
    }
    layer_.sum(mean.data(), width);
    return mean;
}


void Foam::wallLawSampler::setPoints
(
    const UList<wallFunctions::faceState>& points,
    const UList<wallFunctions::faceState>& cells
)
{
    // Means of the cells: everything, and in the place of L the velocity of the wall
    std::fill_n(pointRow(0), width_*layer_.points().size(), 0);
    List<scalar> row(width_);
    forAll(cells, number)
    {
        std::copy_n(cellRow(number), width_, row.data());
        setVector(cells[number].velocity, &row[LINEAR]);
        for (const wallLayer::share& s : layer_.sharesOfCell(number))
        {
            scalar* sum = pointRow(s.point);
            for (label k = 0; k < width_; ++k)
            {
                sum[k] += s.weight*row[k];
            }
        }
    }
    layer_.sum(pointRow(0), width_);

    const List<scalar> mean(meanShapes());

    // On the wall that is g, and the scalars over their shapes. Beyond, cellPoint has the values
    forAll(points, i)
    {
        const wallLayer::layerPoint& p = layer_.points()[i];
        scalar* row = pointRow(i);
        row[DISTANCE] = p.distance;
        if (p.onWall)
        {
            row[FRICTION] = points[i].frictionOverNu;
            setVector(points[i].velocity, row + LINEAR);
            continue;
        }

        scalar* value = values().atPoint(p.point);
        const scalar* shapes = &mean[(1 + scalars_.size())*i];
        const scalar F = length(row[DISTANCE], row[FRICTION]);
        divide(vectorAt(value + U_), vectorAt(row + LINEAR), p.normal, row);
        if (p.free)
        {
            setVector(F/shapes[0]*vectorAt(row + OVER_LAW), row + OVER_LAW);
            setVector
            (
                vectorAt(row + LINEAR) + F*vectorAt(row + OVER_LAW), value + U_
            );
        }
        forAll(scalars_, s)
        {
            const scalar there = shape(scalars_[s], row[DISTANCE]*row[TURBULENT_FRICTION]);
            scalar& known = value[scalars_[s].lane];
            row[SCALARS + s] = known/(p.free ? shapes[1 + s] : there);
            known = row[SCALARS + s]*there;
        }
    }
    forAll(constrained_, i)
    {
        scalar* g = pointRow(constrained_[i]) + OVER_LAW;
        const vector n(constraints_[i]);
        setVector(vectorAt(g) - n*(n & vectorAt(g)), g);
    }
}


// ************************************************************************* //
