/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_LIGGGHTSPLUGIN_H
#define GRAINJET_LIGGGHTSPLUGIN_H

#include "host/grainjet_version.h"

#include <string_view>

/* What a plugin file tells the `plugin` command of LIGGGHTS.

   A plugin is a shared library with one entry point, `liggghtsplugin_init`,
   that returns a description of the styles it brings. It is plain data: nothing
   happens at load time except that the loader enters the creators into the
   style maps of LIGGGHTS. The style itself is two ordinary files with the usual
   FixStyle block and knows nothing of this header.                          */

extern "C" {

// kind: "fix" (creator is a LAMMPS_NS::FixCreator) or
//       "command" (creator is a LAMMPS_NS::Input::CommandCreator)
struct liggghtsplugin_style {
  const char *kind;
  const char *name;      // as written in an input script
  const char *info;      // one line for `plugin list`
  const char *author;
  void (*creator)();     // cast back by the loader according to kind
};

// host: stamp of the LIGGGHTS the plugin was compiled for (see host_build.h); a plugin
//       compiled for another build is refused, since C++ class layouts differ
struct liggghtsplugin_description {
  const char *host;
  int nstyles;
  const liggghtsplugin_style *styles;
};

// the entry point that a plugin file exports
const liggghtsplugin_description *liggghtsplugin_init();

// Version of Grainjet that a plugin, loader or coupling library was compiled with. Every
// library that includes this header exports it, so nothing has to be written for it. It is
// looked at before the entry point is called: another version may describe styles otherwise.
// Within a library use GRAINJET_VERSION; this name may stand for another library's there.
extern const char liggghtsplugin_grainjet[] __attribute__((weak, visibility("default")));
const char liggghtsplugin_grainjet[] = GRAINJET_VERSION;

typedef const liggghtsplugin_description *(*liggghtsplugin_initfunc)();

}

// Stamp given on the compiler's command line by the build (see
// liggghts-plugins/CMakeLists.txt), the same for loader and plugins.
#ifndef LIGGGHTSPLUGIN_HOST
#error "LIGGGHTSPLUGIN_HOST must be what the script host-version says of the LIGGGHTS compiled for"
#endif

// The choices LIGGGHTS was compiled with stand in no header of it: integers of another size, and
// classes with other members, would be taken for its own. They come by the compiler's command line
// (host-version -flags) and are compared with the stamp.
namespace grainjet {

constexpr bool stamped(const char *option)
{
  const std::string_view stamp = LIGGGHTSPLUGIN_HOST;
  const std::size_t at = stamp.find(option), end = at + std::string_view(option).size();
  return at != stamp.npos && at > 0 && stamp[at - 1] == ' ' && end < stamp.size() && (stamp[end] == ' ' || stamp[end] == ',');
}

#if defined(LAMMPS_BIGBIG)
static_assert(stamped("BIGBIG"), "LIGGGHTS has smaller integers than LAMMPS_BIGBIG: compile with what host-version -flags prints");
#elif defined(LAMMPS_SMALLSMALL)
static_assert(stamped("SMALLSMALL"), "LIGGGHTS has larger integers than LAMMPS_SMALLSMALL: compile with what host-version -flags prints");
#else
static_assert(stamped("SMALLBIG"), "LIGGGHTS has other integers than LAMMPS_SMALLBIG: compile with what host-version -flags prints");
#endif
#if defined(SUPERQUADRIC_ACTIVE_FLAG)
static_assert(stamped("superquadrics"), "LIGGGHTS is without superquadrics: compile with what host-version -flags prints");
#else
static_assert(!stamped("superquadrics"), "LIGGGHTS has superquadrics: compile with what host-version -flags prints");
#endif

}

#endif
