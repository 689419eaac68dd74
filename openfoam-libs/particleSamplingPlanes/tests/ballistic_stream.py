# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Parcels that fly straight on through a box, in stock icoUncoupledKinematicParcelFoam.

Without forces each parcel keeps the velocity of its injector, so that time and place of
every crossing of a plane are known. The stream has a parabolic profile with swirl, some
parcels that fly backwards, and some that are so fast that they pass planes in the step of
their injection and leave the box in the middle of a step.
"""

import math

from grainjet import dictionaries

DIAMETER = 0.1          # m, unit of the planes
LENGTH = 1.0            # m, box along z
DT = 0.01               # s
INJECTED = 0.995        # s, one parcel per step and injector: 100
N_PARTICLE = 8          # real particles per parcel
SMALL, LARGE = 1e-3, 2e-3   # m, diameters of the stream and of the others
RHO = 1000.0            # kg/m3
PLANES = (0.3, 1, 5, 9.9)
RINGS, MAX_RADIUS = 4, 0.8

# patch at the ends of the box: side of the block
ENDS = {"ends": "zlo zhi"}


def injectors():
    """Place, velocity and diameter of each injector; one parcel per step comes from each."""
    result = []
    for i in range(40):                                   # the stream
        r, angle = 0.004 + 0.0021*i, 2.4*i
        c, s = math.cos(angle), math.sin(angle)
        axial = 2.0*(1 - (r/0.12)**2)
        swirl, spread = 0.3*r, 0.1*r
        result.append(((r*c, r*s, 0.013),
                       (spread*c - swirl*s, spread*s + swirl*c, axial), SMALL))
    for i in range(5):                                    # against the axis
        result.append(((0.011*i - 0.02, 0.013, 0.953), (0.0, 0.01, -1.37 - 0.1*i), LARGE))
    for i in range(5):                                    # several planes per step
        result.append(((0.017, 0.012*i - 0.03, 0.013), (0.02, 0.0, 30.0 + i), LARGE))
    return result


def crossings():
    """(plane, direction, place, velocity, time of flight, diameter) of the crossings of one parcel of
    each injector, if it is given the time to leave the box."""
    result = []
    for place, velocity, diameter in injectors():
        for plane in PLANES:
            flight = (plane*DIAMETER - place[2])/velocity[2]
            if flight > 0:
                result.append((plane, math.copysign(1, velocity[2]),
                               [x + u*flight for x, u in zip(place, velocity)],
                               velocity, flight, diameter))
    return result


def sampling(**changes):
    """The entry in controlDict."""
    values = {
        "type": "particleSamplingPlanes", "libs": '("libparticleSamplingPlanes.so")',
        "cloud": "kinematicCloud", "origin": "(0 0 0)", "axis": "(0 0 2)",
        "diameter": DIAMETER, "planes": "(" + " ".join(str(x) for x in PLANES) + ")",
        "radialBins": RINGS, "maxRadius": MAX_RADIUS, **changes}
    return f"profiles {{ {dictionaries.entries(values)} }}"


def control(folder, end, start="startTime", functions=None, interval=20, extra="runTimeModifiable no;"):
    functions = sampling() if functions is None else functions
    dictionaries.write(
        folder/"system/controlDict",
        f"startFrom {start}; startTime 0; stopAt endTime; endTime {end}; deltaT {DT};\n"
        f"writeControl timeStep; writeInterval {interval}; writeFormat binary; writePrecision 12;\n"
        f"timePrecision 8; {extra}\nfunctions {{ {functions} }}\n")


def write(folder, end, cut="(1 1 2)", ends=ENDS, **options):
    """Write the case. ends: the patches at the ends of the box; options: those of control."""
    dictionaries.write_all(folder, {
        "system/blockMeshDict": dictionaries.block(
            (-0.1, -0.1, 0), (0.1, 0.1, LENGTH), "4 4 10",
            {**{name: ("patch", side) for name, side in ends.items()}, "sides": ("wall", "xlo xhi ylo yhi")}),
        "system/decomposeParDict":
            f"numberOfSubdomains 2; method simple; simpleCoeffs {{ n {cut}; delta 0.001; }}",
        "system/fvSchemes": "ddtSchemes { default none; } gradSchemes { default none; }\n"
            "divSchemes { default none; } laplacianSchemes { default none; }\n"
            "interpolationSchemes { default linear; }",
        "system/fvSolution": "solvers {}",
        "constant/transportProperties": "transportModel Newtonian; nu 1e-05; rhoInf 1.2;",
        "constant/turbulenceProperties": "simulationType laminar;",
        "constant/kinematicCloudProperties": f"""
solution
{{
    active true; coupled false; transient yes; cellValueSourceCorrection off; maxCo 0.3;
    interpolationSchemes {{ rho cell; U cell; mu cell; }}
    integrationSchemes {{ U Euler; }}
}}
constantProperties {{ rho0 {RHO}; youngsModulus 1e6; poissonsRatio 0.3; }}
subModels
{{
    particleForces {{}}
    injectionModels
    {{
        stream
        {{
            type kinematicLookupTableInjection; inputFile "injectors"; randomise false;
            massTotal 1; parcelBasisType fixed; nParticle {N_PARTICLE}; SOI 0; duration {INJECTED};
            parcelsPerSecond {(1 + 1e-6)/DT};
        }}
    }}
    dispersionModel none; patchInteractionModel none; surfaceFilmModel none;
    stochasticCollisionModel none; collisionModel none;
}}
cloudFunctions {{}}
""",
    })
    dictionaries.write(folder/"constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 0 0);",
                       "uniformDimensionedVectorField")
    dictionaries.write_field(folder, "U", "0 1 -1", "(0 0 0)", {".*": "type fixedValue; value uniform (0 0 0);"})
    rows = "\n".join(f"{dictionaries.vector(place)} {dictionaries.vector(velocity)} {d} {RHO} 1e-6"
                     for place, velocity, d in injectors())
    dictionaries.write(folder/"constant/injectors", f"{len(injectors())}\n(\n{rows}\n)",
                       "GlobalIOList<kinematicParcelInjectionData>")
    control(folder, end, **options)
