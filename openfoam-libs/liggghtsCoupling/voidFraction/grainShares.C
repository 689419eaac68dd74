/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainShares.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::grainShares::grainShares(const cellLocator& locator)
:
    locator_(locator),
    route_(locator.mesh())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::grainShares::clear()
{
    shares_.clear();
    late_.clear();
    remoteParts_.clear();
    firstRank_.clear();
    remote_.clear();
}


// ************************************************************************* //
