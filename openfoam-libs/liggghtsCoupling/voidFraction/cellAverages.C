/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellAverages.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

// The default is a model, not a number, so it is stated in one place
dictionary modelDict(const dictionary& dict)
{
    if (dict.found("voidFraction"))
    {
        return dict.subDict("voidFraction");
    }
    dictionary divided;
    divided.add("model", "divided");
    return divided;
}


const fvMesh& fvMeshOf(const cellLocator& locator)
{
    return refCast<const fvMesh>(locator.mesh());
}

} // End anonymous namespace
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::cellAverages::cellAverages
(
    const dictionary& dict,
    const cellLocator& locator
)
:
    model_(voidFractionModel::New(modelDict(dict), locator)),
    shares_(locator),
    occupied_(locator.mesh().nCells()),
    voidFraction_
    (
        writtenField("voidFraction", locator.mesh()),
        fvMeshOf(locator),
        dimensionedScalar("voidFraction", dimless, scalar(1)),
        zeroGradientFvPatchScalarField::typeName
    ),
    particleVelocity_
    (
        writtenField("particleVelocity", locator.mesh()),
        fvMeshOf(locator),
        dimensionedVector(dimVelocity, Zero)
    )
{}


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
        return content{grain.volume(), grain.mass, grain.mass*grain.velocity};
    };
    const auto add =
        [&](const label celli, const scalar fraction, const content& c)
        {
            content& sum = occupied_.sum(contents_, celli);
            sum.volume += fraction*c.volume;
            sum.mass += fraction*c.mass;
            sum.momentum += fraction*c.momentum;
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

    scalarField& eps = voidFraction_.primitiveFieldRef();
    vectorField& velocity = particleVelocity_.primitiveFieldRef();
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

        velocity[celli] = c.momentum/c.mass;
        eps[celli] = model_->limited(solid, cut);
        result.volumeCut += cut*V[celli];
        result.maxSolidFraction = max(result.maxSolidFraction, solid);
    }
    voidFraction_.correctBoundaryConditions();
    return result;
}


// ************************************************************************* //
