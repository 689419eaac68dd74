/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluidTorqueForce.H"
#include "addToRunTimeSelectionTable.H"
#include "physics/lift/spin_torque.h"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(fluidTorqueForce, 0);
    addToRunTimeSelectionTable(grainForce, fluidTorqueForce, dictionary);
    const knownEntries::ofModel entriesOfFluidTorqueForce
    (
        grainForce::typeName_(), fluidTorqueForce::typeName_()
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fluidTorqueForce::fluidTorqueForce(const dictionary& dict, forceNeeds& needs)
:
    grainForce(dict, needs),
    rho_(needs.quantity("rho")),
    nu_(needs.quantity("nu")),
    curlU_(needs.quantity("curlU"))
{
    needs.torque();
    needs.spin();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fluidTorqueForce::add(grainBatch& grains) const
{
    const lane& rho = *grains.fluid(rho_);
    const lane& nu = *grains.fluid(nu_);
    const lane* curlU = grains.fluid(curlU_);
    const scalar interval = fluid_.interval();

    for (label i = 0; i < grainBatch::size; ++i)
    {
        const scalar d = grains.particleDiameter[i];
        const scalar f_cg = 2*grains.radius[i]/d;
        const vector fluidSpin((0.5/f_cg)*grainBatch::get(curlU, i));
        const scalar W = f_cg*mag(fluidSpin - grainBatch::get(grains.spin, i));

        const scalar rate = slowRate(grains, i, rho[i]*nu[i]);
        const scalar f =
            grainjet::lift::meanSpinTorqueFactor(W*sqr(d)/nu[i], rate*interval);

        grains.spinCoefficient[i] += f*rate*inertia(grains, i);
        for (direction k = 0; k < 3; ++k)
        {
            grains.fluidSpin[k][i] = fluidSpin[k];
        }
    }
}


// ************************************************************************* //
