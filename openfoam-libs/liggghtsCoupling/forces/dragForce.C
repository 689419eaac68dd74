/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dragForce.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(dragForce, 0);
    addToRunTimeSelectionTable(grainForce, dragForce, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dragForce::dragForce(const dictionary& dict, forceNeeds& needs)
:
    grainForce(dict, needs, checkedElsewhere()),
    law_(dragLaw::New(dict, needs)),
    wake_(selfDisturbance::New(needs))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::dragForce::summary() const
{
    return law_->type() + (wake_ ? wake_->summary() : string());
}


void Foam::dragForce::prepare()
{
    if (wake_)
    {
        wake_->prepare();
    }
}


void Foam::dragForce::add(grainBatch& grains) const
{
    if (wake_)
    {
        wake_->correct(grains);
    }

    lane slipSpeed;
    for (label i = 0; i < grainBatch::size; ++i)
    {
        scalar sqr = 0;
        for (direction k = 0; k < 3; ++k)
        {
            const scalar slip = grains.fluidVelocity[k][i] - grains.velocity[k][i];
            sqr += slip*slip;
        }
        slipSpeed[i] = std::sqrt(sqr);
    }

    lane coefficient;
    law_->coefficient(grains, slipSpeed, coefficient);

    for (label i = 0; i < grainBatch::size; ++i)
    {
        grains.Sp[i] += coefficient[i]*grains.volume[i];
    }
}


void Foam::dragForce::remember(grainBatch& grains) const
{
    if (wake_)
    {
        wake_->remember(grains);
    }
}


// ************************************************************************* //
