# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""adjustTimeStep yes: DEM steps that follow a fluid step which changes."""
# processors: 2
# label: long

import math
import re
import unittest

import numpy

from grainjet import coupled_box as box, dictionaries, dumps, scripts

LONGEST = 1e-5       # s, timestep of the script
CLOCK = """variable t equal time
variable h equal dt
fix clock all print 1 "$t $h" file clock.txt screen no title ""
"""
ALL = "{ drag { model Gidaspow; } pressureGradient {} viscous {} addedMass { C 0.5; } }"


def controls(max_delta_t, more=""):
    """The step grows by a fifth from step to step until it is the largest one, or the one of maxCo."""
    return f"adjustTimeStep yes; maxCo 0.1; maxDeltaT {max_delta_t!r}; {more}"


def fluid_steps(output):
    """Steps [s] that the solver has made, with the digits that it prints."""
    return [float(word) for word in re.findall(r"^deltaT = (\S+)$", output, re.M)]


class AdjustTimeStep(box.CoupledCase):

    def adjusted(self, folder, *, grains, end_time, ranks=0, dt=LONGEST, fixes="", plugins="", end="", control="", max_delta_t=2e-4,
                 options=None, interval=None, **fluid):
        """Write and run the box with steps that change."""
        fluid.setdefault("delta_t", 3e-5)
        box.write(folder, steps=10 ** 6, control=controls(max_delta_t, control), **fluid)
        dictionaries.put(folder / "system/controlDict", endTime=repr(end_time), writeControl="adjustableRunTime",
                         writeInterval=repr(end_time), writePrecision="17")
        box.script(folder, grains=grains, dt=dt, fixes=fixes + CLOCK, plugins=plugins, end=end)
        box.fv_options(folder, **{"couplingInterval": interval, **(options or {})})
        self.foam("blockMesh", folder)
        if ranks:
            self.foam("decomposePar", folder)
        self.result = self.foam("pimpleFoam", folder, ranks)
        if ranks:
            self.foam("reconstructPar", folder)
        return folder

    def clock(self, folder):
        """Time after each DEM step, and its length."""
        return numpy.loadtxt(folder / "clock.txt", comments="#").T

    def test_drag_and_number_of_steps(self):
        """Grains in a uniform stream under Stokes drag: velocity and place against the exact solution over the time that
        has passed. The integration is of second order in h/tau; fixed steps of the longest h have an error of 0.2 (h/tau)^2 of
        velocity and time in tau. n is the smallest number, said when it changes; LIGGGHTS' time
        is the solver's."""
        d, end = 2e-5, 0.002
        tau = 2500.0 * d ** 2 / (18 * 1.2 * 1.5e-5)
        x, v = box.swarm(50, 3, mean=(0, 0, -1))
        folder = self.adjusted(self.new_folder(), grains=box.grains(x, v, d), end_time=end, velocity="(0 0 1)",
                               options={"coupling": "oneWay", "forces": "()", "drag": "Stokes"},
                               end=scripts.dump(1, "grains.*.dump", box.MOTION))
        time, h = self.clock(folder)
        steps = fluid_steps(self.result.output)
        self.assertGreater(max(steps) / min(steps), 3)
        numbers = [max(1, math.ceil(step / LONGEST * (1 - 1e-5))) for step in steps]
        self.assertEqual(sum(numbers), len(h))
        lengths = numpy.repeat(numpy.array(steps) / numbers, numbers)
        self.assertLess(abs(h / lengths - 1).max(), 1e-5)
        self.assertLess(h.max(), LONGEST * (1 + 1e-8))
        said = [int(n) for n in re.findall(r"^liggghtsCoupling: (\d+) DEM steps of", self.result.output, re.M)]
        self.assertEqual(said, [n for n, before in zip(numbers, [0, *numbers]) if n != before])
        self.assertAlmostEqual(time[-1] / end, 1, delta=1e-12)
        last = dumps.last(folder / f"grains.{len(h)}.dump")
        left = math.exp(-end / tau)
        for i, start in enumerate(v, 1):
            for k, fluid in enumerate((0, 0, 1)):
                slip = start[k] - fluid
                error = 0.25 * (LONGEST / tau) ** 2 * abs(slip) * end
                self.assertAlmostEqual(last[i][3 + k], fluid + slip * left, delta=error / tau)
                way = last[i][k] - x[i - 1][k] - fluid * end - slip * tau * (1 - left)
                self.assertLess(abs(math.remainder(way, (0.02, 0.02, 0.04)[k])), error)

    def test_momentum_and_ranks(self):
        """Two-way with steps that change, fluid and grains of the same momentum in sum; 1 and 2 ranks agree."""
        x, v = box.swarm(300, 7)
        end = 0.002
        for equations in ("neglected", "full"):
            folders = []
            for ranks in (0, 2):
                with self.subTest(equations=equations, ranks=ranks):
                    folder = self.adjusted(
                        self.new_folder(), grains=box.grains(x, v, 5e-4), end_time=end, ranks=ranks, velocity="(0 0 1)",
                        options={"drag": None, "forces": ALL, "voidFraction": box.void_fraction(equations)},
                        end=scripts.dump(1, "grains.dump", box.MOTION))
                    self.assertGreater(len(set(fluid_steps(self.result.output))), 5)
                    self.assertLess(max(box.read_balance(folder)["imbalance"]), 1e-12)
                    folders.append(folder)
            self.compare(*folders, "0.002", 1e-11)

    def test_constant_step_is_that_of_a_fixed_one(self):
        """A step that is a multiple of the script's one from the start to the end: bit for bit."""
        x, v = box.swarm(300, 7)
        runs = []
        for control, interval in (("adjustTimeStep yes; maxCo 1000; maxDeltaT 1e-4;", None), ("adjustTimeStep no;", "10")):
            folder = self.new_folder()
            box.write(folder, control=control)
            box.script(folder, grains=box.grains(x, v, 1e-3), end=scripts.dump(200, "grains.dump", box.MOTION))
            box.fv_options(folder, couplingInterval=interval, drag=None, forces=ALL)
            self.foam("blockMesh", folder)
            self.foam("pimpleFoam", folder)
            runs.append(folder)
        for field in ("U", "p", "phi", "particleMomentumSource", "particleMomentumOwed"):
            a, b = ((run / "0.002" / field).read_bytes() for run in runs)
            self.assertEqual(a, b, field)
        self.assertEqual(*((run / "grains.dump").read_text() for run in runs))

    def test_contact(self):
        """Two grains meet head-on without a fluid's force, in steps of 1.4 to 2e-6 s, some 60 to a contact: restitution
        of 0.9 to 1 %."""
        x, v = [(0.01, 0.01, 0.0195), (0.01, 0.01, 0.0207)], [(0, 0, 0.5), (0, 0, -0.5)]
        folder = self.adjusted(self.new_folder(), grains=box.grains(x, v, 1e-3), end_time=6e-4, dt=2e-6, delta_t=3e-6,
                               max_delta_t=3.3e-5, velocity="(0 0 0)", options={"drag": None, "forces": "{}"},
                               fixes="fix contacts all hertz/cg tangential history rolling off\n",
                               plugins="plugin load hertzcgplugin.so", end=scripts.dump(10, "grains.dump", box.MOTION), cells="4 4 8")
        frames = [frame.by_id() for frame in dumps.frames(folder / "grains.dump")]
        before, after = (abs(f[1][5] - f[2][5]) for f in (frames[0], frames[-1]))
        print(f"\nrestitution {after / before:.5f}, steps {sorted(set(self.clock(folder)[1]))}")
        self.assertGreater(len(set(self.clock(folder)[1])), 5)
        self.assertAlmostEqual(after / before / 0.9, 1, delta=0.01)

    def test_accelerating_fluid(self):
        """A plug flow with acceleration a, steps that grow by a fifth: DU/Dt is the change of U over the step in which it
        happened. A light grain with added mass has (1 + C)/(s + C) a from the second interval on; 1e-5: the solver's
        pressure gradient."""
        a, ratio, C, end = 100.0, 0.001, 0.5, 1e-3
        folder = self.new_folder()
        box.write(folder, steps=10 ** 6, walls=True, delta_t=3e-5, control=controls(2e-4),
                  rho="rho [1 -3 0 0 0 0 0] 1000;", nu=1e-5)
        dictionaries.put(folder / "system/controlDict", endTime=repr(end), writeControl="adjustableRunTime",
                         writeInterval=repr(end))
        box.script(folder, grains=box.grains([(0.006, 0.007, 0.02)], [(0, 0, 0)], 2e-4, 1000 * ratio), boundary="f f f",
                   fixes=CLOCK, end=scripts.dump(1, "grains.dump", box.MOTION))
        box.fv_options(folder, couplingInterval=None, coupling="oneWay", drag=None,
                       forces="{ pressureGradient {} viscous {} addedMass {} }")
        self.foam("blockMesh", folder)
        for name, inlet, outlet in (
                ("U", f"type uniformFixedValue; uniformValue table ((0 (0 0 0)) (1 (0 0 {a})));", "type zeroGradient;"),
                ("p", "type zeroGradient;", "type fixedValue; value uniform 0;")):
            path = folder / "0" / name
            text = path.read_text()
            path.write_text(text[:text.index("boundaryField")] + "boundaryField\n"
                            f'{{ zlo {{ {inlet} }} zhi {{ {outlet} }} "[xy].*" {{ type slip; }} }}\n')
        mesh = folder / "constant/polyMesh/boundary"
        mesh.write_text(mesh.read_text().replace("wall;", "patch;"))
        result = self.foam("pimpleFoam", folder)
        time, h = self.clock(folder)
        first = fluid_steps(result.output)[0]
        n = math.ceil(first / LONGEST * (1 - 1e-5))
        expected = (1 + C) / (ratio + C) * a * (end - time[n - 1] - 0.5 * h[n])
        self.assertAlmostEqual(dumps.last(folder / "grains.dump")[1][5] / expected, 1, delta=1e-5)

    def interrupted(self, control, equations, ranks=0):
        """A run of twice the time, and one that is stopped and continued, with contacts and added mass."""
        x, v = box.swarm(300, 5, high=(0.02, 0.02, 0.02))
        runs = []
        for whole in (True, False):
            folder = self.new_folder()
            box.write(folder, steps=10 ** 6, delta_t=3e-5, velocity="(0 0 1)", control=controls(2e-4))
            dictionaries.put(folder / "system/controlDict", **control(whole))
            box.script(folder, grains=box.grains(x, v, 1e-3), plugins="plugin load hertzcgplugin.so",
                       fixes="fix contacts all hertz/cg tangential history rolling off\n" + CLOCK.replace(
                           "clock.txt", "clock${continued}.txt"),
                       end=scripts.dump(1, "grains${continued}.dump", box.MOTION))
            box.fv_options(folder, couplingInterval=None, interpolation="cell", drag=None, forces=ALL,
                           voidFraction=box.void_fraction(equations))
            self.foam("blockMesh", folder)
            if ranks:
                self.foam("decomposePar", folder)
            self.result = self.foam("pimpleFoam", folder, ranks)
            runs.append(folder)
        dictionaries.put(folder / "system/controlDict", **control(True))
        self.result = self.foam("pimpleFoam", folder, ranks)
        self.assertIn("300 continued grains", self.result.output)
        return runs

    def test_restart_bit_for_bit(self):
        """Stopped by a time of writing after 8 steps of changing length, and continued."""
        def control(whole):
            stop = dict(endTime="0.0019", stopAt="endTime") if whole else dict(endTime="1", stopAt="nextWrite")
            return dict(writeControl="timeStep", writeInterval="8", **stop)
        for equations in ("neglected", "full"):
            with self.subTest(equations=equations):
                whole, parts = self.interrupted(control, equations)
                self.assertGreater(max(box.read_balance(whole)["contacts"][:8]), 0)
                time = max((p.name for p in whole.iterdir() if re.fullmatch(r"0\.\d+", p.name)), key=float)
                for field in ("U", "p", "phi", "particleMomentumSource", "particleMomentumOwed", "previousGrainU"):
                    a, b = ((f / time / field).read_bytes() for f in (whole, parts))
                    self.assertEqual(a, b, field)
                self.assertEqual(dumps.last(whole / "grains0.dump"), dumps.last(parts / "grains1.dump"))
                self.assertEqual(self.clock_end(whole, 0), self.clock_end(parts, 1))

    def clock_end(self, folder, continued):
        return (folder / f"clock{continued}.txt").read_text().splitlines()[-1]

    def test_restart_at_adjusted_times(self):
        """The same with adjustableRunTime: OpenFOAM works out the step to the next time of writing from the start time
        of the run, so that the two differ by round-off."""
        def control(whole):
            return dict(writeControl="adjustableRunTime", writeInterval="0.001", endTime="0.002" if whole else "0.001")
        whole, parts = self.interrupted(control, "neglected")
        a, b = dumps.last(whole / "grains0.dump"), dumps.last(parts / "grains1.dump")
        for tag in a:
            for p, q in zip(a[tag], b[tag]):
                self.assertAlmostEqual(p, q, delta=1e-11)

    def test_switched_between_runs(self):
        """A run with fixed steps, continued with steps that change, and with fixed ones again: LIGGGHTS' time goes on from
        that of the file with the step that is made, and the balance is kept."""
        x, v = box.swarm(300, 5, high=(0.02, 0.02, 0.02))
        folder = self.new_folder()
        box.write(folder, velocity="(0 0 1)", steps=10, control="adjustTimeStep no; maxCo 0.1; maxDeltaT 2e-4;")
        box.script(folder, grains=box.grains(x, v, 1e-3), fixes=CLOCK)
        options = {"drag": None, "forces": ALL}
        box.fv_options(folder, **options)
        self.foam("blockMesh", folder)
        self.foam("pimpleFoam", folder)
        dictionaries.put(folder / "system/controlDict", adjustTimeStep="yes", endTime="0.002",
                         writeControl="adjustableRunTime", writeInterval="0.001")
        box.fv_options(folder, couplingInterval=None, **options)
        self.foam("pimpleFoam", folder)
        time, h = self.clock(folder)
        self.assertAlmostEqual(time[0], 0.001 + h[0], delta=1e-14)
        self.assertAlmostEqual(time[-1], 0.002, delta=1e-14)
        dictionaries.put(folder / "system/controlDict", adjustTimeStep="no", endTime="0.003", writeControl="timeStep",
                         writeInterval="10")
        box.fv_options(folder, **options)
        self.foam("pimpleFoam", folder)
        self.assertEqual(set(self.clock(folder)[1]), {LONGEST})
        for start in ("0.001", "0.002"):
            self.assertLess(max(box.read_balance(folder, start)["imbalance"]), 1e-12)

    # what is refused

    def refused(self, *words, interval=None, control="adjustTimeStep yes; maxCo 1; maxDeltaT 1e-4;", fixes="", ranks=0):
        folder = self.new_folder()
        box.write(folder, control=control, cells="2 2 4")
        box.script(folder, grains=box.grains([(0.01, 0.01, 0.01)], [(0, 0, 1)]), fixes=fixes)
        box.fv_options(folder, couplingInterval=interval)
        self.foam("blockMesh", folder)
        if ranks:
            self.foam("decomposePar", folder)
        result = self.foam("pimpleFoam", folder, ranks, check=False, timeout=60)
        self.assertFails(result, *words)
        self.assertEqual(result.output.count("FOAM FATAL"), 1, result)
        self.assertNotRegex(result.output, box.SOLVED)

    def test_refused(self):
        self.refused("couplingInterval is for a fixed step", "constant/fvOptions", "adjustTimeStep yes", interval="10", ranks=2)
        self.refused("Entry couplingInterval is missing", control="adjustTimeStep no;")
        distribution = """
fix pts all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 1e-4
fix pdd all particledistribution/discrete 32452843 1 pts 1
region low block 0.004 0.016 0.004 0.016 0.004 0.008 units box
"""
        stream = distribution + (
            "fix ins all insert/rate/region seed 49979693 distributiontemplate pdd verbose no nparticles 100 particlerate 1000 "
            "insert_every 10 overlapcheck yes vel constant 0 0 0 region low ntry_mc 1000\n")
        self.refused("fix ins of style insert/rate/region counts DEM steps", "couplingInterval", "constant/in.particles",
                     fixes=stream, ranks=2)
        self.refused("fix d of style dt/reset", fixes="fix d all dt/reset 1 1e-7 1e-5 1e-6\n")
        once = distribution + ("fix ins all insert/pack seed 49979693 distributiontemplate pdd verbose no insert_every once "
                               "overlapcheck yes vel constant 0 0 0 particles_in_region 20 region low ntry_mc 1000\n")
        folder = self.adjusted(self.new_folder(), grains="", end_time=2e-4, fixes=once, cells="4 4 8")
        self.assertEqual(box.read_balance(folder)["present"][-1], 20)


if __name__ == "__main__":
    unittest.main()
