# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pressure drop of a bed by the drag laws, and the velocity at which it carries the bed's weight.

U is the flux of the fluid through the grains, relative to them: the superficial velocity in a bed at rest. With zero flux of
the mixture, as when a suspension settles in a closed vessel, the grains fall at just this velocity."""

G = 9.81    # m/s2


def ergun(e, d, U, rho, mu):
    """- dp/dz [Pa/m], Ergun, Chem. Eng. Prog. 48 (1952) 89."""
    a = 1 - e
    return (150*mu*a**2*U/d**2 + 1.75*rho*a*U**2/d)/e**3


def wen_yu(e, d, U, rho, mu):
    """The same of the law of Wen and Yu, as Weaver and Miskovic, Fluids 8 (2023) 215, Eqs. (18) to (20)."""
    re = rho*d*U/mu
    cd_re = 24*(1 + 0.15*re**0.687) if re < 1000 else 0.44*re
    return 0.75*cd_re*mu*(1 - e)*U/d**2*e**-4.65


def gidaspow(e, d, U, rho, mu):
    """Ergun below a void fraction of 0.8, Wen and Yu above."""
    return (ergun if e < 0.8 else wen_yu)(e, d, U, rho, mu)


def carrying(drop, weight, high=100.0):
    """U at which drop(U) is the weight; drop grows with U."""
    low = 0.0
    for _ in range(200):
        middle = 0.5*(low + high)
        low, high = (middle, high) if drop(middle) < weight else (low, middle)
    return low
