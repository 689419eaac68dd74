# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The box of gas_box with grains that have a temperature."""

import math

import gas_box
from grainjet import coupled_box as box, dumps

COLUMNS = box.MOTION + " f_Temp"

# W/(m K) of a gas of the box with this viscosity and Prandtl number
def conductivity(mu, prandtl):
    return mu * (gas_box.CV + gas_box.R) / prandtl


def fixes(specific_heat, temperature, group="all"):
    """Commands of the script that give grains a temperature in K, and let those of a group exchange heat."""
    return (f"fix capacity all property/global thermalCapacity peratomtype {specific_heat!r}\n"
            f"fix heat {group} fluid/heat coupled temperature {temperature!r}\n")


def forces(heat="model RanzMarshall;", drag="model Gidaspow;", others="pressureGradient {} viscous {}"):
    """Entries of the coupling: the model heat among the others."""
    return {"drag": None, "forces": f"{{ drag {{ {drag} }} {others} heat {{ {heat} }} }}"}


def ranz_marshall(re, prandtl):
    return 2 + 0.6 * re ** 0.5 * prandtl ** (1 / 3)


class HeatCase(gas_box.GasCase):
    """A test that runs the box of gas with warm grains."""

    def run_warm(self, *, specific_heat=800.0, temperature=400.0, plugins="", before="", group="all", more_fixes="",
                 options=None, **case):
        """As run_gas. before: commands before the fixes of heat, more_fixes: behind them."""
        return self.run_gas(fixes=before + fixes(specific_heat, temperature, group) + more_fixes, plugins="plugin load fluidheatplugin.so\n" + plugins,
                            columns=COLUMNS, options={**forces(), **(options or {})}, **case)


def temperatures(path, frame=-1):
    """{id: K} of a frame of a dump."""
    return {tag: row[-1] for tag, row in dumps.frames(path)[frame].by_id().items()}


def mass(diameter=2e-4, density=2500.0):
    return density * math.pi / 6 * diameter ** 3
