/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_VECTOR_REGISTERS_H
#define GRAINJET_VECTOR_REGISTERS_H

/* Loops over many grains that are compiled twice, for any processor and for those with AVX2, and chosen as the
   program runs. AVX2 has no operation that rounds once for a product and a sum, so the digits are the same.

   GRAINJET_IN_BOTH: of a function that is to be part of both. GRAINJET_AVX2: of the one that calls it for AVX2. */
#define GRAINJET_IN_BOTH __attribute__((always_inline))

#ifdef __x86_64__
#define GRAINJET_AVX2 __attribute__((target("avx2")))
#else
#define GRAINJET_AVX2
#endif

namespace grainjet {

inline bool has_avx2()
{
#ifdef __x86_64__
  return __builtin_cpu_supports("avx2");
#else
  return false;
#endif
}

}

#endif
