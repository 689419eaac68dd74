/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* Files: what is written as a whole, the events, restart data */

#include "fix_wall_collisions.h"

#include "output_file.h"

#include "host/expose_member.h"

#include "comm.h"
#include "dump.h"
#include "error.h"
#include "group.h"
#include "modify.h"
#include "output.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <unistd.h>

using namespace LAMMPS_NS;
using grainjet::EventsFile;
namespace OutputFile = grainjet::OutputFile;

namespace grainjet {

struct DumpPath {
  using type = char *Dump::*;
  friend type member(DumpPath);
};

}

template struct grainjet::Expose<grainjet::DumpPath, &Dump::filename>;

// Of the restart data, in a place where versions without it have stats_start >= 0. Version 0.6 wrote
// no group. Records and statistics with temperatures are longer.
static const double FORMAT = -3.0, FORMAT_WITHOUT_GROUP = -2.0, FORMAT_WITH_TEMPERATURE = -4.0;

/* ---------------------------------------------------------------------- */

void FixWallCollisions::post_create()
{
  find_wall();
  just_created = 0;    // grains are free of collisions; Modify::setup need not say so again

  std::string fault;
  if (comm->me == 0) {
    fault = check_files();
    for (const Output &output : outputs())
      if (fault.empty()) fault = OutputFile::check_folder(OutputFile::temporary(output.path));
    if (fault.empty() && !eventsPath_.empty()) fault = open_events();
  }
  agree(fault);
}

/* ---------------------------------------------------------------------- */

std::vector<std::string> FixWallCollisions::paths() const
{
  std::vector<std::string> list;
  for (const Output &output : outputs()) {
    list.push_back(output.path);
    list.push_back(OutputFile::temporary(output.path));
  }
  if (!eventsPath_.empty()) list.push_back(eventsPath_);
  return list;
}

/* ----------------------------------------------------------------------
   on rank 0: what forbids to write the files, which are not touched. What happens to them
   once a run goes on does not end it (see write()).
------------------------------------------------------------------------- */

std::string FixWallCollisions::check_files() const
{
  const std::vector<std::string> own = paths();
  for (std::size_t p = 0; p < own.size(); p++)
    for (std::size_t q = 0; q < p; q++)
      if (OutputFile::same(own[p], own[q]))
        return "'" + own[p] + "' and '" + own[q] + "' are one file; each output needs a path of "
          "its own, and all but 'events' the same with .new as well";

  const std::string shared = check_others(*modify, this, own);
  if (!shared.empty()) return shared;

  for (const std::string &path : own) {
    std::string fault = started_ ? "" : OutputFile::check_kind(path);
    if (fault.empty())
      fault = OutputFile::check_open(path, path == eventsPath_ && events_ ? events_->file() : NULL);
    if (!fault.empty()) return fault;
  }
  std::string fault = check_dumps();
  if (started_) return fault;
  for (const Output &output : outputs()) {
    if (fault.empty()) fault = OutputFile::check_own(output.path, output.line, style);
    if (fault.empty())
      fault = OutputFile::check_own(OutputFile::temporary(output.path), output.line, style, true);
  }
  if (fault.empty() && !eventsPath_.empty() && !events_ && restartedEvents_ < 0)
    fault = OutputFile::check_own(eventsPath_, event_columns(), style);
  return fault;
}

/* ----------------------------------------------------------------------
   A dump opens its file only when it writes.
------------------------------------------------------------------------- */

std::string FixWallCollisions::check_dumps() const
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

std::string FixWallCollisions::open_events()
{
  events_.reset(new EventsFile(eventsPath_, event_columns(), style));
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

/* ---------------------------------------------------------------------- */

void FixWallCollisions::agree(std::string fault)
{
  int length = fault.size();
  MPI_Bcast(&length, 1, MPI_INT, 0, world);
  if (length == 0) return;
  fault.resize(length);
  MPI_Bcast(&fault[0], length, MPI_CHAR, 0, world);
  fail(fault);
}

/* ---------------------------------------------------------------------- */

std::string FixWallCollisions::replace(const std::string &path, const std::string &line,
  const std::string &text)
{
  bool left = false;
  const std::string fault = OutputFile::replace(path, line, style, text, left);
  const auto before = std::find(left_.begin(), left_.end(), path);
  if (left && before == left_.end()) {
    const std::string message = std::string("Fix ") + style + " (ID " + id + "): '" + path
      + "' has become another file during the run and is not overwritten; the statistics are "
      "in '" + OutputFile::temporary(path) + "'";
    error->warning(FLERR, message.c_str());
    left_.push_back(path);
  } else if (!left && before != left_.end()) {
    left_.erase(before);
  }
  return fault;
}

/* ---------------------------------------------------------------------- */

std::string FixWallCollisions::temperature(const grainjet::FinishedCollision &collision) const
{
  char text[32] = "";
  if (temperature_) snprintf(text, sizeof(text), ",%.9g", collision.contact.temperature);
  return text;
}

/* ---------------------------------------------------------------------- */

void FixWallCollisions::pack_text(std::vector<double> &list, const std::string &text)
{
  list.push_back(text.size());
  list.insert(list.end(), text.begin(), text.end());
}

/* ---------------------------------------------------------------------- */

std::string FixWallCollisions::unpack_text(const double *&next)
{
  const std::size_t length = static_cast<std::size_t>(*next++);
  const std::string text(next, next + length);
  next += length;
  return text;
}

/* ----------------------------------------------------------------------
   What a run has found so far is on disk when its restart file is, whatever ends it then.

   restart data: size, FORMAT, start_, clock_, begin_, bytes of the events file, what is
   watched, wall, events file and group (texts), the surface, collisions begun by region,
   statistics
------------------------------------------------------------------------- */

void FixWallCollisions::write_restart(FILE *fp)
{
  write();
  if (comm->me != 0) return;
  std::vector<double> list =
    {0.0, temperature_ ? FORMAT_WITH_TEMPERATURE : FORMAT, start_, clock_, begin_, events_ ? events_->size() : -1.0};
  const std::vector<double> watched = pack_watched();
  list.insert(list.end(), watched.begin(), watched.end());
  pack_text(list, wallID_);
  pack_text(list, eventsPath_);
  pack_text(list, group->names[igroup]);
  for (const std::vector<double> &part : {pack_surface(), begun_, pack_statistics()})
    list.insert(list.end(), part.begin(), part.end());
  list[0] = list.size();
  const int bytes = list.size() * sizeof(double);
  fwrite(&bytes, sizeof(int), 1, fp);
  fwrite(list.data(), sizeof(double), list.size(), fp);
}

/* ----------------------------------------------------------------------
   Another stats_start asks for statistics from then on, which may be of something else.
------------------------------------------------------------------------- */

void FixWallCollisions::restart(char *buf)
{
  const double *list = reinterpret_cast<const double *>(buf);
  if (list[1] != FORMAT && list[1] != FORMAT_WITHOUT_GROUP && list[1] != FORMAT_WITH_TEMPERATURE)
    fail("the restart file was written by another version of Grainjet; go on with that, or give "
      "this fix another ID");
  anew_ = start_ != list[2];
  const double *next = list + 6;
  std::string difference = compare_watched(next);
  const std::string wall = unpack_text(next), path = unpack_text(next);
  const std::string own = group->names[igroup];
  const std::string grains = list[1] == FORMAT_WITHOUT_GROUP ? own : unpack_text(next);
  restartedTemperature_ = list[1] == FORMAT_WITH_TEMPERATURE;
  if (difference.empty() && wall != wallID_) difference = "another wall ('" + wall + "')";
  unknown_ = !difference.empty();
  if (!unknown_ && grains != own) difference = "another group ('" + grains + "')";
  if (difference.empty() && restartedTemperature_ != temperature_)
    difference = temperature_ ? "grains without temperature (property Temp)"
      : "grains with a temperature (property Temp, which has to be made before this fix)";

  clock_ = list[3];
  observed_ = true;
  if (!difference.empty() && !anew_)
    fail("the restart file holds statistics of " + difference + "; use that, or another fix ID");
  if (unknown_) {
    begin_ = std::max(clock_, start_);
    return;
  }
  next += unpack_surface(next);
  if (anew_) {
    begin_ = std::max(clock_, start_);
    return;
  }
  begin_ = list[4];
  restartedEvents_ = list[5];
  restartedPath_ = path;
  begun_.assign(next, next + begun_.size());
  next += begun_.size();
  unpack_statistics(std::vector<double>(next, list + static_cast<std::size_t>(list[0])));
}
