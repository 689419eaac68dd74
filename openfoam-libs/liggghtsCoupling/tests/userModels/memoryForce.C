/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "memoryForce.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(memoryForce, 0);
    addToRunTimeSelectionTable(grainForce, memoryForce, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::memoryForce::memoryForce(const dictionary& dict, forceNeeds& needs)
:
    grainForce
    (
        dict,
        needs,
        {{"time", {knownEntries::valueType::POSITIVE, knownEntries::REQUIRED}}}
    ),
    time_(dict.get<scalar>("time")),
    rho_(needs.quantity("rho")),
    nu_(needs.quantity("nu")),
    remembered_(needs.state("slip", scalarList(3, 0.0)))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::memoryForce::add(grainBatch& grains) const
{
    const lane& rho = *grains.fluid(rho_);
    const lane& nu = *grains.fluid(nu_);
    lane* remembered = grains.state(remembered_);

    const scalar dt = fluid_.interval();
    const scalar kept = exp(-dt/(2*time_));
    const scalar kernel = sqrt(constant::mathematical::e/time_);

    for (label i = 0; i < grainBatch::size; ++i)
    {
        const scalar coefficient =
            grains.particles[i]*1.5*sqr(grains.particleDiameter[i])*rho[i]
           *sqrt(constant::mathematical::pi*nu[i])*kernel;

        // coefficient (uf - v - h): what is proportional to v follows the grain in every DEM step
        grains.Sp[i] += coefficient;
        for (direction k = 0; k < 3; ++k)
        {
            scalar& h = remembered[k][i];
            const scalar slip = grains.fluidVelocity[k][i] - grains.velocity[k][i];

            grains.Su[k][i] -= coefficient*h;
            h = slip + kept*(h - slip);
        }
    }
}


// ************************************************************************* //
