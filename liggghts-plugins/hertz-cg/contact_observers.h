/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_CONTACT_OBSERVERS_H
#define GRAINJET_CONTACT_OBSERVERS_H

#include "hertz-cg/contact_exchange.h"
#include "hertz-cg/contact_pairs.h"
#include "hertz-cg/contact_store.h"

#include <string>
#include <vector>

namespace grainjet {

/* Who watches the contacts, and where the state of each lies in the row of numbers that a contact has
   for all of them. A restart file brings places of observers that are still to come.          */
class ContactObservers {
 public:

  bool any() const { return !places_.empty(); }
  int size() const { return size_; }      // numbers of a row
  bool has(const std::string &name) const;
  bool has(const LAMMPS_NS::ContactObserver *) const;

  // Rows of both are laid out anew
  void add(LAMMPS_NS::ContactObserver *, const std::string &name, int size, ContactStore &, ContactPairs &);
  void remove(const LAMMPS_NS::ContactObserver *, ContactStore &, ContactPairs &);
  void removeAbsent(ContactStore &, ContactPairs &);      // places that no observer has taken

  void touches(const LAMMPS_NS::ContactStep &, double *row) const;
  void parted(const LAMMPS_NS::ContactStep &, const double *row) const;

  // part of a row; NULL: not an observer
  const double *state(const LAMMPS_NS::ContactObserver *, const double *row) const;

  // ---- as doubles

  std::vector<double> pack() const;
  void unpack(const double *, ContactStore &, ContactPairs &);    // before there are contacts

 private:

  struct Place {
    LAMMPS_NS::ContactObserver *observer;    // NULL: still to come
    std::string name;
    int size, first;
  };

  std::vector<Place> places_;
  int size_ = 0;

  void layOut(std::vector<Place>, ContactStore &, ContactPairs &);
};

}

#endif
