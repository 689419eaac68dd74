/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "MagnusForce.H"
#include "addToRunTimeSelectionTable.H"
#include "fluidTorqueForce.H"
#include "physics/lift/magnus.h"
#include "physics/lift/spin_torque.h"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(MagnusForce, 0);
    addToRunTimeSelectionTable(grainForce, MagnusForce, dictionary);
    const knownEntries::ofModel entriesOfMagnusForce
    (
        grainForce::typeName_(), MagnusForce::typeName_()
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::MagnusForce::MagnusForce(const dictionary& dict, forceNeeds& needs)
:
    liftForce(dict, needs),
    needs_(needs),
    rho_(needs.quantity("rho")),
    nu_(needs.quantity("nu")),
    curlU_(needs.quantity("curlU")),
    decays_(false),
    first_(true)
{
    needs.spin();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::MagnusForce::prepare()
{
    liftForce::prepare();

    decays_ = needs_.requests().torque;
    if (first_ && !decays_)
    {
        IOWarningInFunction(dict_)
            << "forces: Magnus without fluidTorque. The spin that contacts give to grains never"
            << " decays, and a shear flow never turns them. Add fluidTorque {}" << endl;
    }
    first_ = false;
}


void Foam::MagnusForce::add(grainBatch& grains) const
{
    const lane& rho = *grains.fluid(rho_);
    const lane& nu = *grains.fluid(nu_);
    const lane* curlU = grains.fluid(curlU_);
    const scalar interval = fluid_.interval();

    lane L[3];
    for (label i = 0; i < grainBatch::size; ++i)
    {
        const scalar d = grains.particleDiameter[i];
        const vector slip
        (
            grainBatch::get(grains.fluidVelocity, i) - grainBatch::get(grains.velocity, i)
        );

        // Per particle: a grain turns slower by its coarse-graining factor
        vector W
        (
            0.5*grainBatch::get(curlU, i)
          - (2*grains.radius[i]/d)*grainBatch::get(grains.spin, i)
        );
        if (decays_)
        {
            const scalar elapsed = fluidTorqueForce::slowRate(grains, i, rho[i]*nu[i])*interval;
            const scalar f =
                grainjet::lift::meanSpinTorqueFactor(mag(W)*sqr(d)/nu[i], elapsed);
            W *= grainjet::lift::meanOfDecay(f*elapsed);
        }

        const scalar M = grainjet::lift::magnus(d, rho[i], nu[i], mag(slip), mag(W));
        for (direction k = 0; k < 3; ++k)
        {
            // W x slip = slip x (-W)
            L[k][i] = -M*W[k];
        }
    }
    addLift(grains, L);
}


// ************************************************************************* //
