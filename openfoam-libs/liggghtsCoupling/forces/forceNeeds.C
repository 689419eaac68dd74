/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "forceNeeds.H"
#include "couplingEntries.H"

#include <cctype>
#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::forceNeeds::forceNeeds
(
    const dictionary& coupling,
    const carrierFluid& fluid,
    fluidQuantities& quantities,
    const bool stressReacts
)
:
    coupling_(coupling),
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
    const char* wrong = nullptr;

    for (const liggghtsSession::requests::state& other : requests_.states)
    {
        if (other.name == full)
        {
            wrong = "twice. Give each state of a model a name of its own";
        }
    }
    for (const char c : name)
    {
        if (!std::isalnum(static_cast<unsigned char>(c)))
        {
            wrong = "whose name has other characters than letters and digits";
        }
    }
    for (const char c : model_)
    {
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_')
        {
            wrong = "but a model with state needs a name of letters, digits and _ only:"
                " change its TypeName";
        }
    }
    if (name.empty() || initial.empty())
    {
        wrong = "without a name, or without numbers";
    }
    for (const scalar x : initial)
    {
        if (!std::isfinite(x))
        {
            wrong = "of which an initial value is not finite";
        }
    }

    couplingEntries::onMaster
    (
        [&]()
        {
            if (wrong)
            {
                FatalIOErrorInFunction(dict_)
                    << "The model " << model_ << " asks for the state " << name << ' '
                    << wrong << exit(FatalIOError);
            }
        }
    );
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
