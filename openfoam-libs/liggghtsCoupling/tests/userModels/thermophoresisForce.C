/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "thermophoresisForce.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(thermophoresisForce, 0);
    addToRunTimeSelectionTable(grainForce, thermophoresisForce, dictionary);

    const knownEntries::ofModel entriesOfThermophoresis
    (
        grainForce::typeName_(),
        thermophoresisForce::typeName_(),
        {
            {
                "K",
                knownEntries::rule(0, 10, knownEntries::REQUIRED)
               .means("the thermophoretic coefficient").like("0.5")
            }
        }
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::thermophoresisForce::thermophoresisForce
(
    const dictionary& dict,
    forceNeeds& needs
)
:
    grainForce(dict, needs),
    K_(dict.get<scalar>("K")),
    rho_(needs.quantity("rho")),
    nu_(needs.quantity("nu")),
    T_(needs.quantity("T")),
    gradT_(needs.quantity("gradT"))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::thermophoresisForce::add(grainBatch& grains) const
{
    const lane& rho = *grains.fluid(rho_);
    const lane& nu = *grains.fluid(nu_);
    const lane& T = *grains.fluid(T_);
    const lane* gradT = grains.fluid(gradT_);

    for (label i = 0; i < grainBatch::size; ++i)
    {
        const scalar factor =
            grains.particles[i]*K_*grains.particleDiameter[i]*rho[i]*sqr(nu[i])/T[i];

        for (direction k = 0; k < 3; ++k)
        {
            grains.Su[k][i] -= factor*gradT[k][i];
        }
    }
}


// ************************************************************************* //
