/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

#ifndef GRAINJET_FILE_WRITER_H
#define GRAINJET_FILE_WRITER_H

#include "wall-collisions/output_file.h"

#include "fix.h"
#include "modify.h"

#include <string>
#include <vector>

namespace grainjet {

/* A fix that writes files of its own. Fixes of different styles and plugins see by it that no two
   of them write the same file.                                                       */
class FileWriter {
 public:

  // all that the fix writes; a star stands for the number of a step
  virtual std::vector<std::string> paths() const = 0;

  // an empty string, or which of these files of `self` is that of another fix
  static std::string check_others(const LAMMPS_NS::Modify &modify, const LAMMPS_NS::Fix *self,
    const std::vector<std::string> &own)
  {
    for (int ifix = 0; ifix < modify.nfix; ifix++) {
      const LAMMPS_NS::Fix *fix = modify.fix[ifix];
      const FileWriter *other = dynamic_cast<const FileWriter *>(fix);
      if (!other || fix == self) continue;
      for (const std::string &taken : other->paths())
        for (const std::string &path : own)
          if (OutputFile::same(path, taken))
            return "file '" + path + "' is that of fix " + fix->style + " (ID " + fix->id + ")"
              + (path.find('*') != taken.find('*') ? ", which writes '" + taken + "'" : "")
              + "; give another path";
    }
    return "";
  }

 protected:

  ~FileWriter() = default;
};

}

#endif
