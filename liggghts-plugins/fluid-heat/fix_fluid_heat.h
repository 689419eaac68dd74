/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifdef FIX_CLASS

FixStyle(fluid/heat,FixFluidHeat)

#else

#ifndef LMP_FIX_FLUID_HEAT_H
#define LMP_FIX_FLUID_HEAT_H

#include "fix.h"
#include "fluid_heat_exchange.h"
#include "uniform_gas.h"

#include "fluid-force/grain_properties.h"
#include "fluid-force/held_grains.h"

#include <memory>
#include <string>
#include <vector>

namespace LAMMPS_NS {

/* Heat between a fluid and the grains, each of which has one temperature.
   User page: docs/fix_fluid_heat.md.

     fix ID group fluid/heat coupled [temperature T0]
     fix ID group fluid/heat uniform T rho nu cp Pr [velocity ux uy uz]
         [nusselt ranzMarshall|gunn|whitaker] [recovery yes|no] [temperature T0]

   At the end of every step each grain's temperature goes the exact exponential way of that time towards the
   fluid's (physics/heat/lumped_temperature.h). The heat m c (T_new - T_old) is booked.

   The temperature is the stock property Temp of fix heat/gran or of the script's own fix property/atom; where
   there is none, this fix makes it. Further values per grain, each in a stock fix property/atom:
     fluidTemperature fluidHeatCoefficient fluidHeat
   Meaning and units: fluid_heat_exchange.h. Style uniform works the first two out in every step.

   Specific heat and conductivity by atom type: fix property/global thermalCapacity (J/(kg K)) and
   thermalConductivity (W/(m K)); the second one may be missing, then the Biot number is not known.

   Global vector: 1 heat flow to the grains in the latest step (W), 2 mean temperature, weighted by m c (K),
   3 heat given to grains since the start, also across restarts (J), 4 largest Biot number, -1 without
   conductivity.                                                                                   */
class FixFluidHeat : public Fix {
 public:

  FixFluidHeat(class LAMMPS *, int, char **);

  int setmask() override;
  void post_create() override;
  void pre_delete(bool) override;
  void init() override;
  void setup(int) override;
  void pre_neighbor() override;
  void end_of_step() override;
  void post_run() override;
  double compute_vector(int) override;

  void write_restart(FILE *) override;
  void restart(char *) override;

  // "fluid_heat_exchange": FluidHeatExchange *, or NULL if not in style coupled
  // "fluid_heat_version": const char *, the version of Grainjet that layout belongs to
  void *extract(const char *, int &) override;

 private:

  std::unique_ptr<UniformGas> uniform_;     // NULL in style coupled
  double temperature_;                      // K, of new grains where the fix makes Temp; NAN: not given

  GrainProperties properties_;
  bool ownTemperature_;                     // the fix has made Temp
  class FixPropertyAtom *grainTemperature_, *fluidTemperature_, *coefficient_, *heat_;
  HeldGrains held_;

  std::vector<double> specificHeat_, conductivity_;    // by atom type from 1; the second may be empty
  FluidHeatExchange exchange_;

  double latest_, total_;                   // J, heat of the latest step, of all: of this rank
  bool checkBiot_;                          // at the next step
  bool warned_;                             // of a large Biot number
  bigint sumStep_;                          // step of sums_, -1: none
  double sums_[4];                          // heat of the step, sum of m c, of m c T, heat of all steps

  void read_materials();
  std::vector<double> per_type(const char *name, const char *unit, bool needed);
  void check_other_fixes();
  void check_temperatures();
  void refresh_exchange();

  // One step for all grains. Returns whether a temperature is none
  template<bool UNIFORM> bool step();

  // Largest Biot number of this group's grains and the ID of that grain, on all ranks
  double largest_biot(int &tag);
  void warn_of_biot();
  void sum();
  void refuse_temperature();
  [[noreturn]] void fail(const std::string &message) const;
};

}

#endif
#endif
