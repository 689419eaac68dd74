/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "liggghtsParticleView.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(liggghtsParticleView, 0);
    addToRunTimeSelectionTable(particleView, liggghtsParticleView, cloud);
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::liggghtsParticleView::particleDiameter
(
    const scalar d,
    const scalar nParticle
) const
{
    return d/cbrt(nParticle);
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
