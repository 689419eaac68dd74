/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Scales of turbulence, and their gradients, from any model that has a field k. See
    fluidQuantity.H.

    The rms speed keeps the values of k on boundaries: it vanishes at a wall where k does, and is
    that of the cell where a wall function says so. A time scale has no meaning on a boundary: it is that
    of the cell. Gradients use the scheme of grad(k).

\*---------------------------------------------------------------------------*/

#include "fluidQuantity.H"
#include "addToRunTimeSelectionTable.H"
#include "fvcGrad.H"
#include "turbulenceModel.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

const char* const gradientScheme = "grad(k)";


// Below this k [m2/s2] there is no turbulence, and time scales are finite
const scalar noEnergy = 1e-15;


class ofTurbulence
:
    public fluidQuantity
{
protected:

    const volScalarField& k() const
    {
        return fluid_.mesh().lookupObject<volScalarField>("k");
    }

    tmp<volScalarField> speed() const
    {
        return sqrt((2.0/3.0)*max(k(), dimensionedScalar(k().dimensions(), Zero)));
    }

    tmp<volScalarField> time() const
    {
        tmp<volScalarField> tresult
        (
            new volScalarField
            (
                IOobject
                (
                    "turbulentTime",
                    k().time().timeName(),
                    fluid_.mesh(),
                    IOobject::NO_READ,
                    IOobject::NO_WRITE,
                    false
                ),
                fluid_.mesh(),
                dimensionedScalar(dimTime, Zero),
                zeroGradientFvPatchScalarField::typeName
            )
        );
        const tmp<volScalarField> tnut(fluid_.model()->nut());
        tresult.ref().primitiveFieldRef() =
            1.5*tnut().primitiveField()/max(k().primitiveField(), noEnergy);
        tresult.ref().correctBoundaryConditions();
        return tresult;
    }


public:

    using fluidQuantity::fluidQuantity;

    virtual bool isVector() const override
    {
        return false;
    }
    virtual string missing() const override
    {
        return noTurbulence("k");
    }
};


class gradientOfTurbulence
:
    public ofTurbulence
{
public:

    using ofTurbulence::ofTurbulence;

    virtual bool isVector() const override
    {
        return true;
    }
};


struct energyGradientQuantity
:
    public gradientOfTurbulence
{
    TypeName("gradK");
    using gradientOfTurbulence::gradientOfTurbulence;

    virtual tmp<volVectorField> vectorField() const override
    {
        return fvc::grad(k(), gradientScheme);
    }
};


struct turbulentSpeedQuantity
:
    public ofTurbulence
{
    TypeName("turbulentSpeed");
    using ofTurbulence::ofTurbulence;

    virtual bool hasBoundaryValues() const override
    {
        return true;
    }
    virtual tmp<volScalarField> scalarField() const override
    {
        return speed();
    }
};


struct speedGradientQuantity
:
    public gradientOfTurbulence
{
    TypeName("gradTurbulentSpeed");
    using gradientOfTurbulence::gradientOfTurbulence;

    virtual tmp<volVectorField> vectorField() const override
    {
        return fvc::grad(speed(), gradientScheme);
    }
};


struct turbulentTimeQuantity
:
    public ofTurbulence
{
    TypeName("turbulentTime");
    using ofTurbulence::ofTurbulence;

    virtual tmp<volScalarField> scalarField() const override
    {
        return time();
    }
};


struct timeGradientQuantity
:
    public gradientOfTurbulence
{
    TypeName("gradTurbulentTime");
    using gradientOfTurbulence::gradientOfTurbulence;

    virtual tmp<volVectorField> vectorField() const override
    {
        return fvc::grad(time(), gradientScheme);
    }
};


struct dissipationTimeQuantity
:
    public ofTurbulence
{
    TypeName("dissipationTime");
    using ofTurbulence::ofTurbulence;

    virtual tmp<volScalarField> scalarField() const override
    {
        const tmp<volScalarField> tepsilon(fluid_.model()->epsilon());
        return
            max(k(), dimensionedScalar("k", k().dimensions(), noEnergy))
           /max(tepsilon, dimensionedScalar("epsilon", k().dimensions()/dimTime, noEnergy));
    }
};

#define makeFluidQuantity(Class)                                              \
    defineTypeNameAndDebug(Class, 0);                                         \
    addToRunTimeSelectionTable(fluidQuantity, Class, dictionary);

makeFluidQuantity(energyGradientQuantity)
makeFluidQuantity(turbulentSpeedQuantity)
makeFluidQuantity(speedGradientQuantity)
makeFluidQuantity(turbulentTimeQuantity)
makeFluidQuantity(timeGradientQuantity)
makeFluidQuantity(dissipationTimeQuantity)

} // End anonymous namespace
} // End namespace Foam


// ************************************************************************* //
