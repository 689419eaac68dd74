/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* Tells a program which build of LIGGGHTS it has loaded. */

#include "loader/host_build.cpp"

extern "C" const char *host_stamp()
{
  static const std::string stamp = grainjet::host_build::stamp();
  return stamp.c_str();
}

extern "C" const char *host_misfit(const char *stamp)
{
  static std::string misfit;
  misfit = grainjet::host_build::misfit(stamp);
  return misfit.c_str();
}
