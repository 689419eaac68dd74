/*---------------------------------------------------------------------------*\
    Grainjet: coarse-grained CFD-DEM for particle-laden jets
    Copyright (C) 2026 The Grainjet developers
    SPDX-License-Identifier: GPL-3.0-or-later

Description
    Heat between fluid and grains: fix fluid/heat of the script.

\*---------------------------------------------------------------------------*/

#include "liggghtsSession.H"
#include "sessionError.H"
#include "fluid-heat/fluid_heat_exchange.h"

#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wnon-virtual-dtor"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#include "lammps.h"
#include "fix.h"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::liggghtsSession::checkHeat() const
{
    if (requested_.needsTemperature() && !fluidHeat_)
    {
        sessionError
        (
            "Script " + script_ + ": no fix fluid/heat coupled, so the grains have no"
            " temperature, which " + (requested_.heat ? "the model heat" : "a model")
          + " of fvOptions needs; add\n    plugin load fluidheatplugin.so\n"
            "    fix capacity all property/global thermalCapacity peratomtype <J/(kg K) of each atom type>\n"
            "    fix heat all fluid/heat coupled temperature <K of new grains>"
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::liggghtsSession::heatArrays Foam::liggghtsSession::heats() const
{
    heatArrays arrays;
    if (fluidHeat_)
    {
        int dim = 0;
        const auto& exchange = *static_cast<LAMMPS_NS::FluidHeatExchange*>
        (
            fluidHeat_->extract("fluid_heat_exchange", dim)
        );
        arrays.fluidTemperature = exchange.fluidTemperature;
        arrays.heatTransferCoefficient = exchange.heatTransferCoefficient;
        arrays.temperature = exchange.temperature;
        arrays.heat = exchange.heat;
        arrays.specificHeat = exchange.specificHeat;
    }
    return arrays;
}


// ************************************************************************* //
