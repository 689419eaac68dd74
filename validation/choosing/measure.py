#!/usr/bin/python3
# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The small measurements of docs/choosing.md. Prints tables; a minute each, `jet` a quarter of an hour.

    source environment; measure.py <work folder> step|stiffness|collisions|interval|cell|momentum|jet|example ...
"""

import argparse
import math
import pathlib
import random
import re
import shutil
import sys

import numpy

import grainjet
from grainjet import coupled_box as box, dictionaries, dumps, impacts, pages, scripts, tables

RHO, NU = 1.2, 1.5e-5               # air
GLASS = 2950.0


def fresh(folder):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder


def done(command, folder):
    ran = grainjet.run(command, folder, timeout=3000)
    assert ran.code == 0, ran
    return ran.output


def rayleigh(d, rho, E, nu):
    return math.pi*d/2*math.sqrt(2*rho*(1 + nu)/E)/(0.1631*nu + 0.8766)


# --- DEM alone ---------------------------------------------------------------------------------

def step(work):
    """Restitution of a head-on impact of two glass beads, e = 0.926, against the DEM step."""
    E, nu, v, d = 5e6, 0.3, 1.0, 80e-6
    material = impacts.Material(E, nu, 0.926, 0.18)
    ball = impacts.Ball(d/2, GLASS)
    duration = impacts.hertz(material, ball, v, False)[2]
    tR = rayleigh(d, GLASS, E, nu)
    print("\nstep: two beads, 1 m/s, E = 5e6 Pa, e = 0.926")
    print("steps in the contact   % Hertz   % Rayleigh   e out")
    for per_contact in (100, 50, 20, 10, 7, 5, 4, 3):
        # 40 impacts of slightly different speed: contacts begin anywhere within a step
        some = [impacts.Impact(v*(1 + 0.001*n)) for n in range(40)]
        out = impacts.run(fresh(work/"step"), material, ball, some, per_contact=per_contact)
        e = [result.normal/impact.normal for result, impact in zip(out, some)]
        print(f"{per_contact:20d} {100/per_contact:9.1f} {100*duration/per_contact/tR:12.1f}   "
              f"{min(e):.3f} to {max(e):.3f}")


def stiffness(work):
    """Largest overlap of a head-on impact, against 2.78 (rho v^2/E*)."""
    print("\nstiffness: two beads of glass, e = 0.926: overlap/radius, measured and by the formula")
    for E in (5e5, 5e6, 5e7):
        row = [f"E = {E:.0e}:"]
        for v in (0.5, 1, 2, 4):
            material, ball = impacts.Material(E, 0.3, 0.926, 0.18), impacts.Ball(40e-6, GLASS)
            duration = impacts.hertz(material, ball, v, False)[2]
            folder = fresh(work/"stiffness")
            (folder/"in.impact").write_text(impacts.script(
                folder, material, ball, [impacts.Impact(v)], False, 1, duration/200, 150,
                "variable o equal f_c[3]\nfix o all print 1 \"${o}\" file overlap screen no"))
            done(["liggghts-plugins", "-in", "in.impact"], folder)
            seen = max(float(line) for line in (folder/"overlap").read_text().splitlines()[1:])
            formula = (2.777*GLASS*v**2/(E/2/(1 - 0.3**2)))**0.4
            row.append(f"{v:g} m/s {seen:.3f} ({formula:.3f})")
        print("  ".join(row))


def collisions(work):
    """Collisions in a periodic box of beads with random velocities, f_cg 1, 2, 4."""
    d, side, n = 80e-6, 8e-3, 64000
    print(f"\ncollisions: {n} beads of 80 um in a periodic box of 8 mm, 0.5 m/s rms, 1 ms")
    print("f_cg   grains   collisions   per grain   times f_cg   theory per bead")
    rms, time = 0.5, 1e-3
    # kinetic theory, each collision shared by two: 2 n d^2 sqrt(pi) rms per bead and second,
    # and as many again for its partner
    theory = 4*n/side**3*d**2*math.sqrt(math.pi)*rms*time
    for f in (1, 2, 4):
        folder = fresh(work/"collisions")
        (folder/"in.box").write_text(f"""plugin load hertzcgplugin.so
units si
atom_style granular
atom_modify map array
boundary p p p
newton off
communicate single vel yes
region box block 0 {side} 0 {side} 0 {side} units box
create_box 1 box
neighbor 1e-4 bin
neigh_modify delay 0
coarsegraining {f}
fix m1 all property/global youngsModulus peratomtype 5e7
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 1.0
fix m4 all property/global coefficientFriction peratomtypepair 1 0.0
fix c all hertz/cg
timestep {2e-7*f}
fix t all particletemplate/sphere 15485863 atom_type 1 density constant {GLASS} radius constant {d/2} volume_limit 1e-16
fix m all particledistribution/discrete 32452843 1 t 1.0
fix p all insert/pack seed 86028121 distributiontemplate m insert_every once overlapcheck yes all_in no vel gaussian 0 0 0 {rms} {rms} {rms} particles_in_region {n//f**3} region box
fix i all nve/sphere
thermo_style custom step atoms f_c[2]
run 1
variable before equal f_c[2]
variable a equal ${{before}}
run {round(time/(2e-7*f))}
variable b equal f_c[2]
print "COLLISIONS ${{a}} ${{b}}"
""")
        output = done(["liggghts-plugins", "-in", "in.box"], folder)
        a, b = map(float, re.findall(r"^COLLISIONS (\S+) (\S+)", output, re.M)[-1])
        grains = n//f**3
        each = 2*(b - a)/grains
        print(f"{f:4d} {grains:8d} {b - a:12.0f} {each:11.3f} {each*f:12.3f} {theory:17.3f}")


# --- coupled boxes -----------------------------------------------------------------------------
# `set diameter` in box.grains is told the particle's diameter: LIGGGHTS multiplies it by f_cg

def drag_time(d, rho, slip):
    """Response time with Wen-Yu's drag at void fraction 1."""
    re = slip*d/NU
    return rho*d**2/(18*RHO*NU*(1 + 0.15*re**0.687))


def interval(work):
    """A bead slows down in still air: velocity after one response time against the fluid step."""
    d, v0 = 60e-6, 10.0
    tau = drag_time(d, GLASS, 0)
    exact, n = v0, 20000
    for _ in range(n):              # midpoint rule
        half = exact - exact*tau/n/2/drag_time(d, GLASS, exact)
        exact -= half*tau/n/drag_time(d, GLASS, half)
    print(f"\ninterval: bead of 60 um, 10 m/s into still air, tau_p (Stokes) = {tau:.4f} s; "
          f"after tau_p {exact:.4f} m/s")
    print("fluid steps in tau_p   velocity   error %")
    for steps in (100, 50, 20, 10, 5, 2):
        dt = tau/steps
        folder = fresh(work/"interval")
        # a box of 40 m: the bead stays inside, the air at rest
        box.write(folder, steps=steps, delta_t=dt, cells="2 2 4")
        dictionaries.put(folder/"system"/"blockMeshDict", scale=1)
        box.script(folder, dt=dt/10, grains=box.grains([(10, 10, 1)], [(0, 0, v0)], d, GLASS),
                   box="0 20 0 20 0 40", end=scripts.dump(10*steps, "grains.dump", "id vz"))
        dictionaries.change(folder/"constant"/"in.particles",
                            ("neighbor 0.0005 bin", "neighbor 0.5 bin"), ("binsize 0.002", "binsize 2"))
        box.fv_options(folder, coupling="oneWay", forces="()")
        done(["blockMesh"], folder)
        done(["pimpleFoam"], folder)
        v = dumps.last(folder/"grains.dump")[1][0]
        print(f"{steps:20d} {v:10.4f} {100*(v/exact - 1):9.2f}")


def cell(work):
    """One grain falls through still air in a closed box, two-way: how much its own wake in the
    cell makes it too fast, against one-way; without and with selfDisturbance."""
    print("\ncell: one grain of particles of 30 um falls in still air (laminar), 20 ms; box 3 x 3 x 6 mm")
    print("f_cg   cell/grain   cell/particle   fall two-way/one-way - 1, %   selfDisturbance, %   mean solid fraction")
    for f, counts in ((1, (4, 8, 16)), (2, (4, 8, 16)), (4, (4, 8, 12))):
        for n in counts:
            fall = {}
            for way in ("oneWay", "twoWay", "selfDisturbance"):
                folder = fresh(work/"cell")
                box.write(folder, steps=100, delta_t=2e-4, walls=True, cells=f"{n} {n} {2*n}")
                dictionaries.put(folder/"system"/"blockMeshDict", scale=0.00015)
                d = 30e-6
                at = (0.0015, 0.0015, 0.0045)
                box.script(folder, dt=2e-5, gravity="fix g all gravity 9.81 vector 0 0 -1",
                           plugins=f"plugin load hertzcgplugin.so\ncoarsegraining {f} model_check warn",
                           grains=box.grains([at], [(0, 0, 0)], d, 2500.0), boundary="f f f",
                           box="0 0.003 0 0.003 0 0.006",
                           end=scripts.dump(1000, "grains.dump", "id vz"))
                box.fv_options(folder, coupling="oneWay" if way == "oneWay" else "twoWay", forces="()",
                               selfDisturbance="yes" if way == "selfDisturbance" else "no")
                done(["blockMesh"], folder)
                done(["pimpleFoam"], folder)
                fall[way] = dumps.last(folder/"grains.dump")[1][0]
            size = 3e-3/n
            print(f"{f:4d} {size/(f*d):12.1f} {size/d:15.1f} "
                  f"{100*(fall['twoWay']/fall['oneWay'] - 1):31.1f} "
                  f"{100*(fall['selfDisturbance']/fall['oneWay'] - 1):20.1f} {math.pi/6*(f*d/size)**3:21.4f}")


def momentum(work):
    """One grain per cell, all at 1 m/s into still air in a periodic box: the mean slip decays at
    the rate (1 + Z)/tau_p; explicit against implicit."""
    d, f = 50e-6, 8
    D = d*f
    n = 1000                        # 10 x 10 x 10 of the cells of 2 x 2 x 4 mm
    cells = 20*20*40e-9/n
    loading = math.pi/6*D**3*2500/(RHO*cells)
    tau = drag_time(d, 2500.0, 0)
    print(f"\nmomentum: mass loading Z = {loading:.2f}, tau_p = {tau:.4f} s, "
          f"tau_f = tau_p/Z = {tau/loading:.5f} s")
    print("fluid step/tau_f   momentum   mean velocity of grains after 40 tau_f, m/s (exact)")
    x = [(0.002*(i + 0.5), 0.002*(j + 0.5), 0.004*(k + 0.5))
         for i in range(10) for j in range(10) for k in range(10)]
    for ratio in (0.5, 1, 1.5, 2, 4, 8):
        for way in ("explicit", "implicit"):
            dt = float(f"{ratio*tau/loading:.3g}")
            steps = round(40/ratio)
            folder = fresh(work/"momentum")
            box.write(folder, steps=steps, delta_t=dt, cells="10 10 10")
            box.script(folder, dt=dt/10, grains=box.grains(x, [(0, 0, 1)]*n, d, 2500.0),
                       plugins=f"plugin load hertzcgplugin.so\ncoarsegraining {f} model_check warn",
                       end=scripts.dump(10*steps, "grains.dump", "id vz"))
            box.fv_options(folder, momentum=way, forces="()", voidFraction="{ model centre; minimum 0.3; }")
            done(["blockMesh"], folder)
            ran = grainjet.run(["pimpleFoam"], folder)
            rows = list(dumps.last(folder/"grains.dump").values()) if ran.code == 0 else []
            result = f"{numpy.mean(rows):12.4f}" if len(rows) == n else "    diverged"
            print(f"{ratio:16.1f}   {way}   {result} ({loading/(1 + loading):.4f})")


# --- the jet of the tutorial -------------------------------------------------------------------

def variant(start, folder, f, fluid_step, dem_step, end):
    """The tutorial's jet as it is before its step 7, with another factor and other steps."""
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(start, folder)
    for name, changes in (
            ("constant/in.grains", ((r"^timestep .*", f"timestep {dem_step!r}"),
                                    (r"^coarsegraining .*", f"coarsegraining {f}"),
                                    (r"insert_every \d+", f"insert_every {round(2e-4/dem_step)}"))),
            ("constant/fvOptions", ((r"couplingInterval .*;", f"couplingInterval {round(fluid_step/dem_step)};"),)),
            ("system/controlDict", ((r"^deltaT .*", f"deltaT {fluid_step};"), (r"^endTime .*", f"endTime {end};"),
                                    (r"^writeInterval .*", f"writeInterval {end};")))):
        path = folder/name
        text = path.read_text()
        for pattern, new in changes:
            text, found = re.subn(pattern, new, text, flags=re.M)
            assert found == 1, pattern
        path.write_text(text)
    (folder/"log.pimpleFoam").write_text(done(["pimpleFoam"], folder))
    return folder


def seen(folder):
    """What planes and balance say: lines to print, and the table at 5D."""
    balance = tables.history(folder/"postProcessing"/"liggghtsCoupling", "balance")
    words = []
    for plane in (5, 10):
        t = tables.read(folder/"postProcessing"/"profiles"/"0"/f"plane_{plane}D.dat")
        n, u, s = (t[c] for c in ("crossings", "flux_weighted_mean_axial", "flux_weighted_rms_axial"))
        inner = (t["r_outer/D"] < 0.31) & (n > 0)
        mean = (n*u)[inner].sum()/n[inner].sum()
        rms = math.sqrt((n*(s**2 + u**2))[inner].sum()/n[inner].sum() - mean**2)
        area = (t["r_outer/D"]**2 - t["r_inner/D"]**2)[inner]
        flux = (t["number_flux"][inner]*area).sum()/area.sum()
        N = n[inner].sum()
        words.append(f"{plane}D: U {mean:.3f} +- {rms/math.sqrt(N):.3f} rms {rms:.3f} +- {rms/math.sqrt(2*N):.3f} "
                     f"flux {flux/1e9:.3f} +- {flux/1e9/math.sqrt(N):.3f}e9")
    seconds = [balance[f"seconds{part}"].sum() for part in ("Fluid", "DEM", "Coupling")]
    words.append("seconds fluid/DEM/coupling " + "/".join(f"{s:.0f}" for s in seconds))
    words.append(f"Courant {tables.courant(folder):.2f} max solid fraction {balance['maxSolidFraction'].max():.4f}"
                 f" Rayleigh {balance['percentRayleigh'].max():.1f} %")
    return words


def statistics(folder):
    """Standard errors of the batch means over those of independent crossings, by ring."""
    ratios = {"mean": [], "flux": []}
    for plane in (1, 5, 10):
        t = tables.read(folder/"postProcessing"/"profiles"/"0"/f"plane_{plane}D.dat")
        good = t["crossings"] >= 200
        n = t["crossings"][good]
        ratios["mean"] += list(t["stderr_flux_weighted_mean_axial"][good]*numpy.sqrt(n)/t["flux_weighted_rms_axial"][good])
        ratios["flux"] += list(t["stderr_number_flux"][good]*numpy.sqrt(n)/t["number_flux"][good])
    for name, values in ratios.items():
        print(f"  standard error of the {name} over that of independent crossings: "
              f"{numpy.mean(values):.2f} +- {numpy.std(values)/math.sqrt(len(values)):.2f} ({len(values)} rings)")


def jet(work):
    """Coarse-graining factor and fluid step in the jet of docs/tutorial.md."""
    page = (grainjet.ROOT/"docs"/"tutorial.md").read_text()
    start = pages.follow(page[:page.index("## 7. Run")], fresh(work/"jet"))
    end = 0.08
    print(f"\njet: the tutorial's jet, sampled from 0.02 to {end} s, rings up to r = 0.3 D joined")
    for f, fluid_step, dem_step in ((1, 1e-4, 1e-6), (2, 1e-4, 2e-6), (4, 1e-4, 4e-6), (8, 1e-4, 5e-6),
                                    (2, 5e-5, 2e-6), (2, 4e-4, 2e-6)):
        folder = variant(start, work/"jet"/f"f{f}-{fluid_step}", f, fluid_step, dem_step, end)
        print(f"f_cg {f} fluid step {fluid_step:g} s DEM step {dem_step:g} s")
        for words in seen(folder):
            print("   " + words)
        sys.stdout.flush()
    print("statistics, f_cg 1")
    statistics(work/"jet"/"f1-0.0001")
    print("statistics, f_cg 2")
    statistics(work/"jet"/"f2-0.0001")


def example(work):
    """The worked example of the page: Hardalupas1 by the rules."""
    d, rho, loading, U, D, E, nu = 80e-6, 2950, 0.23, 13, 0.015, 5e5, 0.3
    side = 357e-6                       # smallest of the paper's mesh
    bead = rho*math.pi/6*d**3
    rate = loading*RHO*U*math.pi/4*D**2/bead
    n = loading*RHO/bead                # per m3, beads as fast as the air
    umax = 1.2245*U
    tau = drag_time(d, rho, 1.0)
    fluid_step = 0.45*side/umax
    print(f"\nexample: Hardalupas1, {rate:.3g} beads/s, {n:.2g} per m3, solid fraction {n*bead/rho:.1e}, tau_p {tau:.3f} s "
          f"at a slip of 1 m/s, fluid step for Courant 0.45: {fluid_step:.2e} s")
    print("f_cg  grains/s  in 65 D of 12 m/s  f d/D %  lost area %  side/(f d)  t_R s     20 % of t_R  interval for "
          "that  free path mm  bead in 45 D meets others")
    for f in (1, 2, 4):
        tR = f*rayleigh(d, rho, E, nu)
        meetings = 4*n*d**2*math.sqrt(math.pi)*0.7/f        # rms 0.7 m/s
        path = f/(math.sqrt(2)*math.pi*n*d**2)
        print(f"{f:4d}{rate/f**3:10.0f}{rate/f**3*65*D/12:19.0f}{100*f*d/D:9.2f}"
              f"{100*(1 - (1 - f*d/D)**2):13.1f}{side/(f*d):12.2f}{tR:11.2e}{0.2*tR:11.2e}"
              f"{fluid_step/(0.2*tR):18.1f}{1e3*path:14.0f}{meetings*45*D/12:16.2f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("work", type=pathlib.Path)
    measurements = {m.__name__: m for m in (step, stiffness, collisions, interval, cell, momentum, jet, example)}
    parser.add_argument("which", nargs="+", choices=measurements)
    args = parser.parse_args()
    random.seed(1)
    for name in args.which:
        measurements[name](args.work.resolve())


if __name__ == "__main__":
    main()
