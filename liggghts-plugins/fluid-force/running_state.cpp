/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "running_state.h"

#include "marked_grains.h"
#include "host/expose_member.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_contact_history_mesh.h"
#include "fix_mesh.h"
#include "fix_neighlist_mesh.h"
#include "modify.h"
#include "neighbor.h"
#include "update.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <utility>

using namespace LAMMPS_NS;

namespace grainjet {

struct PreForceList {
  using type = int *Modify::*;
  friend type member(PreForceList);
};

}

template struct grainjet::Expose<grainjet::PreForceList, &Modify::list_pre_force>;

/* ---------------------------------------------------------------------- */

RunningState::RunningState(LAMMPS *lmp) :
  Pointers(lmp), noted_(false), inRun_(false), holding_(false), resuming_(false), used_(false),
  nextSort_(0), ago_(0), sortEvery_(0), contactDistance_(1.0), written_(), read_()
{
  written_.stamp = read_.stamp = -1.0;
}

/* ---------------------------------------------------------------------- */

void RunningState::note_lists()
{
  const double *x = atom->nlocal ? atom->x[0] : NULL;
  listed_.assign(x, x + 3 * atom->nlocal);
  noted_ = true;
}

/* ----------------------------------------------------------------------
   those of another rank's part belong to whoever reads the file, in another order
------------------------------------------------------------------------- */

bool RunningState::outside(const double *x) const
{
  for (int dim = 0; dim < 3; dim++)
    if (!(x[dim] >= domain->sublo[dim] && x[dim] < domain->subhi[dim])) return true;
  return false;
}

/* ----------------------------------------------------------------------
   Called for the global part of a restart file, which comes before the grains. The file is one
   from between two runs if LIGGGHTS has worked out new lists for it, which are not in use.
------------------------------------------------------------------------- */

std::vector<double> RunningState::begin_write()
{
  int useful = update->whichflag == 1 && noted_ && listed_.size() == 3u * atom->nlocal, all;
  MPI_Allreduce(&useful, &all, 1, MPI_INT, MPI_MIN, world);
  inRun_ = all;

  moved_.clear();
  marked_.clear();
  if (inRun_) {
    find_marked();
    for (int i = 0; i < atom->nlocal; i++) {
      double *x = atom->x[i];
      if (!outside(x)) continue;
      moved_.push_back(Moved{i, {x[0], x[1], x[2]}});
      std::copy_n(&listed_[3 * i], 3, x);
    }
  }

  // no two files have the same: microseconds of the clock
  std::vector<double> list(NSAVED);
  list[VERSION] = LAYOUT;
  list[IN_RUN] = inRun_;
  list[STAMP] = static_cast<double>(std::chrono::duration_cast<std::chrono::microseconds>(
    std::chrono::system_clock::now().time_since_epoch()).count());
  list[STEP] = static_cast<double>(update->ntimestep);
  list[GRAINS] = static_cast<double>(atom->natoms);
  list[NEXT_SORT] = static_cast<double>(atom->nextsort);
  list[AGO] = neighbor->ago;
  MPI_Bcast(list.data(), NSAVED, MPI_DOUBLE, 0, world);
  written_ = GrainFile{list[STAMP], list[STEP], list[GRAINS]};
  return list;
}

/* ---------------------------------------------------------------------- */

void RunningState::end_write()
{
  for (const Moved &grain : moved_) std::copy_n(grain.x, 3, atom->x[grain.i]);
  moved_.clear();
}

/* ----------------------------------------------------------------------
   fix massflow/mesh deletes grains in the order in which it has marked them
------------------------------------------------------------------------- */

void RunningState::find_marked()
{
  double by = 0.0;
  for (int ifix = 0; ifix < modify->nfix; ifix++) {
    const std::vector<int> *tags = grainjet::marked_tags(modify->fix[ifix]);
    if (!tags) continue;
    by += 1.0;
    for (int tag : *tags) {
      const int i = atom->map(tag);
      if (i >= 0 && i < atom->nlocal) marked_.push_back(Marked{i, by, 1.0 * marked_.size()});
    }
  }
}

/* ---------------------------------------------------------------------- */

int RunningState::pack(int i, double *buf) const
{
  std::fill_n(buf, VALUES, 0.0);
  if (!inRun_) return VALUES;
  const double *x = atom->x[i];
  const auto moved = std::lower_bound(moved_.begin(), moved_.end(), i,
    [](const Moved &grain, int index) { return grain.i < index; });
  if (moved != moved_.end() && moved->i == i) x = moved->x;

  buf[VALID] = 1.0;
  std::copy_n(&listed_[3 * i], 3, buf + LISTED);
  std::copy_n(x, 3, buf + PRESENT);
  std::copy_n(atom->f[i], 3, buf + FORCE);
  std::copy_n(atom->torque[i], 3, buf + TORQUE);
  for (const Marked &grain : marked_) {
    if (grain.i != i) continue;
    buf[MARKED_BY] = grain.by;
    buf[PLACE] = grain.place;
  }
  return VALUES;
}

/* ---------------------------------------------------------------------- */

const double *RunningState::restart(const double *list)
{
  if (list[VERSION] != LAYOUT)
    error->all(FLERR, "Fix fluid/force: the restart file was written with another version of Grainjet, which "
      "keeps other data in it; continue with the version that wrote it");
  read_ = GrainFile{list[STAMP], list[STEP], list[GRAINS]};
  holding_ = list[IN_RUN] != 0.0;
  nextSort_ = static_cast<bigint>(list[NEXT_SORT]);
  ago_ = static_cast<int>(list[AGO]);
  return list + NSAVED;
}

/* ---------------------------------------------------------------------- */

void RunningState::unpack(int i, const double *buf)
{
  if (!holding_) return;
  grow(std::max(atom->nmax, i + 1));
  std::copy_n(buf, VALUES, &held_[VALUES * static_cast<size_t>(i)]);
}

/* ---------------------------------------------------------------------- */

void RunningState::grow(int nmax)
{
  const size_t size = VALUES * static_cast<size_t>(nmax);
  if (holding_ && held_.size() < size) held_.resize(size, 0.0);
}

void RunningState::copy(int i, int j)
{
  if (!holding_) return;
  grow(std::max(i, j) + 1);
  std::copy_n(&held_[VALUES * static_cast<size_t>(i)], VALUES, &held_[VALUES * static_cast<size_t>(j)]);
}

void RunningState::forget(int i)
{
  if (!holding_) return;
  grow(i + 1);
  held_[VALUES * static_cast<size_t>(i) + VALID] = 0.0;
}

int RunningState::pack_exchange(int i, double *buf) const
{
  if (!holding_) return 0;
  std::copy_n(&held_[VALUES * static_cast<size_t>(i)], VALUES, buf);
  return VALUES;
}

int RunningState::unpack_exchange(int i, const double *buf)
{
  if (!holding_) return 0;
  unpack(i, buf);
  return VALUES;
}

/* ----------------------------------------------------------------------
   A run goes on at the step of the file and with its grains only. With others among them, or at
   another step, it begins with a set-up of its own.
------------------------------------------------------------------------- */

bool RunningState::resume()
{
  resuming_ = false;
  if (!holding_) return false;

  int valid = update->whichflag == 1 && update->ntimestep == static_cast<bigint>(read_.step), all;
  grow(atom->nmax);
  for (int i = 0; valid && i < atom->nlocal; i++)
    valid = held_[VALUES * static_cast<size_t>(i) + VALID] != 0.0;
  MPI_Allreduce(&valid, &all, 1, MPI_INT, MPI_MIN, world);
  if (all) resuming_ = true;
  else if (update->whichflag == 1) finish();
  return resuming_;
}

/* ---------------------------------------------------------------------- */

void RunningState::move(int column)
{
  for (int i = 0; i < atom->nlocal; i++)
    std::copy_n(&held_[VALUES * static_cast<size_t>(i) + column], 3, atom->x[i]);
}

/* ----------------------------------------------------------------------
   Forces need the present positions, and the lists of mesh walls the former ones, but the host
   asks for both among the same hooks: those that make lists go first until the set-up is over.
------------------------------------------------------------------------- */

void RunningState::to_lists()
{
  move(LISTED);
  contactDistance_ = neighbor->contactDistanceFactor;
  keep_histories();

  sortEvery_ = atom->sortfreq;
  atom->sortfreq = 0;

  int *list = modify->*member(grainjet::PreForceList());
  order_.assign(list, list + modify->n_pre_force);
  const auto makesLists = [this](int ifix) {
    Fix *fix = modify->fix[ifix];
    return dynamic_cast<FixMesh *>(fix) || dynamic_cast<FixNeighlistMesh *>(fix)
      || dynamic_cast<FixContactHistoryMesh *>(fix);
  };
  const auto isOwn = [this](int ifix) { return strcmp(modify->fix[ifix]->style, "fluid/force") == 0; };
  int *rest = std::stable_partition(list, list + modify->n_pre_force, makesLists);
  std::stable_partition(rest, list + modify->n_pre_force, isOwn);
}

/* ----------------------------------------------------------------------
   pair_style gran takes up the history of a contact if the two grains touch when the list is made.
   They may not have touched then: whatever is in the list counts as touching.
------------------------------------------------------------------------- */

void RunningState::keep_histories()
{
  bool histories = false;
  for (int ifix = 0; ifix < modify->nfix; ifix++)
    histories |= strcmp(modify->fix[ifix]->style, "contacthistory") == 0;
  if (!histories) return;

  double smallest = HUGE_VAL, all;
  for (int i = 0; i < atom->nlocal; i++) smallest = std::min(smallest, atom->radius[i]);
  MPI_Allreduce(&smallest, &all, 1, MPI_DOUBLE, MPI_MIN, world);
  neighbor->contactDistanceFactor *= 1.0 + 0.5 * neighbor->skin / all;
}

/* ---------------------------------------------------------------------- */

void RunningState::lists_made()
{
  atom->sortfreq = sortEvery_;
  if (sortEvery_ > 0) atom->nextsort = nextSort_;
}

/* ---------------------------------------------------------------------- */

void RunningState::to_present()
{
  move(PRESENT);
  comm->forward_comm();
  neighbor->contactDistanceFactor = contactDistance_;
}

/* ---------------------------------------------------------------------- */

void RunningState::present_forces()
{
  for (int i = 0; i < atom->nlocal; i++) {
    const double *held = &held_[VALUES * static_cast<size_t>(i)];
    std::copy_n(held + FORCE, 3, atom->f[i]);
    std::copy_n(held + TORQUE, 3, atom->torque[i]);
  }
}

/* ---------------------------------------------------------------------- */

void RunningState::set_up()
{
  std::copy(order_.begin(), order_.end(), modify->*member(grainjet::PreForceList()));
  neighbor->ago = ago_;
  if (!used_) mark();
  used_ = true;
}

/* ---------------------------------------------------------------------- */

void RunningState::mark()
{
  double by = 0.0;
  for (int ifix = 0; ifix < modify->nfix; ifix++) {
    std::vector<int> *tags = grainjet::marked_tags(modify->fix[ifix]);
    if (!tags) continue;
    by += 1.0;

    std::vector<std::pair<double, int>> marked;
    for (int i = 0; i < atom->nlocal; i++) {
      const double *held = &held_[VALUES * static_cast<size_t>(i)];
      if (held[MARKED_BY] == by) marked.push_back(std::make_pair(held[PLACE], atom->tag[i]));
    }
    std::sort(marked.begin(), marked.end());
    for (const std::pair<double, int> &grain : marked) tags->push_back(grain.second);
  }
}

/* ---------------------------------------------------------------------- */

void RunningState::finish()
{
  holding_ = resuming_ = false;
  std::vector<double>().swap(held_);
}
