/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_CONTACT_STORE_H
#define GRAINJET_CONTACT_STORE_H

#include "physics/contact/vector3.h"

#include <cstddef>
#include <vector>

namespace grainjet {

/* What a touching pair remembers, seen from its first grain i. Forces are those of the last step:
   the work done over a step needs them, and a run that is continued from a restart file written
   in its middle starts from them.                                                           */
struct Contact {
  contact::Vector3 spring;     // m, tangential spring
  contact::Vector3 force;      // N, on i
  contact::Vector3 twist;      // N, n x Ft: times minus the arm it is the torque on either grain
  contact::Vector3 rolling;    // N m, torque of rolling friction on i
  contact::Vector3 rollingSpring;   // N m, part of it that a rolling spring remembers

  // the same contact seen from the other grain; n and Ft both turn round, so twist does not
  Contact mirrored() const
  {
    return {-1.0 * spring, -1.0 * force, twist, -1.0 * rolling, -1.0 * rollingSpring};
  }
};

// Number n of each row now comes from where number from[n] was; -1: it begins with zero. row: numbers of
// a row until now
void layOutRows(std::vector<double> &rows, std::size_t row, std::size_t count, const std::vector<int> &from);

/* Contacts kept per grain, by the ID of the other grain. Between two searches for neighbours
   contacts live in the list of pairs (ContactPairs); here they are while grains change their
   index, their rank or the program (restart). Each of the two grains has its own copy, so a
   contact survives wherever they go.                                                      */
class ContactStore {
 public:

  struct Entry {
    int partner;      // ID of the other grain
    int marks;        // ContactPairs::Mark
    Contact contact;
  };

  // Do contacts have a rolling spring? Without it is neither sent nor written
  void keepRollingSpring(bool keep) { rollingSpring_ = keep; }
  int values() const { return (rollingSpring_ ? 17 : 14) + row_; }    // numbers in which an entry is packed

  // Each contact has a row of numbers that observers keep of it, none at first
  void layOut(const std::vector<int> &from);
  int row() const { return row_; }

  void resize(int ngrains);
  void clear();                                  // no grain has contacts
  void add(int grain, const Entry &entry, const double *row = nullptr);    // grain by grain, in any order
  void finish();                                 // after the last add()

  int count(int grain) const { return count_[grain]; }
  const Entry *entries(int grain) const { return entries_.data() + first_[grain]; }
  const double *row(int grain, int n) const { return rows_.data() + static_cast<std::size_t>(row_) * (first_[grain] + n); }
  int largest() const { return largest_; }       // most contacts any grain had since clear()

  void copy(int from, int to) { count_[to] = count_[from]; first_[to] = first_[from]; }
  void forget(int grain) { count_[grain] = 0; }

  int packed_size(int grain) const { return 1 + values() * count_[grain]; }
  int pack(int grain, double *buffer) const;             // returns the numbers written
  int unpack(int grain, const double *buffer);           // returns the numbers read

  std::size_t bytes() const;

 private:

  struct Added { int grain; Entry entry; };

  std::vector<int> count_, first_;
  std::vector<Entry> entries_;
  std::vector<Added> added_;
  std::vector<double> rows_, addedRows_;    // beside entries_ and added_
  int row_ = 0;
  int largest_ = 0;
  bool rollingSpring_ = false;
};

}

#endif
