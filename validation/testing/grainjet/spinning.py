# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a particle that turns feels in a fluid, from the formulas as printed, and its path. References of tests:
written apart from the library's headers."""

import dataclasses
import math

import numpy

A, B = 128.4 / (64 * math.pi), 12.9 / (64 * math.pi)    # of the torque's factor


def torque_factor(spin_re):
    """Dennis, Singh & Ingham (1980) above Re 32, Rubinow & Keller (1961) below."""
    return max(1.0, A + B * math.sqrt(spin_re))


def magnus_factor(re, spin_re):
    """The smaller of Oesterle & Bui Dinh (1998) and Lun & Liu (1997), over Rubinow & Keller (1961)."""
    if re == 0 or spin_re == 0:
        return 1.0
    ratio = spin_re / re
    bounded = (0.45 + (ratio - 0.45) * math.exp(-0.05684 * spin_re ** 0.4 * re ** 0.3)) / ratio
    return min(bounded, 1.0 if re < 1 else 0.178 + 0.822 * re ** -0.522)


def saffman_factor(re, shear_re):
    """Mei (1992), over Saffman (1965)."""
    if re == 0:
        return 1.0
    beta = shear_re / (2 * re)
    alpha = 0.3314 * math.sqrt(beta)
    return (1 - alpha) * math.exp(-0.1 * re) + alpha if re < 40 else 0.0524 * math.sqrt(beta * re)


def stokes(re):
    return 1.0


def schiller_naumann(re):
    """Cd Re/24."""
    return 1 + 0.15 * re ** 0.687 if re < 1000 else 0.44 * re / 24


@dataclasses.dataclass
class Particle:
    """A sphere in a fluid; kg, m, s."""
    diameter: float
    density: float
    rho: float = 1.2          # of the fluid
    nu: float = 1.5e-5

    @property
    def tau(self):
        return self.density * self.diameter ** 2 / (18 * self.rho * self.nu)

    @property
    def tau_spin(self):
        return self.density * self.diameter ** 2 / (60 * self.rho * self.nu)

    def spin(self, spin_re):
        """Angular velocity of a spin Reynolds number |w| d^2/nu."""
        return spin_re * self.nu / self.diameter ** 2

    def decayed(self, spin, time):
        """What is left of a fast spin (Re above 32) after a time: the closed form."""
        y = math.sqrt(spin * self.diameter ** 2 / self.nu)
        e = math.exp(-A * time / self.tau_spin / 2)
        return self.spin((A * y * e / (A + B * y * (1 - e))) ** 2)

    def saffman(self, slip, curl):
        """Force in N."""
        w = math.sqrt(curl @ curl)
        if w == 0:
            return 0 * slip
        d, nu = self.diameter, self.nu
        g = saffman_factor(math.sqrt(slip @ slip) * d / nu, w * d ** 2 / nu)
        return 1.615 * self.rho * d ** 2 * math.sqrt(nu / w) * g * numpy.cross(slip, curl)

    def magnus(self, slip, relative_spin):
        """Force in N."""
        d, nu = self.diameter, self.nu
        c = magnus_factor(math.sqrt(slip @ slip) * d / nu, math.sqrt(relative_spin @ relative_spin) * d ** 2 / nu)
        return math.pi / 8 * self.rho * d ** 3 * c * numpy.cross(relative_spin, slip)

    def path(self, wind, position, velocity, spin, end, n=5000, curl=(0, 0, 0), gravity=(0, 0, 0), drag=stokes,
             saffman=False, magnus=False, torque=False):
        """Position, velocity and spin after a time, by Runge-Kutta. wind: velocity of the fluid at a position."""
        curl, gravity = numpy.array(curl, dtype=float), numpy.array(gravity, dtype=float)
        mass = self.density * math.pi / 6 * self.diameter ** 3

        def slope(y):
            x, v, w = y.reshape(3, 3)
            s = numpy.asarray(wind(x)) - v
            a = drag(math.sqrt(s @ s) * self.diameter / self.nu) / self.tau * s + gravity
            relative = 0.5 * curl - w
            if saffman:
                a = a + self.saffman(s, curl) / mass
            if magnus:
                a = a + self.magnus(s, relative) / mass
            turn = 0 * w
            if torque:
                f = torque_factor(math.sqrt(relative @ relative) * self.diameter ** 2 / self.nu)
                turn = f / self.tau_spin * relative
            return numpy.concatenate([v, a, turn])

        y, h = numpy.concatenate([position, velocity, spin]).astype(float), end / n
        for _ in range(n):
            k1 = slope(y)
            k2 = slope(y + h / 2 * k1)
            k3 = slope(y + h / 2 * k2)
            k4 = slope(y + h * k3)
            y = y + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        return y.reshape(3, 3)
