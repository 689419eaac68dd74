/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_HOST_FUNCTION_H
#define GRAINJET_HOST_FUNCTION_H

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>

namespace grainjet {

// an address in the library of LIGGGHTS: a function of it that nobody interposes; NULL if there is
// no LIGGGHTS in this process
inline void *host_landmark()
{
  const char *symbol = "_ZN9LAMMPS_NS6LAMMPS11post_createEv";
  void *found = dlsym(RTLD_DEFAULT, symbol);
  return found ? found : dlsym(RTLD_NEXT, symbol);
}

/* The host's own function of a name that this library has taken the place of. Usually it
   is the next one in the linker's search order. If this file is preloaded and LIGGGHTS comes
   later by dlopen (as in OpenFOAM or Python), the next one is not visible from here, and the
   host's file is asked for it. */
inline void *host_function(const char *symbol)
{
  if (void *next = dlsym(RTLD_NEXT, symbol)) return next;

  Dl_info info;
  void *landmark = host_landmark();
  if (landmark && dladdr(landmark, &info))
    if (void *host = dlopen(info.dli_fname, RTLD_LAZY | RTLD_NOLOAD))
      if (void *own = dlsym(host, symbol)) return own;

  fprintf(stderr, "ERROR: the plugin loader cannot find the LIGGGHTS library it was loaded into. "
          "Start LIGGGHTS with liggghts-plugins, without setting LD_PRELOAD yourself\n");
  abort();
}

}

#endif
