/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluidQuantities.H"
#include "coupledFvPatch.H"
#include "couplingEntries.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
void Foam::fluidQuantities::setCellBoundaries
(
    tmp<GeometricField<Type, fvPatchField, volMesh>>& tfield
)
{
    typedef GeometricField<Type, fvPatchField, volMesh> fieldType;

    if (!tfield.movable())
    {
        // Others use it as well
        const fieldType& field = tfield();
        tfield = tmp<fieldType>
        (
            new fieldType
            (
                IOobject
                (
                    field.name() + ":grains",
                    field.time().timeName(),
                    field.mesh(),
                    IOobject::NO_READ,
                    IOobject::NO_WRITE,
                    false
                ),
                field
            )
        );
    }

    for (fvPatchField<Type>& patch : tfield.ref().boundaryFieldRef())
    {
        if (isA<coupledFvPatch>(patch.patch()))
        {
            continue;
        }
        if (polyPatch::constraintType(patch.patch().type()))
        {
            patch.evaluate();
        }
        else
        {
            patch == patch.patchInternalField()();
        }
    }
}


void Foam::fluidQuantities::setUp()
{
    const label n = quantities_.size();
    scalars_.setSize(n);
    vectors_.setSize(n);
    firstLane_.setSize(n + 1);

    label lane = 0;
    for (const bool ofCell : {false, true})
    {
        sampledFields& fields = (ofCell ? ofCells_ : interpolated_);
        fields.first = lane;
        for (label i = 0; i < n; ++i)
        {
            if (quantities_[i].ofCell() == ofCell)
            {
                firstLane_[i] = lane;
                fields.fields.append
                (
                    sampledFields::field{nullptr, nullptr, lane, quantities_[i].changesWithGrains()}
                );
                lane += quantities_[i].isVector() ? 3 : 1;
            }
        }
        fields.nLanes = lane - fields.first;
    }
    firstLane_[n] = lane;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fluidQuantities::fluidQuantities(const carrierFluid& fluid)
:
    fluid_(fluid)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::fluidQuantities::need
(
    const word& name,
    const word& model,
    const dictionary& dict
)
{
    const label known = names_.find(name);
    if (known >= 0)
    {
        return known;
    }
    names_.append(name);
    quantities_.append(fluidQuantity::New(name, fluid_, model, dict));

    const string missing(quantities_.last().missing());
    couplingEntries::onMaster
    (
        [&]()
        {
            if (!missing.empty())
            {
                FatalIOErrorInFunction(dict)
                    << "The model " << model << " needs " << name << " of the fluid, but "
                    << missing.c_str() << ", or take " << model << " out" << exit(FatalIOError);
            }
        }
    );
    return names_.size() - 1;
}


const Foam::labelList& Foam::fluidQuantities::firstLane()
{
    if (firstLane_.empty())
    {
        setUp();
    }
    return firstLane_;
}


void Foam::fluidQuantities::update(const bool all)
{
    firstLane();
    interpolated_.newFluid = ofCells_.newFluid = all;

    label nInterpolated = 0;
    label nOfCells = 0;
    forAll(quantities_, i)
    {
        fluidQuantity& quantity = quantities_[i];
        sampledFields::field& field =
            quantity.ofCell()
          ? ofCells_.fields[nOfCells++] : interpolated_.fields[nInterpolated++];
        const bool asTheyAre = quantity.ofCell() || quantity.hasBoundaryValues();
        if (!all && !quantity.changesWithGrains())
        {
            continue;
        }

        if (quantity.isVector())
        {
            vectors_[i] = quantity.vectorField();
            if (!asTheyAre)
            {
                setCellBoundaries(vectors_[i]);
            }
            field.vector = &vectors_[i]();
        }
        else
        {
            scalars_[i] = quantity.scalarField();
            if (!asTheyAre)
            {
                setCellBoundaries(scalars_[i]);
            }
            field.scalar = &scalars_[i]();
        }
    }
}


// ************************************************************************* //
