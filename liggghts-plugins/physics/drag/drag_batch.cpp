/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

// Neither errno nor an exception of a branch that is not taken, which the laws do not have,
// shall keep the compiler from working on several grains at once. Before all headers, for
// functions of different kinds do not inline each other.
#pragma GCC optimize("no-math-errno", "no-trapping-math")

#include "physics/drag/drag_batch.h"

#include <iterator>
#include <utility>
#include <vector>

// glibc has these for several numbers at once, but says so to programs with -ffast-math only
#if defined(__x86_64__) && defined(__GLIBC__) && !defined(__clang__)
#define GRAINJET_VECTOR_LAWS
extern "C" {
double exp(double) noexcept __attribute__((const, simd("notinbranch")));
double log(double) noexcept __attribute__((const, simd("notinbranch")));
double sqrt(double) noexcept __attribute__((const));
}
#endif

namespace grainjet {
namespace drag {

namespace {

template <std::size_t LAW>
inline __attribute__((always_inline)) void evaluate(Batch &b)
{
  for (int i = 0; i < Batch::SIZE; i++)
    b.drag[i] = LAWS[LAW].law(
      State{b.voidFraction[i], b.slipSpeed[i], b.diameter[i], b.density, b.viscosity[i]});
}

template <std::size_t LAW>
void anyProcessor(Batch &b)
{
  evaluate<LAW>(b);
}

#ifdef GRAINJET_VECTOR_LAWS
template <std::size_t LAW>
__attribute__((target("avx2,fma"))) void withAvx2(Batch &b)
{
  evaluate<LAW>(b);
}

template <std::size_t LAW>
__attribute__((target("avx512f,avx512dq,avx512vl,fma,prefer-vector-width=512")))
void withAvx512(Batch &b)
{
  evaluate<LAW>(b);
}
#endif

// All that this processor can run, the fastest last
template <std::size_t LAW>
std::vector<BatchLaw> forThisProcessor()
{
  std::vector<BatchLaw> kinds = {anyProcessor<LAW>};
#ifdef GRAINJET_VECTOR_LAWS
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    kinds.push_back(withAvx2<LAW>);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")
      && __builtin_cpu_supports("avx512vl"))
    kinds.push_back(withAvx512<LAW>);
#endif
  return kinds;
}

template <std::size_t... ALL>
BatchLaw select(std::size_t wanted, std::index_sequence<ALL...>)
{
  BatchLaw law = nullptr;
  ((ALL == wanted ? void(law = forThisProcessor<ALL>().back()) : void()), ...);
  return law;
}

}

BatchLaw findBatchLaw(const std::string &name, Spelling spelling)
{
  std::size_t i = 0;
  while (i < std::size(LAWS) && name != LAWS[i].*spelling) i++;
  return select(i, std::make_index_sequence<std::size(LAWS)>());
}

}
}
