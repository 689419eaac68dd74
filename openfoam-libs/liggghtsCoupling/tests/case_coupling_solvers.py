# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Other solvers, outer correctors, formulations, turbulence sources, many ranks."""
# processors: 2
# label: long

import math
import os
import re
import unittest

import grainjet
from grainjet import coupled_box as box, dictionaries, dumps
from grainjet.coupled_box import swarm
import user_library

OPTIONS = {"interpolation": "cell"}


class Solvers(box.CoupledCase):

    def test_piso_foam(self):
        """pisoFoam is pimpleFoam with one outer corrector: the same to round-off, 1e-11."""
        folder = self.folder / "piso"
        pimple = self.run_box(0, options=OPTIONS)
        box.write(folder, steps=20)
        for name in ("in.particles", "new.grains", "fvOptions"):
            (folder / "constant" / name).write_text((pimple / "constant" / name).read_text())
        dictionaries.change(folder / "system/controlDict", ("pimpleFoam", "pisoFoam"))
        dictionaries.change(folder / "system/fvSolution", ("PIMPLE", "PISO"))
        self.foam("blockMesh", folder)
        self.foam("pisoFoam", folder)
        self.compare(pimple, folder, "0.002", 1e-11)

    def test_outer_correctors(self):
        """Three outer correctors do not advance the grains three times."""
        folder = self.run_box(0, correctors="nOuterCorrectors 3; nCorrectors 1;")
        self.assertEqual(self.result.output.count("PIMPLE: iteration 3"), 20)
        balance = box.read_balance(folder)
        self.assertEqual(len(balance["Time"]), 20)
        self.assertEqual(dumps.frames(folder / "grains.dump")[-1].step, 200)
        self.assertLess(max(balance["imbalance"]), 1e-10)

    def test_relaxed_last_corrector(self):
        """An equation that is relaxed in the last corrector is not satisfied, so that momentum gets lost: a
        warning, once. None if only the correctors before are relaxed, or for one-way coupling."""
        for factors, solver, coupling, warned in (
                ('".*" 0.7;', "pimpleFoam", "twoWay", "UFinal"), ('".*" 0.7;', "pimpleFoam", "oneWay", None),
                ("U 0.7;", "pimpleFoam", "twoWay", None), ('".*" 0.7; UFinal 1;', "pimpleFoam", "twoWay", None),
                ("U 0.7;", "pisoFoam", "twoWay", "U")):
            with self.subTest(factors=factors, solver=solver, coupling=coupling):
                folder = self.new_folder()
                box.write(folder, cells="2 2 4", steps=4, correctors="nOuterCorrectors 2; nCorrectors 1;")
                box.script(folder, grains=box.grains(*swarm(5, 3)))
                box.fv_options(folder, coupling=coupling)
                dictionaries.change(folder / "system/fvSolution",
                                    ("PIMPLE", f"relaxationFactors {{ equations {{ {factors} }} }}\nPIMPLE"))
                if solver == "pisoFoam":
                    dictionaries.change(folder / "system/fvSolution", ("\nPIMPLE", "\nPISO"))
                self.foam("blockMesh", folder)
                output = self.foam(solver, folder).output
                self.assertEqual(output.count("last momentum equation of the time step is relaxed"), 1 if warned else 0)
                self.assertTrue(not warned or f" for {warned} in relaxationFactors" in output, output)

    def test_four_ranks(self):
        """As on 2 ranks: the same to round-off, 1e-11."""
        serial = self.run_box(0, options=OPTIONS)
        parallel = self.run_box(4, options=OPTIONS, decomposition="(1 2 2)", ranks_in_case=4)
        self.compare(serial, parallel, "0.002", 1e-11)

    def test_matching_decompositions(self):
        """Both sides cut in z: fewer than one grain in ten is remote: LIGGGHTS holds it on
        another rank than its cell. Not so if one side is cut in x."""
        share = {}
        for decomposition in ("(1 1 2)", "(2 1 1)"):
            folder = self.run_box(2, options=OPTIONS, decomposition=decomposition,
                                  processors="processors 1 1 2")
            share[decomposition] = max(box.read_balance(folder)["remote"]) / 300
        self.assertLess(share["(1 1 2)"], 0.1)
        self.assertGreater(share["(2 1 1)"], 0.3)

    def test_set_ii(self):
        """Set II differs from Set I where the force at a grain differs from that of its cell, and by half a DEM
        step: Set I takes the kicks that grains got, of which the first half is due to the interval before. With
        cell values and grains that lie whole in a cell only that is left: half a DEM step of 200 of what the stress
        has changed by, 1/400 of the reaction. 1/100 is allowed. A model that left the reaction out would differ by
        all of it."""
        centre = {**OPTIONS, "voidFraction": "{ model centre; }"}
        one, two, without = (
            dictionaries.internal(self.run_box(0, options={**centre, **more}) / "0.002/U")
            for more in ({}, {"formulation": "SetII"}, {"forces": "()"}))

        def difference(a, b):
            return max(math.dist(u, v) for u, v in zip(a, b))

        reaction = difference(one, without)
        self.assertGreater(reaction, 1e-6)      # m/s, and round-off is 1e-12
        self.assertLess(difference(one, two), 0.01 * reaction)
        # what is interpolated differs by more than the 1e-10 that round-off may make, and Set I keeps to that
        for formulation, differs in (("SetI", False), ("SetII", True)):
            folder = self.run_box(0, options={"formulation": formulation})
            imbalance = max(box.read_balance(folder)["imbalance"])
            self.assertEqual(imbalance > 1e-10, differs, (formulation, imbalance))

    def test_dense_cells_are_announced_once(self):
        """Grains that fill a tenth of a cell: one warning with the number, and below the
        minimum void fraction the volume cut is reported."""
        x = [(0.0101 + 1e-6 * i, 0.0101, 0.0101) for i in range(2)]
        folder = self.run_box(0, steps=3, grains=(x, [(0, 0, 0)] * 2), diameter=1.2e-3,
                              options={"voidFraction": "{ model centre; minimum 0.9; }"})
        self.assertEqual(self.result.output.count("Grains fill"), 1)
        self.assertIn("22.6", self.result.output)
        volume = 2 * 3.14159265 / 6 * 1.2e-3 ** 3
        self.assertAlmostEqual(box.read_balance(folder)["volumeCut"][0], volume - 0.1 * 8e-9,
                               delta=1e-5 * volume)

    def test_long_dem_steps_are_announced_once(self):
        """A step of 1e-5 s: 16 % of the Rayleigh time of grains of 1 mm and 33 % of those half as large, which has one warning with
        the number of the log, on any number of ranks. None if no fix hertz/cg of the script knows the Rayleigh time."""
        hertz = "plugin load hertzcgplugin.so\nfix contacts all hertz/cg tangential history rolling off"
        x = [(0.005, 0.005, 0.01), (0.015, 0.015, 0.03)]
        for ranks, diameter, fixes, percent in ((0, 1e-3, hertz, None), (0, 5e-4, hertz, "32.68"), (2, 5e-4, hertz, "32.68"), (0, 5e-4, "", None)):
            with self.subTest(ranks=ranks, diameter=diameter, fixes=fixes):
                self.run_box(ranks, steps=3, cells="4 4 8", grains=(x, [(0, 0, 0)] * 2), diameter=diameter, fixes=fixes)
                output = self.result.output
                self.assertEqual(output.count("The DEM step is"), 1 if percent else 0, output)
                if percent:
                    said = re.search(r"The DEM step is (\S+) % of the Rayleigh time", output)[1]
                    self.assertEqual(said, percent)
                    self.assertEqual(output.count(f" Rayleigh {said} %"), 3)
                    self.assertIn("couplingInterval", output[output.index("The DEM step is"):])


class TurbulenceSources(box.CoupledCase):

    def decay(self, model, parts=((1, 20),), **options):
        """Turbulent kinetic energy in the box after runs with (subSteps, fluid steps), 20 sub-steps in all."""
        folder = self.folder / f"{model}{len(parts)}"
        box.write(folder, steps=20, velocity="(0 0 1)")
        dictionaries.write(folder / "constant/turbulenceProperties",
                           "simulationType RAS; RAS { RASModel kEpsilon; turbulence on; printCoeffs off; }")
        for name, value, dimension in (("k", 0.5, "0 2 -2"), ("epsilon", 50, "0 2 -3"),
                                       ("nut", 0, "0 2 -1")):
            dictionaries.write_field(folder, name, dimension, value, {".*": "type cyclic;"})
        x, v = swarm(3000, 4, mean=(0, 0, 1), rms=0)
        box.script(folder, grains=box.grains(x, v))
        box.fv_options(folder, turbulenceSources=model, subSteps=1, **options)
        dictionaries.change(folder / "system/controlDict",
                            ('("libliggghtsCoupling.so")', user_library.libs("probeModels")))
        dictionaries.change(folder / "system/fvSolution", ('"U.*"', '"(U|k|epsilon).*"'))
        self.foam("blockMesh", folder)
        end = 0
        for n, steps in parts:
            end += n * steps
            dictionaries.put(folder / "constant/fvOptions", subSteps=n)
            dictionaries.put(folder / "system/controlDict", deltaT=f"{n * 1e-4:.10g}", endTime=f"{end * 1e-4:.10g}", writeInterval=min(steps for _, steps in parts))
            self.foam("pimpleFoam", folder)
        k = dictionaries.internal(folder / "0.002/k")
        return sum(k) / len(k)

    def test_chen_wood_damps(self):
        """Homogeneous turbulence with grains far too heavy to follow it: dk/dt = - eps - 2ck,
        deps/dt = - 1.92 eps^2/k - 1.2 2c eps with c = Ksl/rho, integrated with the solver's own
        implicit Euler steps. c differs from cell to cell: the two limits are cells that mix
        at once (mean c) and cells that do not mix (mean of the cells' results). The
        difference to the decay without grains lies between them, or within 1e-3 of one. The same in a run that
        begins with four sub-steps in a step and goes on with one."""
        for parts in (((1, 20),), ((4, 2), (1, 12))):
            none, damped = self.decay("none", parts), self.decay("ChenWood", parts)
            ksl = dictionaries.internal(self.folder / f"ChenWood{len(parts)}/0.002/dragCoefficient")
            cs = [value / 1.2 for value in ksl]
            lengths = [n * 1e-4 for n, steps in parts for _ in range(steps)]

            def exact(c, lengths=lengths):
                k, eps = 0.5, 50.0
                for dt in lengths:
                    eps /= 1 + dt * (1.92 * eps / k + 2.4 * c)
                    k /= 1 + dt * (eps / k + 2 * c)
                return k

            seen = none - damped
            mixed = exact(0) - exact(sum(cs) / len(cs))
            apart = exact(0) - sum(map(exact, cs)) / len(cs)
            print(f"\nk {none:.6g} alone, {damped:.6g} with grains; difference {seen:.5g}, expected "
                  f"between {apart:.5g} and {mixed:.5g} m2/s2")
            self.assertGreater(apart, 0)
            self.assertGreater(seen, 0.999 * apart)
            self.assertLess(seen, 1.001 * mixed)

    def test_model_of_a_users_library(self):
        """Its coefficients lie in <model>Coeffs. dk/dt = - eps - rate k, deps/dt = - 1.92 eps^2/k, with the
        solver's own implicit Euler steps, with residuals of 1e-14: 1e-9."""
        k, eps, rate, dt = 0.5, 50.0, 30.0, 1e-4
        for _ in range(20):
            eps /= 1 + dt * 1.92 * eps / k
            k /= 1 + dt * (eps / k + rate)
        self.assertAlmostEqual(self.decay("probeSources", probeSourcesCoeffs=f"{{ rate {rate}; }}") / k, 1, delta=1e-9)


class RunningCase(box.CoupledCase):

    def test_plate_before_its_statistics_begin(self):
        """OpenFOAM traps invalid operations: fix plate/stats writes its table, of no collision yet and
        of no time, in a coupled run without making one."""
        folder = self.run_box(
            0, steps=4, walls=True, boundary="f f f",
            grains=([(0.01, 0.01, 0.0399), (0.01, 0.012, 0.02)], [(0, 0, 1), (0, 0, 0)]),
            fixes="plugin load hertzcgplugin.so\nplugin load platestatsplugin.so\n"
            "fix contacts all hertz/cg tangential history\n"
            "fix w all wall/gran model hertz tangential history primitive type 1 zplane 0.04 "
            "store_force yes\n"
            "fix p all plate/stats wall w centre 0.01 0.01 0.04 normal 0 0 -1 radius 0.005 rings 2 "
            "every 5 file plate.csv stats_start 1")
        rows = (folder / "plate.csv").read_text().splitlines()
        self.assertEqual(len(rows), 4)
        self.assertIn("nan", rows[1])

    def test_entries_changed_during_a_run(self):
        """Entries are read once: a change of fvOptions in a running case is answered in words, once
        a change, and the grains go on as they began."""
        folder = self.folder / "changed"
        box.write(folder, steps=100000, write_every=100000, control="runTimeModifiable yes;\n"
                  "OptimisationSwitches { fileModificationSkew 0; fileModificationChecking timeStamp; }")
        x, v = swarm(20, 7)
        box.script(folder, grains=box.grains(x, v))
        box.fv_options(folder, **OPTIONS)
        self.foam("blockMesh", folder)
        options = folder / "constant/fvOptions"
        with grainjet.start(["pimpleFoam"], folder, folder / "log") as run:
            run.wait_for_words("liggghtsCoupling: grains 20")
            # the other text and a later time come at once, in one move
            (self.folder / "constant").mkdir()
            box.fv_options(self.folder, **OPTIONS, drag="Stokes")
            other = self.folder / "constant/fvOptions"
            later = options.stat().st_mtime + 10
            os.utime(other, (later, later))
            other.replace(options)
            text = run.wait_for_words("have changed")
            self.assertIn("fvOptions", text)
            after = text.index("have changed")
            text = run.wait_for_words("liggghtsCoupling: grains 20", after)
            self.assertEqual(text.count("have changed"), 1)


if __name__ == "__main__":
    unittest.main()
