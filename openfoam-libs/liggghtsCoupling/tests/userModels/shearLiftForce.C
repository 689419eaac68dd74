/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "shearLiftForce.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(shearLiftForce, 0);
    addToRunTimeSelectionTable(grainForce, shearLiftForce, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::shearLiftForce::shearLiftForce(const dictionary& dict, forceNeeds& needs)
:
    grainForce
    (
        dict,
        needs,
        {{"C", {knownEntries::valueType::POSITIVE, knownEntries::REQUIRED}}}
    ),
    C_(dict.get<scalar>("C")),
    rho_(needs.quantity("rho")),
    nu_(needs.quantity("nu")),
    curlU_(needs.quantity("curlU"))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::shearLiftForce::add(grainBatch& grains) const
{
    const lane& rho = *grains.fluid(rho_);
    const lane& nu = *grains.fluid(nu_);
    const lane* curlU = grains.fluid(curlU_);

    for (label i = 0; i < grainBatch::size; ++i)
    {
        const vector slip
        (
            grainBatch::get(grains.fluidVelocity, i) - grainBatch::get(grains.velocity, i)
        );
        const vector w(grainBatch::get(curlU, i));

        // The cross product vanishes faster than the root in a fluid without vorticity
        const scalar factor =
            C_*sqr(grains.particleDiameter[i])*rho[i]*sqrt(nu[i]/max(mag(w), SMALL));

        grainBatch::add(grains.Su, i, grains.particles[i]*factor*(slip ^ w));
    }
}


// ************************************************************************* //
