/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "scaledStokesDrag.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(scaledStokesDrag, 0);
    addToRunTimeSelectionTable(dragLaw, scaledStokesDrag, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::scaledStokesDrag::scaledStokesDrag
(
    const dictionary& dict,
    forceNeeds& needs
)
:
    dragLaw
    (
        dict,
        {{"factor", {knownEntries::valueType::POSITIVE, knownEntries::REQUIRED}}}
    ),
    factor_(dict.get<scalar>("factor")),
    rho_(needs.quantity("rho")),
    nu_(needs.quantity("nu"))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::scaledStokesDrag::coefficient
(
    const grainBatch& grains,
    const lane& slipSpeed,
    lane& coefficient
) const
{
    const lane& rho = *grains.fluid(rho_);
    const lane& nu = *grains.fluid(nu_);

    for (label i = 0; i < grainBatch::size; ++i)
    {
        coefficient[i] = factor_*18*rho[i]*nu[i]/sqr(grains.particleDiameter[i]);
    }
}


// ************************************************************************* //
