/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "fix_fluid_heat.h"

#include "host/find_temperature.h"
#include "host/fix_arguments.h"
#include "host/grainjet_version.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "update.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

using namespace LAMMPS_NS;
using namespace FixConst;
using grainjet::find_temperature;
using grainjet::FixArguments;

// In the restart file
static const double LAYOUT = 1.0;
static const int NSAVED = 2;

/* ---------------------------------------------------------------------- */

FixFluidHeat::FixFluidHeat(LAMMPS *lmp, int narg, char **arg) :
  Fix(lmp, narg, arg),
  temperature_(NAN), properties_(lmp, this), ownTemperature_(false),
  grainTemperature_(NULL), fluidTemperature_(NULL), coefficient_(NULL), heat_(NULL), held_(lmp),
  exchange_(), latest_(0.0), total_(0.0), checkBiot_(false), warned_(false), sumStep_(-1), sums_()
{
  FixArguments arguments(error, narg, arg);
  const std::string kind = arguments.word("style: coupled or uniform");
  if (kind == "coupled") {
    while (arguments.more()) {
      arguments.keyword({"temperature"});
      temperature_ = arguments.positive("temperature");
    }
  } else if (kind == "uniform") {
    uniform_.reset(new UniformGas(lmp, arguments));
    temperature_ = uniform_->grainTemperature();
  } else arguments.fail("unknown style '" + kind + "'; valid styles are coupled, uniform");

  // the values per grain have fixed names, so there can be one such fix only
  for (int ifix = 0; ifix < modify->nfix; ifix++)
    if (modify->fix[ifix] && strcmp(modify->fix[ifix]->style, style) == 0)
      arguments.fail(std::string("there is already one with ID ") + modify->fix[ifix]->id
        + "; let one fix fluid/heat act on all grains that exchange heat with the fluid");
  if (!atom->sphere_flag) arguments.fail("requires atom_style granular (spheres)");
  if (strcmp(update->unit_style, "si") != 0) arguments.fail("requires units si");

  const Fix *present = find_temperature(modify, style);
  if (present && !std::isnan(temperature_))
    arguments.fail(std::string("keyword temperature, but there is a property Temp already (fix ") + present->id
      + "), whose temperatures count; take one of them out");
  if (present && !present->restart_peratom && comm->me == 0) {
    const std::string text = std::string("Fix fluid/heat (ID ") + id + "): the temperatures of the property Temp (fix "
      + present->id + ") are not kept in restart files; write fix " + present->id + " all property/atom Temp scalar yes ...";
    error->warning(FLERR, text.c_str());
  }
  if (!present && !uniform_ && std::isnan(temperature_))
    arguments.fail("grains have no temperature; add the keyword temperature <K>, or make the property Temp before, "
      "for instance fix Temp all property/atom Temp scalar yes yes no 300");

  restart_global = 1;
  nevery = 1;
  vector_flag = 1;
  size_vector = 4;
  global_freq = 1;
  extvector = 0;
}

/* ---------------------------------------------------------------------- */

int FixFluidHeat::setmask()
{
  return PRE_NEIGHBOR | END_OF_STEP;
}

/* ----------------------------------------------------------------------
   all ranks come here together
------------------------------------------------------------------------- */

void FixFluidHeat::fail(const std::string &message) const
{
  const std::string text = std::string("Fix fluid/heat (ID ") + id + "): " + message;
  error->all(FLERR, text.c_str());
  std::abort();    // never reached: Error::all ends the program
}

/* ---------------------------------------------------------------------- */

void FixFluidHeat::post_create()
{
  grainTemperature_ = find_temperature(modify, style);
  if (!grainTemperature_) {
    const double initial = std::isnan(temperature_) ? uniform_->temperature() : temperature_;
    grainTemperature_ = properties_.create("Temp", {initial});
    ownTemperature_ = true;
    if (std::isnan(temperature_) && comm->me == 0)
      for (FILE *out : {screen, logfile})
        if (out) fprintf(out, "Fix fluid/heat (ID %s): no temperature is given for grains; new ones have the fluid's, %g K\n",
          id, initial);
  }
  fluidTemperature_ = properties_.create("fluidTemperature", {0.0});
  coefficient_ = properties_.create("fluidHeatCoefficient", {0.0});
  heat_ = properties_.create("fluidHeat", {0.0});
  just_created = 0;
}

/* ---------------------------------------------------------------------- */

void FixFluidHeat::pre_delete(bool unfixflag)
{
  if (unfixflag) properties_.remove();
}

/* ---------------------------------------------------------------------- */

void FixFluidHeat::init()
{
  if (strstr(update->integrate_style, "respa")) fail("does not work with run_style respa, use verlet");

  // fix heat/gran behind this one replaces the property by its own
  grainTemperature_ = find_temperature(modify, style);
  if (!grainTemperature_) fail("the property Temp is gone; keep the fix that made it");
  for (int ifix = 0; ifix < modify->nfix && ownTemperature_; ifix++)
    if (strncmp(modify->fix[ifix]->style, "heat/gran", 9) == 0)
      fail(std::string("fix ") + modify->fix[ifix]->style + " (ID " + modify->fix[ifix]->id
        + ") has replaced the temperatures; put it before fix fluid/heat, without the keyword temperature here");

  read_materials();
  if (uniform_) uniform_->init(this);
  held_.init();
  check_other_fixes();
}

/* ---------------------------------------------------------------------- */

void FixFluidHeat::read_materials()
{
  specificHeat_ = per_type("thermalCapacity", "J/(kg K)", true);
  conductivity_ = per_type("thermalConductivity", "W/(m K)", false);
}

/* ---------------------------------------------------------------------- */

std::vector<double> FixFluidHeat::per_type(const char *name, const char *unit, bool needed)
{
  const int ntypes = atom->ntypes;
  const std::string define = std::string("fix <id> all property/global ") + name + " peratomtype <" + unit
    + " of each atom type>";
  Fix *found = modify->find_fix_property(name, "property/global", "peratomtype", 0, 0, style, false);
  if (!found) {
    if (needed) fail(std::string("material property ") + name + " is missing; add " + define);
    return std::vector<double>();
  }
  if (found->size_vector < ntypes)
    fail(std::string("material property ") + name + " (fix " + found->id + ") has " + std::to_string(found->size_vector)
      + " values for " + std::to_string(ntypes) + " atom types; write " + define);

  std::vector<double> values(1 + ntypes, 0.0);
  for (int type = 1; type <= ntypes; type++) {
    values[type] = found->compute_vector(type - 1);
    if (values[type] > 0.0 && std::isfinite(values[type])) continue;
    char text[64];
    snprintf(text, sizeof(text), " of atom type %d is %g ", type, values[type]);
    fail(std::string("material property ") + name + " (fix " + found->id + ")" + text + unit
      + ", but must be > 0; write " + define);
  }
  return values;
}

/* ----------------------------------------------------------------------
   Clumps have one temperature and a velocity that their spheres' forces do not give. Stock fix
   heat/gran refuses them, too.
------------------------------------------------------------------------- */

void FixFluidHeat::check_other_fixes()
{
  for (int ifix = 0; ifix < modify->nfix; ifix++) {
    const Fix *other = modify->fix[ifix];
    if (!other->rigid_flag && strncmp(other->style, "multisphere", 11) != 0) continue;

    int mine = 0, any = 0;
    for (int i = 0; i < atom->nlocal; i++)
      if ((atom->mask[i] & groupbit) && (atom->mask[i] & other->groupbit)) mine = 1;
    MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
    if (any)
      fail(std::string("its group has grains that fix ") + other->style + " (ID " + other->id
        + ") holds; give fluid/heat a group without them");
  }
}

/* ---------------------------------------------------------------------- */

void FixFluidHeat::setup(int)
{
  check_temperatures();
  held_.reorder();
  checkBiot_ = true;
}

/* ---------------------------------------------------------------------- */

void FixFluidHeat::pre_neighbor()
{
  held_.reorder();
}

/* ---------------------------------------------------------------------- */

void FixFluidHeat::post_run()
{
  warn_of_biot();
}

/* ---------------------------------------------------------------------- */

void FixFluidHeat::refresh_exchange()
{
  if (specificHeat_.empty()) {    // before the first init()
    grainTemperature_ = find_temperature(modify, style);
    if (!grainTemperature_) fail("the property Temp is gone; keep the fix that made it");
    read_materials();
  }
  exchange_.fluidTemperature = fluidTemperature_->vector_atom;
  exchange_.heatTransferCoefficient = coefficient_->vector_atom;
  exchange_.temperature = grainTemperature_->vector_atom;
  exchange_.heat = heat_->vector_atom;
  exchange_.specificHeat = specificHeat_.data();
  exchange_.conductivity = conductivity_.empty() ? NULL : conductivity_.data();
  exchange_.fix = this;
}

/* ---------------------------------------------------------------------- */

void *FixFluidHeat::extract(const char *what, int &dim)
{
  dim = 0;
  if (strcmp(what, "fluid_heat_version") == 0) return const_cast<char *>(GRAINJET_VERSION);
  if (uniform_ || strcmp(what, "fluid_heat_exchange") != 0) return NULL;
  refresh_exchange();
  return &exchange_;
}

/* ---------------------------------------------------------------------- */

void FixFluidHeat::write_restart(FILE *fp)
{
  double list[NSAVED] = {LAYOUT, 0.0};
  MPI_Allreduce(&total_, &list[1], 1, MPI_DOUBLE, MPI_SUM, world);
  if (comm->me) return;
  const int size = sizeof(list);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(list, sizeof(double), NSAVED, fp);
}

/* ---------------------------------------------------------------------- */

void FixFluidHeat::restart(char *buf)
{
  const double *list = reinterpret_cast<const double *>(buf);
  if (list[0] != LAYOUT)
    fail("the restart file was written with another version of Grainjet, which keeps other data in it; continue with "
      "the version that wrote it");
  total_ = comm->me == 0 ? list[1] : 0.0;
}
