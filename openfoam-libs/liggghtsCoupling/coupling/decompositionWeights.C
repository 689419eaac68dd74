/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "decompositionWeights.H"
#include "knownEntries.H"
#include "PstreamReduceOps.H"
#include "volFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(decompositionWeights, 0);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::decompositionWeights::decompositionWeights
(
    const dictionary& entries,
    const fvMesh& mesh
)
:
    releases::writtenWithFields
    (
        IOobject
        (
            "decompositionWeightsOfGrains",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        )
    ),
    mesh_(mesh),
    grainCost_(entries.get<scalar>("grainCost")),
    mostCells_(returnReduce(mesh.nCells(), maxOp<label>())),
    sums_(mesh.nCells(), Zero),
    time_(0),
    means_(mesh.nCells(), Zero),
    cellClock_(),
    grainClock_()
{}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::decompositionWeights> Foam::decompositionWeights::New
(
    const dictionary& coupling,
    const fvMesh& mesh
)
{
    autoPtr<decompositionWeights> weights;
    if (coupling.found(typeName))
    {
        weights.reset(new decompositionWeights(coupling.subDict(typeName), mesh));
    }
    return weights;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::decompositionWeights::checkEntries(const dictionary& coupling)
{
    typedef knownEntries::rule rule;
    if (coupling.found(typeName))
    {
        knownEntries::check
        (
            coupling.subDict(typeName),
            knownEntries::table
            ({
                {
                    "grainCost",
                    rule(knownEntries::valueType::POSITIVE, knownEntries::REQUIRED)
                   .means("what a grain takes of a fluid step, over what a cell takes of it").like("1")
                }
            })
        );
    }
}


void Foam::decompositionWeights::add(const ownedGrains& grains, const scalar interval)
{
    for (label g = 0; g < grains.size(); ++g)
    {
        sums_[grains.cell(g)] += interval;
    }
    time_ += interval;
}


void Foam::decompositionWeights::addClock
(
    const couplingStep& step,
    const scalar fluidSeconds
)
{
    // Before the first line of the log the fluid has not been solved
    if (fluidSeconds <= 0)
    {
        return;
    }
    // All ranks wait for the one with most cells, or most grains
    cellClock_.add(fluidSeconds, mostCells_);
    grainClock_.add(step.demSeconds + step.couplingSeconds, step.mostGrains);
}


bool Foam::decompositionWeights::writeFiles() const
{
    volScalarField weights
    (
        IOobject
        (
            typeName,
            mesh_.time().timeName(),
            mesh_,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh_,
        dimensionedScalar(typeName, dimless, scalar(1))
    );
    // A time may be written twice
    if (time_ > 0)
    {
        means_ = sums_/time_;
        sums_ = 0;
        time_ = 0;
    }
    weights.primitiveFieldRef() += grainCost_*means_;
    weights.correctBoundaryConditions();

    if (cellClock_.each() > 0 && grainClock_.each() > 0)
    {
        const int precision = Info().precision(3);
        Info<< "liggghtsCoupling: " << typeName << " with grainCost " << grainCost_
            << "; by the clock of this run it would be " << grainClock_.each()/cellClock_.each() << nl << endl;
        Info().precision(precision);
    }
    return weights.write();
}


// ************************************************************************* //
