/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "liggghtsCloud.H"
#include "IOField.H"
#include "mathematicalConstants.H"
#include "fluid-force/fluid_force_exchange.h"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

void copy
(
    Foam::UList<Foam::vector>& to,
    const Foam::liggghtsSession::rows<3>& from
)
{
    forAll(to, i)
    {
        to[i] = Foam::vector(from[i][0], from[i][1], from[i][2]);
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::liggghtsCloud::liggghtsCloud(const objectRegistry& mesh)
:
    cloud(mesh, "liggghts"),
    session_(nullptr)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::liggghtsCloud::nParcels() const
{
    return session_ ? session_->grains().n : 0;
}


void Foam::liggghtsCloud::writeObjects(objectRegistry& obr) const
{
    if (!session_)
    {
        return;
    }
    const liggghtsSession::grainArrays grains = session_->grains();
    const label n = grains.n;

    copy(createIOField<point>("position", n, obr), grains.position);
    copy
    (
        createIOField<point>("positionOld", n, obr),
        session_->fluidForces().startPosition
    );
    copy(createIOField<vector>("U", n, obr), grains.velocity);

    auto& d = createIOField<scalar>("d", n, obr);
    auto& rho = createIOField<scalar>("rho", n, obr);
    auto& nParticle = createIOField<scalar>("nParticle", n, obr);
    auto& origId = createIOField<label>("origId", n, obr);
    createIOField<label>("origProc", n, obr) = 0;

    for (label i = 0; i < n; ++i)
    {
        d[i] = 2*grains.radius[i];
        rho[i] = grains.mass[i]/(constant::mathematical::pi/6*pow3(d[i]));
        nParticle[i] = pow3(grains.cg[grains.type[i]]);
        origId[i] = grains.id[i];
    }
    if (session_->hasHeat())
    {
        const double* temperature = session_->heats().temperature;
        auto& T = createIOField<scalar>("T", n, obr);
        for (label i = 0; i < n; ++i)
        {
            T[i] = temperature[i];
        }
    }
}


// ************************************************************************* //
