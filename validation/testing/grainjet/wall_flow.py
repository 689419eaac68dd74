# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A flow that is imposed on a mesh with wall functions, and the fluid at grains in it: what the law of the wall
makes of it, against what was imposed.

The case is one step of pimpleFoam with the k-epsilon model. The grains are sampled at its beginning, so that the
solver has not changed anything yet.
"""

import math
import pathlib
import re
import shutil

from grainjet import coupled_box, dictionaries, dumps, scripts
from grainjet.programs import mpirun, run

KAPPA, E = 0.41, 9.8
SQRT_CMU = 0.3

FLUID_VELOCITY = " ".join(f"f_fluidVelocity[{k}]" for k in (1, 2, 3))
SHOWN = "f_fluidExplicitForce[1]"
UNIT = 1e-15                # N per unit of what the model probe of the coupling's tests shows


def spalding(y):
    """u+ of y+ by Spalding's law, by bisection."""
    def distance(u):
        z = KAPPA * u
        return u + (math.exp(z) - 1 - z - z * z / 2 - z ** 3 / 6) / E
    low, high = 0.0, min(y, math.log(1 + E * y) / KAPPA + 1)
    for _ in range(100):
        middle = (low + high) / 2
        low, high = (low, middle) if distance(middle) > y else (middle, high)
    return low


def reichardt(y):
    """u+ of y+ by Reichardt's (1951) law: another formula than the one that the code has."""
    return math.log(1 + 0.4 * y) / 0.4 + 7.8 * (1 - math.exp(-y / 11) - y / 11 * math.exp(-y / 3))


def channel(size, cells, patches):
    """blockMeshDict of a box. patches: {name: (type and further entries, sides)}."""
    return dictionaries.block((0, 0, 0), size, cells, patches)


def sector(angle):
    return math.cos(angle), math.sin(angle)


class Pipe:
    """A pipe along z, periodic: a ring of cells of equal height around a square. Its wall is a polygon."""

    def __init__(self, radius, height, around=96, along=2, length=None):
        self.radius, self.around = radius, around
        self.layers = max(1, round(0.5 * radius / height))
        self.inner = radius - self.layers * height
        self.along, self.length = along, length or 0.2 * radius
        self.edge = 2 * math.pi / around
        self.apothem = radius * math.cos(self.edge / 2)

    def mesh(self):
        corners = [math.pi / 4 + i * math.pi / 2 for i in range(4)]
        square = 0.7 * self.inner

        def ring(radius, z):
            return [(radius * math.cos(a), radius * math.sin(a), z) for a in corners]

        points = [p for z in (0, self.length)
                  for radius in (square, self.inner, self.radius) for p in ring(radius, z)]
        side, core = self.around // 4, f"{self.along}"
        between = max(1, round((self.inner - square) / (square * math.pi / 2 / side)))
        blocks = [f"hex (0 1 2 3 12 13 14 15) ({side} {side} {core}) simpleGrading (1 1 1)"]
        arcs = []
        for i in range(4):
            j = (i + 1) % 4
            for inner, n in ((0, between), (4, self.layers)):
                a, b, c, d = inner + i, inner + 4 + i, inner + 4 + j, inner + j
                blocks.append(f"hex ({a} {b} {c} {d} {a + 12} {b + 12} {c + 12} {d + 12}) "
                              f"({n} {side} {core}) simpleGrading (1 1 1)")
            middle = corners[i] + math.pi / 4
            for first, radius in ((4, self.inner), (8, self.radius)):
                for up, z in ((0, 0), (12, self.length)):
                    arcs.append(f"arc {first + i + up} {first + j + up} "
                                + dictionaries.vector((radius * math.cos(middle), radius * math.sin(middle), z)))
        wall = " ".join(f"({8 + i} {8 + (i + 1) % 4} {20 + (i + 1) % 4} {20 + i})" for i in range(4))

        def end(up):
            quads = ["0 1 2 3"] + [f"{n + i} {n + 4 + i} {n + 4 + (i + 1) % 4} {n + (i + 1) % 4}"
                                   for n in (0, 4) for i in range(4)]
            return " ".join("(" + " ".join(str(int(c) + up) for c in q.split()) + ")" for q in quads)

        return (f"scale 1;\nvertices ({' '.join(map(dictionaries.vector, points))});\n"
                f"blocks ({' '.join(blocks)});\nedges ({' '.join(arcs)});\n"
                f"boundary (wall {{ type wall; faces ({wall}); }}\n"
                f"zlo {{ type cyclic; neighbourPatch zhi; faces ({end(0)}); }}\n"
                f"zhi {{ type cyclic; neighbourPatch zlo; faces ({end(12)}); }});\n")

    def distance(self, p):
        """Distance of a place from the nearest plane of the wall."""
        angle = math.atan2(p[1], p[0]) % self.edge - self.edge / 2
        return self.apothem - math.hypot(p[0], p[1]) * math.cos(angle)

    def place(self, rng, low, high):
        """A random place with a distance from the wall between two."""
        while True:
            angle, y = rng.uniform(0, 2 * math.pi), rng.uniform(low, high)
            off = angle % self.edge - self.edge / 2
            r = (self.apothem - y) / math.cos(off)
            if r > 0:
                return [r * math.cos(angle), r * math.sin(angle), rng.uniform(0.02, 0.98) * self.length]

    def box(self):
        r = 1.01 * self.radius
        return f"{-r} {r} {-r} {r} 0 {self.length!r}"


def centres(folder):
    """Cell centres of a mesh."""
    result = run(["postProcess", "-func", "writeCellCentres", "-time", "0"], folder)
    if result.code:
        raise AssertionError(result)
    found = dictionaries.internal(pathlib.Path(folder) / "0/C")
    for name in ("C", "Cx", "Cy", "Cz", "V"):
        (pathlib.Path(folder) / "0" / name).unlink(missing_ok=True)
    return found


def turbulent(folder):
    """The k-epsilon model in a case that coupled_box has written."""
    dictionaries.write(folder / "constant/turbulenceProperties",
                       "simulationType RAS; RAS { RASModel kEpsilon; turbulence on; printCoeffs off; }\n")
    dictionaries.change(folder / "system/fvSolution", ('"U.*"', '"(U|k|epsilon).*"'))


def mesh(folder, text, **fluid):
    """The case with its mesh; returns the cell centres."""
    coupled_box.write(folder, **fluid)
    turbulent(folder)
    dictionaries.write(folder / "system/blockMeshDict", text)
    result = run(["blockMesh"], folder)
    if result.code:
        raise AssertionError(result)
    return centres(folder)


def patches(folder):
    """{patch: type} of the mesh."""
    text = (folder / "constant/polyMesh/boundary").read_text()
    return dict(re.findall(r"(\w+)\s*\{\s*type\s+(\w+);", text))


def impose(folder, velocity, *, k, epsilon, walls=None, wall_velocity=(0, 0, 0), nut="nutUSpaldingWallFunction"):
    """Fields of the first time. velocity, k, epsilon: one value per cell. walls: {patch: nut}, all with `nut` if left out;
    wall_velocity: of all walls, or {patch: velocity}."""
    kinds = patches(folder)
    functions = walls or {name: nut for name, kind in kinds.items() if kind == "wall"}

    def boundary(at_wall, elsewhere="type zeroGradient;"):
        lines = {}
        for name, kind in kinds.items():
            lines[name] = (at_wall(name) if name in functions
                           else elsewhere if kind in ("wall", "patch") else f"type {kind};")
        return lines

    def moving(name):
        u = wall_velocity.get(name, (0, 0, 0)) if isinstance(wall_velocity, dict) else wall_velocity
        return f"type fixedValue; value uniform {dictionaries.vector(u)};"

    def value(kind, x):
        return lambda name: f"type {kind}; value uniform {x};"

    write = dictionaries.write_field
    write(folder, "U", "0 1 -1", dictionaries.nonuniform(velocity), boundary(moving, "type noSlip;"))
    write(folder, "p", "0 2 -2", 0, boundary(lambda name: "type zeroGradient;"))
    write(folder, "k", "0 2 -2", dictionaries.nonuniform(k), boundary(value("kqRWallFunction", 1e-3)))
    write(folder, "epsilon", "0 2 -3", dictionaries.nonuniform(epsilon),
          boundary(value("epsilonWallFunction", 1e-3)))
    write(folder, "nut", "0 2 -1", 1e-5,
          boundary(lambda name: f"type {functions[name]}; value uniform 1e-5;", "type calculated; value uniform 0;"))


def sample(folder, places, columns=FLUID_VELOCITY, *, box, boundary="f f p", ranks=0, options=None, log=None):
    """The fluid at grains at rest at some places at the beginning of the first step: the columns of the dump,
    one row per place. log: a list that gets the output of the solver."""
    coupled_box.script(folder, grains=coupled_box.grains(places, [(0, 0, 0)] * len(places), diameter=1e-6),
                       boundary=boundary, box=box, end=scripts.dump(10, "grains.dump", f"id {columns}"))
    coupled_box.fv_options(folder, coupling="oneWay", **{"wallLaw": "yes", "forces": "()", **(options or {})})
    for former in [*folder.glob("[0-9]*"), *folder.glob("processor*"), folder / "postProcessing"]:
        if former.name != "0":
            shutil.rmtree(former, ignore_errors=True)
    commands = [["pimpleFoam"]]
    if ranks:
        commands = [["decomposePar"], [*mpirun(ranks), "pimpleFoam", "-parallel"]]
    for command in commands:
        result = run(command, folder)
        if result.code:
            raise AssertionError(result)
    if log is not None:
        log.append(result.output)
    rows = dumps.last(folder / "grains.dump")
    return [rows[i + 1] for i in range(len(places))]
