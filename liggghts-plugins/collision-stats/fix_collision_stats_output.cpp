/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* fix collision/stats: its files, and its part of a restart file */

#include "collision-stats/collision_tables.h"
#include "collision-stats/fix_collision_stats.h"
#include "wall-collisions/output_file.h"

#include "host/expose_member.h"

#include "atom.h"
#include "comm.h"
#include "dump.h"
#include "error.h"
#include "force.h"
#include "group.h"
#include "modify.h"
#include "output.h"

#include <algorithm>
#include <cstdio>

using namespace LAMMPS_NS;
using grainjet::CollisionSurroundings;
namespace CollisionTables = grainjet::CollisionTables;
namespace OutputFile = grainjet::OutputFile;

namespace grainjet {

struct PathOfDump {
  using type = char *Dump::*;
  friend type member(PathOfDump);
};

}

template struct grainjet::Expose<grainjet::PathOfDump, &Dump::filename>;

/* ---------------------------------------------------------------------- */

std::vector<std::string> FixCollisionStats::paths() const
{
  return {path_, OutputFile::temporary(path_), spectraPath_, OutputFile::temporary(spectraPath_)};
}

/* ----------------------------------------------------------------------
   On rank 0: what forbids to write the files, which are not touched. What becomes of them during a run does not end
   it (see write_file()).
------------------------------------------------------------------------- */

std::string FixCollisionStats::check_files() const
{
  const std::vector<std::string> own = paths();
  for (std::size_t p = 0; p < own.size(); p++)
    for (std::size_t q = 0; q < p; q++)
      if (OutputFile::same(own[p], own[q]))
        return "'" + own[p] + "' and '" + own[q] + "' are one file; 'file' and 'spectra' must be two";

  const std::string shared = check_others(*modify, this, own);
  if (!shared.empty()) return shared;
  for (int n = 0; n < output->ndump; n++) {
    const char *taken = output->dump[n]->*member(grainjet::PathOfDump());
    for (const std::string &path : own)
      if (taken && OutputFile::same(path, taken))
        return "file '" + path + "' is that of dump " + output->dump[n]->id + "; give another path";
  }

  std::string fault;
  for (std::size_t p = 0; p < own.size() && fault.empty(); p++) {
    fault = OutputFile::check_open(own[p]);
    if (started_ || !fault.empty()) continue;
    const bool temporary = p % 2 == 1;
    fault = OutputFile::check_kind(own[p]);
    if (fault.empty())
      fault = OutputFile::check_own(own[p], p < 2 ? CollisionTables::totalsColumns() : CollisionTables::spectraColumns(), style,
        temporary);
    if (fault.empty() && temporary) fault = OutputFile::check_folder(own[p]);
  }
  return fault;
}

/* ----------------------------------------------------------------------
   ends the run on all ranks if rank 0 has met a fault
------------------------------------------------------------------------- */

void FixCollisionStats::agree(std::string fault)
{
  int length = static_cast<int>(fault.size());
  MPI_Bcast(&length, 1, MPI_INT, 0, world);
  if (length == 0) return;
  fault.resize(length);
  MPI_Bcast(&fault[0], length, MPI_CHAR, 0, world);
  fail(fault);
}

/* ----------------------------------------------------------------------
   What the ranks have seen since the last time goes to rank 0, two by two
------------------------------------------------------------------------- */

void FixCollisionStats::gather()
{
  const int me = comm->me, nprocs = comm->nprocs, TAG = 0;
  for (int step = 1; step < nprocs; step *= 2) {
    if (me % (2 * step) == step) {
      const std::vector<double> mine = statistics_->pack();
      MPI_Send(mine.data(), static_cast<int>(mine.size()), MPI_DOUBLE, me - step, TAG, world);
      statistics_->clear();
      return;
    }
    if (me + step >= nprocs) continue;
    Statistics other(*statistics_);
    std::vector<double> theirs = other.pack();
    MPI_Recv(theirs.data(), static_cast<int>(theirs.size()), MPI_DOUBLE, me + step, TAG, world, MPI_STATUS_IGNORE);
    other.unpack(theirs);
    statistics_->merge(other);
  }
}

/* ---------------------------------------------------------------------- */

void FixCollisionStats::write()
{
  gather();
  CollisionSurroundings around;
  around.time = std::max(clock_ - begin_, 0.0);
  around.samples = samples_;
  around.volumes = place_->volumes();
  around.touching = touching();
  for (int type = 1; type <= atom->ntypes; type++) around.factor.push_back(force->cg(type));
  std::string fault;
  if (comm->me == 0) {
    fault = write_file(0, CollisionTables::totalsColumns(), CollisionTables::totals(*statistics_, around));
    if (fault.empty()) fault = write_file(1, CollisionTables::spectraColumns(), CollisionTables::spectra(*statistics_));
  }
  agree(fault);
}

/* ---------------------------------------------------------------------- */

std::string FixCollisionStats::write_file(int which, const std::string &columns, const std::string &text)
{
  const std::string &path = which == 0 ? path_ : spectraPath_;
  bool left = false;
  const std::string fault = OutputFile::replace(path, columns, style, text, left);
  if (left && !left_[which])
    error->warning(FLERR, (std::string("Fix collision/stats (ID ") + id + "): '" + path
      + "' has become another file during the run and is not overwritten; the statistics are in '"
      + OutputFile::temporary(path) + "'").c_str());
  left_[which] = left;
  return fault;
}

/* ----------------------------------------------------------------------
   What a run has found so far is on disk when its restart file is.

   restart data: size, FORMAT, start_, clock_, begin_, samples_, settings, names (length and letters each), statistics
------------------------------------------------------------------------- */

static const double FORMAT = 2.0;

std::vector<double> FixCollisionStats::settings() const
{
  std::vector<double> list = {static_cast<double>(bins_.axis), bins_.low, bins_.high, static_cast<double>(bins_.count),
    static_cast<double>(atom->ntypes)};
  for (const grainjet::SpectrumBins &s : spectra_)
    for (double x : {s.least, s.most, static_cast<double>(s.count)}) list.push_back(x);
  return list;
}

// group, region and its shape
std::vector<std::string> FixCollisionStats::names() const
{
  return {group->names[igroup], regionID_, place_->shape()};
}

/* ---------------------------------------------------------------------- */

void FixCollisionStats::write_restart(FILE *fp)
{
  if (started_) write();
  else gather();
  if (comm->me != 0) return;
  std::vector<double> list = {0.0, FORMAT, start_, clock_, begin_, samples_};
  for (double x : settings()) list.push_back(x);
  for (const std::string &name : names()) {
    list.push_back(static_cast<double>(name.size()));
    list.insert(list.end(), name.begin(), name.end());
  }
  const std::vector<double> statistics = statistics_->pack();
  list.insert(list.end(), statistics.begin(), statistics.end());
  list[0] = static_cast<double>(list.size());
  const int bytes = static_cast<int>(list.size() * sizeof(double));
  fwrite(&bytes, sizeof(int), 1, fp);
  fwrite(list.data(), sizeof(double), list.size(), fp);
}

/* ----------------------------------------------------------------------
   Another stats_start asks for statistics from then on, which may be of something else.
------------------------------------------------------------------------- */

void FixCollisionStats::restart(char *buf)
{
  const double *list = reinterpret_cast<const double *>(buf), *next = list + 6, *end = list + static_cast<int>(list[0]);
  if (list[1] != FORMAT)
    fail("the restart file was written by another version of Grainjet; go on with that, or give this fix another ID");
  clock_ = list[3];
  begin_ = std::max(clock_, start_);
  if (list[2] != start_) return;

  const std::string remedy = "; state what the former run had, another stats_start to begin anew, or another fix ID";
  const std::vector<double> mine = settings();
  if (!std::equal(mine.begin(), mine.end(), next)) fail("the restart file holds statistics of other bins or spectra" + remedy);
  next += mine.size();
  const std::string fault = place_->attach();
  if (!fault.empty()) fail(fault);
  const std::vector<std::string> here = names();
  std::vector<std::string> there;
  for (std::size_t n = 0; n < here.size(); n++) {
    const std::size_t length = static_cast<std::size_t>(*next++);
    there.emplace_back(next, next + length);
    next += length;
  }
  if (there[0] != here[0])
    fail("the restart file holds statistics of group '" + there[0] + "', not '" + here[0] + "'" + remedy);
  if (there[1] != here[1])
    fail("the restart file holds statistics of " + (there[1].empty() ? "no region" : "region '" + there[1] + "'") + remedy);
  if (there[2] != here[2])
    fail("the restart file holds statistics of a region '" + there[1] + "' that was " + there[2] + ", not " + here[2] + remedy);
  begin_ = list[4];
  samples_ = list[5];
  if (comm->me == 0 && !statistics_->unpack(std::vector<double>(next, end)))
    error->one(FLERR, "Fix collision/stats: the restart file is damaged");
}
