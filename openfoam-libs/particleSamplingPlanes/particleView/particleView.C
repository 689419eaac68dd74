/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "particleView.H"
#include "cloudParticleView.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(particleView, 0);
    defineRunTimeSelectionTable(particleView, cloud);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::particleView::particleView(const fvMesh& mesh, const word& cloudName)
:
    mesh_(mesh),
    cloudName_(cloudName),
    deltaT_(mesh.time().deltaTValue())
{}


// * * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::particleView> Foam::particleView::New
(
    const fvMesh& mesh,
    const word& cloudName
)
{
    if (cloudConstructorTablePtr_)
    {
        auto cstrIter = cloudConstructorTablePtr_->cfind(cloudName);

        if (cstrIter.found())
        {
            return cstrIter()(mesh, cloudName);
        }
    }

    return autoPtr<particleView>(new cloudParticleView(mesh, cloudName));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::particleView::mass(const label i) const
{
    return
        now_.nParticle[i]*now_.rho[i]
       *constant::mathematical::pi/6*pow3(diameter(i));
}


// ************************************************************************* //
