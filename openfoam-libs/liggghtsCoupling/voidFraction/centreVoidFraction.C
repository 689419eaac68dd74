/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "centreVoidFraction.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(centreVoidFraction, 0);
    addToRunTimeSelectionTable(voidFractionModel, centreVoidFraction, dictionary);
    const knownEntries::ofModel centreEntries
    (
        voidFractionModel::typeName_(), centreVoidFraction::typeName_()
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::centreVoidFraction::centreVoidFraction
(
    const dictionary& dict,
    const cellLocator& locator
)
:
    voidFractionModel(dict, locator)
{}


// ************************************************************************* //
