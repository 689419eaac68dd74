/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "probedMesh.H"
#include "meshFigures.H"
#include "dividedVoidFraction.H"
#include "IFstream.H"
#include "OFstream.H"
#include "cellPointWeight.H"
#include "volPointInterpolation.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

// Of another sign a few cells on in any direction
scalar wave(const point& p, const scalar phase)
{
    return Foam::sin(1700*p.x() + 2300*p.y() + 1900*p.z() + phase);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::probedMesh::uniform()
{
    return scalar(random_() >> 11)/scalar(std::uint64_t(1) << 53);
}


Foam::point Foam::probedMesh::somewhere()
{
    vector share;
    for (direction k = 0; k < 3; ++k)
    {
        share[k] = uniform();
    }
    return bounds_.min() + cmptMultiply(share, bounds_.span());
}


bool Foam::probedMesh::holds(const label celli, const point& p) const
{
    return
        mesh_.pointInCell(p, celli)
     || meshFigures::depthIn(mesh_, p, celli).largest > -1e-6;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::probedMesh::probedMesh(const fvMesh& mesh, const vector& period)
:
    mesh_(mesh),
    locator_(mesh),
    bounds_(mesh.bounds()),
    random_(1),
    p_
    (
        IOobject("p", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimless, Zero),
        zeroGradientFvPatchScalarField::typeName
    ),
    U_
    (
        IOobject("U", mesh.time().timeName(), mesh),
        mesh,
        dimensionedVector(dimless, Zero),
        zeroGradientFvPatchVectorField::typeName
    )
{
    locator_.setPeriod(bounds_.min(), period);
    forAll(mesh.C(), celli)
    {
        const point& centre = mesh.C()[celli];
        p_[celli] = wave(centre, 0);
        U_[celli] = vector(wave(centre, 1), wave(centre, 2), wave(centre, 3));
    }
    p_.correctBoundaryConditions();
    U_.correctBoundaryConditions();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::probedMesh::points(const label n, const fileName& file)
{
    pointField points(n);
    List<cellLocator::place> places(n);
    label end;
    forAll(points, i)
    {
        points[i] = somewhere();
        places[i] = locator_.find(points[i], -1, end);
    }
    const List<FixedList<scalar, 4>> values(sample(points, places));

    // Cell centre and values of each point that this rank has
    scalarField found(8*n, Zero);
    forAll(points, i)
    {
        if (places[i].cell >= 0)
        {
            scalar* row = &found[8*i];
            row[0] = 1;
            std::copy_n(mesh_.cellCentres()[places[i].cell].cdata(), 3, row + 1);
            std::copy_n(values[i].cdata(), 4, row + 4);
        }
    }

    if (Pstream::parRun())
    {
        Pstream::listCombineGather(found, plusEqOp<scalar>());
        label several = 0, lost = 0, otherCell = 0, otherValue = 0;
        scalar worst = 0;
        if (Pstream::master())
        {
            IFstream is(file, IOstream::BINARY);
            const scalarField serial(is);
            const scalar width = 1e-6*cbrt(bounds_.volume()/n);
            for (label i = 0; i < 8*n; i += 8)
            {
                several += (found[i] > 1);
                lost += (found[i] != 1 && serial[i] == 1) || (found[i] == 1 && serial[i] == 0);
                if (found[i] == 1 && serial[i] == 1)
                {
                    scalar apart = 0, error = 0;
                    for (label k = 1; k < 4; ++k)
                    {
                        apart = max(apart, mag(found[i + k] - serial[i + k]));
                    }
                    for (label k = 4; k < 8; ++k)
                    {
                        error = max(error, mag(found[i + k] - serial[i + k]));
                    }
                    otherCell += (apart > width);
                    otherValue += (error > 1e-11);
                    worst = max(worst, error);
                }
            }
        }
        Info<< "result pointsOfSeveralRanks " << several << nl
            << "result pointsLost " << lost << nl
            << "result pointsInOtherCell " << otherCell << nl
            << "result otherValues " << otherValue << nl
            << "result worstValue " << worst << endl;
        return;
    }

    OFstream os(file, IOstream::BINARY);
    os << found;

    // OpenFOAM's interpolationCellPoint from values at points over those of a field that is one
    // everywhere. From v2012 on these are one; before, they are not beside cyclicAMI
    const volPointInterpolation& toPoints = volPointInterpolation::New(mesh_);
    const volScalarField one
    (
        IOobject("one", mesh_.time().timeName(), mesh_), mesh_, dimensionedScalar("one", dimless, 1)
    );
    const scalarField ones(toPoints.interpolate(one)().primitiveField());
    const scalarField pAtPoints(toPoints.interpolate(p_)().primitiveField()/ones);
    const vectorField UAtPoints(toPoints.interpolate(U_)().primitiveField()/ones);
    const auto stockValue = [](const auto& field, const auto& atPoints, const cellPointWeight& weight)
    {
        auto value = weight.weights()[0]*field[weight.cell()];
        forAll(weight.faceVertices(), i)
        {
            value += weight.weights()[i + 1]*atPoints[weight.faceVertices()[i]];
        }
        return value;
    };
    label inside = 0, ambiguous = 0, wrong = 0, lost = 0, byWalk = 0;
    label different = 0, overlapping = 0;
    scalar worst = 0;
    label hint = 0;
    forAll(points, i)
    {
        const point& p = points[i];
        const label celli = places[i].cell;
        const label stock = mesh_.findCell(locator_.wrap(p));
        inside += (stock >= 0);
        if (celli < 0 || stock < 0)
        {
            lost += (celli >= 0 || stock >= 0);
            continue;
        }

        // Through the mesh from where the point before was
        byWalk += (locator_.find(p, hint, end).cell != celli);
        hint = celli;
        if (celli != stock)
        {
            ++(holds(celli, p) ? ambiguous : wrong);
        }

        const cellPointWeight weight(mesh_, p, celli);
        scalar error = mag(values[i][0] - stockValue(p_, pAtPoints, weight));
        const vector U(stockValue(U_, UAtPoints, weight));
        for (direction k = 0; k < 3; ++k)
        {
            error = max(error, mag(values[i][1 + k] - U[k]));
        }
        if (error > 1e-11)
        {
            const bool several = meshFigures::depthIn(mesh_, p, celli).nHolding != 1;
            ++(several ? overlapping : different);
            worst = max(worst, several ? 0 : error);
        }
    }
    Info<< "result inside " << inside << nl
        << "result lost " << lost << nl
        << "result wrongCell " << wrong << nl
        << "result ambiguousCell " << ambiguous << nl
        << "result otherCellByWalk " << byWalk << nl
        << "result differentValue " << different << nl
        << "result worstValue " << worst << nl
        << "result valueOfOtherTetrahedron " << overlapping << endl;
}


void Foam::probedMesh::walk(const label n, const label steps)
{
    struct walker
    {
        point p;
        vector v;
        label cell;
    };
    const auto direction = [&]()
    {
        vector d;
        do
        {
            d = 2*vector(uniform(), uniform(), uniform()) - vector::one;
        }
        while (magSqr(d) > 1 || magSqr(d) < 0.01);
        return d/mag(d);
    };

    List<walker> walkers(n);
    label end;
    for (walker& w : walkers)
    {
        do
        {
            w.p = somewhere();
            w.cell = locator_.find(w.p, -1, end).cell;
        }
        while (w.cell < 0);
        w.v = 2*uniform()*cbrt(mesh_.V()[w.cell])*direction();
    }

    label located = 0, notThere = 0, lost = 0, otherBySearch = 0, turned = 0, searched = 0;
    for (label step = 0; step < steps; ++step)
    {
        for (walker& w : walkers)
        {
            const point p(w.p + w.v);
            const std::int64_t before = locator_.searches();
            const label celli = locator_.find(p, w.cell, end).cell;
            if (celli < 0)
            {
                lost += (mesh_.findCell(locator_.wrap(p)) >= 0);
                w.v = mag(w.v)*direction();
                ++turned;
                continue;
            }
            searched += locator_.searches() - before;
            ++located;
            w.p = locator_.wrap(p);
            w.cell = celli;
            notThere += !holds(celli, locator_.near(p, celli));
            if (step % 20 == 0)
            {
                otherBySearch += (locator_.find(p, -1, end).cell != celli);
            }
        }
    }
    Info<< "result located " << located << nl
        << "result notThere " << notThere << nl
        << "result lostOnTheWay " << lost << nl
        << "result otherCellBySearch " << otherBySearch << nl
        << "result turned " << turned << nl
        << "result searched " << scalar(searched)/located << endl;
}


void Foam::probedMesh::spheres(const label n)
{
    dictionary divided;
    divided.add("model", "divided");
    autoPtr<voidFractionModel> model(voidFractionModel::New(divided, locator_));
    grainShares shares(locator_);

    DynamicList<grainData> grains;
    label end;
    for (label i = 0; i < n; ++i)
    {
        const point p(somewhere());
        const scalar size = 0.1 + 0.9*uniform();
        const cellLocator::place place(locator_.find(p, -1, end));
        if (place.cell >= 0)
        {
            grainData grain{};
            grain.position = p;
            grain.radius = size*cbrt(mesh_.V()[place.cell]);
            grain.cell = place.cell;
            grain.clearance = place.clearance;
            grain.pyramid = place.pyramid;
            grains.append(grain);
        }
    }
    model->share(0, grains, shares);
    const auto cellOf = [&](const label g){ return grains[g].cell; };
    shares.findRemoteParts(cellOf);
    scalarField solid(mesh_.nCells(), Zero);
    shares.deposit<scalar>
    (
        grains.size(),
        cellOf,
        [&](const label g){ return grains[g].volume(); },
        [&](const label celli, const scalar fraction, const scalar volume)
        {
            solid[celli] += fraction*volume;
        }
    );

    scalar volume = 0;
    for (const grainData& grain : grains)
    {
        volume += grain.volume();
    }
    reduce(volume, sumOp<scalar>());
    Info<< "result spheres " << returnReduce(grains.size(), sumOp<label>()) << nl
        << "result volumeError " << mag(gSum(solid)/volume - 1) << endl;
    if (Pstream::parRun())
    {
        return;
    }

    scalarField expected(mesh_.nCells(), Zero);
    for (const grainData& grain : grains)
    {
        for (const vector& part : dividedVoidFraction::points())
        {
            const label celli =
                mesh_.findCell(locator_.wrap(grain.position + grain.radius*part));
            expected[celli < 0 ? grain.cell : celli] +=
                grain.volume()/dividedVoidFraction::nParts;
        }
    }
    Info<< "result volumeInOtherCell " << 0.5*gSumMag(solid - expected)/volume << endl;
}


// ************************************************************************* //
