# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The box of grainjet.coupled_box filled with air as a perfect gas, for the solvers of a compressible fluid."""

import math

import numpy

from grainjet import coupled_box as box, dictionaries, dumps, scripts

# Air: J/kg K, K, Pa
R, GAMMA = 8314.46261815324 / 28.9, 1.4
CV = R / (GAMMA - 1)
T0, P0 = 300.0, 1e5
RHO0 = P0 / (R * T0)
SOUND = (GAMMA * R * T0) ** 0.5

# The solvers write T, not the energy that they solve for; sonicFoam no density
WRITE = "energy {{ type writeObjects; libs (utilityFunctionObjects); objects (rho {}); writeControl writeTime; }}"

# of air
SUTHERLAND = "As 1.4792e-6; Ts 116;"

ENERGY = {"e": "sensibleInternalEnergy", "h": "sensibleEnthalpy"}

# Solver, energy, transonic
SOLVERS = (("rhoPimpleFoam", "e", False), ("rhoPimpleFoam", "h", True), ("sonicFoam", "e", False))


def heat_capacity(energy):
    """The line of thermodynamics: eConst for e, hConst for h."""
    return f"Cv {CV!r}; Hf 0;" if energy == "e" else f"Cp {CV + R!r}; Hf 0;"


def write(folder, *, velocity="(0 0 0)", solver="rhoPimpleFoam", mu=1.8e-5, energy="e", thermo=None, transonic=False,
          correctors="nOuterCorrectors 1; nCorrectors 2;", walls=False, through=False, convection="linear",
          tolerance=1e-14, gas="perfectGas", gas_density=None, pressure=P0, consistent=False, time_scheme="Euler",
          turbulence=None, simulation="RAS", frozen=False, coefficients="", les_entries="", k=1.0, epsilon=1.0, nu_tilda=1e-5, prandtl=0.7,
          transport="const", **fluid):
    """Write the fluid side of the case. Through: supersonic or subsonic, the gas enters at zlo with the given velocity
    and temperature, and leaves at zhi at the given pressure. Turbulence: a model of k, epsilon or nuTilda, which have these
    values at the beginning and at zlo, and its coefficients; simulation: RAS or LES, which has further entries."""
    fluid["functions"] = fluid.get("functions", "") + WRITE.format(energy)
    box.write(folder, velocity=velocity, walls=walls, through=through, convection=convection, **fluid)
    thermo = thermo or ("hePsiThermo" if gas == "perfectGas" else "heRhoThermo")
    state = f"equationOfState {{ rho {gas_density!r}; }}" if gas_density else ""
    dictionaries.write(folder / "constant/thermophysicalProperties", f"""
thermoType
{{
    type {thermo}; mixture pureMixture; transport {transport}; thermo {'e' if energy == 'e' else 'h'}Const;
    equationOfState {gas}; specie specie; energy {ENERGY[energy]};
}}
mixture
{{
    specie {{ molWeight 28.9; }}
    {state}
    thermodynamics {{ {heat_capacity(energy)} }}
    transport {{ {f"mu {mu!r}; Pr {prandtl!r};" if transport == "const" else SUTHERLAND} }}
}}
""")
    dictionaries.change(folder / "system/controlDict", ("application pimpleFoam", f"application {solver}"))
    dictionaries.change(folder / "system/fvSchemes", ("default Gauss linear; div(phi,U)", f"default Gauss {convection}; div(phi,U)"),
        ("snGradSchemes", "fluxRequired { default no; p; }\nsnGradSchemes"))
    dictionaries.change(folder / "system/fvSchemes", ("divSchemes {", "divSchemes { div(((rho*nuEff)*dev2(T(grad(U))))) Gauss linear;"))
    dictionaries.change(folder / "system/fvSchemes", ("default Euler", f"default {time_scheme}"))
    krylov = "solver PBiCGStab; preconditioner {}; tolerance {}; relTol 0;"
    of_p = krylov.format("DILU" if transonic or solver == "sonicFoam" else "DIC", tolerance)
    dictionaries.write(folder / "system/fvSolution", f"""
solvers
{{
    "p.*" {{ {of_p} }}
    "rho.*" {{ solver diagonal; }}
    "(U|e|h|k|epsilon|nuTilda).*" {{ {krylov.format("DILU", tolerance)} }}
}}
PIMPLE {{ {correctors} nNonOrthogonalCorrectors 0; transonic {'yes' if transonic else 'no'};
          consistent {'yes' if consistent else 'no'}; }}
""")
    solid = "type noSlip;" if walls else "type cyclic;"
    other = "type zeroGradient;" if walls else "type cyclic;"
    inlet = f"zlo {{ type fixedValue; value uniform {velocity}; }} zhi {{ type zeroGradient; }}"
    warm = f"zlo {{ type fixedValue; value uniform {T0}; }} zhi {{ type zeroGradient; }}"
    outlet = f"zlo {{ type zeroGradient; }} zhi {{ type fixedValue; value uniform {pressure!r}; }}"
    dictionaries.write_field(folder, "U", "0 1 -1", velocity, f'".*" {{ {solid} }} {inlet if through else ""}')
    dictionaries.write_field(folder, "p", "1 -1 -2", pressure, f'".*" {{ {other} }} {outlet if through else ""}')
    dictionaries.write_field(folder, "T", "[0 0 0 1 0 0 0]", T0, f'".*" {{ {other} }} {warm if through else ""}')
    if turbulence:
        filter_width = f"delta cubeRootVol; cubeRootVolCoeffs {{ deltaCoeff 1; }} {les_entries}" if simulation == "LES" else ""
        dictionaries.write(folder / "constant/turbulenceProperties",
                           f"simulationType {simulation}; {simulation} {{ {simulation}Model {turbulence}; "
                           f"turbulence {'off' if frozen else 'on'}; printCoeffs off; {filter_width} "
                           f"{turbulence}Coeffs {{ {coefficients} }} }}")
        dictionaries.change(folder / "system/fvSchemes", ("ddtSchemes", "wallDist { method meshWave; }\nddtSchemes"))
        for name, value, dimensions in (("k", k, "0 2 -2"), ("epsilon", epsilon, "0 2 -3"), ("nuTilda", nu_tilda, "0 2 -1"),
                                        ("nut", 0, "0 2 -1"), ("alphat", 0, "1 -1 -1")):
            at_inlet = "type calculated; value uniform 0;" if value == 0 else f"type fixedValue; value uniform {value!r};"
            dictionaries.write_field(folder, name, dimensions, value, f'".*" {{ {other} }} ' + (
                f"zlo {{ {at_inlet} }} zhi {{ type zeroGradient; }}" if through else ""))


def loth(re, mach):
    """Cd Re by Loth et al. (2021), AIAA J. 59, 3261, for Re > 45, which the slips here have until little is left."""
    c = 1.65 + 0.65 * math.tanh(4 * mach - 3.4) if mach < 1.5 else 2.18 - 0.13 * math.tanh(0.9 * mach - 2.7)
    g = 166 * mach ** 3 + 3.29 * mach ** 2 - 10.9 * mach + 20 if mach < 0.8 else 5 + 40 / mach ** 3
    h = 0.0239 * mach ** 3 + 0.212 * mach ** 2 - 0.074 * mach + 1 if mach < 1 else 0.93 + 1 / (3.5 + mach ** 5)
    assert re > 45
    return 24 * (1 + 0.15 * re ** 0.687) * h + 0.42 * c * re / (1 + 42500 / re ** (1.16 * c) + g / re ** 0.5)


def field(path):
    """A field of the cells as an array; one value if it is uniform."""
    return numpy.array(dictionaries.internal(path))


def field_sum(path):
    """Sum of a field of the cells without boundary."""
    text = path.read_text()
    body = text[text.index("value"):]
    if "nonuniform" not in body[:40]:
        return 0.0
    return sum(float(line) for line in body.split("(", 1)[1].split(")")[0].split())


class GasCase(box.CoupledCase):
    """A test that runs the box of gas."""

    def run_gas(self, ranks=0, steps=20, grains=None, solver="rhoPimpleFoam", options=None, boundary="p p p",
                diameter=2e-4, density=2500.0, ranks_in_case=2, processors="", into=None, dem_step=1e-5, interval=10,
                box_of_grains="0 0.02 0 0.02 0 0.04", check=True, dump_every=None, columns=box.MOTION, fixes="", plugins="",
                prepare=None, **fluid):
        """As run_box of CoupledCase. prepare(folder) changes the case that is written."""
        folder = into or self.new_folder()
        write(folder, steps=steps, ranks=ranks_in_case, solver=solver, **fluid)
        if options is not False:
            x, v = grains or box.swarm(300, 7)
            box.script(folder, grains=box.grains(x, v, diameter, density), boundary=boundary, box=box_of_grains,
                       dt=dem_step, processors=processors, fixes=fixes, plugins=plugins,
                       end=scripts.dump(dump_every or interval * steps, "grains.dump", columns))
            box.fv_options(folder, **{"fluid": "compressible", "couplingInterval": str(interval), **(options or {})})
        if prepare:
            prepare(folder)
        self.foam("blockMesh", folder)
        if ranks:
            self.foam("decomposePar", folder)
        self.result = self.foam(solver, folder, ranks, check=check)
        if ranks:
            self.foam("reconstructPar", folder)
        return folder


def kinetic(path, step=-1, diameter=2e-4, density=2500.0):
    """Kinetic energy of the translation of the grains of a dump in J, and their momentum in N s."""
    rows = numpy.array([row[3:6] for row in dumps.frames(path)[step].by_id().values()])
    mass = density * numpy.pi / 6 * diameter ** 3
    return 0.5 * mass * (rows ** 2).sum(), mass * rows.sum(0)
