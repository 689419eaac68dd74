/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#include "loader/interposition.h"

#include "loader/plugin_file.h"

#include <dlfcn.h>
#include <stdlib.h>

namespace {

// a plain array, since the preloaded library asks before objects are constructed
const grainjet::interposition::Function of_the_loader[] = {
  {"LAMMPS::create", "_ZN9LAMMPS_NS6LAMMPS6createEv"},
  {"Input::file", "_ZN9LAMMPS_NS5Input4fileEv"},
  {NULL, NULL}
};

// the library in which the linker finds a function first, as a path
std::string first_with(const char *symbol)
{
  void *found = dlsym(RTLD_DEFAULT, symbol);
  Dl_info info;
  if (!found || !dladdr(found, &info)) return "";
  char *real = realpath(info.dli_fname, NULL);
  const std::string file = real ? real : info.dli_fname;
  free(real);
  return file;
}

std::string fault_of(const grainjet::interposition::Function *functions, bool other_loaders)
{
  const std::string own = grainjet::plugin_file::loader();
  for (; functions->name; functions++) {
    const std::string file = first_with(functions->symbol);
    if (file == own || (other_loaders && !grainjet::plugin_file::version(file).empty())) continue;

    const char *preload = getenv("LD_PRELOAD");
    std::string text = std::string("LIGGGHTS takes its function ") + functions->name + " from " +
      (file.empty() ? std::string("no library that is loaded") : file) + " and not from " + own +
      ", since that library comes first in the linker's search order";
    if (preload) text += std::string(" (LD_PRELOAD is '") + preload + "')";
    return text;
  }
  return "";
}

}

/* ---------------------------------------------------------------------- */

std::string grainjet::interposition::fault(const Function *functions)
{
  return fault_of(functions, false);
}

/* ---------------------------------------------------------------------- */

std::string grainjet::interposition::loader_fault()
{
  return fault_of(of_the_loader, true);
}

/* ---------------------------------------------------------------------- */

std::string grainjet::interposition::program()
{
  char *real = realpath("/proc/self/exe", NULL);
  const std::string path = real ? real : "the program";
  free(real);
  return path;
}

/* ---------------------------------------------------------------------- */

const char *const grainjet::interposition::own_calls =
  "LIGGGHTS calls its own functions where others have been put in their place, so it knows no plugin. Its library was linked with "
  "-Bsymbolic or -Bsymbolic-functions, or compiled with -fno-semantic-interposition: build it without (docs/loader.md)";
