/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_SEARCH_SETTINGS_H
#define GRAINJET_SEARCH_SETTINGS_H

#include "hertz-cg/wall_axes.h"

#include <algorithm>
#include <vector>

namespace LAMMPS_NS { class LAMMPS; }

namespace grainjet {

/* The host's settings around the search for neighbours, as fix hertz/cg needs them. LIGGGHTS
   derives them from the pair style; there is none here, so the fix sets them itself:

   - reach: the largest margin between surfaces with which pairs may be listed; so far ghosts are
     fetched. Chosen at the start of a run and again at searches, from how dense the grains lie
   - skin: how far beyond contact the walls' own lists reach. A mesh tests each listed pair of grain
     and triangle at every step, so the skin of the script's `neighbor` is its upper limit there
   - cut-offs, the largest and (for `communicate multi`) those of the types: what ghosts, mesh walls
     and bins are sized by
   - when to search: LIGGGHTS' own test by absolute displacement is switched off
   - sizes of bins for mesh walls and for sorting the grains in memory: LIGGGHTS would take half
     the cut-off, which cuts a mostly empty box into a hundred million bins. What the user set by
     `neigh_modify binsize` or `atom_modify sort` is left alone.                             */
class SearchSettings {
 public:

  explicit SearchSettings(LAMMPS_NS::LAMMPS *lmp) : lmp_(lmp) {}

  /* Choose all of it for a run. Call before the host initialises its neighbour search.
     radius: of the largest grain of each type, [1] to [number of types], 0 if there is none [m];
     packing: volume fraction where grains are, 0 for none yet. */
  void choose(const std::vector<double> &radius, double packing, const WallAxes &walls);

  // Some stock fix goes through the list of pairs for grains that do not touch: from the next choose() on
  // the reach is at least the script's skin, as with the stock pair style
  void require_skin(bool required) { required_ = required; }

  // m, least margin of the list: the script's skin where it is required, else 0
  double least() const { return required_ ? userSkin_ : 0.0; }

  // What the searches and lists so far have shown
  struct Work {
    double pairs;       // listed per grain, negative if nothing has been listed yet
    double margin;      // m, with which they were
    double triangles;   // listed per grain
    double search;      // cost of a search per grain, in visits of a listed pair
    double searches;    // per step
  };

  /* Choose reach and skin again at a search. True if they have changed: the host's communication and bins
     are then to be set up anew. With mesh walls the skin never grows beyond that at the start of the run,
     by which ranks share triangles. */
  bool adapt(const Work &work);

  // What a run that goes on with this one's lists, and with its grains in the same order, has to take over [m]
  struct Lengths { double reach = 0.0, skin = 0.0, largestSkin = 0.0, sortBin = 0.0; };
  Lengths lengths() const;

  // Have the next choose() take these: those of the run that is continued
  void keep(const Lengths &lengths) { kept_ = lengths; }

  // To be called once the host has initialised its neighbour search, which forgets them
  void set_cutoff() const;

  // Was a grain of this type and radius [m] to be expected?
  bool known(int type, double radius) const;

  // Is one of these radii [m, by type] beyond those that ghosts are fetched for?
  bool outgrown(const std::vector<double> &radius) const;

  // Fetch ghosts for these from now on; the host's communication and bins are then to be set up anew
  void grow(const std::vector<double> &radius);

  // group whose grains alone become ghosts (`communicate ... group`), 0: all
  int ghost_group() const;

  double reach() const { return reach_; }
  double skin() const { return skin_; }

  // cut-off to ask the host's communication for, which adds the skin to it: it then fetches every
  // grain i that is closer to another rank than the largest radius + the radius of i + reach()
  double ghosts() const { return diameter_ + 2.0 * (reach_ - skin_); }

  // m, a rank's part of the box along d where grains have neighbours beyond it: along periodic
  // sides and between ranks. Infinite where there is nothing beyond, and along z in two dimensions.
  double part(int d) const;

  // m, the smallest of the three
  double narrowest() const { return std::min(part(0), std::min(part(1), part(2))); }

  // Leave the host as it was before the first choose()
  void restore();

 private:

  double width(double packing) const;
  void limit_skin(double skin);
  double best_skin(const Work &work) const;
  void choose_bins();
  void choose_sorting();

  LAMMPS_NS::LAMMPS *lmp_;
  std::vector<double> radius_;
  WallAxes walls_ = {};
  double diameter_ = 0.0, reach_ = 0.0, skin_ = 0.0, largestSkin_ = 0.0;
  Lengths kept_;           // reach 0: nothing is kept
  bool taken_ = false, required_ = false;
  double userSkin_ = 0.0;
  int userDelay_ = 0;
  bool ownBins_ = false, ownSortBins_ = false;
};

}

#endif
