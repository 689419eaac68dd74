/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The quantities of a gas that follow from its thermodynamics, see fluidQuantity.H.

\*---------------------------------------------------------------------------*/

#include "fluidQuantity.H"
#include "addToRunTimeSelectionTable.H"
#include "basicThermo.H"
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

    //- The thermodynamics of the solver. A static cast, since the type information of basicThermo lies in
    //  a library that solvers of an incompressible fluid do not load
    const basicThermo& thermo() const
    {
        return static_cast<const basicThermo&>
        (
            fluid_.mesh().lookupObject<IOdictionary>("thermophysicalProperties")
        );
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


struct heatCapacityRatioQuantity
:
    public gasQuantity
{
    TypeName("gamma");
    using gasQuantity::gasQuantity;

    virtual tmp<volScalarField> scalarField() const override
    {
        return thermo().gamma();
    }
};


struct speedOfSoundQuantity
:
    public gasQuantity
{
    TypeName("speedOfSound");
    using gasQuantity::gasQuantity;

    // Compressibility at constant temperature [s2/m2]
    const volScalarField& psi() const
    {
        return fluid_.mesh().lookupObject<volScalarField>(releases::ofThermo("psi"));
    }

    virtual string missing() const override
    {
        const string noGas(gasQuantity::missing());
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

#define makeGasQuantity(Class)                                                \
    defineTypeNameAndDebug(Class, 0);                                         \
    addToRunTimeSelectionTable(fluidQuantity, Class, dictionary);

makeGasQuantity(heatCapacityRatioQuantity)
makeGasQuantity(speedOfSoundQuantity)

} // End anonymous namespace
} // End namespace Foam


// ************************************************************************* //
