/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_CONTACT_EXCHANGE_H
#define GRAINJET_CONTACT_EXCHANGE_H

/* How another library looks at the contacts of `fix hertz/cg`. This header is the whole interface. An
   observer finds the fix by its style name and compares, before anything else,

       int dim;
       auto *version = static_cast<const char *>(fix->extract("contact_version", dim));

   with GRAINJET_VERSION of host/grainjet_version.h (NULL: the fix is older than that entry), and asks

       auto *contacts = static_cast<ContactExchange *>(fix->extract("contact_exchange", dim));

   Values are in SI units and of the whole GRAIN. What nobody observes takes neither memory nor time, and
   the fix computes and writes the same with and without observers.                            */

#include "physics/contact/vector3.h"

#include <functional>
#include <string>

namespace LAMMPS_NS {

// One step of one contact. A pair of grains of two ranks, or across a periodic boundary, is computed
// on both sides: both tell it to their observers, and one of them has `counts`
struct ContactStep {
  int i, j;                               // local indices; i is owned, j may be a ghost
  bool counts;
  bool begins;                            // the first step in contact
  bool advances;                          // false: forces before the first step of a run
  double dt;                              // s
  double overlap;                         // m; 0 or less: the grains have parted
  double mass;                            // kg, m*: 1/m* = 1/m_i + 1/m_j, the other's mass if one is frozen;
                                          // only where begins is set, else 0
  grainjet::contact::Vector3 normal;      // unit, from j to i
  grainjet::contact::Vector3 velocity;    // m/s, of the centre of i relative to that of j. Of mid-step: where
                                          // begins is set, no force of the contact has acted yet
  grainjet::contact::Vector3 slip;        // m/s, tangential velocity at the contact point, with rotation
  grainjet::contact::Vector3 force;       // N, on i
  double work;                            // J, that the contact has done on both grains over the step
};

/* Watches contacts and keeps numbers of each, its state. It goes where the contact goes: to other ranks,
   through searches and restart files. It must be the same seen from either grain. A contact begins with
   zeros; so do the contacts that were there before the observer.                               */
class ContactObserver {
 public:

  // the two grains touch
  virtual void touches(const ContactStep &, double *state) = 0;

  // The first step in which they do not touch any more. Contacts of deleted or displaced grains
  // end without it
  virtual void parted(const ContactStep &, const double *state) = 0;

 protected:

  ~ContactObserver() = default;
};

/* The functions that change the observers are called on all ranks alike and between runs. */
class ContactExchange {
 public:

  // From now on. name: one that no other observer has; by it and its size the state is found in a restart file.
  // Empty, or what forbids it
  virtual std::string observe(ContactObserver *, const std::string &name, int size) = 0;

  virtual void ignore(const ContactObserver *) = 0;
  virtual bool observed(const ContactObserver *) const = 0;

  using Visit = std::function<void(bool counts, const double *state)>;

  // all contacts of this rank that go on now
  virtual void visit(const ContactObserver *, const Visit &) const = 0;

 protected:

  ~ContactExchange() = default;
};

}

#endif
