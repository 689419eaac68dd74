# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Flight of one sphere along the axis of a gas that does not change with time, written down once more from the papers, so that
it can judge the coupled run."""

import math

import numpy


def loth(re, M, gamma):
    """Drag coefficient of Loth, Daspit, Jeong, Nagata & Nonomura, AIAA J. 59 (2021) 3261."""
    low = 24/re*(1 + 0.15*re**0.687)
    if re <= 45:
        kn = math.sqrt(0.5*math.pi*gamma)*M/re
        c1 = low/(1 + kn*(2.514 + 0.8*math.exp(-0.55/kn)))
        s = M*math.sqrt(0.5*gamma)
        free = ((1 + 2*s*s)*math.exp(-s*s)/(s**3*math.sqrt(math.pi)) + (4*s**4 + 4*s*s - 1)*math.erf(s)/(2*s**4)
                + 2*math.sqrt(math.pi)/(3*s))
        J = 2.26 - 0.1/M + 0.14/M**3 if M <= 1 else 1.6 + 0.25/M + 0.11/M**2 + 0.44/M**3
        c2 = free/(1 + (free/J - 1)*math.sqrt(re/45))
        return (c1 + M**4*c2)/(1 + M**4)
    C = 1.65 + 0.65*math.tanh(4*M - 3.4) if M < 1.5 else 2.18 - 0.13*math.tanh(0.9*M - 2.7)
    G = 166*M**3 + 3.29*M**2 - 10.9*M + 20 if M < 0.8 else 5 + 40/M**3
    H = 0.0239*M**3 + 0.212*M**2 - 0.074*M + 1 if M < 1 else 0.93 + 1/(3.5 + M**5)
    return low*H + 0.42*C/(1 + 42500/re**(1.16*C) + G/math.sqrt(re))


class Axis:
    """Gas on the axis: x [m], U [m/s], p [Pa], T [K], in the order of x; n: the nozzle, which knows the gas."""

    def __init__(self, x, U, p, T, n):
        self.x, self.values, self.n = x, (U, p, T, numpy.gradient(p, x)), n

    def at(self, x):
        """(U, p, T, dp/dx)"""
        return [float(numpy.interp(x, self.x, v)) for v in self.values]


def rates(gas, d, density, capacity, x, v, T):
    """(dv/dt, dT/dt) of a sphere at x with velocity v and temperature T."""
    n = gas.n
    U, p, Tg, slope = gas.at(x)
    rho, mu = p/(n.R*Tg), n.viscosity(Tg)
    slip = abs(U - v) + 1e-12
    re, M = rho*slip*d/mu, slip/math.sqrt(n.gamma*n.R*Tg)
    # drag, and the force by the pressure gradient
    a = 0.75*loth(re, max(M, 1e-9), n.gamma)*rho*slip/(d*density)*(U - v) - slope/density
    # Ranz & Marshall, Chem. Eng. Prog. 48 (1952) 141; recovery factor of a laminar boundary layer; conductivity as OpenFOAM's
    # transport model has it (modified Eucken formula)
    cp = n.p["Cp"]
    cv = cp - n.R
    conductivity = mu*cv*(1.32 + 1.77*n.R/cv)
    prandtl = mu*cp/conductivity
    recovery = Tg + math.sqrt(prandtl)*slip**2/(2*cp)
    nusselt = 2 + 0.6*math.sqrt(re)*prandtl**(1/3)
    return a, 6*nusselt*conductivity/(density*capacity*d*d)*(recovery - T)


def fly(gas, d, density, capacity, x, v, T, end, step=1e-7):
    """Classical Runge-Kutta steps from x to end; arrays of x, v, T, t."""
    ways, t = [(x, v, T, 0.0)], 0.0
    while x < end and v > 0:
        a1, q1 = rates(gas, d, density, capacity, x, v, T)
        a2, q2 = rates(gas, d, density, capacity, x + 0.5*step*v, v + 0.5*step*a1, T + 0.5*step*q1)
        a3, q3 = rates(gas, d, density, capacity, x + 0.5*step*(v + 0.5*step*a1), v + 0.5*step*a2, T + 0.5*step*q2)
        a4, q4 = rates(gas, d, density, capacity, x + step*(v + 0.5*step*a2), v + step*a3, T + step*q3)
        x, v, T = (x + step*(v + step/6*(a1 + a2 + a3)), v + step/6*(a1 + 2*a2 + 2*a3 + a4), T + step/6*(q1 + 2*q2 + 2*q3 + q4))
        t += step
        ways.append((x, v, T, t))
    return numpy.array(ways).T
