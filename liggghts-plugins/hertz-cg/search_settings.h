/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_SEARCH_SETTINGS_H
#define GRAINJET_SEARCH_SETTINGS_H

#include "hertz-cg/wall_axes.h"

namespace LAMMPS_NS { class LAMMPS; }

namespace grainjet {

/* The host's settings around the search for neighbours, as fix hertz/cg needs them. LIGGGHTS
   derives them from the pair style; there is none here, so the fix sets them itself:

   - reach: the largest margin between surfaces with which pairs may be listed; so far ghosts are
     fetched
   - skin: how far beyond contact the walls' own lists reach
   - largest cut-off: what mesh walls and bins are sized by
   - when to search: LIGGGHTS' own test by absolute displacement is switched off
   - sizes of bins for mesh walls and for sorting the grains in memory: LIGGGHTS would take half
     the cut-off, which cuts a mostly empty box into a hundred million bins. What the user set by
     `neigh_modify binsize` or `atom_modify sort` is left alone.                             */
class SearchSettings {
 public:

  explicit SearchSettings(LAMMPS_NS::LAMMPS *lmp) : lmp_(lmp) {}

  /* Choose all of it for a run. Call before the host initialises its neighbour search.
     diameter: of the largest grain [m]; packing: volume fraction where grains are, 0 for none yet. */
  void choose(double diameter, double packing, const WallAxes &walls);

  // Some stock fix goes through the list of pairs for grains that do not touch: from the next choose() on
  // the reach is at least the script's skin, as with the stock pair style
  void require_skin(bool required) { required_ = required; }

  // m, least margin of the list: the script's skin where it is required, else 0
  double least() const { return required_ ? userSkin_ : 0.0; }

  // Have the next choose() take this reach [m]: that of the run that is continued
  void keep(double reach) { kept_ = reach; }

  // To be called once the host has initialised its neighbour search, which forgets it
  void set_cutoff() const;

  double reach() const { return reach_; }
  double skin() const { return skin_; }

  // cut-off to ask the host's communication for, which adds the skin to it: it then fetches every
  // grain i that is closer to another rank than the largest radius + the radius of i + reach()
  double ghosts() const { return diameter_ + 2.0 * (reach_ - skin_); }

  // Leave the host as it was before the first choose()
  void restore();

 private:

  void choose_bins(bool meshWalls);
  void choose_sorting();

  LAMMPS_NS::LAMMPS *lmp_;
  double diameter_ = 0.0, reach_ = 0.0, skin_ = 0.0, kept_ = 0.0;
  bool taken_ = false, required_ = false;
  double userSkin_ = 0.0;
  int userDelay_ = 0;
  bool ownBins_ = false, ownSortBins_ = false;
};

}

#endif
