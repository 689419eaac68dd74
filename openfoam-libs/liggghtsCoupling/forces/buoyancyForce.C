/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "buoyancyForce.H"
#include "addToRunTimeSelectionTable.H"
#include "couplingEntries.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(buoyancyForce, 0);
    addToRunTimeSelectionTable(grainForce, buoyancyForce, dictionary);
    const knownEntries::ofModel entriesOfBuoyancyForce
    (
        grainForce::typeName_(), buoyancyForce::typeName_()
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::buoyancyForce::buoyancyForce(const dictionary& dict, forceNeeds& needs)
:
    grainForce(dict, needs),
    rho_(needs.quantity("rho"))
{
    needs.nonReacting();
    if (fluid_.holdsHydrostatic())
    {
        couplingEntries::onMaster
        (
            [&]()
            {
                FatalIOErrorInFunction(dict)
                    << "forces: the pressure of this solver holds the hydrostatic part, so that"
                    << " pressureGradient holds buoyancy. Take buoyancy out, and use"
                    << " pressureGradient" << exit(FatalIOError);
            }
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::buoyancyForce::prepare()
{
    if (!fluid_.hasGravity())
    {
        couplingEntries::onMaster
        (
            [&]()
            {
                FatalIOErrorInFunction(dict_)
                    << "forces: buoyancy needs gravity, but the input script of LIGGGHTS"
                    << " has no fix gravity. Add it there, for instance\n"
                    << "    fix g all gravity 9.81 vector 0 0 -1\n"
                    << "or take buoyancy out" << exit(FatalIOError);
            }
        );
    }
}


void Foam::buoyancyForce::add(grainBatch& grains) const
{
    const lane& rho = *grains.fluid(rho_);
    const vector& g = fluid_.g();

    for (direction k = 0; k < 3; ++k)
    {
        for (label i = 0; i < grainBatch::size; ++i)
        {
            grains.nonReactingSu[k][i] -= grains.volume[i]*rho[i]*g[k];
        }
    }
}



// ************************************************************************* //
