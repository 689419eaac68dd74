/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "forceNeeds.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::forceNeeds::forceNeeds
(
    const carrierFluid& fluid,
    fluidQuantities& quantities,
    const bool stressReacts
)
:
    fluid_(fluid),
    quantities_(quantities),
    firstState_(1, Zero),
    stressReacts_(stressReacts)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::forceNeeds::quantity(const word& name)
{
    return quantities_.need(name, model_, dict_);
}


Foam::label Foam::forceNeeds::state(const word& name, const scalarList& initial)
{
    const std::string full(model_ + '_' + name);
    for (const liggghtsSession::requests::state& other : requests_.states)
    {
        if (other.name == full)
        {
            FatalErrorInFunction
                << "The model " << model_ << " asks for the state " << name << " twice"
                << exit(FatalError);
        }
    }
    requests_.states.push_back
    (
        liggghtsSession::requests::state
        {
            full, std::vector<double>(initial.begin(), initial.end())
        }
    );
    firstState_.append(firstState_.last() + initial.size());
    return firstState_.size() - 2;
}


void Foam::forceNeeds::begin(const word& model, const dictionary& dict)
{
    model_ = model;
    dict_ = dict;
}


// ************************************************************************* //
