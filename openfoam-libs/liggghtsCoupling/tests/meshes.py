# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes that users have: each function makes one in the folder of a case that coupled_box has written.

All fill (part of) the box of 20 mm x 20 mm x 40 mm with cells of about 2 mm, so that grains of one kind serve
all of them. Walls, an inlet at zlo and an outlet at zhi, unless a mesh says otherwise.
"""

import math
import random
import re

import grainjet
from grainjet import dictionaries

SIZE = (0.02, 0.02, 0.04)
AXIS = 0.01     # x and y of the axis of pipes

SNAPPY = """
castellatedMesh true; snap true; addLayers {layers};
geometry {{ {surface}.stl {{ type triSurfaceMesh; name {surface}; }}
            near {{ type searchableBox; min (0.003 0.003 0.008); max (0.017 0.017 0.02); }} }}
castellatedMeshControls
{{
    maxLocalCells 100000; maxGlobalCells 100000; minRefinementCells 0; nCellsBetweenLevels 1;
    features (); refinementSurfaces {{ {surface} {{ level ({level} {level}); }} }}
    resolveFeatureAngle 30; refinementRegions {{ {regions} }}
    locationInMesh (0.01013 0.01017 0.0211); allowFreeStandingZoneFaces true;
}}
snapControls {{ nSmoothPatch 3; tolerance 2; nSolveIter 30; nRelaxIter 5; }}
addLayersControls
{{
    relativeSizes true; layers {{ "{surface}.*" {{ nSurfaceLayers 3; }} }}
    expansionRatio 1.2; finalLayerThickness 0.4; minThickness 0.05; nGrow 0; featureAngle 130;
    nRelaxIter 3; nSmoothSurfaceNormals 1; nSmoothNormals 3; nSmoothThickness 10;
    maxFaceThicknessRatio 0.5; maxThicknessToMedialRatio 0.3; minMedianAxisAngle 90; minMedialAxisAngle 90;
    nBufferCellsNoExtrude 0; nLayerIter 50;
}}
meshQualityControls
{{
    maxNonOrtho 65; maxBoundarySkewness 20; maxInternalSkewness 4; maxConcave 80; minVol 1e-15;
    minTetQuality 1e-15; minArea -1; minTwist 0.02; minDeterminant 0.001; minFaceWeight 0.05;
    minVolRatio 0.01; minTriangleTwist -1; nSmoothScale 4; errorReduction 0.75;
}}
mergeTolerance 1e-6;
"""

WEDGE = """
scale 0.001;
vertices ((0 0 0) ({x} -{y} 0) ({x} {y} 0) (0 0 40) ({x} -{y} 40) ({x} {y} 40));
blocks (hex (0 1 2 0 3 4 5 3) (8 1 20) simpleGrading (1 1 1));
boundary (front {{ type wedge; faces ((0 1 4 3)); }} back {{ type wedge; faces ((0 3 5 2)); }}
          xhi {{ type wall; faces ((1 2 5 4)); }}
          zlo {{ type patch; faces ((0 2 1 0)); }} zhi {{ type patch; faces ((3 4 5 3)); }});
"""
WEDGE_ANGLE = 5     # degrees

# two blocks whose points do not match at z = 20 mm, nor those of their ends, which are periodic
UNMATCHED = """
scale 0.001;
vertices ((0 0 0) (20 0 0) (20 20 0) (0 20 0) (0 0 20) (20 0 20) (20 20 20) (0 20 20)
          (0 0 20) (20 0 20) (20 20 20) (0 20 20) (0 0 40) (20 0 40) (20 20 40) (0 20 40));
blocks (hex (0 1 2 3 4 5 6 7) (10 10 10) simpleGrading (1 1 1)
        hex (8 9 10 11 12 13 14 15) (7 8 11) simpleGrading (1 1 1));
boundary
(
    sides { type wall; faces ((0 4 7 3) (1 2 6 5) (0 1 5 4) (3 7 6 2)
                              (8 12 15 11) (9 10 14 13) (8 9 13 12) (11 15 14 10)); }
    below { type cyclicAMI; neighbourPatch above; transform noOrdering; faces ((4 5 6 7)); }
    above { type cyclicAMI; neighbourPatch below; transform noOrdering; faces ((8 11 10 9)); }
    zlo { type cyclicAMI; neighbourPatch zhi; transform translational; separationVector (0 0 0.04);
          faces ((0 3 2 1)); }
    zhi { type cyclicAMI; neighbourPatch zlo; transform translational; separationVector (0 0 -0.04);
          faces ((12 13 14 15)); }
);
"""

BAFFLES = """internalFacesOnly true; noFields true;
baffles
{
    across { type searchableSurface; surface plate; origin (0 0 0.02); span (0.014 0.02 0);
             patchPairs { type wall; } }
    along { type searchableSurface; surface plate; origin (0.01 0 0); span (0 0.01 0.03);
            patchPairs { type wall; } }
}
"""


def program(folder, *command):
    """Run a program of OpenFOAM that must succeed."""
    result = grainjet.run(command, folder)
    if result.code:
        raise AssertionError(f"{command}: {result}")
    return result.output


def put(path, text, kind="dictionary"):
    """Write a file with its header."""
    dictionaries.write(path, text, kind)


def write_mesh(folder, points, cells, patch_of):
    """Write a mesh of any polyhedra. cells: per cell its faces, each a tuple of points in order,
    outward. patch_of(centre): name of the patch of a boundary face."""
    faces = {}
    for celli, cell in enumerate(cells):
        for face in cell:
            faces.setdefault(frozenset(face), []).append((celli, face))
    # Each face points from its owner, the cell of the lower number, to the other
    inner = sorted((two[0][0], two[1][0], two[0][1]) for two in faces.values() if len(two) == 2)
    patches = {}
    for one in faces.values():
        if len(one) == 1:
            celli, face = one[0]
            centre = [sum(points[p][k] for p in face) / len(face) for k in range(3)]
            patches.setdefault(patch_of(centre), []).append((celli, face))
    outer = [item for name in sorted(patches) for item in patches[name]]

    mesh = folder / "constant/polyMesh"
    mesh.mkdir(parents=True, exist_ok=True)

    def store(name, cls, lines, note=""):
        (mesh / name).write_text(
            f'FoamFile {{ version 2.0; format ascii; class {cls}; {note} location "constant/polyMesh"; '
            f"object {name}; }}\n{len(lines)}\n(\n" + "\n".join(lines) + "\n)\n")

    note = (f'note "nPoints: {len(points)} nCells: {len(cells)} nFaces: {len(inner) + len(outer)} '
            f'nInternalFaces: {len(inner)}";')
    store("points", "vectorField", ["({!r} {!r} {!r})".format(*p) for p in points])
    store("faces", "faceList", ["{}({})".format(len(f), " ".join(map(str, f)))
                              for f in [f[2] for f in inner] + [f[1] for f in outer]])
    store("owner", "labelList", [str(f[0]) for f in inner] + [str(f[0]) for f in outer], note)
    store("neighbour", "labelList", [str(f[1]) for f in inner], note)
    entries, start = [], len(inner)
    for name in sorted(patches):
        kind = "patch" if name in ("zlo", "zhi") else "wall"
        entries.append(f"{name} {{ type {kind}; nFaces {len(patches[name])}; startFace {start}; }}")
        start += len(patches[name])
    store("boundary", "polyBoundaryMesh", entries)


def side_of(centre):
    """The patch of a face of the box."""
    for k, axis in enumerate("xyz"):
        for value, end in ((0, "lo"), (SIZE[k], "hi")):
            if abs(centre[k] - value) < 1e-6 * SIZE[k]:
                return axis + end
    raise ValueError(centre)


def grid_points(cells, shift, seed):
    """Points of a grid; inner ones moved at random by a share of a cell's width. Returns them, and
    the number of point i, j, k."""
    rng = random.Random(seed)
    points = []
    for k in range(cells[2] + 1):
        for j in range(cells[1] + 1):
            for i in range(cells[0] + 1):
                p = []
                inner = all(0 < a < n for a, n in zip((i, j, k), cells))
                for a, n, side in zip((i, j, k), cells, SIZE):
                    p.append(side * (a + inner * shift * rng.uniform(-1, 1)) / n)
                points.append(p)
    return points, lambda i, j, k: i + (cells[0] + 1) * (j + (cells[1] + 1) * k)


def tetrahedra(folder):
    """Each cell of a grid with moved points divided into six tetrahedra."""
    n = (8, 8, 16)
    points, at = grid_points(n, 0.15, 1)
    # the ways from one corner of a cube to the opposite one
    ways = ((0, 1, 2), (1, 2, 0), (2, 0, 1), (0, 2, 1), (2, 1, 0), (1, 0, 2))
    cells = []
    for k in range(n[2]):
        for j in range(n[1]):
            for i in range(n[0]):
                for way in ways:
                    corner, corners = [i, j, k], [at(i, j, k)]
                    for axis in way:
                        corner[axis] += 1
                        corners.append(at(*corner))
                    if way in ways[3:]:
                        corners[1], corners[2] = corners[2], corners[1]
                    a, b, c, d = corners
                    cells.append(((a, c, b), (a, b, d), (b, c, d), (a, d, c)))
    write_mesh(folder, points, cells, side_of)


def dual(folder):
    """The dual of the tetrahedra: polyhedra of many faces, faces of many points."""
    tetrahedra(folder)
    program(folder, "polyDualMesh", "60", "-overwrite")


def concave(folder):
    """Three cells of a grid in the form of an L make one cell. Those above each other have one common
    face, an L of eight points; points are moved, so that faces are warped."""
    n = (10, 9, 12)
    points, at = grid_points(n, 0.08, 2)
    # two L fill a rectangle of two by three: the squares of each, and the contour of their
    # common face, counter-clockwise seen from above
    forms = ((((0, 0), (1, 0), (0, 1)), ((0, 0), (1, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2), (0, 1))),
             (((1, 1), (0, 2), (1, 2)), ((1, 1), (2, 1), (2, 2), (2, 3), (1, 3), (0, 3), (0, 2), (1, 2))))
    cells = []
    for k in range(n[2]):
        for j in range(0, n[1], 3):
            for i in range(0, n[0], 2):
                for _, contour in forms:
                    ring = [(i + a, j + b) for a, b in contour]
                    sides = [(at(*p, k), at(*q, k), at(*q, k + 1), at(*p, k + 1))
                             for p, q in zip(ring, ring[1:] + ring[:1])]
                    cells.append((*sides, tuple(at(*p, k + 1) for p in ring),
                                  tuple(at(*p, k) for p in reversed(ring))))
    write_mesh(folder, points, cells, side_of)


def stl(path, triangles):
    path.parent.mkdir(exist_ok=True)
    path.write_text("solid surface\n" + "".join(
        "facet normal 0 0 0\n outer loop\n" + "".join("  vertex {!r} {!r} {!r}\n".format(*p) for p in t)
        + " endloop\nendfacet\n" for t in triangles) + "endsolid surface\n")


def ring(radius, z, sides=48):
    return [(AXIS + radius * math.cos(2 * math.pi * i / sides), AXIS + radius * math.sin(2 * math.pi * i / sides), z)
            for i in range(sides)]


def tube(lower, upper):
    """Triangles between two rings."""
    out = []
    for i in range(len(lower)):
        j = (i + 1) % len(lower)
        out += [(lower[i], lower[j], upper[j]), (lower[i], upper[j], upper[i])]
    return out


def snappy(folder, surface, triangles, **settings):
    stl(folder / "constant/triSurface" / f"{surface}.stl", triangles)
    program(folder, "blockMesh")
    put(folder / "system/snappyHexMeshDict", SNAPPY.format(surface=surface, **settings))
    program(folder, "snappyHexMesh", "-overwrite")


def jet(folder):
    """A pipe of 5 mm radius that opens into a chamber at z = 10 mm, by snappyHexMesh: cells cut by the
    pipe's wall, and finer cells around the mouth."""
    snappy(folder, "nozzle", tube(ring(0.005, -0.001), ring(0.005, 0.01)) + tube(ring(0.005, 0.01), ring(0.02, 0.01)),
           layers="false", level=1, regions="near { mode inside; levels ((1 1)); }")


def layers(folder):
    """A pipe of 8 mm radius with layers of flat prisms on its wall, by snappyHexMesh."""
    snappy(folder, "pipe", tube(ring(0.008, -0.001), ring(0.008, 0.041)), layers="true", level=0, regions="")


def wedge(folder):
    """A wedge of 5 degrees with its axis, one cell thick."""
    half = math.radians(WEDGE_ANGLE / 2)
    put(folder / "system/blockMeshDict", WEDGE.format(x=20 * math.cos(half), y=20 * math.sin(half)))
    program(folder, "blockMesh")


def baffles(folder):
    """The box with two walls of no thickness inside, which meet, end within the fluid, and are warped: the
    points inside are moved."""
    n = (10, 10, 20)
    points, at = grid_points(n, 0.1, 3)
    cells = []
    for k in range(n[2]):
        for j in range(n[1]):
            for i in range(n[0]):
                c = [at(i + a, j + b, k + c) for a, b, c in
                     ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))]
                cells.append([tuple(c[p] for p in face) for face in
                              ((0, 4, 7, 3), (1, 2, 6, 5), (0, 1, 5, 4), (3, 7, 6, 2), (0, 3, 2, 1), (4, 5, 6, 7))])
    write_mesh(folder, points, cells, side_of)
    put(folder / "system/createBafflesDict", BAFFLES)
    program(folder, "createBaffles", "-overwrite")


def unmatched(folder):
    """Two blocks joined by cyclicAMI, periodic by cyclicAMI."""
    put(folder / "system/blockMeshDict", UNMATCHED)
    program(folder, "blockMesh")


def decompose(folder, ranks):
    """Divide the mesh: for two ranks by a plane, for more into pieces of seven cells, so that cells of all ranks
    meet everywhere."""
    text = f"numberOfSubdomains {ranks}; method simple; simpleCoeffs {{ n (2 1 1); delta 1e-6; }}\n"
    if ranks > 2:
        owner = (folder / "constant/polyMesh/owner").read_text()
        n = int(re.search(r"nCells:\s*(\d+)", owner).group(1))
        put(folder / "constant/ranksOfCells",
            f"{n}\n(\n" + "\n".join(str(i // 7 % ranks) for i in range(n)) + "\n)\n", "labelList")
        text = f'numberOfSubdomains {ranks}; method manual; manualCoeffs {{ dataFile "ranksOfCells"; }}\n'
    put(folder / "system/decomposeParDict", text)
    program(folder, "decomposePar", "-force")


def radius(p):
    return math.hypot(p[0] - AXIS, p[1] - AXIS)


# per mesh: how it is made, and where grains may begin
MESHES = {
    "jet": (jet, lambda p: p[2] > 0.0105 or radius(p) < 0.0045),
    "layers": (layers, lambda p: radius(p) < 0.0078),
    "tetrahedra": (tetrahedra, lambda p: True),
    "dual": (dual, lambda p: True),
    "concave": (concave, lambda p: True),
    "wedge": (wedge, lambda p: p[0] > 0 and abs(p[1]) < 0.98 * p[0] * math.tan(math.radians(WEDGE_ANGLE / 2))),
    "baffles": (baffles, lambda p: True),
    "unmatched": (unmatched, lambda p: True),
}


class EachMesh:
    """One test per mesh, for a test class with on_mesh(name)."""

    def test_jet(self):
        """A pipe that opens into a chamber, by snappyHexMesh."""
        self.on_mesh("jet")

    def test_layers(self):
        """A pipe with prism layers, by snappyHexMesh."""
        self.on_mesh("layers")

    def test_tetrahedra(self):
        """Tetrahedra."""
        self.on_mesh("tetrahedra")

    def test_dual(self):
        """Polyhedra, by polyDualMesh."""
        self.on_mesh("dual")

    def test_concave(self):
        """Cells and faces in the form of an L."""
        self.on_mesh("concave")

    def test_wedge(self):
        """A wedge."""
        self.on_mesh("wedge")

    def test_baffles(self):
        """Baffles between warped cells."""
        self.on_mesh("baffles")

    def test_unmatched(self):
        """cyclicAMI."""
        self.on_mesh("unmatched")
