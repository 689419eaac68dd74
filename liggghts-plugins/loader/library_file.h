/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_LIBRARY_FILE_H
#define GRAINJET_LIBRARY_FILE_H

#include <string>

namespace grainjet {
namespace library_file {

  // Why a library file is not whole, empty if it is: it ends before the parts that its own
  // tables name, or those tables are empty, as after a full disk or a copy that was
  // interrupted. The linker does not look and the program dies of SIGBUS or SIGSEGV.
  // What is no library at all is left for the linker to say.
  std::string damage(const std::string &path);

  // Why a library file is for another kind of machine than this program, as words that follow
  // its name; empty if it is for this one or is no library. The linker only says that it
  // cannot open such a file.
  std::string foreign(const std::string &path);

}
}

#endif
