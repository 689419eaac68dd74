/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "pressureGradientForce.H"
#include "addToRunTimeSelectionTable.H"
#include "turbulenceField.H"
#include "voidFractionEquations.H"
#include "volFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(pressureGradientForce, 0);
    addToRunTimeSelectionTable(grainForce, pressureGradientForce, dictionary);
    const knownEntries::ofModel entriesOfPressureGradientForce
    (
        grainForce::typeName_(),
        pressureGradientForce::typeName_(),
        {{"turbulentPressure", knownEntries::valueType::SWITCH}}
    );
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::pressureGradientForce::holdsTurbulence(const fvMesh& mesh)
{
    return
        mesh.foundObject<volScalarField>("k")
     && mesh.foundObject<volScalarField>("nut")
     && !mesh.foundObject<volSymmTensorField>("R");
}


bool Foam::pressureGradientForce::withoutTurbulence
(
    const dictionary& dict,
    const carrierFluid& fluid
)
{
    const word key("turbulentPressure");
    const bool without = dict.lookupOrDefault<Switch>(key, holdsTurbulence(fluid.mesh()));
    if (without)
    {
        turbulenceField::require
        (
            fluid,
            "k",
            dict,
            key,
            "pressureGradient with turbulentPressure yes",
            "turbulentPressure no"
        );
    }
    return without;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::pressureGradientForce::pressureGradientForce
(
    const dictionary& dict,
    forceNeeds& needs
)
:
    grainForce(dict, needs),
    gradP_(needs.quantity("gradP")),
    turbulent_(withoutTurbulence(dict, needs.fluid())),
    rho_(turbulent_ ? needs.quantity("rho") : -1),
    gradK_(turbulent_ ? needs.quantity("gradK") : -1),
    weight_
    (
        needs.fluid().holdsHydrostatic() && !voidFractionEquations::full(needs.coupling())
      ? needs.quantity("fluidWeight")
      : -1
    ),
    reacts_(needs.stressReacts()),
    quantities_(needs.quantities())
{
    if (!reacts_ || weight_ >= 0)
    {
        needs.nonReacting();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::pressureGradientForce::summary() const
{
    return turbulent_ ? "without 2k/3" : "";
}


void Foam::pressureGradientForce::add(grainBatch& grains) const
{
    const lane* gradP = grains.fluid(gradP_);
    lane* Su = reacts_ ? grains.Su : grains.nonReactingSu;

    // The loop over grains is the outer one: g++ makes a fifth of the instructions of it
    for (label i = 0; i < grainBatch::size; ++i)
    {
        for (direction k = 0; k < 3; ++k)
        {
            Su[k][i] -= grains.volume[i]*gradP[k][i];
        }
    }

    if (reacts_ && weight_ >= 0)
    {
        const lane* weight = grains.fluid(weight_);
        for (direction k = 0; k < 3; ++k)
        {
            for (label i = 0; i < grainBatch::size; ++i)
            {
                Su[k][i] += grains.volume[i]*weight[k][i];
                grains.nonReactingSu[k][i] -= grains.volume[i]*weight[k][i];
            }
        }
    }

    if (turbulent_)
    {
        const lane& rho = *grains.fluid(rho_);
        const lane* gradK = grains.fluid(gradK_);
        for (direction k = 0; k < 3; ++k)
        {
            for (label i = 0; i < grainBatch::size; ++i)
            {
                Su[k][i] += grains.volume[i]*rho[i]*(2.0/3.0)*gradK[k][i];
            }
        }
    }
}


Foam::vector Foam::pressureGradientForce::stressDensity(const label celli) const
{
    vector gradient(quantities_.vectorField(gradP_)[celli]);
    if (turbulent_)
    {
        gradient -=
            quantities_.scalarField(rho_)[celli]*(2.0/3.0)
           *quantities_.vectorField(gradK_)[celli];
    }
    if (weight_ >= 0)
    {
        gradient -= quantities_.vectorField(weight_)[celli];
    }
    return -gradient;
}


// ************************************************************************* //
