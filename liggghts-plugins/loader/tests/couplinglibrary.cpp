/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* A library that depends on LIGGGHTS and holds the loader, as a coupling library does. */

#include "loader/lammps_create_hook.cpp"
#include "loader/plugin_command.cpp"
#include "loader/plugin_file.cpp"
#include "loader/host_build.cpp"
#include "loader/interposition.cpp"
#include "loader/library_file.cpp"
#include "loader/plugin_loader.cpp"
#include "loader/style_maps.cpp"
#include "loader/script_start.cpp"

extern "C" void run_script(char *file)
{
  char program[] = "coupling", nocite[] = "-nocite";
  char *arguments[] = {program, nocite};
  LAMMPS lmp(2, arguments, MPI_COMM_WORLD);
  lmp.input->file(file);
}
