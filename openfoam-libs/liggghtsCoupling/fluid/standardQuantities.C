/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The quantities of the fluid that have no state, see fluidQuantity.H.

\*---------------------------------------------------------------------------*/

#include "fluidQuantity.H"
#include "addToRunTimeSelectionTable.H"
#include "turbulenceModel.H"
#include "wallDist.H"

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

// A scalar or vector quantity whose field is one expression of the fluid
class scalarQuantity
:
    public fluidQuantity
{
public:

    using fluidQuantity::fluidQuantity;

    virtual bool isVector() const override
    {
        return false;
    }
};


// A field of the solver or of the coupling that has the quantity's name
class fieldQuantity
:
    public scalarQuantity
{
public:

    using scalarQuantity::scalarQuantity;

    virtual bool hasBoundaryValues() const override
    {
        return true;
    }
    virtual tmp<volScalarField> scalarField() const override
    {
        return fluid_.mesh().lookupObject<volScalarField>(type());
    }
};


class vectorQuantity
:
    public fluidQuantity
{
public:

    using fluidQuantity::fluidQuantity;

    virtual bool isVector() const override
    {
        return true;
    }
};


class ofCellQuantity
:
    public scalarQuantity
{
public:

    using scalarQuantity::scalarQuantity;

    virtual bool ofCell() const override
    {
        return true;
    }
};


struct velocityQuantity
:
    public vectorQuantity
{
    TypeName("U");
    using vectorQuantity::vectorQuantity;

    virtual bool hasBoundaryValues() const override
    {
        return true;
    }
    virtual tmp<volVectorField> vectorField() const override
    {
        return fluid_.velocity();
    }
};


struct voidFractionQuantity
:
    public fieldQuantity
{
    TypeName("voidFraction");
    using fieldQuantity::fieldQuantity;

    virtual bool changesWithGrains() const override
    {
        return true;
    }
};


struct densityQuantity
:
    public ofCellQuantity
{
    TypeName("rho");
    using ofCellQuantity::ofCellQuantity;

    virtual tmp<volScalarField> scalarField() const override
    {
        return fluid_.rho();
    }
};


struct viscosityQuantity
:
    public ofCellQuantity
{
    TypeName("nu");
    using ofCellQuantity::ofCellQuantity;

    virtual tmp<volScalarField> scalarField() const override
    {
        return fluid_.nu();
    }
};


struct effectiveViscosityQuantity
:
    public ofCellQuantity
{
    TypeName("nuEff");
    using ofCellQuantity::ofCellQuantity;

    virtual tmp<volScalarField> scalarField() const override
    {
        return fluid_.model() ? fluid_.nu() + fluid_.model()->nut() : fluid_.nu();
    }
};


struct pressureGradientQuantity
:
    public vectorQuantity
{
    TypeName("gradP");
    using vectorQuantity::vectorQuantity;

    virtual tmp<volVectorField> vectorField() const override
    {
        return fluid_.feltGradP();
    }
};


struct fluidWeightQuantity
:
    public vectorQuantity
{
    TypeName("fluidWeight");
    using vectorQuantity::vectorQuantity;

    virtual tmp<volVectorField> vectorField() const override
    {
        return fluid_.weight();
    }
};


struct viscousStressQuantity
:
    public vectorQuantity
{
    TypeName("divTau");
    using vectorQuantity::vectorQuantity;

    virtual tmp<volVectorField> vectorField() const override
    {
        return fluid_.feltDivTau();
    }
};


struct vorticityQuantity
:
    public vectorQuantity
{
    TypeName("curlU");
    using vectorQuantity::vectorQuantity;

    virtual tmp<volVectorField> vectorField() const override
    {
        // As fvc::curl does it
        return 2.0*(*skew(fluid_.gradVelocity("curl")));
    }
};


struct turbulentEnergyQuantity
:
    public fieldQuantity
{
    TypeName("k");
    using fieldQuantity::fieldQuantity;

    virtual string missing() const override
    {
        return noTurbulence("k");
    }
};


struct dissipationQuantity
:
    public fieldQuantity
{
    TypeName("epsilon");
    using fieldQuantity::fieldQuantity;

    virtual string missing() const override
    {
        return noTurbulence("epsilon");
    }
};


struct temperatureQuantity
:
    public fieldQuantity
{
    TypeName("T");
    using fieldQuantity::fieldQuantity;

    virtual string missing() const override
    {
        return
            fluid_.mesh().foundObject<volScalarField>(type())
          ? string() : string("the solver has no field T. Take a solver that has one");
    }
};


struct wallDistanceQuantity
:
    public scalarQuantity
{
    TypeName("wallDistance");
    using scalarQuantity::scalarQuantity;

    virtual string missing() const override
    {
        return
            fluid_.mesh().schemesDict().subOrEmptyDict("wallDist").found("method")
          ? string() : string("system/fvSchemes has no wallDist { method meshWave; }. Add it there");
    }
    virtual bool hasBoundaryValues() const override
    {
        return true;
    }
    virtual tmp<volScalarField> scalarField() const override
    {
        return wallDist::New(fluid_.mesh()).y();
    }
};

#define makeFluidQuantity(Class)                                              \
    defineTypeNameAndDebug(Class, 0);                                         \
    addToRunTimeSelectionTable(fluidQuantity, Class, dictionary);

makeFluidQuantity(velocityQuantity)
makeFluidQuantity(voidFractionQuantity)
makeFluidQuantity(densityQuantity)
makeFluidQuantity(viscosityQuantity)
makeFluidQuantity(effectiveViscosityQuantity)
makeFluidQuantity(pressureGradientQuantity)
makeFluidQuantity(fluidWeightQuantity)
makeFluidQuantity(viscousStressQuantity)
makeFluidQuantity(vorticityQuantity)
makeFluidQuantity(turbulentEnergyQuantity)
makeFluidQuantity(dissipationQuantity)
makeFluidQuantity(temperatureQuantity)
makeFluidQuantity(wallDistanceQuantity)

} // End anonymous namespace
} // End namespace Foam


// ************************************************************************* //
