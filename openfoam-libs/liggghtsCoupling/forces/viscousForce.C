/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "viscousForce.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(viscousForce, 0);
    addToRunTimeSelectionTable(grainForce, viscousForce, dictionary);
    const knownEntries::ofModel entriesOfViscousForce
    (
        grainForce::typeName_(), viscousForce::typeName_()
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::viscousForce::viscousForce(const dictionary& dict, forceNeeds& needs)
:
    grainForce(dict, needs),
    divTau_(needs.quantity("divTau")),
    reacts_(needs.stressReacts()),
    quantities_(needs.quantities())
{
    if (!reacts_)
    {
        needs.nonReacting();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::viscousForce::add(grainBatch& grains) const
{
    const lane* divTau = grains.fluid(divTau_);
    lane* Su = reacts_ ? grains.Su : grains.nonReactingSu;

    // The loop over grains is the outer one: g++ makes a fifth of the instructions of it
    for (label i = 0; i < grainBatch::size; ++i)
    {
        for (direction k = 0; k < 3; ++k)
        {
            Su[k][i] += grains.volume[i]*divTau[k][i];
        }
    }
}


Foam::vector Foam::viscousForce::stressDensity(const label celli) const
{
    return quantities_.vectorField(divTau_)[celli];
}



// ************************************************************************* //
