/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* couplingprogram <library> <script>: like an OpenFOAM solver, knows nothing of LIGGGHTS, opens
   the coupling library at run time and has it run an input script.             */

#include <mpi.h>

#include <dlfcn.h>
#include <stdio.h>

int main(int argc, char **argv)
{
  MPI_Init(&argc, &argv);
  void *library = argc == 3 ? dlopen(argv[1], RTLD_LAZY | RTLD_GLOBAL) : NULL;
  void *run = library ? dlsym(library, "run_script") : NULL;
  if (!run) {
    fprintf(stderr, "couplingprogram: %s\n", argc == 3 ? dlerror() : "expected a library and a script");
    MPI_Abort(MPI_COMM_WORLD, 2);
  }
  reinterpret_cast<void (*)(char *)>(run)(argv[2]);
  MPI_Finalize();
}
