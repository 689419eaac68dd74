# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A case of stock DPMFoam that starts from a populated state of the main job.

Fluid: the fields of the main job under the names that DPMFoam wants. Grains: parcels at the same
places with the same velocities, and a list of those that will enter. All numbers come from the
dictionaries of the main job.
"""

import math
import random
import re
import shutil

from grainjet import dictionaries

# What DPMFoam reads of each parcel beside place, velocity and size; at rest, without contacts
PARCEL_FIELDS = {
    "active": ("labelField", "1"), "typeId": ("labelField", "0"), "age": ("scalarField", "0"),
    "tTurb": ("scalarField", "0"), "UTurb": ("vectorField", "(0 0 0)"),
    "f": ("vectorField", "(0 0 0)"), "angularMomentum": ("vectorField", "(0 0 0)"),
    "torque": ("vectorField", "(0 0 0)"),
    "collisionRecordsPairAccessed": ("labelFieldField", "0()"),
    "collisionRecordsPairOrigProcOfOther": ("labelFieldField", "0()"),
    "collisionRecordsPairOrigIdOfOther": ("labelFieldField", "0()"),
    "collisionRecordsPairData": ("vectorFieldField", "0()"),
    "collisionRecordsWallAccessed": ("labelFieldField", "0()"),
    "collisionRecordsWallPRel": ("vectorFieldField", "0()"),
    "collisionRecordsWallData": ("vectorFieldField", "0()"),
    "UCorrect": ("vectorField", "(0 0 0)"),      # asked for by later releases than v1912
}


def vector(components):
    return "({:.10g} {:.10g} {:.10g})".format(*components)


def listed(values):
    return f"{len(values)}\n(\n" + "\n".join(values) + "\n)\n"


def write_cloud_geometry(time, name, geometry, particles):
    """How places are given in a cloud's files, and how many ids are taken."""
    dictionaries.write(time/"uniform/lagrangian"/name/"cloudProperties",
                       f"geometry {geometry};\nprocessor0 {{ particleCount {particles}; }}")


def write_cloud(time, name, positions, fields, first_id=0):
    """A cloud in a time folder, by positions: the cells are found by the reader."""
    ids = range(first_id, first_id + len(positions))
    write_cloud_geometry(time, name, "positions", ids.stop)
    cloud = time/"lagrangian"/name
    fields = {"origProcId": ("labelField", "0"),
              "origId": ("labelField", [str(i) for i in ids]), **fields}
    dictionaries.write(cloud/"positions", listed([f"{vector(x)} -1" for x in positions]), "Cloud")
    for field, (kind, values) in fields.items():
        text = (f"{len(positions)}{{{values}}}\n" if isinstance(values, str) else listed(values))
        dictionaries.write(cloud/field, text, kind)


def write_parcels(time, positions, velocities, p):
    """The grains of the populated state."""
    write_cloud(time, "kinematicCloud", positions, {
        **PARCEL_FIELDS,
        "U": ("vectorField", [vector(u) for u in velocities]),
        "d": ("scalarField", f"{p['dParticle']:g}"),
        "dTarget": ("scalarField", f"{p['dParticle']:g}"),
        "rho": ("scalarField", f"{p['rhoParticle']:g}"),
        "nParticle": ("scalarField", f"{p['cg']**3:g}")})


def entering(p, duration):
    """(times, positions, velocities) of the grains that enter, as LIGGGHTS inserts them in the main
    job: same rate, same disc, Gaussian velocities, never into another grain."""
    dice = random.Random(1)
    diameter = p["cg"]*p["dParticle"]
    kg_per_s = p["massLoading"]*p["rhoFluid"]*p["Umean"]*math.pi/4*p["D"]**2
    interval = p["rhoParticle"]*math.pi/6*diameter**3/kg_per_s
    side = math.cos(math.pi/(4*p["nSide"]))      # the pipe is a prism, the disc lies within it
    reach = (p["D"]/2 - diameter/2/side)*side
    z = (p["endOffset"] - p["pipeLength"])*p["D"]
    near = math.ceil(2*p["fluidStep"]/interval)  # those before are out of the way
    places = []
    while len(places)*interval < duration:
        x, y = (dice.uniform(-reach, reach) for _ in range(2))
        if math.hypot(x, y) < reach and all(
                math.hypot(x - a, y - b) > diameter for a, b in places[-near:]):
            places.append((x, y))
    return ([i*interval for i in range(len(places))], [(x, y, z) for x, y in places],
            [(dice.gauss(0, p["uRmsRadial"]), dice.gauss(0, p["uRmsRadial"]),
              dice.gauss(p["Uinsertion"], p["uRmsAxial"])) for _ in places])


def write_entering(time, p, duration, present):
    """The list of entering grains, as the cloud that the model injectedParticleInjection reads."""
    times, positions, velocities = entering(p, duration)
    write_cloud(time, "stream", positions, {
        "tag": ("labelField", "0"), "soi": ("scalarField", [f"{t:.10g}" for t in times]),
        "d": ("scalarField", f"{p['dParticle']:g}"),
        "U": ("vectorField", [vector(u) for u in velocities])}, first_id=present)


def resolution_steps(p, sub_cycles, fastest):
    """The value of collisionResolutionSteps at which DPMFoam chooses a number of sub-cycles, from its
    own criterion for pairs. Half a cycle below, because it rounds up."""
    modulus = p["youngsModulus"]/p["cg"]**3/(2*(1 - p["poissonsRatio"]**2))
    shortest = 5.429675*p["cg"]*p["dParticle"]/4*(
        p["rhoParticle"]/(modulus*math.sqrt(2*fastest)))**0.4
    return shortest/(p["fluidStep"]/(sub_cycles - 0.5))


def write_cloud_properties(case, p, steps):
    """Force, injection and contact models of the cloud. The contact force acts on the mass of one
    particle but has the stiffness of a grain: modulus/cg^3 gives the grain's motion of the main job."""
    grain = p["cg"]*p["dParticle"]
    modulus = p["youngsModulus"]/p["cg"]**3
    # damping of the stock Hertz model of LIGGGHTS: 2 sqrt(5/6) sqrt(3/2) |beta|
    log_e = math.log(p["restitution"])
    alpha = math.sqrt(5)*abs(log_e)/math.hypot(log_e, math.pi)
    contact = f"""useEquivalentSize yes; volumeFactor 1; alpha {alpha:.6g}; b 1.5;
            mu {p['friction']:g}; cohesionEnergyDensity 0; collisionResolutionSteps {steps:.6g};"""
    dictionaries.write(case/"constant/kinematicCloudProperties", f"""
solution
{{
    active yes; coupled yes; transient yes; cellValueSourceCorrection off;
    interpolationSchemes {{ rho.air cell; U.air cellPoint; mu.air cell; DUcDt cellPoint; }}
    integrationSchemes {{ U Euler; }}
    sourceTerms {{ schemes {{ U semiImplicit 1; }} }}
}}
constantProperties
{{
    parcelTypeId 0; rhoMin 1e-15; minParcelMass 1e-15; constantVolume no; alphaMax 0.7;
    rho0 {p['rhoParticle']:g}; youngsModulus {modulus:g}; poissonsRatio {p['poissonsRatio']:g};
}}
subModels
{{
    particleForces
    {{
        ErgunWenYuDrag {{ alphac alpha.air; }}
        pressureGradient {{ U U.air; }}
        gravity;
    }}
    injectionModels
    {{
        stream
        {{
            type injectedParticleInjection; cloud stream; positionOffset (0 0 0);
            SOI 0; massTotal 0; parcelBasisType fixed; nParticle {p['cg']**3:g};
        }}
    }}
    dispersionModel none; heatTransferModel none; surfaceFilmModel none;
    stochasticCollisionModel none; radiation off;
    patchInteractionModel localInteraction;
    localInteractionCoeffs
    {{
        patches
        (
            pipeWall {{ type rebound; e {p['restitution']:g}; mu {p['friction']:g}; }}
            inlet {{ type escape; }} entrainment {{ type escape; }} outlet {{ type escape; }}
        );
    }}
    collisionModel pairCollision;
    pairCollisionCoeffs
    {{
        maxInteractionDistance {grain:g}; writeReferredParticleCloud no; U U.air;
        pairModel pairSpringSliderDashpot;
        pairSpringSliderDashpotCoeffs
        {{
            {contact}
        }}
        wallModel wallSpringSliderDashpot;
        wallSpringSliderDashpotCoeffs
        {{
            youngsModulus {modulus:g}; poissonsRatio {p['poissonsRatio']:g};
            {contact}
        }}
    }}
}}
cloudFunctions {{}}
""")


def write_dictionaries(case, job, p, window, write_interval):
    """constant/ and system/ but for the cloud: the numerics of the main job under DPMFoam's names."""
    dictionaries.write(case/"system/controlDict", f"""
application DPMFoam; startFrom startTime; startTime 0; stopAt endTime; endTime {window:.10g};
deltaT {p['fluidStep']:g}; writeControl runTime; writeInterval {write_interval:.10g};
writeFormat ascii; writePrecision 12; timePrecision 8; runTimeModifiable no;
profiling {{ active yes; }}
functions
{{
    grains {{ type vtkCloud; libs ("liblagrangianFunctionObjects.so"); cloud kinematicCloud; writeControl writeTime; }}
}}
""")
    for name in ("decomposeParDict", "parameters"):     # the one includes the other
        shutil.copy(job/"system"/name, case/"system")

    schemes = (job/"system/fvSchemes").read_text()
    for old, new in (
            ("div(phi,U)", "div(alphaPhi.air,U.air)"), ("linearUpwind grad(U)", "linearUpwind grad(U.air)"),
            ("div(phi,k)", "div(alphaPhi.air,k.air)"), ("div(phi,epsilon)", "div(alphaPhi.air,epsilon.air)"),
            ("div((nuEff*dev2(T(grad(U)))))", "div(((alpha.air*nuEff.air)*dev2(T(grad(U.air)))))")):
        schemes = schemes.replace(old, new)
    (case/"system/fvSchemes").write_text(schemes)

    solution = (job/"system/fvSolution").read_text()
    solution = re.sub(r'"\(U\|k\|epsilon\)Final"\s*\{[^}]*\}', "", solution)
    (case/"system/fvSolution").write_text(
        solution.replace('"(U|k|epsilon)"', '"(U|k|epsilon).air(Final)?"'))

    dictionaries.write(case/"constant/transportProperties",
                       f"continuousPhase air; rho.air {p['rhoFluid']:g}; transportModel Newtonian; "
                       f"nu {p['D']*p['Umean']/p['Re']:g};")
    # jetKEpsilon without correction is kEpsilon with these two coefficients
    coefficients = dict(re.findall(r"\b(C[12])\s+([\d.]+);",
                                   (job/"constant/turbulenceProperties").read_text()))
    dictionaries.write(case/"constant/turbulenceProperties.air",
                       "simulationType RAS; RAS { RASModel kEpsilon; turbulence on; printCoeffs on; "
                       f"kEpsilonCoeffs {{ C1 {coefficients['C1']}; C2 {coefficients['C2']}; }} }}")
    dictionaries.write(case/"constant/g", f"dimensions [0 1 -2 0 0 0 0]; value (0 0 {p['gravity']:g});",
                       "uniformDimensionedVectorField")


def patch_text(text, patch):
    """The text between the braces of a patch in an ascii field."""
    return re.search(rf"\n    {patch}\s*\{{(.*?)\n    \}}", text, re.S)[1]


def write_fields(time, populated, heights, gravity):
    """The fluid of the populated state. DPMFoam's pressure contains the weight of the fluid, that of
    the main job does not: g z is added inside and in the total pressure of the open boundaries."""
    for old in ("U", "k", "epsilon", "nut", "phi"):
        text = (populated/old).read_text()
        text = re.sub(r"(type\s+pressureInletOutletVelocity;)", r"\1 phi phi.air;", text)
        (time/f"{old}.air").write_text(re.sub(rf"object\s+{old};", f"object {old}.air;", text, count=1))

    z = heights.read_text()
    pairs = zip(dictionaries.internal(populated/"p"), dictionaries.internal(heights), strict=True)
    sums = [f"{a + gravity*b:.12g}" for a, b in pairs]
    patches = ["inlet { type fixedFluxPressure; phi phi.air; value uniform 0; }",
               "pipeWall { type fixedFluxPressure; phi phi.air; value uniform 0; }"]
    for patch in ("entrainment", "outlet"):
        found = patch_text(z, patch)
        faces = re.search(r"value\s+nonuniform List<scalar>\s*\d+\s*\(([^)]*)\)", found)
        if faces:
            weight = "nonuniform List<scalar> " + listed(
                [f"{gravity*float(b):.12g}" for b in faces[1].split()])
        else:
            weight = f"uniform {gravity*float(re.search(r'value +uniform ([^;]+);', found)[1]):.12g}"
        patches.append(f"{patch} {{ type totalPressure; U U.air; phi phi.air; p0 {weight}; "
                       f"value {weight}; }}")
    dictionaries.write_field(time.parent, "p", "0 2 -2", dictionaries.nonuniform(sums), "\n".join(patches))
