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


void Foam::wallLawSampler::around::add(const around& other, const scalar factor)
{
    weight += factor*other.weight;
    F += factor*other.F;
    U += factor*other.U;
    for (label k = 0; k < 2; ++k)
    {
        shapes[k] += factor*other.shapes[k];
        values[k] += factor*other.values[k];
    }
}


Foam::List<Foam::wallLawSampler::around> Foam::wallLawSampler::aroundPoints() const
{
    List<around> sums(2*layer_.points().size());
    const auto add = [&]
    (
        const label number,
        const label celli,
        const scalar distance,
        const scalar friction,
        const scalar turbulent
    )
    {
        around a;
        a.weight = 1;
        a.F = length(distance, friction);
        a.U = vectorAt(values().inCell(celli) + U_);
        forAll(scalars_, s)
        {
            a.shapes[s] = shape(scalars_[s], distance*turbulent);
            a.values[s] = (*scalars_[s].field)[celli];
        }
        for (const wallLayer::share& s : layer_.freeShares(number))
        {
            sums[2*s.point + (number < layer_.nCells() ? 0 : 1)].add(a, s.weight);
        }
    };

    for (label number = 0; number < layer_.nCells(); ++number)
    {
        const scalar* row = rows_.data() + width_*number;
        add
        (
            number, layer_.cell(number).cell, row[DISTANCE], row[FRICTION],
            scalars_.size() ? row[TURBULENT_FRICTION] : 0
        );
    }
    forAll(layer_.outerDistances(), i)
    {
        const label number = layer_.nCells() + i;
        const label celli = layer_.outerCell(i);
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
            number, celli, distance, friction,
            scalars_.size() ? turbulentFriction(celli, distance, friction) : 0
        );
    }

    constexpr label width = sizeof(around)/sizeof(scalar);
    static_assert(width == 9, "summed as numbers");
    layer_.sum(reinterpret_cast<scalar*>(sums.data()), 2*width);

    // From sums to means
    for (around& a : sums)
    {
        const scalar weight = a.weight;
        if (weight > 0)
        {
            around mean;
            mean.add(a, 1/weight);
            mean.weight = weight;
            a = mean;
        }
    }
    return sums;
}


Foam::scalar Foam::wallLawSampler::between
(
    const scalar in,
    const scalar out,
    const scalar at,
    const scalar mean
)
{
    // Equal ones tell nothing, such as k in the log layer
    return
        mag(out - in) > 1e-6*mag(at)
      ? min(max((at - in)/(out - in), scalar(0)), scalar(1)) : mean;
}


void Foam::wallLawSampler::bend
(
    const around& in,
    const around& out,
    const vector& normal,
    const scalar* row,
    scalar* value
) const
{
    const scalar at = between(in.F, out.F, length(row[DISTANCE], row[FRICTION]), out.weight);
    const vector U(in.U + at*(out.U - in.U));
    const vector change(U - vectorAt(value + U_));
    setVector(U - normal*(normal & change), value + U_);

    forAll(scalars_, s)
    {
        const scalar there = shape(scalars_[s], row[DISTANCE]*row[TURBULENT_FRICTION]);
        const scalar place = between(in.shapes[s], out.shapes[s], there, out.weight);
        value[scalars_[s].lane] = in.values[s] + place*(out.values[s] - in.values[s]);
    }
}


void Foam::wallLawSampler::setPoints
(
    const UList<wallFunctions::faceState>& points,
    const UList<wallFunctions::faceState>& cells
)
{
    // Means of the cells: everything, and in the place of L the velocity of the wall. At points on the wall
    // g is what the cells have with the wall of that point, which may move or rub in another way than theirs
    std::fill_n(pointRow(0), width_*layer_.points().size(), 0);
    List<scalar> row(width_);
    forAll(cells, number)
    {
        const wallLayer::layerCell& cell = layer_.cell(number);
        std::copy_n(cellRow(number), width_, row.data());
        for (const wallLayer::share& s : layer_.sharesOfCell(number))
        {
            if (layer_.points()[s.point].onWall)
            {
                row[FRICTION] = points[s.point].frictionOverNu;
                divide
                (
                    vectorAt(values().inCell(cell.cell) + U_), points[s.point].velocity, cell.normal,
                    row.data()
                );
            }
            else
            {
                std::copy_n(cellRow(number), LINEAR, row.data());
                row[FRICTION] = cellRow(number)[FRICTION];
            }
            setVector(cells[number].velocity, &row[LINEAR]);
            scalar* sum = pointRow(s.point);
            for (label k = 0; k < width_; ++k)
            {
                sum[k] += s.weight*row[k];
            }
        }
    }
    layer_.sum(pointRow(0), width_);

    const List<around> cellsAround(aroundPoints());

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
        const around& in = cellsAround[2*i];
        const around& out = cellsAround[2*i + 1];
        if (in.weight > 0 && out.weight > 0)
        {
            bend(in, out, p.normal, row, value);
        }
        divide(vectorAt(value + U_), vectorAt(row + LINEAR), p.normal, row);
        forAll(scalars_, s)
        {
            row[SCALARS + s] =
                value[scalars_[s].lane]
               /shape(scalars_[s], row[DISTANCE]*row[TURBULENT_FRICTION]);
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
