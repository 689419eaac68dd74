/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    The drag laws of liggghts-plugins/physics/drag/gas_drag.h, which know the Mach number. Speed of sound
    and ratio of specific heats are those of the solver's gas in the grain's cell. With the model heat
    Henderson takes the temperature of each grain and that of the gas there.

\*---------------------------------------------------------------------------*/

#include "dragLaw.H"
#include "addToRunTimeSelectionTable.H"
#include "couplingEntries.H"
#include "entryError.H"
#include "heatTransfer.H"
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

    //- \param law    coefficient(state of the gas, number of the grain)
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
                },
                i
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
        evaluate
        (
            [](const grainjet::drag::GasState& gas, const label){ return grainjet::drag::loth(gas); },
            grains, slipSpeed, coefficient
        );
    }
};


class HendersonDragLaw
:
    public gasDragLaw
{
    //- The grains' temperature is known: the number of the gas' temperature. Else -1
    label T_;

    //- Their temperature over that of the gas where it is not
    const scalar temperatureRatio_;

    //- Stop if the ratio is stated although the temperature is known. For the master
    static void checkRatio(const dictionary& dict)
    {
        if (dict.found("temperatureRatio"))
        {
            FatalIOErrorInEntry(dict, "temperatureRatio")
                << "temperatureRatio together with the model heat, which knows the temperature of each"
                << " particle. Remove temperatureRatio" << exit(FatalIOError);
        }
    }

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
               .means("temperature of the particles over that of the gas without the model heat, 1 if absent")
               .like("1")
            }
        });
    }

    HendersonDragLaw(const dictionary& dict, forceNeeds& needs)
    :
        gasDragLaw(dict, needs),
        T_(-1),
        temperatureRatio_(dict.lookupOrDefault<scalar>("temperatureRatio", 1))
    {
        if (heatTransfer::acts(needs.coupling()))
        {
            couplingEntries::onMaster([&](){ checkRatio(dict); });
            needs.temperature();
            T_ = needs.quantity("T");
        }
    }

    virtual void coefficient
    (
        const grainBatch& grains,
        const lane& slipSpeed,
        lane& coefficient
    ) const override
    {
        const lane* T = T_ < 0 ? nullptr : grains.fluid(T_);
        evaluate
        (
            [&](const grainjet::drag::GasState& gas, const label i)
            {
                return grainjet::drag::Henderson(T ? grains.temperature[i]/(*T)[i] : temperatureRatio_)(gas);
            },
            grains, slipSpeed, coefficient
        );
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
