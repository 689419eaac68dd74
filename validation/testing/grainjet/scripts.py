# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Text that LIGGGHTS reads: commands, data files, surfaces."""


def dump(every, file, columns, name="d"):
    """The commands that dump columns of all grains with all digits, sorted; the first column is the id."""
    words = columns.split()
    layout = " ".join(["%d"] + ["%.17g"] * (len(words) - 1))
    return (f"dump {name} all custom {every} {file} {columns}\n"
            f'dump_modify {name} sort id format "{layout}"\n')


def data(grains, box, types=1):
    """A data file. grains: (type, diameter, density, place, velocity, spin), the last two may lack;
    box: ((xlo, xhi), (ylo, yhi), (zlo, zhi))."""
    def numbers(values):
        return " ".join(map(repr, values))

    lines = ["grains", "", f"{len(grains)} atoms", f"{types} atom types", ""]
    lines += [f"{low} {high} {k}lo {k}hi" for k, (low, high) in zip("xyz", box)]
    lines += ["", "Atoms", ""]
    lines += [f"{i} {kind} {numbers((diameter, density, *place))}"
              for i, (kind, diameter, density, place, *_) in enumerate(grains, 1)]
    lines += ["", "Velocities", ""]
    for i, (_, _, _, _, *motion) in enumerate(grains, 1):
        velocity, spin = [*motion, (0, 0, 0), (0, 0, 0)][:2]
        lines.append(f"{i} {numbers((*velocity, *spin))}")
    return "\n".join(lines) + "\n"


def stl(*triangles):
    """A surface in STL, of triangles of three places each; those who read it work out the normals."""
    lines = ["solid surface"]
    for corners in triangles:
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += ["vertex {!r} {!r} {!r}".format(*corner) for corner in corners]
        lines += ["endloop", "endfacet"]
    return "\n".join([*lines, "endsolid surface"]) + "\n"


def rectangle(a, b, c, d):
    """The two triangles of a rectangle with these corners, in order."""
    return (a, b, c), (a, c, d)
