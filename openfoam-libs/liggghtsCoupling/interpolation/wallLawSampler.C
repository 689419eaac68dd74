/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallLawSampler.H"
#include "couplingEntries.H"
#include "entryError.H"
#include "symmetryPlanePolyPatch.H"
#include "symmetryPolyPatch.H"
#include "wedgePolyPatch.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(wallLawSampler, 0);
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// Means at points would mix vectors of different directions
const Foam::dictionary& checkedSides(const Foam::dictionary& dict, const Foam::polyMesh& mesh)
{
    // A rank without a face of the side does not know
    const Foam::polyBoundaryMesh& patches = mesh.boundaryMesh();
    Foam::label rotated = -1;
    for (const Foam::polyPatch& patch : patches)
    {
        if
        (
            Foam::isA<Foam::cyclicPolyPatch>(patch)
         && !Foam::refCast<const Foam::coupledPolyPatch>(patch).parallel()
        )
        {
            rotated = patch.index();
        }
    }
    Foam::reduce(rotated, Foam::maxOp<Foam::label>());
    Foam::couplingEntries::onMaster
    (
        [&]()
        {
            if (rotated >= 0)
            {
                FatalIOErrorInEntry(dict, "wallLaw")
                    << "wallLaw cannot be used with periodic sides that are rotated, such as patch "
                    << patches[rotated].name()
                    << ". Take cyclicAMI or symmetry planes there, or remove wallLaw"
                    << Foam::exit(Foam::FatalIOError);
            }
        }
    );
    return dict;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

inline const Foam::scalar* Foam::wallLawSampler::row
(
    const label pointi,
    const label number
) const
{
    const label p = layer_.pointNumber(pointi);
    return
        rows_.data()
      + width_*(layer_.points()[p].twoSided ? ownWall_[number] : layer_.nCells() + p);
}


void Foam::wallLawSampler::choose(const sampledFields& fields)
{
    typedef grainjet::wall::WallTurbulence shapes;

    U_ = -1;
    scalars_.clear();
    for (const sampledFields::field& field : fields.fields)
    {
        if (field.vector)
        {
            U_ = (field.vector == &fluid_.velocity() ? field.lane : U_);
            continue;
        }
        const word& quantity = field.scalar->name();
        const auto shape =
            quantity == "k" ? &shapes::k
          : quantity == "epsilon" ? &shapes::epsilon : nullptr;
        if (shape)
        {
            scalars_.append(shapedScalar{field.scalar, field.lane, shape});
        }
    }
    width_ = label(WIDTH_OF_VELOCITY);
    if (scalars_.size())
    {
        width_ = label(LARGEST_WIDTH);
        k_ = fluid_.mesh().cfindObject<volScalarField>("k");
        nu_ = fluid_.nu();
    }
}


template<Foam::label width>
inline void Foam::wallLawSampler::apply
(
    const grainBatch& grains,
    const weights& at,
    const label number,
    const label i,
    grainBatch::lane* lanes
) const
{
    const scalar* rows[4] = {rows_.data() + width*number};
    for (label v = 1; v < 4; ++v)
    {
        rows[v] = row(at.points[v - 1], number);
    }
    scalar sum[width];
    for (label k = DISTANCE; k < width; ++k)
    {
        sum[k] = at.w[0]*rows[0][k] + at.w[1]*rows[1][k] + at.w[2]*rows[2][k] + at.w[3]*rows[3][k];
    }

    const scalar y = layer_.distance(number, grainBatch::get(grains.position, i), sum[DISTANCE]);

    // Each with its own friction: a product of interpolated g and F is that of two walls where they differ
    scalar U[3] = {0, 0, 0};
    for (label v = 0; v < 4; ++v)
    {
        const scalar F = length(y, rows[v][FRICTION]);
        for (label k = 0; k < 3; ++k)
        {
            U[k] += at.w[v]*(rows[v][LINEAR + k] + F*rows[v][OVER_LAW + k]);
        }
    }
    for (label k = 0; k < 3; ++k)
    {
        lanes[U_ + k][i] = U[k];
    }
    if (width > WIDTH_OF_VELOCITY)
    {
        forAll(scalars_, s)
        {
            lanes[scalars_[s].lane][i] =
                sum[SCALARS + s]*shape(scalars_[s], y*sum[TURBULENT_FRICTION]);
        }
    }
}


void Foam::wallLawSampler::findConstrained()
{
    for (const polyPatch& patch : fluid_.mesh().boundaryMesh())
    {
        if
        (
            isA<symmetryPlanePolyPatch>(patch) || isA<symmetryPolyPatch>(patch)
         || isA<wedgePolyPatch>(patch)
        )
        {
            forAll(patch.meshPoints(), i)
            {
                const label number = layer_.pointNumber(patch.meshPoints()[i]);
                if (number >= 0 && layer_.points()[number].onWall)
                {
                    constrained_.append(number);
                    constraints_.append(patch.pointNormals()[i]);
                }
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::wallLawSampler::wallLawSampler
(
    const dictionary& dict,
    const carrierFluid& fluid,
    const cellLocator& locator
)
:
    cellPointSampler(locator),
    fluid_(fluid),
    walls_(checkedSides(dict, locator.mesh()), fluid),
    layer_(locator.mesh(), walls_.faces()),
    law_(grainjet::wall::Spalding(walls_.kappa(), walls_.E())),
    turbulence_(walls_.sublayerEdge(), walls_.Cmu()),
    U_(-1),
    k_(nullptr),
    width_(0),
    ownWall_(layer_.nCells(), -1),
    nRows_(layer_.nCells() + layer_.points().size())
{
    for (label number = 0; number < layer_.nCells(); ++number)
    {
        for (const wallLayer::share& s : layer_.sharesOfCell(number))
        {
            if (layer_.points()[s.point].twoSided && ownWall_[number] < 0)
            {
                ownWall_[number] = nRows_++;
            }
        }
    }
    findConstrained();

    DynamicList<label> cells(layer_.nCells() + layer_.outerDistances().size());
    for (label number = 0; number < layer_.nCells(); ++number)
    {
        cells.append(layer_.cell(number).cell);
    }
    forAll(layer_.outerDistances(), i)
    {
        cells.append(layer_.outerCell(i));
    }
    values().needAlways(cells);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::wallLawSampler::report(Ostream& os) const
{
    os  << "    Law of the wall: " << returnReduce(layer_.nCells(), sumOp<label>())
        << " cells at " << flatOutput(walls_.names()) << nl;
}


void Foam::wallLawSampler::update(const sampledFields& fields)
{
    cellPointSampler::update(fields);
    if (!fields.newFluid && values().scalarsAlone(fields))
    {
        // Velocity, k, epsilon and walls are those of the update before
        return;
    }
    choose(fields);
    rows_.resize(width_*nRows_);

    const List<wallFunctions::faceState> faces(walls_.states());
    const List<wallFunctions::faceState> points(atPoints(faces));
    const List<wallFunctions::faceState> cells(atCells(faces, points));
    setCells(cells);
    setPoints(points, cells);
}


void Foam::wallLawSampler::at(const grainBatch& grains, grainBatch::lane* lanes) const
{
    weights places[grainBatch::size];
    weigh(grains, places);
    interpolate(grains, places, lanes);
    for (label i = 0; i < grainBatch::size; ++i)
    {
        const label number = layer_.cellNumber(grains.cell[i]);
        if (number < 0)
        {
            continue;
        }
        if (scalars_.empty())
        {
            apply<WIDTH_OF_VELOCITY>(grains, places[i], number, i, lanes);
        }
        else
        {
            apply<LARGEST_WIDTH>(grains, places[i], number, i, lanes);
        }
    }
}


// ************************************************************************* //
