/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "LangevinDispersion.H"
#include "addToRunTimeSelectionTable.H"

#include "physics/turbulence/langevin_step.h"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(LangevinDispersion, 0);
    addToRunTimeSelectionTable(turbulentDispersion, LangevinDispersion, dictionary);
    const knownEntries::ofModel entriesOfLangevinDispersion
    (
        turbulentDispersion::typeName_(),
        LangevinDispersion::typeName_(),
        {
            {
                "Sct",
                knownEntries::rule(0.1, 10)
               .means("the turbulent Schmidt number of fluid particles, 0.7 to 1 in jets and pipes")
               .like("0.7")
            }
        }
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::LangevinDispersion::LangevinDispersion
(
    const dictionary& dict,
    const carrierFluid& fluid
)
:
    turbulentDispersion(dict, fluid),
    Sct_(dict.lookupOrDefault<scalar>("Sct", 0.7))
{}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::LangevinDispersion::ask(forceNeeds& needs)
{
    speed_ = needs.quantity("turbulentSpeed");
    speedGradient_ = needs.quantity("gradTurbulentSpeed");
    time_ = needs.quantity("turbulentTime");
    timeGradient_ = needs.quantity("gradTurbulentTime");
    response_ = needs.state("response", scalarList(3, Zero));
    before_ = needs.state("before", scalarList(3, Zero));
}


void Foam::LangevinDispersion::advance
(
    grainBatch& grains,
    const label i,
    const random& numbers,
    const scalar responseTime,
    vector& fluctuation,
    vector& mean
) const
{
    const lane* speedGradient = grains.fluid(speedGradient_);
    const lane* timeGradient = grains.fluid(timeGradient_);
    grainjet::turbulence::SeenTurbulence seen;
    seen.speed = (*grains.fluid(speed_))[i];
    seen.time = (*grains.fluid(time_))[i]/Sct_;
    for (direction k = 0; k < 3; ++k)
    {
        seen.speed_gradient[k] = speedGradient[k][i];
        seen.time_gradient[k] = timeGradient[k][i]/Sct_;
    }

    // Of the end of the interval before. The velocity where the grain has come to since, which no
    // model has changed yet, is for new grains alone
    const vector slip
    (
        grainBatch::get(isNew(grains, i) ? grains.fluidVelocity : grains.state(before_), i)
      - grainBatch::get(grains.velocity, i)
      + grainBatch::get(grains.state(response_), i)
    );

    scalar normals[6];
    numbers.normals(1, normals);
    numbers.normals(2, normals + 4, 2);

    grainjet::turbulence::LangevinStep(seen, dt_, responseTime, slip.cdata())
       .advance(normals, fluctuation.data(), mean.data());
}


Foam::scalar Foam::LangevinDispersion::eddyTime(const grainBatch& grains, const label i) const
{
    const scalar speed = (*grains.fluid(speed_))[i];
    return
        speed > 1e-3*mag(grainBatch::get(grains.fluidVelocity, i))
      ? (*grains.fluid(time_))[i]/Sct_
      : GREAT;
}


void Foam::LangevinDispersion::mirrored
(
    grainBatch& grains,
    const label i,
    const vector& normal
) const
{
    lane* response = grains.state(response_);
    grainBatch::add(response, i, -2*(normal & grainBatch::get(response, i))*normal);
}


void Foam::LangevinDispersion::keep
(
    grainBatch& grains,
    const label i,
    const scalar kept,
    const vector& mean
) const
{
    lane* response = grains.state(response_);
    lane* before = grains.state(before_);
    for (direction k = 0; k < 3; ++k)
    {
        response[k][i] = mean[k] + kept*(response[k][i] - mean[k]);
        before[k][i] = grains.fluidVelocity[k][i] - mean[k];
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::LangevinDispersion::summary() const
{
    return turbulentDispersion::summary() + ", Sct " + Foam::name(Sct_);
}


// ************************************************************************* //
