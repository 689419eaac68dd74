/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The quantities of a gas that follow from its thermodynamics, see fluidQuantity.H.

\*---------------------------------------------------------------------------*/

#include "fluidQuantity.H"
#include "addToRunTimeSelectionTable.H"
#include "gasThermo.H"
#include "releases.H"

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

class gasQuantity
:
    public fluidQuantity
{
protected:

    //- The thermodynamics of the solver
    const basicThermo& thermo() const
    {
        return gasThermo::of(fluid_.mesh());
    }


public:

    using fluidQuantity::fluidQuantity;

    virtual bool isVector() const override
    {
        return false;
    }
    virtual bool ofCell() const override
    {
        return true;
    }
};


//- One of drag laws that know the Mach number
class machQuantity
:
    public gasQuantity
{
public:

    using gasQuantity::gasQuantity;

    virtual string missing() const override
    {
        return
            fluid_.compressible()
          ? string()
          : string
            (
                "the solver's fluid has no speed of sound. Take a solver of a gas, such as rhoPimpleFoam,"
                " or a drag law without Mach number"
            );
    }
};


//- One of heat
class heatQuantity
:
    public gasQuantity
{
public:

    using gasQuantity::gasQuantity;

    virtual string missing() const override
    {
        return
            fluid_.compressible()
          ? string()
          : string
            (
                "the solver has no thermodynamics: it has not read constant/thermophysicalProperties. Take"
                " rhoPimpleFoam, sonicFoam or buoyantPimpleFoam"
            );
    }
};


struct heatCapacityRatioQuantity
:
    public machQuantity
{
    TypeName("gamma");
    using machQuantity::machQuantity;

    virtual tmp<volScalarField> scalarField() const override
    {
        return thermo().gamma();
    }
};


struct speedOfSoundQuantity
:
    public machQuantity
{
    TypeName("speedOfSound");
    using machQuantity::machQuantity;

    // Compressibility at constant temperature [s2/m2]
    const volScalarField& psi() const
    {
        return fluid_.mesh().lookupObject<volScalarField>(releases::ofThermo("psi"));
    }

    virtual string missing() const override
    {
        const string noGas(machQuantity::missing());
        if (!noGas.empty() || gMin(psi().primitiveField()) > 0)
        {
            return noGas;
        }
        return
            "the equationOfState in constant/thermophysicalProperties is that of a fluid whose density"
            " does not depend on pressure, so it has no speed of sound. Take perfectGas, or a drag law"
            " without Mach number";
    }

    // (dp/drho) at constant entropy is gamma times that at constant temperature, in any fluid
    virtual tmp<volScalarField> scalarField() const override
    {
        return sqrt(thermo().gamma()/psi());
    }
};


struct specificHeatQuantity
:
    public heatQuantity
{
    TypeName("specificHeat");
    using heatQuantity::heatQuantity;

    virtual tmp<volScalarField> scalarField() const override
    {
        return thermo().Cp();
    }
};


struct conductivityQuantity
:
    public heatQuantity
{
    TypeName("conductivity");
    using heatQuantity::heatQuantity;

    virtual tmp<volScalarField> scalarField() const override
    {
        return thermo().kappa();
    }
};

#define makeGasQuantity(Class)                                                \
    defineTypeNameAndDebug(Class, 0);                                         \
    addToRunTimeSelectionTable(fluidQuantity, Class, dictionary);

makeGasQuantity(heatCapacityRatioQuantity)
makeGasQuantity(speedOfSoundQuantity)
makeGasQuantity(specificHeatQuantity)
makeGasQuantity(conductivityQuantity)

} // End anonymous namespace
} // End namespace Foam


// ************************************************************************* //
