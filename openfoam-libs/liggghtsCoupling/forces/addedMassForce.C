/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "addedMassForce.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(addedMassForce, 0);
    addToRunTimeSelectionTable(grainForce, addedMassForce, dictionary);
    const knownEntries::ofModel entriesOfAddedMassForce
    (
        grainForce::typeName_(),
        addedMassForce::typeName_(),
        {
            {
                "C",
                knownEntries::rule(1e-6, 100)
               .means("coefficient of added mass, 0.5 for a sphere").like("0.5")
            }
        }
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::addedMassForce::addedMassForce(const dictionary& dict, forceNeeds& needs)
:
    grainForce(dict, needs),
    C_(dict.lookupOrDefault<scalar>("C", 0.5)),
    rho_(needs.quantity("rho")),
    DUDt_(needs.quantity("DUDt"))
{
    needs.addedMass();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::addedMassForce::summary() const
{
    return "C " + name(C_);
}


void Foam::addedMassForce::add(grainBatch& grains) const
{
    const lane& rho = *grains.fluid(rho_);
    const lane* DUDt = grains.fluid(DUDt_);

    lane mass;
    for (label i = 0; i < grainBatch::size; ++i)
    {
        mass[i] = C_*rho[i]*grains.volume[i];
        grains.addedMass[i] += mass[i];
    }
    for (direction k = 0; k < 3; ++k)
    {
        for (label i = 0; i < grainBatch::size; ++i)
        {
            grains.Su[k][i] += mass[i]*DUDt[k][i];
        }
    }
}


// ************************************************************************* //
