# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Single impacts in LIGGGHTS with `fix hertz/cg`: many in one run, far from each other.

A ball moves along x (normal) and y (tangential) and turns about z. It meets an equal free ball, or a
target: an immovable ball so large that it is a plane for it.
"""

import dataclasses
import math

from grainjet import dumps, programs, scripts

LARGE = 300.0     # radius of a target over that of the ball


@dataclasses.dataclass
class Material:
    youngs: float
    poisson: float
    restitution: float
    friction: float
    rigid: bool = False       # the other body: same material, or rigid,
    other: tuple = None       # or this Young's modulus and Poisson's ratio


@dataclasses.dataclass
class Ball:
    radius: float
    density: float

    @property
    def mass(self):
        return 4.0 / 3.0 * math.pi * self.radius ** 3 * self.density


@dataclasses.dataclass
class Impact:
    """State before: normal speed (> 0 towards the other), tangential speed, spin."""
    normal: float
    tangential: float = 0.0
    spin: float = 0.0


@dataclasses.dataclass
class Result:
    """State of the ball after: normal speed (> 0 away from the other), tangential speed, spin."""
    normal: float
    tangential: float
    spin: float


def effective_youngs(m):
    youngs, poisson = m.other or (m.youngs, m.poisson)
    other = 0.0 if m.rigid else (1 - poisson ** 2) / youngs
    return 1.0 / ((1 - m.poisson ** 2) / m.youngs + other)


def effective(ball, plane):
    """Effective radius and mass."""
    return (ball.radius / (1 + 1 / LARGE), ball.mass) if plane else (ball.radius / 2, ball.mass / 2)


def hertz(material, ball, speed, plane):
    """Largest overlap, peak force, duration of an elastic head-on impact at relative speed."""
    radius, mass = effective(ball, plane)
    youngs = effective_youngs(material)
    overlap = (15 * mass * speed ** 2 / (16 * math.sqrt(radius) * youngs)) ** 0.4
    force = 4 / 3 * youngs * math.sqrt(radius) * overlap ** 1.5
    return overlap, force, 2.9432750643 * overlap / speed


def script(folder, material, ball, impacts, plane, factor, dt, steps, extra):
    other_radius = LARGE * ball.radius if plane else ball.radius
    gap = 1e-5 * ball.radius
    spacing = 2.5 * (ball.radius + other_radius)
    width = 2.2 * other_radius + 4 * ball.radius
    share = 1.0 if plane else 0.5      # free balls share the relative motion
    grains = []
    for n, impact in enumerate(impacts):
        x = (n + 0.5) * spacing
        reach = ball.radius + other_radius + gap
        grains.append((1, 2 * ball.radius, ball.density, (x, 0, 0),
                       (share * impact.normal, share * impact.tangential, 0), (0, 0, impact.spin)))
        grains.append((2, 2 * other_radius, ball.density, (x + reach, 0, 0))
                      + (() if plane else ((-share * impact.normal, -share * impact.tangential, 0), (0, 0, impact.spin))))
    (folder / "data").write_text(scripts.data(
        grains, ((0, len(impacts) * spacing), (-width, width), (-width, width)), types=2))
    other, other_poisson = material.other or (material.youngs, material.poisson)
    if material.rigid:
        other = 1e6 * material.youngs
    e, mu = material.restitution, material.friction
    return f"""plugin load hertzcgplugin.so
coarsegraining {factor}
atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
units si
read_data data
fix m1 all property/global youngsModulus peratomtype {material.youngs!r} {other!r}
fix m2 all property/global poissonsRatio peratomtype {material.poisson} {other_poisson}
fix m3 all property/global coefficientRestitution peratomtypepair 2 {e} {e} {e} {e}
fix m4 all property/global coefficientFriction peratomtypepair 2 {mu} {mu} {mu} {mu}
fix c all hertz/cg
fix i all nve/sphere
{'group target type 2' if plane else ''}
{'fix z target freeze' if plane else ''}
timestep {dt!r}
{extra}
{scripts.dump(steps, "after", "id vx vy omegaz")}
run {steps}
"""


def run(folder, material, ball, impacts, plane=False, factor=1, per_contact=2000, extra=""):
    """Results in the order of the impacts. per_contact: steps in the shortest contact."""
    fastest = max(i.normal for i in impacts)
    slowest = min(i.normal for i in impacts)
    dt = hertz(material, ball, fastest, plane)[2] / per_contact
    longest = hertz(material, ball, slowest, plane)[2]
    steps = int((3.0 * longest + 2e-5 * ball.radius / slowest) / dt)
    (folder / "in.impacts").write_text(
        script(folder, material, ball, impacts, plane, factor, dt, steps, extra))
    done = programs.run(["liggghts-plugins", "-in", "in.impacts"], folder)
    assert done.code == 0, done
    after = dumps.last(folder / "after")
    share = 1.0 if plane else 2.0
    results = []
    for n in range(len(impacts)):
        vx, vy, spin = after[2 * n + 1]
        results.append(Result(-share * vx, share * vy, spin))
    return results
