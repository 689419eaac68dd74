/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Entries of the models, what they must not add to the sums of a batch, and what does not go
    together, see grainForces.H.

\*---------------------------------------------------------------------------*/

#include "grainForces.H"
#include "dragForce.H"
#include "dragLaw.H"
#include "SaffmanMeiForce.H"
#include "turbulenceModel.H"
#include "wallPolyPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::grainForces::checkRequested(const grainBatch& batch) const
{
    const liggghtsSession::requests& requested = requests();
    const auto anyIn = [](const grainBatch::lane& lane)
    {
        bool any = false;
        for (label i = 0; i < grainBatch::size; ++i)
        {
            any |= (lane[i] != 0);
        }
        return any;
    };
    const auto anyInVector = [&](const grainBatch::lane* lanes)
    {
        return anyIn(lanes[0]) || anyIn(lanes[1]) || anyIn(lanes[2]);
    };

    if
    (
        !requested.nonReacting
     && (anyIn(batch.nonReactingSp) || anyInVector(batch.nonReactingSu))
    )
    {
        refuse
        (
            "forces without reaction, but has not called forceNeeds::nonReacting()"
            " in its constructor"
        );
    }
    if (!requested.torque && (anyIn(batch.spinCoefficient) || anyInVector(batch.torque)))
    {
        refuse("torque, but has not called forceNeeds::torque() in its constructor");
    }
    if (!requested.addedMass && anyIn(batch.addedMass))
    {
        refuse("added mass, but has not called forceNeeds::addedMass() in its constructor");
    }
    if (!requested.heat && anyIn(batch.heatTransferCoefficient))
    {
        refuse("heat transfer, but has not called forceNeeds::heat() in its constructor");
    }
}


void Foam::grainForces::checkCoefficients(const grainBatch& batch) const
{
    const auto anyNegativeIn = [](const grainBatch::lane& lane)
    {
        bool any = false;
        for (label i = 0; i < grainBatch::size; ++i)
        {
            any |= (lane[i] < 0);
        }
        return any;
    };

    if (anyNegativeIn(batch.Sp))
    {
        refuse("a negative Sp: such drag would speed grains up");
    }
    if (requests().nonReacting && anyNegativeIn(batch.nonReactingSp))
    {
        refuse("a negative nonReactingSp: such drag would speed grains up");
    }
    if (requests().torque && anyNegativeIn(batch.spinCoefficient))
    {
        refuse("a negative spinCoefficient: such a torque would speed up the spin");
    }
    if (requests().heat && anyNegativeIn(batch.heatTransferCoefficient))
    {
        refuse("a negative heatTransferCoefficient: heat would flow from cold to hot");
    }
}


void Foam::grainForces::warnOfWalls(const dictionary& dict) const
{
    bool lift = false;
    for (const grainForce& force : forces_)
    {
        lift = lift || isA<SaffmanMeiForce>(force);
    }
    const turbulenceModel* model = needs_.fluid().model();
    if
    (
        lift && !dispersion_ && model && model->get<word>("simulationType") == "RAS"
     && needs_.mesh().boundaryMesh().findPatchIDs<wallPolyPatch>().size()
    )
    {
        IOWarningInFunction(dict)
            << "forces: SaffmanMei without turbulentDispersion: at walls this lift draws grains that are"
            << " faster than the flow to the wall, and no eddies take them off it again. Leave SaffmanMei"
            << " out, or set turbulentDispersion Langevin" << endl;
    }
}


void Foam::grainForces::refuse(const char* what) const
{
    wordList names;
    for (const grainForce& force : forces_)
    {
        names.append(force.type());
    }
    FatalErrorInFunction
        << "One of the models " << flatOutput(names) << " adds " << what << exit(FatalError);
}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

void Foam::grainForces::checkEntries(const dictionary& dict)
{
    const auto& models = *grainForce::dictionaryConstructorTablePtr_;
    for (const Tuple2<word, dictionary>& model : readModels(dict))
    {
        const word& name = model.first();
        if (!models.found(name))
        {
            const bool longForm = dict.isDict("forces");
            FatalIOErrorInEntry
            (
                longForm ? dict.subDict("forces") : dict,
                longForm ? name : word("forces")
            )
                << "Unknown force " << name << "\n\nValid forces: "
                << flatOutput(models.sortedToc())
                << "\nA library with models of your own must stand in libs of"
                << " system/controlDict" << exit(FatalIOError);
        }
        if (name == dragForce::typeName)
        {
            dragLaw::checkEntries(model.second());
        }
        grainForce::checkEntries(name, model.second());
    }
}


// ************************************************************************* //
