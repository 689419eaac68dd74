/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "randomWalkDispersion.H"
#include "addToRunTimeSelectionTable.H"

#include "physics/turbulence/eddy_walk.h"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(randomWalkDispersion, 0);
    addToRunTimeSelectionTable(turbulentDispersion, randomWalkDispersion, dictionary);
    const knownEntries::ofModel entriesOfrandomWalkDispersion
    (
        turbulentDispersion::typeName_(),
        randomWalkDispersion::typeName_(),
        {
            {
                "CL",
                knownEntries::rule(0.01, 1)
               .means("the Lagrangian time scale over k/epsilon, usually 0.15 to 0.3")
               .like("0.15")
            }
        }
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::randomWalkDispersion::randomWalkDispersion
(
    const dictionary& dict,
    const carrierFluid& fluid
)
:
    turbulentDispersion(dict, fluid),
    CL_(dict.lookupOrDefault<scalar>("CL", 0.15))
{}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::randomWalkDispersion::ask(forceNeeds& needs)
{
    speed_ = needs.quantity("turbulentSpeed");
    time_ = needs.quantity("dissipationTime");
    left_ = needs.state("left", scalarList(1, -1.0));
}


void Foam::randomWalkDispersion::advance
(
    grainBatch& grains,
    const label i,
    const random& numbers,
    const scalar responseTime,
    vector& fluctuation,
    vector& mean
) const
{
    const scalar speed = (*grains.fluid(speed_))[i];
    const scalar time = (*grains.fluid(time_))[i];

    // Cmu^(3/4) k^(3/2)/epsilon, k = 1.5 speed2
    const scalar length = pow(0.09, 0.75)*sqrt(1.5)*speed*time;
    const vector slip
    (
        grainBatch::get(grains.fluidVelocity, i) - grainBatch::get(grains.velocity, i)
    );

    const auto life = [&](const scalar* xi)
    {
        const vector u(xi[0], xi[1], xi[2]);
        return min
        (
            2*CL_*time,
            grainjet::turbulence::crossing_time(length, mag(slip + speed*u), responseTime)
        );
    };

    // Draw 0 made the first eddy of a new grain
    grainjet::turbulence::EddyWalk walk(numbers, 1);
    scalar& left = (*grains.state(left_))[i];
    if (left < 0)
    {
        left = life(fluctuation.cdata());
    }
    walk.advance(dt_, life, fluctuation.data(), left, mean.data());
    mean *= speed;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::randomWalkDispersion::summary() const
{
    return turbulentDispersion::summary() + ", CL " + Foam::name(CL_);
}


// ************************************************************************* //
