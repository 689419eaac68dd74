# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Forces on grains in flows that are known: Newton's law for the displaced fluid."""
# label: long

import math
import random
import re
import shutil
import unittest

import grainjet
from grainjet import coupled_box as box, dictionaries, dumps, scripts
from grainjet.coupled_box import swarm

RHO, NU, D = 1.2, 1.5e-5, 2e-4
VOLUME = math.pi / 6 * D ** 3
DUMP = scripts.dump(10, "grains.*.dump",
                    "id x y z f_fluidExplicitForce[1] f_fluidExplicitForce[2] f_fluidExplicitForce[3]")


class Forces(grainjet.Case):

    def prepare(self, steps, boundary="p p p", walls=False, forces="(pressureGradient viscous)",
                interpolation="cellPoint", **options):
        box.write(self.folder, steps=steps, write_every=1, walls=walls)
        x, _ = swarm(50, 21, low=(0.003,) * 3, high=(0.017, 0.017, 0.037))
        box.script(self.folder, grains=box.grains(x, [(0, 0, 0)] * len(x), D), boundary=boundary,
                   end=DUMP)
        box.fv_options(self.folder, coupling="oneWay", forces=forces, interpolation=interpolation, **options)
        self.foam("blockMesh", self.folder)

    def lean(self):
        """Move the upper end of the box sideways by half of its width, 14 degrees."""
        path = self.folder / "system/blockMeshDict"
        text = path.read_text()
        start, stop = text.index("vertices"), text.index("blocks")
        vertices = re.findall(r"\(([^()]+)\)", text[start:stop])
        self.assertEqual(len(vertices), 8)
        moved = [[float(v) for v in vertex.split()] for vertex in vertices]
        path.write_text(text[:start] + "vertices (" + " ".join(
            f"({x + z / 4} {y} {z})" for x, y, z in moved) + ");\n" + text[stop:])

    def test_accelerated_plug_flow(self):
        """A uniform flow that accelerates with a = 100 m/s2 in a duct with slip walls: on every
        grain f_gradp + f_visc = V rho Du/Dt = V rho a, to 1e-6. Grains within 12 mm of the
        inlet are left out: there the stock solver itself is uneven after five steps
        (2 % in the second cell, falling by a factor of ten per cell)."""
        a = 100.0
        self.prepare(5, boundary="f f f", walls=True)
        for name, inlet, outlet, side in (
                ("U", f"type uniformFixedValue; uniformValue table ((0 (0 0 0)) (1 (0 0 {a})));",
                 "type zeroGradient;", "type slip;"),
                ("p", "type zeroGradient;", "type fixedValue; value uniform 0;", "type slip;")):
            path = self.folder / "0" / name
            text = path.read_text()
            path.write_text(text[:text.index("boundaryField")] + f"""boundaryField
{{ zlo {{ {inlet} }} zhi {{ {outlet} }} "[xy].*" {{ {side} }} }}
""")
        mesh = self.folder / "constant/polyMesh/boundary"
        mesh.write_text(mesh.read_text().replace("wall;", "patch;"))
        self.foam("pimpleFoam", self.folder)
        # the coupling sees in step n the pressure of step n - 1
        forces = dumps.last(self.folder / "grains.50.dump")
        self.assertEqual(len(forces), 50)
        inner = {tag: row for tag, row in forces.items() if row[2] > 0.012}
        self.assertGreater(len(inner), 30)
        for tag, (_, _, _, fx, fy, fz) in inner.items():
            expected = VOLUME * RHO * a
            self.assertAlmostEqual(fz, expected, delta=1e-6 * expected, msg=f"grain {tag}")
            self.assertLess(math.hypot(fx, fy), 1e-6 * expected)

    def test_decaying_shear(self):
        """u_x = U sin(kz) decays by viscosity alone: f_gradp + f_visc = V rho du/dt. The solver's step
        is implicit and the force taken at its beginning, a difference of nu k^2 dt = 4e-5
        relative; compared with the solver's own du/dt in the grain's cell."""
        self.prepare(2, interpolation="cell")
        k = 2 * math.pi / 0.04
        values = [math.sin(k * (0.001 + 0.002 * (i // 100))) for i in range(2000)]
        path = self.folder / "0/U"
        path.write_text(path.read_text().replace(
            "uniform (0 0 0)", "nonuniform List<vector> 2000 (" + "".join(
                f"({v!r} 0 0)\n" for v in values) + ")"))
        self.foam("pimpleFoam", self.folder)
        before, after = (dictionaries.internal(self.folder / t / "U") for t in ("0.0001", "0.0002"))
        largest = VOLUME * RHO * NU * k ** 2
        grains = dumps.last(self.folder / "grains.20.dump")
        self.assertEqual(len(grains), 50)
        for tag, (x, y, z, fx, fy, fz) in grains.items():
            cell = int(x / 0.002) + 10 * int(y / 0.002) + 100 * int(z / 0.002)
            expected = VOLUME * RHO * (after[cell][0] - before[cell][0]) / 1e-4
            self.assertAlmostEqual(fx, expected, delta=1e-4 * largest, msg=f"grain {tag}")
            self.assertLess(math.hypot(fy, fz), 1e-4 * largest)

    def test_viscous_scheme(self):
        """The viscous force takes the scheme of laplacian(nu,U) of the case, and is the same on one rank and on
        two, to round-off: on a graded mesh with walls or periodic sides and on an oblique one, and for a fluid
        whose nu falls with shear. midPoint differs from linear only in the face value of nu: by nothing for
        uniform nu, and on a uniform mesh, where faces lie halfway."""
        rng = random.Random(5)
        U = "".join("({} {} {})\n".format(*(rng.uniform(-1, 1) for _ in range(3))) for _ in range(2000))
        thinning = ("CrossPowerLaw; CrossPowerLawCoeffs { nu0 nu0 [0 2 -1 0 0 0 0] 1e-4; "
                    "nuInf nuInf [0 2 -1 0 0 0 0] 1e-6; m m [0 0 1 0 0 0 0] 0.01; n n [0 0 0 0 0 0 0] 1; }")
        for walls, oblique, nu in ((True, False, None), (False, False, None), (True, True, None),
                                   (True, False, thinning), (False, False, thinning)):
            forces = {}
            for scheme in ("linear", "midPoint"):
                for ranks in (0, 2):
                    with self.subTest(walls=walls, oblique=oblique, nu=nu, scheme=scheme, ranks=ranks):
                        for old in self.folder.iterdir():
                            shutil.rmtree(old) if old.is_dir() else old.unlink()
                        self.prepare(1, boundary="f f f" if walls else "p p p", walls=walls,
                                     forces="(viscous)", interpolation="cell")
                        for name, before, after in (
                                ("system/blockMeshDict", "simpleGrading (1 1 1)",
                                 f"simpleGrading (1 1 {1 if nu else 3})"),
                                ("constant/transportProperties", "Newtonian;", nu or "Newtonian;"),
                                ("system/fvSchemes", "laplacianSchemes {",
                                 f"laplacianSchemes {{ laplacian(nu,U) Gauss {scheme} corrected;"),
                                ("0/U", "uniform (0 0 0)", f"nonuniform List<vector> 2000 ({U})")):
                            path = self.folder / name
                            text = path.read_text()
                            self.assertEqual(text.count(before), 1, name)
                            path.write_text(text.replace(before, after))
                        if oblique:
                            self.lean()
                        self.foam("blockMesh")
                        if ranks:
                            self.foam("decomposePar")
                        self.foam("pimpleFoam", ranks=ranks)
                        forces[scheme, ranks] = dumps.last(self.folder / "grains.10.dump")
            expected = forces["midPoint", 0]
            largest = max(abs(f) for row in expected.values() for f in row[3:])
            self.assertGreater(largest, VOLUME * RHO * NU / 0.002 ** 2)
            for key, found in forces.items():
                self.assertEqual(found.keys(), expected.keys())
                for tag, row in found.items():
                    for f, e in zip(row[3:], expected[tag][3:]):
                        self.assertAlmostEqual(f, e, delta=1e-11 * largest, msg=f"{key} grain {tag}")

    def test_all_laws_at_rest(self):
        """A fluid at rest with grains at rest: no law may stop the program by a floating-point exception,
        for which OpenFOAM watches (DiFelice once did, by the logarithm of Re = 0), and none moves a
        grain."""
        for law in ("Gidaspow", "WenYu", "Ergun", "SchillerNaumann", "Stokes", "DiFelice", "KochHill",
                    "Beetstra"):
            with self.subTest(law=law):
                self.prepare(1)
                box.fv_options(self.folder, drag=law)
                self.foam("pimpleFoam", self.folder)
                balance = box.read_balance(self.folder)
                self.assertEqual(balance["present"], [50])
                self.assertEqual(balance["meanSlip"], [0])

    def test_buoyancy(self):
        """- V rho g, a vector, the only force of the fluid here; the grain's weight is left to LIGGGHTS. It has no
        reaction on the fluid: the fluid stays at rest, and the impulse is booked as nonReacting: a whole
        fluid step of it, since fix fluid/force applies the first interval's forces before its first half kick."""
        self.prepare(1, drag=None, forces="{ buoyancy {} }")
        script = self.folder / "constant/in.particles"
        script.write_text(script.read_text().replace(
            "fix fluid", "fix g all gravity 9.81 vector 0.6 0 -0.8\nfix fluid").replace(
            "f_fluidExplicitForce", "f_fluidForce"))
        self.foam("pimpleFoam", self.folder)
        weight = VOLUME * RHO * 9.81
        grains = dumps.last(self.folder / "grains.10.dump")
        self.assertEqual(len(grains), 50)
        for *_, fx, fy, fz in grains.values():
            self.assertAlmostEqual(fx, -0.6 * weight, delta=1e-12 * weight)
            self.assertAlmostEqual(fy, 0, delta=1e-12 * weight)
            self.assertAlmostEqual(fz, 0.8 * weight, delta=1e-12 * weight)
        balance = box.read_balance(self.folder)
        impulse = len(grains) * weight * 1e-4
        for name, expected in (("x", -0.6 * impulse), ("y", 0), ("z", 0.8 * impulse)):
            # the table has 17 digits
            self.assertAlmostEqual(balance[f"nonReacting_{name}"][0], expected, delta=1e-12 * impulse)
            self.assertEqual(balance[f"toGrains_{name}"], [0])
            self.assertEqual(balance[f"toFluid_{name}"], [0])


if __name__ == "__main__":
    unittest.main()
