# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page, quickJet and the benchmark have the same settings; the benchmark's variants are what they say."""

import re
import unittest

import grainjet
import variants
from grainjet import dictionaries

HERE = grainjet.ROOT/"validation/benchmarks/fluid_settings"


def entries(text, name):
    """{key: value} of the braces behind a name."""
    found = re.search(rf"(?m)^\s*{re.escape(name)}\s*\{{([^{{}}]*)\}}", text)
    return {words.split()[0]: " ".join(words.split()[1:]) for words in found[1].split(";") if words.strip()}


class Settings(grainjet.Case):

    def setUp(self):
        super().setUp()
        self.ours = (grainjet.ROOT/"cases/quickJet/system/fvSolution").read_text()

    def test_page_shows_what_quickJet_has(self):
        block = re.search(r"(?s)```foam\n(solvers.*?)```", (HERE/"README.md").read_text())[1]
        for name in ("p", "pFinal", '"(U|k|epsilon)"', '"(U|k|epsilon)Final"', "PIMPLE"):
            self.assertEqual(entries(block, name), entries(self.ours, name), name)

    def test_chosen_is_what_quickJet_has(self):
        chosen = variants.solution(variants.VARIANTS["chosen"])
        for name in ("p", '"(U|k|epsilon)"', "PIMPLE"):
            self.assertEqual(entries(chosen, name), entries(self.ours, name), name)
        self.assertEqual(entries(chosen, "pFinal")["relTol"], entries(self.ours, "pFinal")["relTol"])

    def test_variants_differ_only_in_what_they_state(self):
        """None takes an entry away; p and its last solve share what is not stated for the latter."""
        before, other = (variants.solution(variants.VARIANTS[name]) for name in ("before", "PCG DIC"))
        self.assertEqual(entries(other, "p"), {"solver": "PCG", "preconditioner": "DIC", "tolerance": "1e-8", "relTol": "0.01"})
        self.assertEqual(entries(other, "pFinal"), {**entries(other, "p"), "relTol": "0"})
        self.assertEqual(entries(other, '"(U|k|epsilon)"'), entries(before, '"(U|k|epsilon)"'))

    def test_openfoam_reads_all_variants(self):
        """foamDictionary finds the solver of each."""
        for number, (name, changes) in enumerate(variants.VARIANTS.items()):
            dictionaries.write(self.folder/f"{number}/fvSolution", variants.solution(changes))
        listed = " ".join(f"{number}/fvSolution" for number in range(len(variants.VARIANTS)))
        said = grainjet.run(["bash", "-c", f"for f in {listed}; do foamDictionary -entry solvers.p.solver -value $f || exit 1; done"], self.folder)
        self.assertEqual(said.code, 0, said)
        self.assertEqual(len(re.findall(r"(?m)^(GAMG|PCG)$", said.output)), len(variants.VARIANTS))


if __name__ == "__main__":
    unittest.main()
