# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of parameters: which runs there are, and the numbers of one run.

`Table(path).run(name, size)` gives the settings of a run as a dict: what the table states and what
follows from it (steps, times, numbers of cells, size classes)."""

import math
import pathlib
import sys

try:
    import tomllib
except ModuleNotFoundError:         # before Python 3.11 the same module is a package of its own
    try:
        import tomli as tomllib
    except ModuleNotFoundError:
        sys.exit(f"Python {sys.version.split()[0]} ({sys.executable}) reads no TOML: install the package python3-tomli")

HERE = pathlib.Path(__file__).resolve().parent
PATH = HERE.parent/"parameters.toml"

# What the table may state of a run, beside its rig, particles and material
NUMBERS = set("""rhoFluid gravity powerLaw turbulenceIntensity mixingLength cg sizeClasses endOffset
nozzleRadius endRadius boxRadius widening coreSide airGrading jetGrading plateRadius plateRings radialBins
maxRadius settleFactor sampleTime ranks D jetLength youngsModulus poissonsRatio restitution friction
rollingFriction dParticle rhoParticle massLoading Umean Re Uinsertion uRmsAxial uRmsRadial demStep
pipeLength insertionLength cellLength nSide nRing nAir courant rayleigh subSteps writes spinUpIterations
refinement""".split())
LISTS = {"planes", "sizeRange"}
WORDS = {"interpolation", "endPatch", "wallLaw", "turbulentDispersion", "models", "startFrom"}
WORD_LISTS = {"forces"}
REFERENCES = {"rig", "particles", "material", "case"}
# what the mesh of a size is made of, and its steady flow
MESH = ("cellLength", "nSide", "nRing", "nAir", "coreSide", "airGrading", "jetGrading", "spinUpIterations")


class TableError(Exception):
    """Wrong input, in one sentence."""


def rayleigh_time(radius, density, young, poisson):
    """pi R sqrt(rho/G)/(0.1631 nu + 0.8766)"""
    shear = young/(2*(1 + poisson))
    return math.pi*radius*math.sqrt(density/shear)/(0.1631*poisson + 0.8766)


def size_classes(nominal, limits, number):
    """(diameters, number fractions): classes of equal width over a range. A normal distribution
    with a fifth of the range as deviation, shifted until the number mean is the nominal size."""
    low, high = limits
    if high - low < 1e-3*nominal:
        return [nominal], [1.0]
    width = (high - low)/number
    sizes = [low + (i + 0.5)*width for i in range(number)]

    def fractions(centre):
        weights = [math.exp(-0.5*((d - centre)/(0.2*(high - low)))**2) for d in sizes]
        return [w/sum(weights) for w in weights]

    left, right = low, high
    for _ in range(100):
        middle = 0.5*(left + right)
        mean = sum(d*x for d, x in zip(sizes, fractions(middle)))
        left, right = (middle, right) if mean < nominal else (left, middle)
    return sizes, fractions(middle)


def round_down(value, digits=2):
    """Down to so many significant digits."""
    unit = 10.0**(math.floor(math.log10(value)) - digits + 1)
    return float(f"{math.floor(value/unit + 1e-9)*unit:.{digits}g}")


def read_toml(path):
    """The tables of a file, as dicts."""
    return tomllib.loads(path.read_text())


class Table:
    """All of parameters.toml, checked key by key."""

    def __init__(self, path=PATH):
        self.path = pathlib.Path(path)
        try:
            self.data = read_toml(self.path)
        except tomllib.TOMLDecodeError as error:
            raise TableError(f"{self.path}: {error}") from None
        self.cases = self.data["case"]
        self.sizes = self.data["size"]
        self.studies = self.data["study"]

    def runs(self, word):
        """The names of the runs that a word of the command line means."""
        if word in self.cases:
            return [word]
        if word in self.studies:
            return list(self.studies[word]["run"])
        if any(word in study["run"] for study in self.studies.values()):
            return [word]
        raise TableError(f"no case, study or run '{word}' in {self.path.name}; there are the cases "
                         f"{', '.join(self.cases)}, the studies {', '.join(self.studies)} and the "
                         f"sizes {', '.join(self.sizes)}")

    def size(self, word):
        if word not in self.sizes:
            raise TableError(f"no size '{word}' in {self.path.name}; there are {', '.join(self.sizes)}")
        return self.sizes[word]

    def study_of(self, name):
        """The study a run belongs to, or None for a case."""
        return next((study for study, entry in self.studies.items() if name in entry["run"]), None)

    def case_of(self, name, study):
        """The case of a run of a study: its own, or that of the whole study."""
        entry = self.studies[study]
        case = entry["run"][name].get("case", entry.get("case"))
        if case is None:
            raise TableError(f"{self.path.name}: [study.{study}] and its run {name} have no case")
        return case

    def _add(self, settings, entries, place):
        """Take over checked entries; tables inside belong to somebody else."""
        for key, value in entries.items():
            if isinstance(value, dict) or key in REFERENCES:
                continue
            kind = ("number" if key in NUMBERS else "list of numbers" if key in LISTS
                    else "word" if key in WORDS else "list of words" if key in WORD_LISTS else None)
            where = f"{self.path.name}: [{place}] {key} = {value!r}"
            if kind is None:
                raise TableError(f"{where}: no such parameter; see the list in cases/README.md")
            right = {"number": lambda v: isinstance(v, (int, float)) and not isinstance(v, bool),
                     "list of numbers": lambda v: isinstance(v, list) and v and all(
                         isinstance(x, (int, float)) for x in v),
                     "list of words": lambda v: isinstance(v, list) and all(
                         isinstance(x, str) for x in v),
                     "word": lambda v: isinstance(v, str)}[kind](value)
            if not right:
                raise TableError(f"{where}: must be a {kind}")
            settings[key] = value

    def coarse(self, settings):
        """The settings of a run on the mesh of the size that its steady flow starts from, or None if there is none."""
        if "startFrom" not in settings:
            return None
        size = self.size(settings["startFrom"])
        return self.run(settings["name"], settings["size"], {key: size.get(key, self.data["defaults"].get(key)) for key in MESH})

    def run(self, name, size, changes=None):
        """All settings of a run, stated and derived; changes: other values instead of those of the table."""
        study = self.study_of(name)
        case_name = self.case_of(name, study) if study else name
        if case_name not in self.cases:
            self.runs(case_name)
        case, size_entry = self.cases[case_name], self.size(size)
        rig = case["rig"]
        particles = self.data["particles"][case["particles"]]
        settings = {}
        self._add(settings, self.data["defaults"], "defaults")
        self._add(settings, self.data["rig"][rig], f"rig.{rig}")
        self._add(settings, self.data["material"][particles["material"]], f"material.{particles['material']}")
        self._add(settings, particles, f"particles.{case['particles']}")
        self._add(settings, case, f"case.{case_name}")
        self._add(settings, size_entry, f"size.{size}")
        self._add(settings, size_entry.get("rig", {}).get(rig, {}), f"size.{size}.rig.{rig}")
        self._add(settings, size_entry.get("case", {}).get(case_name, {}), f"size.{size}.case.{case_name}")
        if study:
            entry = self.studies[study]
            self._add(settings, entry, f"study.{study}")
            self._add(settings, entry["run"][name], f"study.{study}.run.{name}")
            self._add(settings, entry.get("size", {}).get(size, {}), f"study.{study}.size.{size}")
        models = settings["models"]
        if models not in self.data["models"]:
            raise TableError(f"{self.path.name}: run {name}: no models '{models}'; there are "
                             f"{', '.join(self.data['models'])}")
        self._add(settings, self.data["models"][models], f"models.{models}")
        settings.update(changes or {})
        settings |= {"name": name, "size": size, "case": case_name, "study": study,
                     "rig": rig, "material": particles["material"]}
        try:
            return derive(settings)
        except KeyError as error:
            raise TableError(f"{self.path.name}: run {name} of size {size} lacks {error}") from None


def derive(s):
    """Adds what follows: mesh, steps, times, size classes."""
    sizes, numbers = size_classes(s["dParticle"], s["sizeRange"], s["sizeClasses"])
    volumes = [n*d**3 for n, d in zip(numbers, sizes)]
    s["diameters"] = sizes
    s["massFractions"] = [v/sum(volumes) for v in volumes]
    s["meanParticleMass"] = s["rhoParticle"]*math.pi/6*sum(volumes)
    s["endType"] = "wall" if s["endPatch"] == "plate" else "patch"

    # Mesh. The first cells of the jet are as long as those of the pipe: mean length over first length
    fine = s.get("refinement", 1)
    cell = s["cellLength"]/fine
    g = s["jetGrading"]
    stretch = (g - 1)/math.log(g) if g > 1 else 1
    for key in ("nSide", "nRing", "nAir"):
        s[key] = max(2, round(s[key]*fine))
    s["nPipe"] = math.ceil(s["pipeLength"]/cell)
    s["nJet"] = math.ceil(s["jetLength"]/(cell*stretch))

    # Steps: `courant` and `rayleigh` limit the sub-step, through which grains fly while the fluid stays
    # as it is, and the DEM step; subSteps of them make a fluid step
    if not isinstance(s["subSteps"], int) or s["subSteps"] < 1:
        raise TableError(f"run {s['name']}: subSteps = {s['subSteps']!r} must be a whole number from 1 on")
    umax = s["Umean"]*(s["powerLaw"] + 1)*(2*s["powerLaw"] + 1)/(2*s["powerLaw"]**2)
    whole = rayleigh_time(s["cg"]*s["dParticle"]/2, s["rhoParticle"], s["youngsModulus"], s["poissonsRatio"])
    if "courant" in s:
        sub_step = round_down(s["courant"]*cell*s["D"]/umax)
        s["couplingInterval"] = max(1, math.ceil(sub_step/(0.01*s["rayleigh"]*whole)))
    else:
        s["couplingInterval"] = 10
        sub_step = float(f"{10*s['demStep']:.10g}")
    s["fluidStep"] = float(f"{s['subSteps']*sub_step:.10g}")
    s["demStep"] = sub_step/s["couplingInterval"]
    s["percentRayleigh"] = 100*s["demStep"]/whole

    # Grains enter in packets that are long enough for them to find room
    flight = s["D"]/s["Umean"]
    steps = max(2, math.ceil(0.0866*flight/sub_step))
    s["insertionInterval"] = steps*s["couplingInterval"]
    s.setdefault("insertionLength", s["pipeLength"] - s["endOffset"])

    # Times: the window of sampling in equal parts, and the settling in as many of these as it needs
    last = s["jetLength"] if s["endPatch"] == "plate" else max(s["planes"])
    part = max(1, round(s["sampleTime"]*flight/s["writes"]/s["fluidStep"]))
    settle = math.ceil(s["settleFactor"]*(s["insertionLength"] + last)*flight/s["fluidStep"]/part)
    s["writeInterval"] = float(f"{part*s['fluidStep']:.10g}")
    s["sampleStart"] = float(f"{settle*part*s['fluidStep']:.10g}")
    s["endTime"] = float(f"{(settle + s['writes'])*part*s['fluidStep']:.10g}")

    s["particlesPerSecond"] = (s["massLoading"]*s["rhoFluid"]*s["Umean"]*math.pi/4*s["D"]**2
                               / s["meanParticleMass"])
    return s
