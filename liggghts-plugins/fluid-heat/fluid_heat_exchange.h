/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_FLUID_HEAT_EXCHANGE_H
#define GRAINJET_FLUID_HEAT_EXCHANGE_H

/* The data that a coupling and `fix fluid/heat coupled` exchange. This header is the whole
   interface. A coupling finds the fix by its style name and asks before every access, since
   arrays may have moved,

       int dim;
       auto *exchange = static_cast<FluidHeatExchange *>(
           fix->extract("fluid_heat_exchange", dim));

   and once, before the first access, compares the string of extract("fluid_heat_version")
   with GRAINJET_VERSION of host/grainjet_version.h, as for fluid_force_exchange.h.

   Index of all arrays: local atom, 0 <= i < atom->nlocal. Values are in SI units and of the
   whole GRAIN. They move with it between ranks and are in restart files. The heat of grains
   that were removed is in FluidForceExchange::Removed.                                  */

namespace LAMMPS_NS {

struct FluidHeatExchange {

  // ---- Written by the coupling, constant over the DEM steps of an interval

  double *fluidTemperature;           // [n] K, at which the grain would exchange no heat with the
                                      // fluid: of a fast gas the recovery temperature
  double *heatTransferCoefficient;    // [n] W/K, not negative: the grain receives the heat flow
                                      // heatTransferCoefficient (fluidTemperature - temperature)

  // ---- Written by the fix

  double *temperature;                // [n] K, property Temp. A coupling may add to it what a grain has given
                                      // and the fluid has not received; that is not in heat
  double *heat;                       // [n] J, that the grain received from the fluid since the
                                      // coupling last set it to zero

  // ---- Constant

  const double *specificHeat;         // [1 + atom types], index: atom type from 1, J/(kg K)
  const double *conductivity;         // the same, W/(m K), for the Biot number; NULL: not given

  void *fix;                          // the fix itself
};

}

#endif
