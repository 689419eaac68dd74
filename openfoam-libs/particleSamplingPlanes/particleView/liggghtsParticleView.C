/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "liggghtsParticleView.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(liggghtsParticleView, 0);
    addToRunTimeSelectionTable(particleView, liggghtsParticleView, cloud);
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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::liggghtsParticleView::diameter(const label i) const
{
    return now_.d[i]/cbrt(now_.nParticle[i]);
}


// ************************************************************************* //
