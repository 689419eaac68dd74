/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "viscousTorque.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(viscousTorque, 0);
    addToRunTimeSelectionTable(grainForce, viscousTorque, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::viscousTorque::viscousTorque(const dictionary& dict, forceNeeds& needs)
:
    grainForce(dict, needs),
    rho_(needs.quantity("rho")),
    nu_(needs.quantity("nu")),
    curlU_(needs.quantity("curlU"))
{
    needs.torque();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::viscousTorque::add(grainBatch& grains) const
{
    const lane& rho = *grains.fluid(rho_);
    const lane& nu = *grains.fluid(nu_);
    const lane* curlU = grains.fluid(curlU_);

    for (label i = 0; i < grainBatch::size; ++i)
    {
        grains.spinCoefficient[i] +=
            24*rho[i]*nu[i]*grains.volume[i]
           *sqr(grains.radius[i]/grains.particleDiameter[i]);

        // A grain turns slower than its particles by its coarse-graining factor, 2R/d
        for (direction k = 0; k < 3; ++k)
        {
            grains.fluidSpin[k][i] =
                0.25*curlU[k][i]*grains.particleDiameter[i]/grains.radius[i];
        }
    }
}


// ************************************************************************* //
