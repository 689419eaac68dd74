/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

// wmake keeps no objects for files outside of its folder, so the library takes it in as well
#include "physics/drag/drag_batch.cpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <vector>

using namespace grainjet::drag;

namespace {

const double RHO = 1.2, NU = 1.5e-5, D = 80e-6;

// All that OpenFOAM stops a program for
struct Traps {
  Traps() { feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW); }
  ~Traps() { fedisableexcept(FE_ALL_EXCEPT); }
};

// Rest, both sides of all branches, and a void fraction that exceeds 1 by round-off
const std::vector<double> REYNOLDS = {0, 1e-12, 1e-3, 0.5, 30, 900, 999.9, 1000.1, 1e4, 1e6};
const std::vector<double> VOID_FRACTIONS = {0.3, 0.45, 0.5999, 0.6001, 0.7999, 0.8001, 0.95,
  1 - 1e-9, 1, 1 + 4e-16};

std::vector<State> states()
{
  std::vector<State> all;
  for (double eps : VOID_FRACTIONS)
    for (double re : REYNOLDS) all.push_back({eps, re * NU / (eps * D), D, RHO, NU});
  return all;
}

void put(Batch &batch, int i, const State &s)
{
  batch.voidFraction[i] = s.voidFraction;
  batch.slipSpeed[i] = s.slipSpeed;
  batch.diameter[i] = s.diameter;
  batch.viscosity[i] = s.viscosity;
}

// The law for each kind of processor whose programs this one can run
template <std::size_t... ALL>
std::vector<BatchLaw> kinds(std::size_t wanted, std::index_sequence<ALL...>)
{
  std::vector<BatchLaw> found;
  ((ALL == wanted ? void(found = forThisProcessor<ALL>()) : void()), ...);
  return found;
}

std::vector<BatchLaw> kinds(const NamedLaw &law)
{
  return kinds(&law - LAWS, std::make_index_sequence<std::size(LAWS)>());
}

}

// glibc promises 4 units of the last digit (8.9e-16) for its vector functions; ten of them
// through exponents of up to 10 (0.687 ln 1e6)
TEST(DragBatch, SameAsTheLawOfOneGrain)
{
  const std::vector<State> all = states();
  for (const NamedLaw &entry : LAWS) {
    Batch batch(RHO);
    for (std::size_t first = 0; first < all.size(); first += Batch::SIZE) {
      for (int i = 0; i < Batch::SIZE; i++) put(batch, i, all[(first + i) % all.size()]);
      findBatchLaw(entry.script, &NamedLaw::script)(batch);
      for (int i = 0; i < Batch::SIZE; i++) {
        const State &s = all[(first + i) % all.size()];
        const double one = entry.law(s);
        EXPECT_NEAR(batch.drag[i], one, 2e-14 * one)
          << entry.script << " at eps " << s.voidFraction << ", slip " << s.slipSpeed;
      }
    }
  }
}

// Also on a processor with narrower registers
TEST(DragBatch, SameOnAnyProcessor)
{
  const std::vector<State> all = states();
  for (const NamedLaw &entry : LAWS) {
    Batch batch(RHO), other(RHO);
    for (int i = 0; i < Batch::SIZE; i++) {
      put(batch, i, all[3 * i]);
      put(other, i, all[3 * i]);
    }
    findBatchLaw(entry.script, &NamedLaw::script)(batch);
    const std::vector<BatchLaw> laws = kinds(entry);
    for (std::size_t kind = 0; kind < laws.size(); kind++) {
      laws[kind](other);
      for (int i = 0; i < Batch::SIZE; i++)
        EXPECT_NEAR(batch.drag[i], other.drag[i], 2e-14 * other.drag[i])
          << entry.script << ", kind " << kind << ", grain " << i;
    }
  }
}

// Bit for bit: a restarted run may find a grain in another place
TEST(DragBatch, DragDoesNotDependOnThePlace)
{
  const State s = {0.87, 1.3, D, RHO, NU};
  for (const NamedLaw &entry : LAWS) {
    Batch batch(RHO);
    for (int i = 0; i < Batch::SIZE; i++) put(batch, i, s);
    findBatchLaw(entry.script, &NamedLaw::script)(batch);
    for (int i = 1; i < Batch::SIZE; i++) EXPECT_EQ(batch.drag[i], batch.drag[0]) << entry.script;
  }
}

// A grain at rest in a fluid at rest stopped OpenFOAM with DiFelice: log10(0) is a division by
// zero. Neither a law nor the batch, new or filled, may raise an exception
TEST(DragBatch, NoFloatingPointException)
{
  const Traps traps;
  for (const NamedLaw &entry : LAWS) {
    for (const BatchLaw law : kinds(entry)) {
      Batch batch(RHO);
      law(batch);
      for (const State &s : states()) {
        EXPECT_TRUE(std::isfinite(entry.law(s))) << entry.script;
        put(batch, 5, s);
        law(batch);
        EXPECT_TRUE(std::isfinite(batch.drag[5])) << entry.script;
      }
    }
  }
}

TEST(DragBatch, UnknownName)
{
  EXPECT_EQ(findBatchLaw("gidaspow", &NamedLaw::dictionary), nullptr);
  EXPECT_NE(findBatchLaw("Gidaspow", &NamedLaw::dictionary), nullptr);
}
