# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
"""The plugins' styles can be compiled into a LIGGGHTS built from source instead.

What LIGGGHTS' own build does is done here with the files of the plugins and of what they share: copy them into one folder,
collect the headers with a style block, compile, enter the styles into a table as the host's
constructors do. Nothing of the loader and no registration file takes part. The styles found that way
must be those the plugin files bring.
"""

import concurrent.futures
import re
import shutil
import unittest

import grainjet
from grainjet import host_library

PLUGINS = grainjet.ROOT / "liggghts-plugins"

# what several plugins share
SHARED = [PLUGINS / "wall-collisions"]

# as in the constructors of LIGGGHTS' Modify and Input
TABLE = """
#include "lammps.h"
#include "fix.h"
#include "style_command.h"
#include "style_fix.h"
#include <stdio.h>
#include <map>
#include <string>
using namespace LAMMPS_NS;
template <typename T> Fix *create(LAMMPS *lmp, int narg, char **arg) { return new T(lmp, narg, arg); }
template <typename T> void execute(LAMMPS *lmp, int narg, char **arg) { T command(lmp); command.command(narg, arg); }
int main()
{
  std::map<std::string, Fix *(*)(LAMMPS *, int, char **)> fixes;
  std::map<std::string, void (*)(LAMMPS *, int, char **)> commands;
#define FIX_CLASS
#define FixStyle(key,Class) fixes[#key] = &create<Class>;
#include "style_fix.h"
#undef FIX_CLASS
#define COMMAND_CLASS
#define CommandStyle(key,Class) commands[#key] = &execute<Class>;
#include "style_command.h"
  for (const auto &style : fixes) printf("fix %s\\n", style.first.c_str());
  for (const auto &style : commands) printf("command %s\\n", style.first.c_str());
}
"""


class CompileIn(grainjet.Case):

    def compile(self, source):
        return grainjet.run(
            ["mpicxx", "-std=c++17", "-O0", "-DOMPI_SKIP_MPICXX", "-iquote", ".", *host_library.flags(),
             "-I", PLUGINS, "-c", source.name], source.parent)

    def test_styles_without_loader(self):
        src = self.folder / "src"
        src.mkdir()
        registered = sorted(PLUGINS.glob("*/*plugin.cpp"))
        self.assertGreaterEqual(len(registered), 3, registered)
        for folder in [*(registration.parent for registration in registered), *SHARED]:
            for pattern in ("*.h", "*.cpp"):
                for path in folder.glob(pattern):
                    self.assertFalse((src / path.name).exists(), f"two files are called {path.name}")
                    shutil.copy(path, src)
        for registration in registered:
            (src / registration.name).unlink()

        for kind, pattern in (("fix", "fix_*.h"), ("command", "*.h")):
            headers = [path.name for path in sorted(src.glob(pattern))
                       if f"{kind.upper()}_CLASS" in path.read_text()]
            self.assertTrue(headers, kind)
            (src / f"style_{kind}.h").write_text("".join(f'#include "{name}"\n' for name in headers))
        (src / "table.cpp").write_text(TABLE)
        # LIGGGHTS' build makes these lists of its own contact models before it compiles anything
        for part in ("surface", "normal", "tangential", "cohesion", "rolling"):
            (src / f"style_{part}_model.h").write_text("")

        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            for result in pool.map(self.compile, sorted(src.glob("*.cpp"))):
                self.assertEqual(result.code, 0, result)
        objects = sorted(path.name for path in src.glob("*.o"))
        linked = grainjet.run(["mpicxx", "-o", "table", *objects, host_library.part("-library")], src)
        self.assertEqual(linked.code, 0, linked)

        table = grainjet.run(["./table"], src)
        self.assertEqual(table.code, 0, table)
        script = "".join(f"plugin load {path.stem}.so\n" for path in registered) + "plugin list\n"
        listed = re.findall(r"(?m)^    ((?:fix|command) \S+):", self.liggghts(script).output)
        self.assertEqual(sorted(table.output.split("\n")[:-1]), sorted(listed))


if __name__ == "__main__":
    unittest.main()
