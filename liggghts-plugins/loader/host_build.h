/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_HOST_BUILD_H
#define GRAINJET_HOST_BUILD_H

#include <string>

/* Which LIGGGHTS runs in this process.

   What is compiled against LIGGGHTS knows the sizes of its classes and the places of their
   members. Two builds of one version may differ in them (other options, patched sources), so
   the version is not enough. A stamp (LIGGGHTSPLUGIN_HOST, made by the script host-version)
   names one build of the library:

     LIGGGHTS-PUBLIC 3.8.0, <options>, build <build ID that the linker has put into it>
     LIGGGHTS-PUBLIC 3.8.0, <options>, checksum <POSIX checksum and size of the file>

   the latter for a library without a build ID. The options are those that change what calls
   and classes look like, or what can be loaded, as words: the sizes of integers (SMALLBIG,
   BIGBIG, SMALLSMALL), the MPI (OpenMPI, MPICH), superquadrics, VTK. All of this is read from
   the library itself and not through its classes.                                         */

namespace grainjet {
namespace host_build {

  // The part of the stamp behind the version, of the running LIGGGHTS; empty if there is
  // none in this process
  std::string identity();

  // the whole stamp of the running LIGGGHTS
  std::string stamp();

  // Why something with this stamp does not fit the running LIGGGHTS, as the end of a
  // sentence that begins with its name; empty if it fits
  std::string misfit(const std::string &stamp);

}
}

#endif
