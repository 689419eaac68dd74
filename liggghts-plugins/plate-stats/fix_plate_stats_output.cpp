/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* Files: the table, the events, restart data */

#include "fix_plate_stats.h"

#include "output_file.h"

#include "host/expose_member.h"

#include "comm.h"
#include "dump.h"
#include "error.h"
#include "modify.h"
#include "output.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <unistd.h>

using namespace LAMMPS_NS;
using grainjet::EventsFile;
using grainjet::PlateStatistics;
namespace OutputFile = grainjet::OutputFile;

namespace grainjet {

struct DumpPath {
  using type = char *Dump::*;
  friend type member(DumpPath);
};

}

template struct grainjet::Expose<grainjet::DumpPath, &Dump::filename>;

// Of the restart data, in a place where versions without it have stats_start >= 0
static const double FORMAT = -2.0;

// centre and normal, radius, rings
static const int GEOMETRY = 8;

/* ---------------------------------------------------------------------- */

void FixPlateStats::post_create()
{
  find_wall();
  just_created = 0;    // grains are free of collisions; Modify::setup need not say so again

  std::string fault;
  if (comm->me == 0) {
    fault = check_files();
    if (fault.empty()) fault = OutputFile::check_folder(OutputFile::temporary(path_));
    if (fault.empty() && !eventsPath_.empty()) fault = open_events();
  }
  agree(fault);
}

/* ---------------------------------------------------------------------- */

std::vector<std::string> FixPlateStats::paths() const
{
  std::vector<std::string> list = {path_, OutputFile::temporary(path_)};
  if (!eventsPath_.empty()) list.push_back(eventsPath_);
  return list;
}

/* ----------------------------------------------------------------------
   on rank 0: what forbids to write the files, which are not touched. What happens to them
   once a run goes on does not end it (see write()).
------------------------------------------------------------------------- */

std::string FixPlateStats::check_files() const
{
  const std::vector<std::string> own = paths();
  for (std::size_t p = 0; p < own.size(); p++)
    for (std::size_t q = 0; q < p; q++)
      if (OutputFile::same(own[p], own[q]))
        return "'" + own[p] + "' and '" + own[q] + "' are one file; 'file' (which also needs '"
          + own[1] + "') and 'events' must be two";

  for (int ifix = 0; ifix < modify->nfix; ifix++) {
    const FixPlateStats *other = dynamic_cast<const FixPlateStats *>(modify->fix[ifix]);
    if (!other || other == this) continue;
    for (const std::string &path : own)
      for (const std::string &taken : other->paths())
        if (OutputFile::same(path, taken))
          return "file '" + path + "' is that of fix plate/stats (ID " + other->id
            + "); give another path";
  }

  for (const std::string &path : own) {
    std::string fault = started_ ? "" : OutputFile::check_kind(path);
    if (fault.empty())
      fault = OutputFile::check_open(path, path == eventsPath_ && events_ ? events_->file() : NULL);
    if (!fault.empty()) return fault;
  }
  std::string fault = check_dumps();
  if (started_) return fault;
  if (fault.empty()) fault = OutputFile::check_own(own[0], PlateStatistics::columns());
  if (fault.empty()) fault = OutputFile::check_own(own[1], PlateStatistics::columns(), true);
  if (fault.empty() && !eventsPath_.empty() && !events_ && restartedEvents_ < 0)
    fault = OutputFile::check_own(eventsPath_, EventsFile::columns());
  return fault;
}

/* ----------------------------------------------------------------------
   A dump opens its file only when it writes.
------------------------------------------------------------------------- */

std::string FixPlateStats::check_dumps() const
{
  for (int idump = 0; idump < output->ndump; idump++) {
    const char *taken = output->dump[idump]->*member(grainjet::DumpPath());
    for (const std::string &path : paths())
      if (taken && OutputFile::same(path, taken))
        return "file '" + path + "' is that of dump " + output->dump[idump]->id
          + "; give another path";
  }
  return "";
}

/* ----------------------------------------------------------------------
   on rank 0. A restarted run goes on in the file that it was writing; under another path
   it may begin one.
------------------------------------------------------------------------- */

std::string FixPlateStats::open_events()
{
  events_.reset(new EventsFile(eventsPath_));
  if (restartedEvents_ < 0) return events_->create();
  const bool missing = access(eventsPath_.c_str(), F_OK) != 0 && errno == ENOENT;
  if (missing && eventsPath_ == restartedPath_) {
    char lost[100];
    snprintf(lost, sizeof(lost), "%.0f bytes, written until t = %.9g s", restartedEvents_, clock_);
    return "events file '" + eventsPath_ + "' of the run before the restart (" + lost
      + ") is missing; bring it here, or give another path for the events from now on";
  }
  return missing ? events_->create() : events_->resume(restartedEvents_);
}

/* ----------------------------------------------------------------------
   ends the run on all ranks if rank 0 has met a fault
------------------------------------------------------------------------- */

void FixPlateStats::agree(std::string fault)
{
  int length = fault.size();
  MPI_Bcast(&length, 1, MPI_INT, 0, world);
  if (length == 0) return;
  fault.resize(length);
  MPI_Bcast(&fault[0], length, MPI_CHAR, 0, world);
  fail(fault);
}

/* ---------------------------------------------------------------------- */

void FixPlateStats::write()
{
  gather();
  const std::vector<double> now = touching();
  std::string fault;
  if (comm->me == 0) {
    bool left = false;
    fault = OutputFile::replace(path_, PlateStatistics::columns(),
      statistics_->csv(std::max(clock_ - begin_, 0.0), begun_, now), left);
    if (left && !left_) {
      const std::string text = std::string("Fix plate/stats (ID ") + id + "): '" + path_
        + "' has become another file during the run and is not overwritten; the statistics are "
        "in '" + OutputFile::temporary(path_) + "'";
      error->warning(FLERR, text.c_str());
    }
    left_ = left;
  }
  agree(fault);
}

/* ----------------------------------------------------------------------
   What a run has found so far is on disk when its restart file is, whatever ends it then.

   restart data: size, FORMAT, start_, clock_, begin_, bytes of the events file, geometry,
   wall and events file (texts), plates of the meshes, collisions begun per region,
   statistics
------------------------------------------------------------------------- */

static void pack_text(std::vector<double> &list, const std::string &text)
{
  list.push_back(text.size());
  list.insert(list.end(), text.begin(), text.end());
}

static std::string unpack_text(const double *&next)
{
  const std::size_t length = static_cast<std::size_t>(*next++);
  const std::string text(next, next + length);
  next += length;
  return text;
}

/* ---------------------------------------------------------------------- */

void FixPlateStats::write_restart(FILE *fp)
{
  write();
  if (comm->me != 0) return;
  std::vector<double> list =
    {0.0, FORMAT, start_, clock_, begin_, events_ ? events_->size() : -1.0};
  list.insert(list.end(), plate_->centre(), plate_->centre() + 3);
  list.insert(list.end(), plate_->normal(), plate_->normal() + 3);
  list.push_back(plate_->radius());
  list.push_back(plate_->rings());
  pack_text(list, wallID_);
  pack_text(list, eventsPath_);
  for (const std::vector<double> &part : {surface_->pack(), begun_, statistics_->pack()})
    list.insert(list.end(), part.begin(), part.end());
  list[0] = list.size();
  const int bytes = list.size() * sizeof(double);
  fwrite(&bytes, sizeof(int), 1, fp);
  fwrite(list.data(), sizeof(double), list.size(), fp);
}

/* ----------------------------------------------------------------------
   how the plate of a restart file differs from this one; numbers may have gone through a
   script's variables
------------------------------------------------------------------------- */

std::string FixPlateStats::other_plate(const double *stored, const std::string &wall) const
{
  const double SAME = 1e-9;
  const double radius = plate_->radius();
  if (stored[7] != plate_->rings()) return "another number of rings";
  if (!(std::fabs(stored[6] - radius) <= SAME * radius)) return "another radius";
  for (int dim = 0; dim < 3; dim++) {
    if (!(std::fabs(stored[dim] - plate_->centre()[dim]) <= SAME * radius))
      return "another centre";
    if (!(std::fabs(stored[3 + dim] - plate_->normal()[dim]) <= SAME)) return "another normal";
  }
  return wall == wallID_ ? "" : "another wall ('" + wall + "')";
}

/* ----------------------------------------------------------------------
   Another stats_start asks for statistics from then on, which may be of another plate.
------------------------------------------------------------------------- */

void FixPlateStats::restart(char *buf)
{
  const double *list = reinterpret_cast<const double *>(buf);
  if (list[1] != FORMAT)
    fail("the restart file was written by another version of Grainjet; go on with that, or give "
      "this fix another ID");
  anew_ = start_ != list[2];
  const double *geometry = list + 6, *next = geometry + GEOMETRY;
  const std::string wall = unpack_text(next), path = unpack_text(next);

  clock_ = list[3];
  observed_ = true;
  const std::string difference = other_plate(geometry, wall);
  if (!difference.empty()) {
    if (!anew_)
      fail("the restart file holds statistics of " + difference + "; use that, or another fix ID");
    unknown_ = true;
    begin_ = std::max(clock_, start_);
    return;
  }
  next += surface_->unpack(next);
  if (anew_) {
    begin_ = std::max(clock_, start_);
    return;
  }
  begin_ = list[4];
  restartedEvents_ = list[5];
  restartedPath_ = path;
  begun_.assign(next, next + begun_.size());
  next += begun_.size();
  statistics_->unpack(std::vector<double>(next, list + static_cast<std::size_t>(list[0])));
}
