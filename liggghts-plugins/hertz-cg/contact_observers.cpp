/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "hertz-cg/contact_observers.h"

#include <algorithm>
#include <utility>

using namespace grainjet;
using LAMMPS_NS::ContactObserver;
using LAMMPS_NS::ContactStep;

/* ---------------------------------------------------------------------- */

bool ContactObservers::has(const std::string &name) const
{
  return std::any_of(places_.begin(), places_.end(),
                     [&name](const Place &p) { return p.observer && p.name == name; });
}

bool ContactObservers::has(const ContactObserver *observer) const
{
  return std::any_of(places_.begin(), places_.end(), [observer](const Place &p) { return p.observer == observer; });
}

/* ----------------------------------------------------------------------
   Places whose name is among the former ones keep their numbers; others begin with zeros
------------------------------------------------------------------------- */

void ContactObservers::layOut(std::vector<Place> places, ContactStore &store, ContactPairs &pairs)
{
  std::vector<int> from;
  for (Place &place : places) {
    place.first = static_cast<int>(from.size());
    const auto old = std::find_if(places_.begin(), places_.end(),
                                  [&place](const Place &p) { return p.name == place.name && p.size == place.size; });
    for (int n = 0; n < place.size; ++n) from.push_back(old == places_.end() ? -1 : old->first + n);
  }
  store.layOut(from);
  pairs.layOut(from);
  places_ = std::move(places);
  size_ = static_cast<int>(from.size());
}

/* ---------------------------------------------------------------------- */

void ContactObservers::add(ContactObserver *observer, const std::string &name, int size, ContactStore &store,
                           ContactPairs &pairs)
{
  std::vector<Place> places = places_;
  const auto same = std::find_if(places.begin(), places.end(), [&name](const Place &p) { return p.name == name; });
  if (same != places.end()) places.erase(same);
  places.push_back({observer, name, size, 0});
  layOut(std::move(places), store, pairs);
}

/* ---------------------------------------------------------------------- */

void ContactObservers::remove(const ContactObserver *observer, ContactStore &store, ContactPairs &pairs)
{
  std::vector<Place> places;
  for (const Place &place : places_)
    if (place.observer != observer) places.push_back(place);
  if (places.size() != places_.size()) layOut(std::move(places), store, pairs);
}

void ContactObservers::removeAbsent(ContactStore &store, ContactPairs &pairs)
{
  remove(nullptr, store, pairs);
}

/* ---------------------------------------------------------------------- */

void ContactObservers::touches(const ContactStep &step, double *row) const
{
  for (const Place &place : places_)
    if (place.observer) place.observer->touches(step, row + place.first);
}

void ContactObservers::parted(const ContactStep &step, const double *row) const
{
  for (const Place &place : places_)
    if (place.observer) place.observer->parted(step, row + place.first);
}

/* ---------------------------------------------------------------------- */

const double *ContactObservers::state(const ContactObserver *observer, const double *row) const
{
  for (const Place &place : places_)
    if (place.observer == observer) return row + place.first;
  return nullptr;
}

/* ----------------------------------------------------------------------
   number of places; size, length of the name and name of each
------------------------------------------------------------------------- */

std::vector<double> ContactObservers::pack() const
{
  std::vector<double> list = {static_cast<double>(places_.size())};
  for (const Place &place : places_) {
    list.push_back(place.size);
    list.push_back(place.name.size());
    list.insert(list.end(), place.name.begin(), place.name.end());
  }
  return list;
}

void ContactObservers::unpack(const double *next, ContactStore &store, ContactPairs &pairs)
{
  places_.clear();
  size_ = 0;
  for (int n = static_cast<int>(*next++); n > 0; --n) {
    const int size = static_cast<int>(*next++);
    const std::size_t length = static_cast<std::size_t>(*next++);
    places_.push_back({nullptr, std::string(next, next + length), size, size_});
    next += length;
    size_ += size;
  }
  const std::vector<int> zeros(size_, -1);
  store.layOut(zeros);
  pairs.layOut(zeros);
}
