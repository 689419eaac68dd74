/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "heatTransfer.H"
#include "addToRunTimeSelectionTable.H"
#include "couplingEntries.H"
#include "physics/heat/lumped_temperature.h"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(heatTransfer, 0);
    addToRunTimeSelectionTable(grainForce, heatTransfer, dictionary);
    const knownEntries::ofModel entriesOfHeatTransfer
    (
        grainForce::typeName_(),
        heatTransfer::typeName_(),
        {
            {"model", knownEntries::rule(heatTransfer::laws())},
            {"recovery", knownEntries::valueType::SWITCH}
        }
    );
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

struct namedLaw
{
    const char* name;
    grainjet::heat::NusseltLaw law;
};

const namedLaw lawTable[] =
{
    {"RanzMarshall", grainjet::heat::ranzMarshall},
    {"Gunn", grainjet::heat::gunn},
    {"Whitaker", grainjet::heat::whitaker}
};


// Of a name that is known
grainjet::heat::NusseltLaw lawOf(const Foam::word& name)
{
    for (const namedLaw& entry : lawTable)
    {
        if (name == entry.name)
        {
            return entry.law;
        }
    }
    return nullptr;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::heatTransfer::viscosityConstant
(
    const dictionary& dict,
    const fvMesh& mesh
)
{
    const auto& thermo = mesh.lookupObject<IOdictionary>("thermophysicalProperties");
    const dictionary& type = thermo.subOrEmptyDict("thermoType");
    const word mixture(type.lookupOrDefault<word>("mixture", word::null));
    const word transport(type.lookupOrDefault<word>("transport", word::null));

    couplingEntries::onMaster
    (
        [&]()
        {
            if (mixture != "pureMixture" || (transport != "const" && transport != "sutherland"))
            {
                FatalIOErrorInEntry(dict, "model")
                    << "model Whitaker needs the viscosity of the gas at the temperature of the particles,"
                    << " which is known for mixture pureMixture with transport const or sutherland, but"
                    << " thermoType in constant/thermophysicalProperties has mixture " << mixture
                    << " and transport " << transport << ". Set model RanzMarshall or Gunn"
                    << exit(FatalIOError);
            }
        }
    );
    return
        transport == "sutherland"
      ? thermo.subDict("mixture").subDict("transport").get<scalar>("Ts")
      : -1;
}


Foam::scalar Foam::heatTransfer::viscosityRatio(const scalar T, const scalar Ts) const
{
    // Sutherland's viscosity, proportional to sqrt(T)/(1 + S/T)
    return
        Sutherland_ < 0
      ? 1
      : std::sqrt(T/Ts)*(1 + Sutherland_/Ts)/(1 + Sutherland_/T);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::heatTransfer::heatTransfer(const dictionary& dict, forceNeeds& needs)
:
    grainForce(dict, needs),
    model_(dict.lookupOrDefault<word>("model", lawTable[0].name)),
    law_(lawOf(model_)),
    recovery_(dict.lookupOrDefault<Switch>("recovery", true)),
    Sutherland_
    (
        law_ == grainjet::heat::whitaker && needs.fluid().compressible()
      ? viscosityConstant(dict, needs.mesh()) : -1
    ),
    cp_(needs.quantity("specificHeat")),
    kappa_(needs.quantity("conductivity")),
    T_(needs.quantity("T")),
    rho_(needs.quantity("rho")),
    nu_(needs.quantity("nu")),
    voidFraction_(needs.quantity("voidFraction"))
{
    needs.heat();
}


// * * * * * * * * * * * * * * * Static Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::heatTransfer::laws()
{
    wordList names;
    for (const namedLaw& entry : lawTable)
    {
        names.append(entry.name);
    }
    return names;
}


bool Foam::heatTransfer::acts(const dictionary& coupling)
{
    return
        coupling.isDict("forces")
      ? coupling.subDict("forces").found(typeName)
      : coupling.lookupOrDefault<wordList>("forces", wordList()).found(typeName);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::heatTransfer::summary() const
{
    return model_ + (recovery_ ? "" : ", without recovery temperature");
}


void Foam::heatTransfer::add(grainBatch& grains) const
{
    const lane& T = *grains.fluid(T_);
    const lane& cp = *grains.fluid(cp_);
    const lane& kappa = *grains.fluid(kappa_);
    const lane& rho = *grains.fluid(rho_);
    const lane& nu = *grains.fluid(nu_);
    const lane& voidFraction = *grains.fluid(voidFraction_);

    for (label i = 0; i < grainBatch::size; ++i)
    {
        const scalar slip =
            mag(grainBatch::get(grains.fluidVelocity, i) - grainBatch::get(grains.velocity, i));
        const scalar d = grains.particleDiameter[i];
        const scalar Pr = nu[i]*rho[i]*cp[i]/kappa[i];
        const scalar Nu = law_
        (
            grainjet::heat::State
            {
                voidFraction[i], slip, d, nu[i], Pr, viscosityRatio(T[i], grains.temperature[i])
            }
        );
        grains.heatTransferCoefficient[i] =
            Nu*kappa[i]*constant::mathematical::pi*d*grains.particles[i];
        grains.undisturbedTemperature[i] = T[i];
        grains.fluidTemperature[i] =
            recovery_ ? grainjet::heat::recoveryTemperature(T[i], slip, cp[i], Pr) : T[i];
    }
}


// ************************************************************************* //
