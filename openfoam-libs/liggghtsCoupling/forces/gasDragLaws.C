/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The drag laws of liggghts-plugins/physics/drag/gas_drag.h, which know the Mach number. Speed of sound
    and ratio of specific heats are those of the solver's gas in the grain's cell.

\*---------------------------------------------------------------------------*/

#include "dragLaw.H"
#include "addToRunTimeSelectionTable.H"
#include "physics/drag/gas_drag.h"

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

//- A law of the state of a gas
class gasDragLaw
:
    public dragLaw
{
    const label voidFraction_;
    const label rho_;
    const label nu_;
    const label speedOfSound_;
    const label gamma_;

protected:

    template<class Law>
    void evaluate
    (
        const Law& law,
        const grainBatch& grains,
        const lane& slipSpeed,
        lane& coefficient
    ) const
    {
        const lane& voidFraction = *grains.fluid(voidFraction_);
        const lane& rho = *grains.fluid(rho_);
        const lane& nu = *grains.fluid(nu_);
        const lane& speedOfSound = *grains.fluid(speedOfSound_);
        const lane& gamma = *grains.fluid(gamma_);
        for (label i = 0; i < grainBatch::size; ++i)
        {
            coefficient[i] = law
            (
                grainjet::drag::GasState
                {
                    {voidFraction[i], slipSpeed[i], grains.particleDiameter[i], rho[i], nu[i]},
                    speedOfSound[i], gamma[i]
                }
            );
        }
    }

public:

    gasDragLaw(const dictionary& dict, forceNeeds& needs)
    :
        dragLaw(dict),
        voidFraction_(needs.quantity("voidFraction")),
        rho_(needs.quantity("rho")),
        nu_(needs.quantity("nu")),
        speedOfSound_(needs.quantity("speedOfSound")),
        gamma_(needs.quantity("gamma"))
    {}
};


struct LothDragLaw
:
    public gasDragLaw
{
    //- Runtime type information
    TypeName("Loth");

    using gasDragLaw::gasDragLaw;

    virtual void coefficient
    (
        const grainBatch& grains,
        const lane& slipSpeed,
        lane& coefficient
    ) const override
    {
        evaluate(grainjet::drag::loth, grains, slipSpeed, coefficient);
    }
};


class HendersonDragLaw
:
    public gasDragLaw
{
    const grainjet::drag::Henderson law_;

public:

    //- Runtime type information
    TypeName("Henderson");

    //- Any temperature of particles that are solid in a gas
    static knownEntries::table entries()
    {
        return knownEntries::table
        ({
            {
                "temperatureRatio",
                knownEntries::rule(0.01, 100)
               .means("temperature of the particles over that of the gas, 1 if absent")
               .like("1")
            }
        });
    }

    HendersonDragLaw(const dictionary& dict, forceNeeds& needs)
    :
        gasDragLaw(dict, needs),
        law_(dict.lookupOrDefault<scalar>("temperatureRatio", 1))
    {}

    virtual void coefficient
    (
        const grainBatch& grains,
        const lane& slipSpeed,
        lane& coefficient
    ) const override
    {
        evaluate(law_, grains, slipSpeed, coefficient);
    }
};


defineTypeNameAndDebug(LothDragLaw, 0);
addToRunTimeSelectionTable(dragLaw, LothDragLaw, dictionary);
const knownEntries::ofModel LothEntries(dragLaw::typeName_(), "Loth");

defineTypeNameAndDebug(HendersonDragLaw, 0);
addToRunTimeSelectionTable(dragLaw, HendersonDragLaw, dictionary);
const knownEntries::ofModel HendersonEntries
(
    dragLaw::typeName_(), "Henderson", HendersonDragLaw::entries()
);

} // End anonymous namespace
} // End namespace Foam


// ************************************************************************* //
