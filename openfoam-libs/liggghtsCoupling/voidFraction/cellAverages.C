/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellAverages.H"
#include "continuedField.H"
#include "fixedValueFvPatchFields.H"
#include "heatTransfer.H"
#include "voidFractionEquations.H"
#include "wallPolyPatch.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

// The default is a model, not a number, so it is stated in one place
dictionary modelDict(const dictionary& dict)
{
    dictionary model(dict.subOrEmptyDict("voidFraction"));
    if (!model.found("model"))
    {
        model.add("model", voidFractionModel::usual());
    }
    return model;
}


const fvMesh& fvMeshOf(const cellLocator& locator)
{
    return refCast<const fvMesh>(locator.mesh());
}


// The full equations continue with the void fraction of the latest step
IOobject voidFractionHeader(const dictionary& dict, const cellLocator& locator)
{
    const word name("voidFraction");
    return
        voidFractionEquations::full(dict)
      ? continuedField::header(name, fvMeshOf(locator))
      : cellAverages::writtenField(name, locator.mesh());
}


// Time schemes of second order continue with two former values. GeometricField looks for the older one in the
// folder of the present step, in which the coupling is made
template<class FieldType>
void continueOldTimes(FieldType& field)
{
    const Time& time = field.time();
    IOobject header
    (
        field.name() + "_0",
        time.timeName(time.startTime().value()),
        field.mesh(),
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );
    field.oldTime();
    if (header.typeHeaderOk<FieldType>(true))
    {
        field.oldTime().oldTime() == FieldType(header, field.mesh());
    }
}

} // End anonymous namespace
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::cellAverages::makeSolidsFlux()
{
    const fvMesh& mesh = voidFraction_.mesh();

    // No grain goes through a wall
    wordList types(mesh.boundary().size(), zeroGradientFvPatchVectorField::typeName);
    forAll(types, patchi)
    {
        if (isA<wallPolyPatch>(mesh.boundaryMesh()[patchi]))
        {
            types[patchi] = fixedValueFvPatchVectorField::typeName;
        }
    }

    IOobject header(continuedField::header("solidsFlux", mesh));
    continues_ = header.typeHeaderOk<volVectorField>(true);
    solidsFlux_.reset
    (
        new volVectorField(header, mesh, dimensionedVector(dimVelocity, Zero), types)
    );
    continueOldTimes(*solidsFlux_);
    continueOldTimes(voidFraction_);
}


void Foam::cellAverages::setSolidsFlux()
{
    volVectorField& q = *solidsFlux_;
    vectorField& flux = q.primitiveFieldRef();
    if (first_)
    {
        flux = Zero;
    }
    for (const label celli : occupied_.previous())
    {
        flux[celli] = Zero;
    }
    forAll(contents_, i)
    {
        const label celli = occupied_.cells()[i];
        const content& c = contents_[i];
        flux[celli] =
            filter_
          ? filteredFlux(c, q.mesh().V()[celli])
          : (1 - voidFraction_[celli])*(c.flux/c.volume);
    }
    q.correctBoundaryConditions();
    q.instance() = q.time().timeName();

    // In its first step a new run knows no flux of a step before
    if (first_ && !continues_)
    {
        q.oldTime() == q;
        voidFraction_.oldTime() == voidFraction_;
    }
}


Foam::vector Foam::cellAverages::filteredFlux
(
    const content& c,
    const scalar V
) const
{
    // Exact where the void fraction is not cut, also with next to no grains
    const scalar solid = c.volume/V;
    scalar cut = 0;
    model_->limited(solid, cut);
    return (cut > 0 ? 1 - cut/solid : 1)*c.flux/V;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellAverages::cellAverages
(
    const dictionary& dict,
    const cellLocator& locator
)
:
    model_(voidFractionModel::New(modelDict(dict), locator)),
    filter_(grainFilter::New(modelDict(dict), fvMeshOf(locator))),
    shares_(locator),
    occupied_(locator.mesh().nCells()),
    voidFraction_
    (
        voidFractionHeader(dict, locator),
        fvMeshOf(locator),
        dimensionedScalar("voidFraction", dimless, scalar(1)),
        zeroGradientFvPatchScalarField::typeName
    ),
    particleVelocity_
    (
        writtenField("particleVelocity", locator.mesh()),
        fvMeshOf(locator),
        dimensionedVector(dimVelocity, Zero)
    ),
    first_(true),
    continues_(false)
{
    if (heatTransfer::acts(dict))
    {
        particleTemperature_.reset
        (
            new volScalarField
            (
                writtenField("particleTemperature", locator.mesh()),
                fvMeshOf(locator),
                dimensionedScalar(dimTemperature, Zero)
            )
        );
    }
    if (voidFractionEquations::full(dict))
    {
        makeSolidsFlux();
    }
}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

Foam::IOobject Foam::cellAverages::writtenField
(
    const word& name,
    const polyMesh& mesh
)
{
    return IOobject
    (
        name,
        mesh.time().timeName(),
        mesh,
        IOobject::NO_READ,
        IOobject::AUTO_WRITE
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::cellAverages::figures Foam::cellAverages::update(ownedGrains& grains)
{
    const auto contentOf = [](const grainData& grain)
    {
        return content
        {
            grain.volume(), grain.volume()*grain.velocity, grain.mass, grain.mass*grain.velocity
        };
    };
    const auto add =
        [&](const label celli, const scalar fraction, const content& c)
        {
            content& sum = occupied_.sum(contents_, celli);
            sum.volume += fraction*c.volume;
            sum.mass += fraction*c.mass;
            sum.momentum += fraction*c.momentum;
            sum.flux += fraction*c.flux;
        };

    occupied_.clear();
    contents_.clear();

    // What is read of a grain to find its cell serves for the cell's sums as well
    shares_.clear();
    grains.locate
    (
        [&](const label first, const UList<grainData>& found)
        {
            label part = shares_.size();
            model_->share(first, found, shares_);
            forAll(found, i)
            {
                const grainData& grain = found[i];
                part = shares_.depositOne
                (
                    part, first + i, grain.cell, contentOf(grain), add
                );
            }
        }
    );
    shares_.findRemoteParts([&](const label g){ return grains.cell(g); });
    shares_.depositRest<content>
    (
        [&](const label g){ return contentOf(grains.grain(g)); },
        add
    );
    if (filter_)
    {
        filter_->spread(occupied_, contents_, solidsFlux_ ? content::ofFlux : content::ofVolume);
    }

    scalarField& eps = voidFraction_.primitiveFieldRef();
    vectorField& velocity = particleVelocity_.primitiveFieldRef();
    if (first_)
    {
        // What was read is that of the run before
        eps = 1;
    }
    for (const label celli : occupied_.previous())
    {
        eps[celli] = 1;
        velocity[celli] = Zero;
    }

    figures result;
    const scalarField& V = voidFraction_.mesh().V();
    forAll(contents_, i)
    {
        const label celli = occupied_.cells()[i];
        const content& c = contents_[i];
        const scalar solid = c.volume/V[celli];
        scalar cut = 0;

        velocity[celli] =
            filter_ && c.mass <= 0 ? vector(Zero) : c.momentum/c.mass;
        eps[celli] = model_->limited(solid, cut);
        result.volumeCut += cut*V[celli];
        result.maxSolidFraction = max(result.maxSolidFraction, solid);
    }
    voidFraction_.correctBoundaryConditions();
    if (solidsFlux_)
    {
        setSolidsFlux();
    }
    first_ = false;
    return result;
}


void Foam::cellAverages::updateTemperature(const ownedGrains& grains)
{
    // Heat capacity, and its product with the temperature
    typedef FixedList<scalar, 2> content;

    DynamicList<content> sums;
    shares_.deposit<content>
    (
        grains.size(),
        [&](const label g){ return grains.cell(g); },
        [&](const label g)
        {
            const scalar capacity = grains.heatCapacity(g);
            return content({capacity, capacity*grains.temperature(g)});
        },
        [&](const label celli, const scalar fraction, const content& c)
        {
            content& sum = occupied_.sum(sums, celli);
            sum[0] += fraction*c[0];
            sum[1] += fraction*c[1];
        }
    );

    scalarField& T = particleTemperature_->primitiveFieldRef();
    T = Zero;
    forAll(sums, i)
    {
        if (sums[i][0] > 0)
        {
            T[occupied_.cells()[i]] = sums[i][1]/sums[i][0];
        }
    }
}


void Foam::cellAverages::restoreShares
(
    ownedGrains& grains,
    DynamicList<fluidCoefficients>& acted
)
{
    shares_.clear();
    grains.restoreOwners
    (
        [&](const label first, const UList<grainData>& found)
        {
            model_->share(first, found, shares_);
        },
        acted
    );
    shares_.findRemoteParts([&](const label g){ return grains.cell(g); });
}


// ************************************************************************* //
