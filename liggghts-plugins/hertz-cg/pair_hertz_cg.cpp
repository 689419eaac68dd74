/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "hertz-cg/pair_hertz_cg.h"
#include "hertz-cg/fix_hertz_cg.h"

#include "atom.h"
#include "compute_pair_gran_local.h"
#include "error.h"
#include "fix_contact_property_atom.h"
#include "force.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "update.h"

#include <algorithm>
#include <cstdio>
#include <cstring>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

PairHertzCg::PairHertzCg(LAMMPS *lmp, FixHertzCg *fix) : PairGran(lmp), fix_(fix)
{
  needs_neighlist = false;
  list = new NeighList(lmp);
  // its own arrays only: no pages, which its constructor leaves undefined
  list->ipage = nullptr;
  list->dpage = nullptr;
  list->ghostflag = 0;

  // what `compute pair/gran/local ... history` shows of a contact
  dnum_pairgran = 0;
  if (fix->law_.tangential == grainjet::contact::Tangential::HISTORY) dnum_pairgran += 3;
  if (fix->law_.rollingSpring()) dnum_pairgran += 3;

  // what `pair_coeff * *` would do
  allocate();
  for (int i = 1; i <= atom->ntypes; ++i)
    for (int j = i; j <= atom->ntypes; ++j) setflag[i][j] = 1;
}

/* ---------------------------------------------------------------------- */

PairHertzCg::~PairHertzCg()
{
  fix_->stand_in_ = nullptr;
  delete list;
}

/* ---------------------------------------------------------------------- */

void PairHertzCg::settings(int, char **)
{
  error->all(FLERR, "Fix hertz/cg has taken the place of the pair style; it has no settings");
}

/* ----------------------------------------------------------------------
   the checks of the fix come first, their messages say what to do
------------------------------------------------------------------------- */

void PairHertzCg::init_style()
{
  fix_->check_host();
  // the fix has set a delay that is never reached; the host's advice against one is for the user's
  const int delay = neighbor->delay;
  neighbor->delay = 0;
  PairGran::init_style();
  neighbor->delay = delay;
}

/* ----------------------------------------------------------------------
   a step, or (addflag) only to tell compute pair/gran/local
------------------------------------------------------------------------- */

void PairHertzCg::compute_force(int eflag, int vflag, int addflag)
{
  if (eflag || vflag) ev_setup(eflag, vflag);
  else evflag = vflag_fdotr = 0;

  if (addflag) {
    fix_->tell_contacts();
    if (cpl()) cpl_pair_finalize();
    return;
  }
  fix_->compute(shearupdate_);
  if (storeContactForces()) fix_contact_forces()->do_forward_comm();
  if (storeContactForcesStress()) fix_contact_forces_stress()->do_forward_comm();
}

/* ---------------------------------------------------------------------- */

bool PairHertzCg::contact_match(const std::string kind, const std::string model)
{
  if (kind == "model") return model == "hertz";
  if (kind == "surface") return model == "default";
  return false;
}

/* ----------------------------------------------------------------------
   The host has just written that a pair style `gran` follows. It would be read as the stock one, which
   knows nothing of this: take the record back, so that the file is as one without a pair style.
------------------------------------------------------------------------- */

void PairHertzCg::write_restart(FILE *fp)
{
  const long record = 2 * sizeof(int) + strlen(force->pair_style) + 1;
  if (fseek(fp, -record, SEEK_CUR))
    error->one(FLERR, "Fix hertz/cg: the restart file cannot be written; it must be a plain file");
}

/* ---------------------------------------------------------------------- */

void PairHertzCg::show(const grainjet::ContactPairs &pairs, int nlocal)
{
  const int n = static_cast<int>(pairs.size());
  if (list->get_maxlocal() < atom->nmax) list->grow(atom->nmax);
  first_.assign(nlocal + 1, 0);
  order_.resize(n);
  partners_.resize(n);
  for (int p = 0; p < n; ++p) ++first_[pairs.pairs[p].i + 1];
  for (int i = 0; i < nlocal; ++i) first_[i + 1] += first_[i];
  list->inum = nlocal;
  for (int i = 0; i < nlocal; ++i) {
    list->ilist[i] = i;
    list->numneigh[i] = 0;
    list->firstneigh[i] = partners_.data() + first_[i];
  }
  for (int p = 0; p < n; ++p) {
    const int i = pairs.pairs[p].i, at = first_[i] + list->numneigh[i]++;
    partners_[at] = pairs.pairs[p].j;
    order_[at] = p;
  }
}

/* ---------------------------------------------------------------------- */

bool PairHertzCg::storing() const
{
  return storeContactForces() && update->ntimestep % storeContactForcesEvery() == 0;
}

bool PairHertzCg::watched() const
{
  return evflag || storing() || store_contact_forces_stress_ || store_sum_normal_force();
}

/* ---------------------------------------------------------------------- */

void PairHertzCg::store(FixContactPropertyAtom *fix, int i, int j, const double *force, const double *rest,
                        int nrest)
{
  if (fix->has_partner(i, atom->tag[j]) != -1) return;
  double values[6];
  std::copy(force, force + 3, values);
  std::copy(rest, rest + nrest, values + 3);
  fix->add_partner(i, atom->tag[j], values);
}

/* ---------------------------------------------------------------------- */

void PairHertzCg::tell(const Contact &c)
{
  const double *f = c.force;
  const double opposite[3] = {-f[0], -f[1], -f[2]};
  if (evflag)
    ev_tally_xyz(c.i, c.j, atom->nlocal, force->newton_pair, 0.0, 0.0, f[0], f[1], f[2],
                 c.delta[0], c.delta[1], c.delta[2]);
  if (store_sum_normal_force()) {
    const double along = f[0] * c.normal[0] + f[1] * c.normal[1] + f[2] * c.normal[2];
    *get_sum_normal_force_ptr(c.i) += along;
    if (c.j < atom->nlocal) *get_sum_normal_force_ptr(c.j) += along;
  }
  if (storing()) {
    store(fix_contact_forces(), c.i, c.j, f, c.torqueI, 3);
    store(fix_contact_forces(), c.j, c.i, opposite, c.torqueJ, 3);
  }
  if (storeContactForcesStress()) {
    const double i = c.i, j = c.j;
    store(fix_contact_forces_stress(), c.i, c.j, f, &j, 1);
    store(fix_contact_forces_stress(), c.j, c.i, opposite, &i, 1);
  }
}

/* ---------------------------------------------------------------------- */

void PairHertzCg::tell_local(Contact &c)
{
  if (!cpl()) return;
  cpl()->add_pair(c.i, c.j, c.force[0], c.force[1], c.force[2], c.torqueI[0], c.torqueI[1], c.torqueI[2],
                  c.history, nullptr);
}
