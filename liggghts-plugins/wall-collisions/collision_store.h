/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_COLLISION_STORE_H
#define GRAINJET_COLLISION_STORE_H

#include "collision.h"

#include <algorithm>
#include <vector>

namespace grainjet {

/* Collisions in progress, by local index of the grain. Few grains are in contact at a time,
   so a grain holds no more than the number of its record: that is what is copied when
   grains are sorted, and one value is what a free grain adds to a message.

   The functions mirror what LIGGGHTS asks of a fix with per-grain data.              */
class CollisionStore {
 public:

  // kept: how many doubles of a record are used, the first ones; temperature: so is that, which is the
  // last one
  explicit CollisionStore(int kept = Collision::OF_SURFACE, bool temperature = false)
    : kept_(kept), temperature_(temperature) {}

  // room for n grains; new places are free
  void grow(int n) { if (n > static_cast<int>(record_.size())) record_.resize(n, NONE); }

  // a new grain lies at this place
  void reset(int i) { record_[i] = NONE; }

  // the collision of grain i, or NULL
  Collision *find(int i) { return record_[i] == NONE ? NULL : &records_[record_[i]]; }
  const Collision *find(int i) const
  {
    return record_[i] == NONE ? NULL : &records_[record_[i]];
  }

  // a collision of grain i, all zero; must not have one
  Collision &begin(int i)
  {
    if (free_.empty()) {
      free_.push_back(static_cast<int>(records_.size()));
      records_.push_back(Collision());
    }
    record_[i] = free_.back();
    free_.pop_back();
    return records_[record_[i]] = Collision();
  }

  void end(int i)
  {
    if (record_[i] != NONE) free_.push_back(record_[i]);
    record_[i] = NONE;
  }

  // Grain `from` comes to lie at `to`. removed: the grain that lay there is no more on this
  // rank (from == to: it was the last one); else it was itself moved before.
  void move(int from, int to, bool removed)
  {
    if (removed) end(to);
    if (from != to) record_[to] = record_[from];
  }

  // ---- as doubles: 0, or 1 and the record

  static constexpr int PACKED = 1 + Collision::SIZE;    // at most, of any store

  int packed() const { return 1 + kept_ + (temperature_ ? 1 : 0); }

  int pack(int i, double *buffer) const
  {
    const Collision *collision = find(i);
    buffer[0] = collision ? 1.0 : 0.0;
    if (!collision) return 1;
    std::copy_n(collision->data(), kept_, buffer + 1);
    if (temperature_) buffer[1 + kept_] = collision->temperature;
    return packed();
  }

  int unpack(int i, const double *buffer) { return unpack(i, buffer, temperature_); }

  // temperature: the record has one, also where the store keeps none
  int unpack(int i, const double *buffer, bool temperature)
  {
    reset(i);
    if (buffer[0] == 0.0) return 1;
    Collision &collision = begin(i);
    std::copy_n(buffer + 1, kept_, collision.data());
    if (temperature) collision.temperature = buffer[1 + kept_];
    return 1 + kept_ + (temperature ? 1 : 0);
  }

 private:

  static constexpr int NONE = -1;
  int kept_;
  bool temperature_;
  std::vector<int> record_;           // per grain
  std::vector<Collision> records_;
  std::vector<int> free_;             // records that are not in use
};

}

#endif
