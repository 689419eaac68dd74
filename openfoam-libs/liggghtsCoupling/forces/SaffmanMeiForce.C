/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "SaffmanMeiForce.H"
#include "addToRunTimeSelectionTable.H"
#include "physics/lift/saffman_mei.h"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(SaffmanMeiForce, 0);
    addToRunTimeSelectionTable(grainForce, SaffmanMeiForce, dictionary);
    const knownEntries::ofModel entriesOfSaffmanMeiForce
    (
        grainForce::typeName_(), SaffmanMeiForce::typeName_()
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::SaffmanMeiForce::SaffmanMeiForce(const dictionary& dict, forceNeeds& needs)
:
    liftForce(dict, needs),
    rho_(needs.quantity("rho")),
    nu_(needs.quantity("nu")),
    curlU_(needs.quantity("curlU"))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::SaffmanMeiForce::add(grainBatch& grains) const
{
    const lane& rho = *grains.fluid(rho_);
    const lane& nu = *grains.fluid(nu_);
    const lane* curlU = grains.fluid(curlU_);

    lane L[3];
    for (label i = 0; i < grainBatch::size; ++i)
    {
        const vector slip
        (
            grainBatch::get(grains.fluidVelocity, i) - grainBatch::get(grains.velocity, i)
        );
        const vector w(grainBatch::get(curlU, i));
        const scalar S = grainjet::lift::saffmanMei
        (
            grains.particleDiameter[i], rho[i], nu[i], mag(slip), mag(w)
        );
        for (direction k = 0; k < 3; ++k)
        {
            L[k][i] = S*w[k];
        }
    }
    addLift(grains, L);
}


// ************************************************************************* //
