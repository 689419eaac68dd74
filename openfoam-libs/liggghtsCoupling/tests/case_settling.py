# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""One grain falls through fluid at rest: terminal velocity and the way to it."""

import unittest

import grainjet
from grainjet import coupled_box as box, dumps, scripts

RHO, NU, G = 1.2, 1.5e-5, 9.81
D, RHO_P = 6e-5, 2500.0


def acceleration(w):
    """Downward acceleration of a sphere falling at w: weight less buoyancy less Wen-Yu drag at
    void fraction 1 (Weaver and Miskovic 2023, Eqs. 18 to 20)."""
    re = w * D / NU
    drag = 18 * RHO * NU / D ** 2 * (1 + 0.15 * re ** 0.687) * w
    return G * (1 - RHO / RHO_P) - drag / RHO_P


def velocity(t_end, n=20000):
    """Velocity after t_end from rest, by a fourth-order Runge-Kutta integration."""
    w, h = 0.0, t_end / n
    for _ in range(n):
        k1 = acceleration(w)
        k2 = acceleration(w + h / 2 * k1)
        k3 = acceleration(w + h / 2 * k2)
        k4 = acceleration(w + h * k3)
        w += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    return w


class Settling(grainjet.Case):

    def fall(self, steps, f_cg=1, gravity="fix g all gravity 9.81 vector 0 0 -1", **move):
        folder = self.folder / f"{steps}-{f_cg}-{len(move)}"
        box.write(folder, walls=False, steps=steps, delta_t=2e-4, cells="4 4 8")
        box.script(folder, dt=2e-5,
                   plugins=f"plugin load hertzcgplugin.so\ncoarsegraining {f_cg} model_check warn" if f_cg > 1 else "", gravity=gravity, **move,
                   grains=box.grains([(0.012, 0.013, 0.035)], [(0, 0, 0)], D, RHO_P),
                   end=scripts.dump(10 * steps, "grains.dump", "id vz"))
        box.fv_options(folder, coupling="oneWay", forces="(pressureGradient viscous buoyancy)")
        self.foam("blockMesh", folder)
        self.foam("pimpleFoam", folder)
        return -dumps.last(folder / "grains.dump")[1][0]

    def test_velocity(self):
        """One way, so the fluid stays at rest. The drag coefficient is held over a fluid step of
        2e-4 s, 1 % of the relaxation time: first order, 0.3 % on the way, nothing at the end."""
        for steps, tolerance in ((100, 3e-3), (1500, 1e-4)):
            with self.subTest(steps=steps):
                w, exact = self.fall(steps), velocity(steps * 2e-4)
                print(f"\n{steps * 2e-4:.3g} s: {w:.6f} m/s, exact {exact:.6f} m/s")
                self.assertLess(abs(w / exact - 1), tolerance)

    def test_coarse_grain(self):
        """A grain of f_cg = 4 falls like its particles: drag from the original diameter, volume and
        mass of the grain. LIGGGHTS' `set diameter` is told the particle's. The factor enters once, to 1e-3 (Wen-Yu's void fraction differs
        a little, since the grain fills more of its cell)."""
        particle, grain = self.fall(300), self.fall(300, 4)
        print(f"\nparticle {particle:.6f} m/s, grain {grain:.6f} m/s")
        self.assertLess(abs(grain / particle - 1), 1e-3)

    def test_grain_motion(self):
        """fix grain/motion with its own gravity, which buoyancy takes too, and joined steps, of which none is joined
        over the end of a coupling interval: the velocity of stock fixes, but for the order of a sum."""
        motion = "plugin load grainmotionplugin.so\nfix move all grain/motion gravity 9.81 0 0 -1 fluid fluid"
        stock, moved = self.fall(100), self.fall(100, gravity="", move=motion)
        print(f"\nstock {stock!r} m/s, grain/motion {moved!r} m/s")
        self.assertLess(abs(moved / stock - 1), 1e-13)


if __name__ == "__main__":
    unittest.main()
