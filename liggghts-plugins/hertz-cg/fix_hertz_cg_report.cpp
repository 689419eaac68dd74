/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* fix hertz/cg: its global vector, its reports and its part of a restart file */

#include "hertz-cg/fix_hertz_cg.h"
#include "physics/contact/time_step.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "force.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>
#include <vector>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

double FixHertzCg::compute_vector(int n)
{
  if (reduced_step_ != update->ntimestep || update->setupflag) reduce();
  return n == 4 ? hertz_percent() : reduced_[n];
}

/* ----------------------------------------------------------------------
   all but one at once: every rank asks for the first of them together. The Hertz time is not for
   a coupled run, which asks every fluid step
------------------------------------------------------------------------- */

void FixHertzCg::reduce()
{
  double contacts = 0.0;
  for (std::size_t p = 0; pairs_valid_ && p < pairs_.size(); ++p)
    if (pairs_.marks[p]) {
      const int i = pairs_.pairs[p].i, j = pairs_.pairs[p].j;
      if (j < atom->nlocal || atom->tag[i] < atom->tag[j]) contacts += 1.0;
    }
  double sum[5] = {contacts, collisions_, elastic_energy(), work_, found_};
  double deepest = deepest_;
  MPI_Allreduce(MPI_IN_PLACE, sum, 5, MPI_DOUBLE, MPI_SUM, world);
  MPI_Allreduce(MPI_IN_PLACE, &deepest, 1, MPI_DOUBLE, MPI_MAX, world);
  reduced_[0] = sum[0];
  reduced_[1] = sum[1];
  reduced_[2] = deepest;
  reduced_[3] = rayleigh_percent();
  reduced_[5] = sum[2];
  // what the contacts took from the motion and did not keep in their springs
  reduced_[6] = sum[4] - sum[3] - sum[2];
  reduced_step_ = update->ntimestep;
}

/* ----------------------------------------------------------------------
   of each type the grain with the smallest m^power/R, which has the shortest time, so that roots
   and powers are for this one only. Products, since a division takes longer than all the rest
------------------------------------------------------------------------- */

std::vector<FixHertzCg::Grain> FixHertzCg::quickest(int power) const
{
  std::vector<Grain> found(atom->ntypes + 1);
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit)) continue;
    const double R = atom->radius[i], m = atom->rmass[i];
    const double key = power == 2 ? m * m : m;
    Grain &best = found[atom->type[i]];
    if (best.radius <= 0.0 || key * best.radius < best.key * R) best = {key, R, m};
  }
  return found;
}

/* ----------------------------------------------------------------------
   The time step in % of the shortest time of all grains. No grains: 0 %.
------------------------------------------------------------------------- */

double FixHertzCg::percent_of(double shortest) const
{
  MPI_Allreduce(MPI_IN_PLACE, &shortest, 1, MPI_DOUBLE, MPI_MIN, world);
  return 100.0 * update->dt / shortest;
}

double FixHertzCg::rayleigh_percent() const
{
  const std::vector<Grain> wave = quickest(1);
  double shortest = HUGE_VAL;
  for (int type = 1; type <= atom->ntypes; ++type) {
    const double R = wave[type].radius;
    if (R <= 0.0) continue;
    const double density = wave[type].mass / (4.0 / 3.0 * 3.14159265358979323846 * R * R * R);
    shortest = std::min(shortest, grainjet::contact::rayleighTime(R, density, materials_.youngs(type),
                                                                  materials_.poisson(type)));
  }
  return percent_of(shortest);
}

/* ----------------------------------------------------------------------
   Of two equal grains that meet at twice the largest speed, over all grains, as in the stock
   `fix check/timestep/gran`
------------------------------------------------------------------------- */

double FixHertzCg::hertz_percent() const
{
  double fastest = 0.0;
  for (int i = 0; i < atom->nlocal; ++i) {
    const double *v = atom->v[i];
    fastest = std::max(fastest, v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  }
  MPI_Allreduce(MPI_IN_PLACE, &fastest, 1, MPI_DOUBLE, MPI_MAX, world);

  const std::vector<Grain> impact = quickest(2);
  double shortest = HUGE_VAL;
  for (int type = 1; fastest > 0.0 && type <= atom->ntypes; ++type)
    if (impact[type].radius > 0.0)
      shortest = std::min(shortest, grainjet::contact::hertzTime(0.5 * impact[type].mass, 0.5 * impact[type].radius,
        materials_(type, type).material.youngs, 2.0 * std::sqrt(fastest)));
  return percent_of(shortest);
}

/* ---------------------------------------------------------------------- */

void FixHertzCg::end_of_step()
{
  const double percent[2] = {rayleigh_percent(), hertz_percent()};
  const char *name[2] = {"Rayleigh", "Hertz"};
  for (int n = 0; n < 2; ++n) {
    if (percent[n] <= 100.0 * timestep_fraction_) continue;
    std::ostringstream message;
    message << "time step " << update->dt << " is " << percent[n] << " % of the " << name[n]
            << " time; timestep_check allows " << 100.0 * timestep_fraction_ << " %";
    if (timestep_error_) error->fix_error(FLERR, this, message.str().c_str());
    if (comm->me == 0) error->warning(FLERR, ("Fix hertz/cg: " + message.str()).c_str());
  }
}

void FixHertzCg::post_run()
{
  report_failure();
  report_deep();
}

/* ----------------------------------------------------------------------
   Runs may be many and short, and restart files many in one: deep contacts are reported when
   there are the first of them, and again when there are ten times as many
------------------------------------------------------------------------- */

void FixHertzCg::report_deep()
{
  double deep = deep_, deepest = deepest_;
  MPI_Allreduce(MPI_IN_PLACE, &deep, 1, MPI_DOUBLE, MPI_SUM, world);
  MPI_Allreduce(MPI_IN_PLACE, &deepest, 1, MPI_DOUBLE, MPI_MAX, world);
  if (deep == 0.0 || deep < 10.0 * deep_reported_) return;
  deep_reported_ = deep;
  if (comm->me) return;
  std::ostringstream message;
  message << "Fix hertz/cg: " << deep << " contacts since the start were deeper than " << overlap_fraction_
          << " of the smaller radius, the deepest " << deepest << "; grains are too soft for their speed";
  error->warning(FLERR, message.str().c_str());
}

/* ----------------------------------------------------------------------
   Restart file. Global: sums over all ranks, so that the number of ranks may change. Deep
   contacts are reported here too: what comes after may be killed, and a run be long.
------------------------------------------------------------------------- */

namespace {

// order of the numbers in the global part; the first of them is its version
enum Saved { VERSION, COLLISIONS, DEEP, DEEPEST, WORK, FOUND, IN_RUN, REACH, MARGIN, PAIRS,
             ROLLING, SKIN, LARGEST_SKIN, SORT_BIN, SEARCHED, STREAM, STATE = STREAM + 3, NTYPES = STATE + 2,
             NSAVED };   // and after them the coarse-graining factor of each type, elapsed_ and counted_step_, observers

}

void FixHertzCg::write_restart(FILE *fp)
{
  report_deep();
  double sum[4] = {collisions_, deep_, work_, found_};
  double deepest = deepest_;
  MPI_Allreduce(MPI_IN_PLACE, sum, 4, MPI_DOUBLE, MPI_SUM, world);
  MPI_Allreduce(MPI_IN_PLACE, &deepest, 1, MPI_DOUBLE, MPI_MAX, world);
  double now[2];
  state(now);
  if (comm->me) return;

  std::vector<double> list(NSAVED);
  list[VERSION] = observers_.any() ? 3.2 : 3.1;
  list[COLLISIONS] = sum[0];
  list[DEEP] = sum[1];
  list[DEEPEST] = deepest;
  list[WORK] = sum[2];
  list[FOUND] = sum[3];
  // between runs the next one works out forces anew; in the middle of one it goes on with them
  list[IN_RUN] = update->whichflag ? 1.0 : 0.0;
  const grainjet::SearchSettings::Lengths lengths = search_.lengths();
  list[REACH] = lengths.reach;
  list[MARGIN] = margin_;
  list[PAIRS] = pairs_per_grain_;
  list[ROLLING] = static_cast<double>(law_.rolling);
  list[SKIN] = lengths.skin;
  list[LARGEST_SKIN] = lengths.largestSkin;
  list[SORT_BIN] = lengths.sortBin;
  list[SEARCHED] = static_cast<double>(search_step_);
  for (int d = 0; d < 3; ++d) list[STREAM + d] = stream_[d];
  for (int d = 0; d < 2; ++d) list[STATE + d] = now[d];
  list[NTYPES] = atom->ntypes;
  for (int type = 1; type <= atom->ntypes; ++type) list.push_back(force->cg(type));
  list.push_back(elapsed_);
  list.push_back(static_cast<double>(counted_step_));
  if (observers_.any()) {
    const std::vector<double> observers = observers_.pack();
    list.insert(list.end(), observers.begin(), observers.end());
  }
  const int size = static_cast<int>(list.size() * sizeof(double));
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(list.data(), sizeof(double), list.size(), fp);
}

/* ---------------------------------------------------------------------- */

void FixHertzCg::restart(char *buf)
{
  double list[NSAVED];
  memcpy(list, buf, sizeof(double));
  if (list[VERSION] != 3.0 && list[VERSION] != 3.1 && list[VERSION] != 3.2)
    error->fix_error(FLERR, this, "the restart file was written by another version of Grainjet; continue with that one, "
                     "or write the grains with write_data or a dump and start from them");
  memcpy(list, buf, sizeof(list));
  const auto rolling = static_cast<grainjet::contact::Rolling>(static_cast<int>(list[ROLLING]));
  grainjet::contact::LawOptions written;
  written.rolling = rolling;
  if (rolling != law_.rolling && (written.rollingSpring() || law_.rollingSpring()))
    error->fix_error(FLERR, this, "the restart file was written with another `rolling` model, of which contacts remember "
                     "something else; state the same one");
  for (int type = 1; type <= atom->ntypes && type <= list[NTYPES]; ++type) {
    double factor;
    memcpy(&factor, buf + (NSAVED + type - 1) * sizeof(double), sizeof(double));
    if (factor == force->cg(type)) continue;
    std::ostringstream message;
    message << "the restart file was written with `coarsegraining " << factor << "` for type " << type
            << ", this script has " << force->cg(type) << "; state the same factors before the fix";
    error->fix_error(FLERR, this, message.str().c_str());
  }
  const bool first = comm->me == 0;    // sums belong to one rank
  collisions_ = first ? list[COLLISIONS] : 0.0;
  deep_ = first ? list[DEEP] : 0.0;
  deepest_ = list[DEEPEST];
  work_ = first ? list[WORK] : 0.0;
  found_ = first ? list[FOUND] : 0.0;
  forces_restarted_ = list[IN_RUN] != 0.0;
  // a run that starts anew chooses its reach anew, here as there
  grainjet::SearchSettings::Lengths lengths;
  lengths.reach = list[REACH];
  lengths.skin = list[SKIN];
  lengths.largestSkin = list[LARGEST_SKIN];
  lengths.sortBin = list[SORT_BIN];
  if (forces_restarted_) search_.keep(lengths);
  margin_ = list[MARGIN];
  pairs_per_grain_ = list[PAIRS];
  search_step_ = counted_step_ = static_cast<bigint>(list[SEARCHED]);
  if (list[VERSION] > 3.0) {
    // behind the factors; before this version all steps were of one length
    double steps[2];
    memcpy(steps, buf + (NSAVED + static_cast<int>(list[NTYPES])) * sizeof(double), sizeof(steps));
    elapsed_ = steps[0];
    counted_step_ = static_cast<bigint>(steps[1]);
  }
  if (list[VERSION] > 3.1) {
    // the contacts of the file have rows for them
    observers_.unpack(reinterpret_cast<const double *>(buf) + NSAVED + static_cast<int>(list[NTYPES]) + 2, store_, pairs_);
  }
  for (int d = 0; d < 3; ++d) stream_[d] = list[STREAM + d];
  for (int d = 0; d < 2; ++d) state_restarted_[d] = list[STATE + d];
}

/* ----------------------------------------------------------------------
   A fingerprint of all grains in two halves of 32 bits, the same on any number of ranks: a sum of one number
   per grain, made of the bits of its ID, type, size and motion.
------------------------------------------------------------------------- */

void FixHertzCg::state(double sum[2]) const
{
  unsigned long long total = 0;
  for (int i = 0; i < atom->nlocal; ++i) {
    unsigned long long h = 1469598103934665603ULL;
    const double *v = atom->v[i], *w = atom->omega[i];
    const double values[] = {static_cast<double>(atom->tag[i]), static_cast<double>(atom->type[i]), atom->radius[i],
                             atom->rmass[i], v[0], v[1], v[2], w[0], w[1], w[2]};
    for (const double value : values) {
      unsigned long long bits;
      memcpy(&bits, &value, sizeof(bits));
      h = (h ^ bits) * 1099511628211ULL;
      h ^= h >> 29;
    }
    total += h;
  }
  MPI_Allreduce(MPI_IN_PLACE, &total, 1, MPI_UNSIGNED_LONG_LONG, MPI_SUM, world);
  sum[0] = static_cast<double>(total >> 32);
  sum[1] = static_cast<double>(total & 0xffffffffULL);
}

/* ----------------------------------------------------------------------
   A script that changes grains before it runs on (set, velocity, delete_atoms ...) does not go on with the
   forces of the file
------------------------------------------------------------------------- */

void FixHertzCg::check_restarted()
{
  if (!forces_restarted_) return;
  double now[2];
  state(now);
  forces_restarted_ = now[0] == state_restarted_[0] && now[1] == state_restarted_[1];
}

/* ----------------------------------------------------------------------
   per grain: its contacts as they are now, also those of the running step
------------------------------------------------------------------------- */

int FixHertzCg::size_restart(int i)
{
  save_contacts();
  return 1 + store_.packed_size(i);
}

int FixHertzCg::maxsize_restart()
{
  save_contacts();
  int largest = 0;
  for (int i = 0; i < atom->nlocal; ++i) largest = std::max(largest, 1 + store_.packed_size(i));
  MPI_Allreduce(MPI_IN_PLACE, &largest, 1, MPI_INT, MPI_MAX, world);
  return largest;
}

int FixHertzCg::pack_restart(int i, double *buf)
{
  save_contacts();
  buf[0] = 1 + store_.pack(i, &buf[1]);
  return static_cast<int>(buf[0]);
}

void FixHertzCg::unpack_restart(int i, int nth)
{
  const double *extra = atom->extra[i];
  int m = 0;
  for (int n = 0; n < nth; ++n) m += static_cast<int>(extra[m]);
  store_.unpack(i, &extra[m + 1]);
}
