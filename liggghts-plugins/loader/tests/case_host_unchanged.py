# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
# processors: 2
"""With the loader present and no plugin loaded LIGGGHTS does what it does without it.

LIGGGHTS' own shipped examples are run by `liggghts` and by `liggghts-plugins`; every file they
write and all they print must be the same to the byte, but for clock times. The examples
come from the Debian source package of the installed version, like OpenFOAM's headers for the build.
"""

import re
import shutil
import unittest

import grainjet

# lines that hold a clock time, and what depends on it
CLOCK = re.compile(r"^(Setting up run at|Loop time of|(Pair|Neigh|Comm|Outpt|Other|Modify|Fix) .*time|"
                   r"CPU time|.*finish time|.*\d+:\d\d:\d\d)")


def written(folder):
    """Contents of all files below a folder that are results, clock times taken out."""
    files = {}
    for path in sorted(folder.rglob("*")):
        if path.is_file():
            content = path.read_bytes()
            if path.name == "log.liggghts":
                content = without_clock(content.decode())
            files[str(path.relative_to(folder))] = content
    return files


def without_clock(text):
    return "\n".join(line for line in text.splitlines() if not CLOCK.match(line))


class ShippedExamples(grainjet.Case):

    def compare(self, example, script, steps, ranks):
        """Run one example both ways, ended after so many steps; returns the number of grains."""
        results, files = {}, {}
        for program in ("liggghts", "liggghts-plugins"):
            folder = self.folder / f"{example}-{ranks}-{program}"
            shutil.copytree(grainjet.liggghts_examples() / example, folder)
            (folder / "post").mkdir(exist_ok=True)
            text = (folder / script).read_text()
            text, runs = re.subn(r"(?m)^run\s+\d{4,}(\s+upto)?\s*$", f"run {steps} upto", text)
            self.assertGreater(runs, 0, "the example is not as expected: it has no long run to shorten")
            (folder / script).write_text(text)
            result = grainjet.run([*grainjet.mpirun(ranks), program, "-in", script], folder)
            self.assertEqual(result.code, 0, result)
            # ranks print into each other's lines in any order
            results[program] = sorted(without_clock(result.output).splitlines())
            files[program] = written(folder)

        self.assertEqual(results["liggghts"], results["liggghts-plugins"])
        self.assertEqual(list(files["liggghts"]), list(files["liggghts-plugins"]))
        for name, content in files["liggghts"].items():
            self.assertEqual(content, files["liggghts-plugins"][name], name)

        # the comparison must have had something to compare: dumps, and grains in them
        dumps = [name for name in files["liggghts"] if re.fullmatch(r"post/.*_\d+\.vtk", name)]
        self.assertGreater(len(dumps), 3, list(files["liggghts"]))
        last = [line.split() for line in results["liggghts"] if line.split()[:1] == [str(steps)]]
        self.assertTrue(last, results["liggghts"])
        self.assertGreater(int(last[-1][1]), 20, last)

    def test_chute_wear(self):
        """Mesh wall with history and wear, insertion from a face, two radii."""
        for ranks in (0, 2):
            self.compare("chute_wear", "in.chute_wear", 8000, ranks)

    def test_insert_stream(self):
        """Stream of grains, moving box, a restart file."""
        for ranks in (0, 2):
            self.compare("insert_stream", "in.insert_stream", 8000, ranks)

    def test_contact_models(self):
        """A packing in primitive walls."""
        for ranks in (0, 2):
            self.compare("contactModels", "in.newModels", 4000, ranks)


if __name__ == "__main__":
    unittest.main()
