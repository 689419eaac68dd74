"""Other solvers, outer correctors, formulations, turbulence sources, many ranks."""
# processors: 2

import math
import pathlib
import re
import subprocess
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import case_coupling
import coupled_box as box
import grainjet
from case_coupling import swarm

OPTIONS = {"interpolation": "cell"}


class Solvers(grainjet.Case):

    run_box = case_coupling.Coupling.run_box
    compare = case_coupling.Coupling.compare

    def test_piso_foam(self):
        """pisoFoam is pimpleFoam with one outer corrector: the same to round-off, 1e-11."""
        folder = self.folder / "piso"
        pimple = self.run_box(0, options=OPTIONS)
        box.write(folder, steps=20)
        for name in ("in.particles", "new.grains", "fvOptions"):
            (folder / "constant" / name).write_text((pimple / "constant" / name).read_text())
        for name in ("controlDict", "fvSolution"):
            path = folder / "system" / name
            path.write_text(path.read_text().replace("pimpleFoam", "pisoFoam")
                            .replace("PIMPLE", "PISO"))
        self.foam("blockMesh", folder)
        self.foam("pisoFoam", folder)
        self.compare(pimple, folder, "0.002", 1e-11)

    def test_outer_correctors(self):
        """Three outer correctors do not advance the grains three times."""
        folder = self.run_box(0, correctors="nOuterCorrectors 3; nCorrectors 1;")
        self.assertEqual(self.result.output.count("PIMPLE: iteration 3"), 20)
        balance = box.read_balance(folder)
        self.assertEqual(len(balance["Time"]), 20)
        steps = re.findall(r"ITEM: TIMESTEP\n(\d+)", (folder / "grains.dump").read_text())
        self.assertEqual(steps[-1], "200")
        self.assertLess(max(balance["imbalance"]), 1e-10)

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
        cell values and grains that lie whole in a cell only that is left, 1/400 of the reaction over 20 steps
        of 10 DEM steps if the stress is steady; 1/100 is allowed. A model that left the reaction out would
        differ by all of it."""
        centre = {**OPTIONS, "voidFraction": "{ model centre; }"}
        one, two, without = (
            box.read_internal(self.run_box(0, options={**centre, **more}) / "0.002/U")
            for more in ({}, {"formulation": "SetII"}, {"forces": "()"}))

        def difference(a, b):
            return max(math.dist(u, v) for u, v in zip(a, b))

        reaction = difference(one, without)
        self.assertGreater(reaction, 1e-6)      # m/s, and round-off is 1e-12
        self.assertLess(difference(one, two), 0.01 * reaction)
        interpolated = self.run_box(0, options={"formulation": "SetII"})
        self.assertGreater(max(box.read_balance(interpolated)["imbalance"]), 0)

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


class TurbulenceSources(grainjet.Case):

    run_box = case_coupling.Coupling.run_box

    def decay(self, model):
        """Turbulent kinetic energy in the box after 20 steps."""
        folder = self.folder / model
        box.write(folder, steps=20, velocity="(0 0 1)")
        (folder / "constant/turbulenceProperties").write_text(
            box.HEADER.format("dictionary", "turbulenceProperties")
            + "simulationType RAS; RAS { RASModel kEpsilon; turbulence on; printCoeffs off; }\n")
        for name, value, dimension in (("k", 0.5, "0 2 -2"), ("epsilon", 50, "0 2 -3"),
                                       ("nut", 0, "0 2 -1")):
            (folder / "0" / name).write_text(
                box.HEADER.format("volScalarField", name)
                + f'dimensions [{dimension} 0 0 0 0]; internalField uniform {value};\n'
                'boundaryField { ".*" { type cyclic; } }\n')
        x, v = swarm(3000, 4, mean=(0, 0, 1), rms=0)
        box.script(folder, grains=box.grains(x, v))
        box.fv_options(folder, turbulenceSources=model)
        path = folder / "system/fvSolution"
        path.write_text(path.read_text().replace('"U.*"', '"(U|k|epsilon).*"'))
        self.foam("blockMesh", folder)
        self.foam("pimpleFoam", folder)
        k = box.read_internal(folder / "0.002/k")
        return sum(k) / len(k)

    def test_chen_wood_damps(self):
        """Homogeneous turbulence with grains far too heavy to follow it: dk/dt = - eps - 2ck,
        deps/dt = - 1.92 eps^2/k - 1.2 2c eps with c = Ksl/rho, integrated with the solver's own
        implicit Euler steps. c differs from cell to cell: the two limits are cells that mix
        at once (mean c) and cells that do not mix (mean of the cells' results). The
        difference to the decay without grains lies between them, or within 1e-3 of one."""
        none, damped = self.decay("none"), self.decay("ChenWood")
        ksl = box.read_internal(self.folder / "ChenWood/0.002/dragCoefficient")
        cs = [value / 1.2 for value in ksl]

        def exact(c, dt=1e-4):
            k, eps = 0.5, 50.0
            for _ in range(20):
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


class RunningCase(grainjet.Case):

    run_box = case_coupling.Coupling.run_box

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
        with open(folder / "log", "w") as log:
            run = subprocess.Popen(["pimpleFoam"], cwd=folder, env=grainjet.ENV, stdout=log,
                                   stderr=subprocess.STDOUT)
            try:
                self.wait_for(folder / "log", "liggghtsCoupling: grains 20")
                time.sleep(1.1)     # file times may be as coarse as a second
                box.fv_options(folder, **OPTIONS, drag="Stokes")
                text = self.wait_for(folder / "log", "have changed")
                self.assertIn("fvOptions", text)
                after = text.index("have changed")
                text = self.wait_for(folder / "log", "liggghtsCoupling: grains 20", after)
                self.assertEqual(text.count("have changed"), 1)
            finally:
                run.kill()
                run.wait()

    def wait_for(self, path, words, start=0, seconds=60):
        """The text of a growing file once it holds the words behind a place."""
        for _ in range(10 * seconds):
            text = path.read_text()
            if words in text[start:]:
                return text
            time.sleep(0.1)
        self.fail(f"'{words}' did not come: {text[-2000:]}")


if __name__ == "__main__":
    unittest.main()
