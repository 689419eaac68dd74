# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of pipes (pipes.toml): the numbers of a run, stated and derived."""

import math
import pathlib
import re
import sys

import grainjet

sys.path.insert(0, str(grainjet.ROOT/"cases/common"))
import table as jets                           # noqa: E402  size classes, Rayleigh time, TOML, as the jets have them

PATH = pathlib.Path(__file__).resolve().parent/"pipes.toml"


class PipeError(Exception):
    """Wrong input, in one sentence."""


def version():
    """Of the libraries that run: a coupling and plugins of two versions refuse each other."""
    header = (grainjet.ROOT/"liggghts-plugins/host/grainjet_version.h").read_text()
    return re.search('#define GRAINJET_VERSION "(.+)"', header)[1]


def choose(entries, name, kind):
    """An entry of the table, or an error that lists those there are."""
    if name not in entries:
        raise PipeError(f"pipes.toml has no {kind} '{name}'; there are {', '.join(entries)}")
    return entries[name]


class Pipes:
    """All of pipes.toml."""

    def __init__(self, path=PATH):
        self.data = jets.read_toml(pathlib.Path(path))

    def model(self, name):
        """The sum of the models whose names are joined by `+`: options, forces, script, collisions."""
        whole = {"options": {}, "forces": [], "script": [], "collisions": True}
        for part in name.split("+"):
            entry = choose(self.data["model"], part, "model")
            whole["options"] |= entry.get("options", {})
            whole["forces"] += entry.get("forces", [])
            whole["script"] += entry.get("script", [])
            whole["collisions"] &= entry.get("collisions", True)
        return whole

    def run(self, case, size="standard", **changes):
        """All settings of a case in a size; changes hold last."""
        entry = choose(self.data["case"], case, "case")
        experiment = self.data["experiment"][entry["experiment"]]
        settings = (self.data["defaults"] | experiment | self.data["material"][experiment["material"]] | entry
                    | choose(self.data["size"], size, "size"))
        settings |= {"name": case, **changes}
        return derive(settings)


def response_time(d, rho_particle, rho, nu, slip):
    """Of a particle at a slip velocity, after Schiller and Naumann."""
    reynolds = slip*d/nu
    return rho_particle*d**2/(18*rho*nu*(1 + 0.15*reynolds**0.687))


def derive(s):
    """Adds size classes, mesh, steps, number of grains."""
    s["cg"] *= s.pop("cgFactor", 1)
    d, width = s["dParticle"], s["sizeRange"]*s["dParticle"]
    diameters, shares = jets.size_classes(d, (d - width/2, d + width/2), s["sizeClasses"])
    volumes = [share*diameter**3 for diameter, share in zip(diameters, shares)]
    s["diameters"] = diameters
    s["massFractions"] = [v/sum(volumes) for v in volumes]
    s["smallest"] = s["cg"]*min(diameters)

    # A grain at the wall, pressed in by up to a third of its radius, must have its centre inside of the mesh, whose wall is a prism
    radius = s["D"]/2
    s["nSide"] = max(s["nSide"], math.ceil(math.pi/4/math.acos(1 - s["smallest"]/3/radius)))
    s["length"] = s["pipeLength"]*s["D"]
    s["nAxial"] = max(2, round(s["pipeLength"]/s["cellLength"]))

    s["fluidStep"] = jets.round_down(s["courant"]*s["length"]/s["nAxial"]/(1.25*s["Ubulk"]))
    whole = jets.rayleigh_time(s["smallest"]/2, s["rhoParticle"], s["youngsModulus"], s["poissonsRatio"])
    s["couplingInterval"] = math.ceil(s["fluidStep"]/(0.01*s["rayleigh"]*whole))
    s["demStep"] = s["fluidStep"]/s["couplingInterval"]
    steps = [math.ceil(s[name]/s["fluidStep"]) for name in ("settleTime", "sampleTime")]
    s["sampleStart"], s["endTime"] = (float(f"{n*s['fluidStep']:.10g}") for n in (steps[0], sum(steps)))

    # loading: mass flux of the particles over that of the gas
    solids = s["loading"]*s["rhoFluid"]/(s["rhoParticle"]*(1 - s["slip"]))
    s["solidFraction"] = solids
    s["grains"] = round(solids*math.pi*radius**2*s["length"]/(math.pi/6*sum(volumes)*s["cg"]**3))
    return s
