/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "liggghtsParticleView.H"
#include "mathematicalConstants.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(liggghtsParticleView, 0);
    addToRunTimeSelectionTable(particleView, liggghtsParticleView, cloud);
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::liggghtsParticleView::parcelMass
(
    const scalar d,
    const scalar rho,
    const scalar
) const
{
    return rho*constant::mathematical::pi/6*pow3(d);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::liggghtsParticleView::liggghtsParticleView
(
    const fvMesh& mesh,
    const word& cloudName
)
:
    cloudParticleView(mesh, cloudName)
{}


// ************************************************************************* //
