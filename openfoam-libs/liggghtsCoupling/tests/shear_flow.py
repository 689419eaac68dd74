# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A linear shear flow in the box of grainjet.coupled_box."""

from grainjet import dictionaries


def write(folder, shear, temperature=None):
    """Couette flow in the box of 4 x 4 x 8 cells: u_x = shear z between moving walls, which the solver keeps to
    round-off. T, if asked for, is linear in z, too. The box is written with through=True."""
    def field(name, cls, dimensions, values, low, high):
        kind = "vector" if cls == "volVectorField" else "scalar"
        dictionaries.write_field(folder, name, dimensions, f"nonuniform List<{kind}> 128 ({values})",
                                 f'zlo {{ {low} }} zhi {{ {high} }} "[xy].*" {{ type cyclic; }}')

    z = [0.0025 + 0.005 * (i // 16) for i in range(128)]
    field("U", "volVectorField", "[0 1 -1 0 0 0 0]", " ".join(f"({shear * h!r} 0 0)" for h in z),
          "type fixedValue; value uniform (0 0 0);", f"type fixedValue; value uniform ({shear * 0.04!r} 0 0);")
    field("p", "volScalarField", "[0 2 -2 0 0 0 0]", "0 " * 128, "type zeroGradient;", "type zeroGradient;")
    if temperature:
        low, high = temperature
        field("T", "volScalarField", "[0 0 0 1 0 0 0]",
              " ".join(repr(low + (high - low) * h / 0.04) for h in z),
              f"type fixedValue; value uniform {low};", f"type fixedValue; value uniform {high};")
        path = folder / "system/fvSolution"
        path.write_text(path.read_text().replace('"U.*"', '"(U|T).*"'))
