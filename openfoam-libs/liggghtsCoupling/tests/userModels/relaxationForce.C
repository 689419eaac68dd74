/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "relaxationForce.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(relaxationForce, 0);
    addToRunTimeSelectionTable(grainForce, relaxationForce, dictionary);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::relaxationForce::relaxationForce(const dictionary& dict, forceNeeds& needs)
:
    grainForce
    (
        dict,
        needs,
        {
            {"time", {knownEntries::valueType::POSITIVE, knownEntries::REQUIRED}},
            {"reaction", knownEntries::valueType::SWITCH}
        }
    ),
    time_(dict.get<scalar>("time")),
    reacts_(dict.lookupOrDefault<Switch>("reaction", true))
{
    if (!reacts_)
    {
        needs.nonReacting();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::relaxationForce::add(grainBatch& grains) const
{
    lane& Sp = reacts_ ? grains.Sp : grains.nonReactingSp;

    for (label i = 0; i < grainBatch::size; ++i)
    {
        Sp[i] += grains.mass[i]/time_;
    }
}


// ************************************************************************* //
