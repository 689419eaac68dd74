# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The box of the coupling's tests as a case of solvers with other kinds of fluid. Each function changes a folder that
coupled_box.write has written; cells are numbered with x first, z last."""

from grainjet import dictionaries

WATER, AIR = 1000.0, 1.2

WALL_PRESSURE = "type fixedFluxPressure; value uniform 0;"

THERMO = """
thermoType {{ type heRhoThermo; mixture pureMixture; transport const; thermo hConst;
             equationOfState perfectGas; specie specie; energy sensible{energy}; }}
mixture {{ specie {{ molWeight 28.9; }} thermodynamics {{ Cp 1007; Hf 0; }} transport {{ mu 1.8e-5; Pr 0.7; }} }}
"""


def layers(values, per_layer):
    """A field of the cells that has one value in each layer across z; the text behind internalField."""
    return dictionaries.nonuniform([value for value in values for _ in range(per_layer)])


def gravity(folder, g):
    """constant/g."""
    dictionaries.write(folder / "constant/g", f"dimensions [0 1 -2 0 0 0 0]; value {dictionaries.vector(g)};\n",
                       "uniformDimensionedVectorField")


def pressure(folder, kinematic, walls, value="0", density="rho"):
    """0/p_rgh."""
    dictionaries.write_field(folder, "p_rgh", "0 2 -2" if kinematic else "1 -1 -2", value, {
        ".*": f"{WALL_PRESSURE} rho {density};" if walls else "type cyclic;"})


def inter_foam(folder, alpha, g=(0, 0, 0), walls=True, sigma=0.07, water_nu=1e-6, boundary=None):
    """interFoam and interIsoFoam: water and air. alpha: the text behind internalField."""
    dictionaries.write(folder / "constant/transportProperties", f"""
phases (water air);
water {{ transportModel Newtonian; nu {water_nu}; rho {WATER}; }}
air {{ transportModel Newtonian; nu 1.5e-5; rho {AIR}; }}
sigma {sigma};
""")
    gravity(folder, g)
    pressure(folder, False, walls)
    dictionaries.write_field(folder, "alpha.water", "0 0 0", alpha,
                             {".*": "type zeroGradient;" if walls else "type cyclic;"})
    (folder / "0/p").unlink()
    # the flux of a continued run stays as it is: pcorr is content with any
    dictionaries.change(folder / "system/fvSolution", (
        "solvers\n{", 'solvers\n{ pcorr { solver PCG; preconditioner DIC; tolerance 10; relTol 0; } pcorrFinal { $pcorr; }\n'
        '"alpha.*" { nAlphaCorr 1; nAlphaSubCycles 2; cAlpha 1; isoFaceTol 1e-8; surfCellTol 1e-8; nAlphaBounds 3;'
        " snapTol 1e-12; clip true; }"))
    dictionaries.change(folder / "system/fvSchemes", (
        "divSchemes {", "divSchemes { div(phi,alpha) Gauss vanLeer;"))
    dictionaries.change(folder / "system/controlDict", (
        "deltaT", "adjustTimeStep no; maxCo 1; maxAlphaCo 1; deltaT"))


def boussinesq(folder, temperature, g, walls=True):
    """buoyantBoussinesqPimpleFoam. temperature: the text behind internalField."""
    gravity(folder, g)
    dictionaries.change(folder / "constant/transportProperties", (
        "nu [0 2", "beta [0 0 0 -1 0 0 0] 3e-3; TRef [0 0 0 1 0 0 0] 300; Pr [0 0 0 0 0 0 0] 0.7; "
        "Prt [0 0 0 0 0 0 0] 0.85; nu [0 2"))
    side = "type zeroGradient;" if walls else "type cyclic;"
    dictionaries.write_field(folder, "T", "[0 0 0 1 0 0 0]", temperature, {".*": side})
    dictionaries.write_field(folder, "alphat", "0 2 -1", "0", {
        ".*": "type calculated; value uniform 0;" if walls else side})
    pressure(folder, True, walls, density="rhok")
    dictionaries.change(folder / "system/fvSolution", ('"U.*"', '"(U|T).*"'))


def buoyant_pimple(folder, p, g, top=("1e5", "1e5"), energy="Enthalpy"):
    """buoyantPimpleFoam with air at 300 K as a perfect gas, in a box with walls. p: the text behind internalField. top:
    p and p_rgh at the upper wall, which hold the pressure: a box without such a place ends the stock solver with a
    division by zero."""
    dictionaries.write(folder / "constant/thermophysicalProperties", THERMO.format(energy=energy))
    (folder / "constant/transportProperties").unlink()
    gravity(folder, g)
    dictionaries.write_field(folder, "T", "[0 0 0 1 0 0 0]", "300", {".*": "type zeroGradient;"})
    dictionaries.write_field(folder, "p", "1 -1 -2", p, {
        ".*": "type calculated; value uniform 1e5;", "zhi": f"type calculated; value uniform {top[0]};"})
    pressure(folder, False, True, "1e5")
    dictionaries.change(folder / "0/p_rgh", ("\n}\n", f"\nzhi {{ type fixedValue; value uniform {top[1]}; }}\n}}\n"))
    dictionaries.change(folder / "system/fvSolution", (
        "solvers\n{", 'solvers\n{ "rho.*" { solver diagonal; }'), ('"U.*"', '"(U|h|e).*"'))
