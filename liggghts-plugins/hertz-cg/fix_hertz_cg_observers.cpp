/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* fix hertz/cg: what other fixes get to know of its contacts */

#include "hertz-cg/fix_hertz_cg.h"
#include "hertz-cg/kinematics.h"
#include "host/grainjet_version.h"

#include "atom.h"
#include "update.h"

#include <cstring>

using namespace LAMMPS_NS;
using grainjet::ContactPairs;

/* ---------------------------------------------------------------------- */

void *FixHertzCg::extract(const char *what, int &dim)
{
  dim = 0;
  if (strcmp(what, "contact_version") == 0) return const_cast<char *>(GRAINJET_VERSION);
  if (strcmp(what, "contact_exchange") == 0) return static_cast<ContactExchange *>(this);
  return nullptr;
}

/* ---------------------------------------------------------------------- */

std::string FixHertzCg::observe(ContactObserver *observer, const std::string &name, int size)
{
  if (observers_.has(name)) return "fix hertz/cg is observed by another '" + name + "' already";
  observers_.add(observer, name, size, store_, pairs_);
  return "";
}

void FixHertzCg::ignore(const ContactObserver *observer)
{
  observers_.remove(observer, store_, pairs_);
}

bool FixHertzCg::observed(const ContactObserver *observer) const
{
  return observers_.has(observer);
}

/* ---------------------------------------------------------------------- */

void FixHertzCg::visit(const ContactObserver *observer, const Visit &visit) const
{
  const int nlocal = atom->nlocal;
  if (!pairs_valid_) {
    // put by, as after write_restart: by each of the two grains
    for (int i = 0; i < nlocal; ++i)
      for (int n = 0; n < store_.count(i); ++n) {
        const double *state = observers_.state(observer, store_.row(i, n));
        if (state) visit(atom->tag[i] < store_.entries(i)[n].partner, state);
      }
    return;
  }
  for (std::size_t p = 0; p < pairs_.size(); ++p) {
    if (!(pairs_.marks[p] & ContactPairs::TOUCHING)) continue;
    const double *state = observers_.state(observer, pairs_.row(p));
    const int i = pairs_.pairs[p].i, j = pairs_.pairs[p].j;
    if (state) visit(j < nlocal || atom->tag[i] < atom->tag[j], state);
  }
}

/* ----------------------------------------------------------------------
   a step of a contact; no longer marked when its grains have parted
------------------------------------------------------------------------- */

void FixHertzCg::observe_contact(const grainjet::Kinematics &k, std::size_t p, double work, bool begins, bool advance)
{
  if (!observers_.any()) return;
  const int i = pairs_.pairs[p].i, j = pairs_.pairs[p].j;
  const double mi = atom->rmass[i], mj = atom->rmass[j];
  ContactStep step;
  step.i = i;
  step.j = j;
  step.counts = j < atom->nlocal || atom->tag[i] < atom->tag[j];
  step.begins = begins;
  step.advances = advance;
  step.dt = update->dt;
  step.overlap = k.overlap;
  step.mass = 0.0;
  if (begins) step.mass = atom->mask[i] & freeze_bit_ ? mj : atom->mask[j] & freeze_bit_ ? mi : mi * mj / (mi + mj);
  step.normal = k.normal;
  step.velocity = k.velocity;
  step.slip = k.vt;
  step.work = work;
  if (pairs_.marks[p] & ContactPairs::TOUCHING) {
    step.force = pairs_.contacts[p].force;
    observers_.touches(step, pairs_.row(p));
  } else {
    step.force = {0.0, 0.0, 0.0};
    observers_.parted(step, pairs_.row(p));
  }
}
