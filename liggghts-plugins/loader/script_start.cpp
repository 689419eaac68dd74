/* ----------------------------------------------------------------------
   Grainjet: coarse-grained CFD-DEM for particle-laden jets
   Copyright (C) 2026 The Grainjet developers
   SPDX-License-Identifier: GPL-3.0-or-later
------------------------------------------------------------------------- */

/* Scripts as editors of other systems save them.

   Input::file() reads a script from its first line on, whether the script comes from
   -in, from standard input or through the library interface. The function below takes its
   place like the one in lammps_create_hook.cpp does, looks at the first bytes of the
   script and then runs the host's own.

     byte order mark of UTF-8    passed over; LIGGGHTS takes it for a part of the first word
     UTF-16, UTF-32              error: every other byte ends the line
     a folder                    error: LIGGGHTS takes it for an empty script
     CR alone ends the lines     error: all is one line, which a first comment makes empty
   CR LF is white space to LIGGGHTS and needs nothing.

   It also is where a LIGGGHTS is found out that has not called lammps_create_hook.cpp: this
   function is called by the program itself, which goes through the dynamic linker even if the
   library calls its own functions without it.                                         */

#include "loader/host_build.h"
#include "loader/host_function.h"
#include "loader/interposition.h"
#include "loader/liggghtsplugin.h"
#include "loader/plugin_command.h"
#include "loader/plugin_file.h"
#include "loader/style_maps.h"

#include <liggghts/error.h>
#include <liggghts/input.h>

#include <stdio.h>
#include <string.h>

#include <string>

using namespace LAMMPS_NS;

namespace {

enum ScriptStart { PLAIN, UNREADABLE, WIDE, OLD_MAC };

/* Looks at a script whose first byte is the next one to be read, and passes over a byte
   order mark. Line ends are looked for in the first block, and only in a file: what
   comes through a pipe cannot be read twice.                                           */

int pass_over_start(FILE *script)
{
  const long begin = ftell(script);
  const int first = getc(script);
  if (first == EOF && ferror(script)) return UNREADABLE;
  ungetc(first, script);
  if (first == 0xFE || first == 0xFF || first == 0) return WIDE;
  if (first == 0xEF) {
    const char *mark = "\xEF\xBB\xBF";
    char found[3];
    size_t n = 0;
    for (int c; n < 3 && (c = getc(script)) != EOF;) found[n++] = static_cast<char>(c);
    if (n < 3 || memcmp(found, mark, 3) != 0)
      while (n > 0) ungetc(static_cast<unsigned char>(found[--n]), script);
  }
  if (begin < 0) return PLAIN;

  char block[4096];
  const long here = ftell(script);
  const size_t n = fread(block, 1, sizeof(block), script);
  clearerr(script);
  fseek(script, here, SEEK_SET);
  if (memchr(block, '\0', n)) return WIDE;
  return memchr(block, '\r', n) && !memchr(block, '\n', n) ? OLD_MAC : PLAIN;
}

}

/* ---------------------------------------------------------------------- */

void Input::file()
{
  using namespace grainjet;
  std::string fault = host_build::misfit(LIGGGHTSPLUGIN_HOST);
  if (!fault.empty()) fault = "The plugin loader " + fault;
  else if (style_maps::find(lmp, plugin_command) == style_maps::Entry::FREE) fault = interposition::own_calls;
  plugin_file::agree(lmp, fault);

  int start = me == 0 && infile ? pass_over_start(infile) : PLAIN;
  MPI_Bcast(&start, 1, MPI_INT, 0, world);
  if (start == UNREADABLE)
    error->all(FLERR, "The script cannot be read: is it a folder? Give the file, as in -in in.script");
  if (start == WIDE)
    error->all(FLERR, "The script is not plain text: it holds zero bytes, or begins like UTF-16. "
      "Save it as UTF-8, for instance with iconv -f UTF-16 -t UTF-8");
  if (start == OLD_MAC)
    error->all(FLERR, "The lines of the script end in CR alone, so LIGGGHTS takes them for one line. "
      "Save it with LF or CR LF, for instance with tr '\\r' '\\n'");

  typedef void (*File)(Input *);
  static const File file_host = reinterpret_cast<File>(grainjet::host_function("_ZN9LAMMPS_NS5Input4fileEv"));
  file_host(this);
}
