#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers of Weaver & Miskovic, Fluids 8 (2023) 215, worked out from its own formulas: the tables of
docs/errata.md."""

import math

RHO = 1.2                           # air; the paper does not state it

# Tables 1 and 4: name, d, rho, nu, U, D, Re, printed St, DEM step, printed % Rayleigh and % Hertz
CASES = (
    ("Hardalupas1, 2", 80e-6, 2950, 0.30, 13, 0.015, 13000, 50, 1e-6, 5.9, 5.3),
    ("Hardalupas3, 4", 40e-6, 2420, 0.30, 13, 0.015, 13000, 10.27, 5e-7, 6.6, 5.7),
    ("Lau1", 40e-6, 1200, 0.37, 12, 0.0127, 10000, 5.6, 5e-7, 9.2, 7.6),
    ("Lau2", 40e-6, 1200, 0.37, 24, 0.0127, 20000, 11.2, 2.5e-7, 4.6, 4.3),
    ("Lau3", 40e-6, 1200, 0.37, 48, 0.0127, 40000, 22.4, 1.25e-7, 2.3, 2.5),
)

# Table 7: ratios at CG0 and CG2, printed error
TABLE_7 = (("Col. freq.", 1.22, 1.25, 2.39), ("Fn mean", 0.70, 0.68, 3.10), ("Fn var.", 0.64, 0.62, 3.78),
           ("Fn skew", 1.38, 1.42, 3.56), ("Ft mean", 0.73, 0.75, 3.81), ("Ft var.", 0.56, 0.55, 1.04),
           ("Ft skew", 1.12, 1.10, 1.23))

# Table 5: U at 0.1D, 10D, 20D, rms at the same
TABLE_5 = (("Hardalupas1", 50, (.071, .090, .178), (.023, .029, .063)),
           ("Hardalupas2", 50, (.054, .036, .301), (.013, .012, .050)),
           ("Hardalupas3", 10.27, (.056, .110, .074), (.051, .123, .239)),
           ("Hardalupas4", 10.27, (.096, .129, .055), (.006, .070, .247)))


def rayleigh(d, rho, E, nu):
    return math.pi*d/2*math.sqrt(rho*2*(1 + nu)/E)/(0.1631*nu + 0.8766)


def hertz_speed(d, rho, E, nu, time):
    """Relative speed at which stock LIGGGHTS' Hertz time is the given one: two equal spheres, the whole
    mass for m*."""
    m = rho*math.pi/6*d**3
    return m**2/(d/4*(E/2/(1 - nu**2))**2)*(2.87/time)**5


def table_4():
    print("case             printed   % Rayleigh by E, nu                  printed   speed/U from % Hertz")
    print("               % Rayleigh  5e5      5e6      1e7      5e5, .245  % Hertz   E = 5e5   E = 5e6")
    for name, d, rho, nu, U, _, _, _, dt, percent_rayleigh, percent_hertz in CASES:
        row = [100*dt/rayleigh(d, rho, E, nu) for E in (5e5, 5e6, 1e7)]
        other = f"{100*dt/rayleigh(d, rho, 5e5, 0.245):.2f}" if name[0] == "H" else ""
        speeds = [hertz_speed(d, rho, E, nu, 100*dt/percent_hertz)/U for E in (5e5, 5e6)]
        print(f"{name:15s}{percent_rayleigh:7.1f}" + "".join(f"{x:9.2f}" for x in row) + f"{other:>11s}"
              f"{percent_hertz:11.1f}{speeds[0]:10.2f}{speeds[1]:10.3f}")


def table_1():
    print("\ncase             nu = U D/Re   St = rho_p d^2 U/(18 rho nu D)   printed   Re_p at slip 1.22 U")
    for name, d, rho, _, U, D, Re, St, *_ in CASES:
        nu = U*D/Re
        print(f"{name:15s}{nu:13.3e}{rho*d**2*U/(18*RHO*nu*D):18.2f}{St:24.2f}{1.2245*U*d/nu:17.0f}")


def table_7():
    print("\nTable 7       CG0    CG2   error %   possible, given the rounding   printed")
    for name, a, b, printed in TABLE_7:
        h = 0.005
        edges = [100*abs(x - y)/x for x in (a - h, a + h) for y in (b - h, b + h)]
        low = 0 if abs(a - b) <= 2*h + 1e-12 else min(edges)
        inside = "inside" if low <= printed <= max(edges) else "OUTSIDE"
        print(f"{name:12s}{a:6.2f}{b:7.2f}{100*abs(a - b)/a:9.2f}{low:13.2f} to {max(edges):.2f}"
              f"{printed:20.2f} {inside}")


def table_5():
    print("\nTable 5       St      mean of the three: U      rms")
    for name, St, U, rms in TABLE_5:
        print(f"{name:12s}{St:6g}{sum(U)/3:23.3f}{sum(rms)/3:12.3f}")


def formulas():
    n = 7
    print(f"\n(23), n = 7, umax/umean: printed middle form {(1/n - 1)*(1/n + 2)/2:.3f}, with (1/n + 1) "
          f"{(1/n + 1)*(1/n + 2)/2:.3f}, last form {(n + 1)*(2*n + 1)/(2*n**2):.3f}")
    print(f"(24), Re = 13000: x/D = {0.636*13000**0.25:.2f}")
    for E in (5e6, 5e5):
        print(f"longer time step by softening 6.89e10 Pa to {E:.0e} Pa: x {math.sqrt(6.89e10/E):.0f}")


if __name__ == "__main__":
    table_4()
    table_1()
    table_7()
    table_5()
    formulas()
