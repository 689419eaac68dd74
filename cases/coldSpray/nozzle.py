# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The nozzle of the cold spray case and the one-dimensional isentropic flow in it."""

import math

R_GAS = 8314.46                 # J/(kmol K)


class Nozzle:
    """p: the numbers of system/parameters. Lengths in m along the axis from the throat."""

    def __init__(self, p):
        self.p = p
        self.inlet, self.throat, self.exit = (0.5*p[f"{name}Diameter"] for name in ("inlet", "throat", "exit"))
        if not self.inlet > self.throat < self.exit:
            raise ValueError("system/parameters: throatDiameter must be smaller than inletDiameter and exitDiameter")
        self.begin, self.end = -p["contraction"] - p["inletLength"], p["divergence"]
        self.plate = self.end + p["standOff"]
        self.R = R_GAS/p["molWeight"]
        self.gamma = p["Cp"]/(p["Cp"] - self.R)

    def radius(self, x):
        """Of the contour."""
        if x >= 0:
            return self.throat + (self.exit - self.throat)*min(x/self.end, 1)
        s = min(-x/self.p["contraction"], 1)
        return self.throat + (self.inlet - self.throat)*0.5*(1 - math.cos(math.pi*s))

    def area_ratio(self, M):
        """Area over that of the throat, isentropic flow of one dimension (Anderson, Modern Compressible Flow, Eq. 5.20)."""
        g = self.gamma
        return (2/(g + 1)*(1 + 0.5*(g - 1)*M*M))**(0.5*(g + 1)/(g - 1))/M

    def mach(self, ratio, supersonic):
        """Mach number where the area is `ratio` times that of the throat."""
        low, high = (1.0, 50.0) if supersonic else (1e-6, 1.0)
        for _ in range(200):
            M = 0.5*(low + high)
            if (self.area_ratio(M) < ratio) == supersonic:
                low = M
            else:
                high = M
        return 0.5*(low + high)

    def state(self, M):
        """{M, p, T, U, rho} of gas from the stagnation state at a Mach number."""
        factor = 1 + 0.5*(self.gamma - 1)*M*M
        T = self.p["TStagnation"]/factor
        p = self.p["pStagnation"]*factor**(-self.gamma/(self.gamma - 1))
        return {"M": M, "p": p, "T": T, "U": M*math.sqrt(self.gamma*self.R*T), "rho": p/(self.R*T)}

    def at(self, x):
        """The state at a place in the nozzle."""
        return self.state(self.mach((self.radius(x)/self.throat)**2, x > 0))

    def viscosity(self, T):
        """Sutherland's law [Pa s]."""
        return self.p["As"]*math.sqrt(T)/(1 + self.p["Ts"]/T)
