# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""A driven cavity with walls in the stock solvers that know kEpsilon, for comparing jetKEpsilon with it.

Half of it is water where there are two phases. All written fields are compared.
"""

import shutil

import numpy

import grainjet
import homogeneous_box as box
from grainjet import dictionaries

SIDE = 8                                    # cells along a side
STEPS, DT = 10, 0.005
STOCK = {"C1": 1.44, "C2": 1.92}            # of kEpsilon
JET = {"C1": 1.52, "C2": 1.90}              # of jetKEpsilon

COMMON = {
    "system/blockMeshDict": dictionaries.block(
        (0, 0, 0), (1, 1, 0.1), f"{SIDE} {SIDE} 1",
        {"lid": ("wall", "yhi"), "walls": ("wall", "xlo xhi ylo"), "frontAndBack": ("empty", "zlo zhi")}),
    "system/decomposeParDict": "numberOfSubdomains 2; method simple; simpleCoeffs { n (2 1 1); delta 0.001; }",
    "system/controlDict": f"""
libs ("libjetTurbulenceModels.so");
startFrom startTime; startTime 0; stopAt endTime; endTime {STEPS*DT}; deltaT {DT};
writeControl timeStep; writeInterval {STEPS}; writePrecision 17; runTimeModifiable no;
adjustTimeStep no; maxCo 1; maxAlphaCo 1;
""",
    "system/fvSchemes": r"""
ddtSchemes { default Euler; } gradSchemes { default Gauss linear; }
divSchemes
{
    default Gauss linear;
    "div\(.*[pP]hi.*,(U|T|p|e|h|k|K|Ekp|epsilon)(\.(air|water))?\)" Gauss upwind; "div\(phi,alpha.*\)" Gauss vanLeer;
}
laplacianSchemes { default Gauss linear corrected; } interpolationSchemes { default linear; } snGradSchemes { default corrected; }
""",
    "system/fvSolution": """
solvers
{
    ".*" { solver PBiCGStab; preconditioner DILU; tolerance 1e-11; relTol 0; }
    "p.*" { solver PCG; preconditioner DIC; tolerance 1e-11; relTol 0; }
    "alpha.*"
    {
        solver smoothSolver; smoother symGaussSeidel; tolerance 1e-12; relTol 0;
        nAlphaCorr 1; nAlphaSubCycles 1; cAlpha 1; MULESCorr no; nLimiterIter 3;
    }
}
PIMPLE { nCorrectors 2; pRefCell 0; pRefValue <pressure>; }
""",
    "constant/g": "dimensions [0 1 -2 0 0 0 0]; value (0 -9.81 0);",
}
GAS = """
thermoType
{
    type heRhoThermo; mixture pureMixture; transport const; thermo hConst;
    equationOfState perfectGas; specie specie; energy sensibleInternalEnergy;
}
mixture { specie { molWeight 28.9; } thermodynamics { Cp 1007; Hf 0; } transport { mu 1.84e-05; Pr 0.7; } }
"""
LIQUID = GAS.replace("perfectGas", "perfectFluid").replace(
    "molWeight 28.9; }", "molWeight 18; } equationOfState { R 3000; rho0 1027; }").replace("1007", "4195")
WATER_AND_AIR = """phases (water air); sigma 0.07;
water { transportModel Newtonian; nu 1e-06; rho 1000; } air { transportModel Newtonian; nu 1.48e-05; rho 1; }"""
BOTH = """
phases (air water); pMin 1e4; air { type purePhaseModel; diameterModel constant; constantCoeffs { d 3e-3; } residualAlpha 1e-6; }
water { type purePhaseModel; diameterModel constant; constantCoeffs { d 1e-3; } residualAlpha 1e-6; }
blending
{
    default
    {
        type linear; minFullyContinuousAlpha.air 0.7; minPartlyContinuousAlpha.air 0.3;
        minFullyContinuousAlpha.water 0.7; minPartlyContinuousAlpha.water 0.3;
    }
}
surfaceTension ((air and water) { type constant; sigma 0.07; });
drag ((air in water) { type SchillerNaumann; residualRe 1e-3; swarmCorrection { type none; } }
      (water in air) { type SchillerNaumann; residualRe 1e-3; swarmCorrection { type none; } }
      (air and water) { type segregated; m 0.5; n 8; swarmCorrection { type none; } });
heatTransfer ((air in water) { type RanzMarshall; residualAlpha 1e-4; } (water in air) { type RanzMarshall; residualAlpha 1e-4; });
aspectRatio (); virtualMass (); lift (); phaseTransfer (); wallLubrication (); turbulentDispersion (); interfaceCompression ();
"""
CLOUD = """
solution
{
    active true; coupled true; transient yes; cellValueSourceCorrection no; maxCo 0.3;
    interpolationSchemes { rho cell; U cellPoint; mu cell; } averagingMethod basic; integrationSchemes { U Euler; }
    sourceTerms { schemes { U semiImplicit 1; } }
}
constantProperties { rho0 2500; alphaMax 0.9; }
subModels
{
    particleForces { WenYuDrag { alphac alphac; } gravity; }
    injectionModels
    {
        grains
        {
            type manualInjection; massTotal 5; parcelBasisType mass; SOI 0; positionsFile "grains"; U0 (0 0 0);
            sizeDistribution { type fixedValue; fixedValueDistribution { value 1e-3; } }
        }
    }
    dispersionModel none; patchInteractionModel standardWallInteraction; standardWallInteractionCoeffs { type rebound; }
    heatTransferModel none; surfaceFilmModel none; packingModel none; dampingModel none; isotropyModel none;
    stochasticCollisionModel none; radiation off;
}
cloudFunctions { }
"""
GRAINS = "(\n" + "\n".join(f"({(i + 0.4)/6} {(j + 0.6)/12} 0.05)" for i in range(6) for j in range(6)) + "\n)\n"

# what a solver needs beyond the common files, the fields beside velocity and turbulence, and the groups of these
SOLVERS = {
    "pimpleFoam": ({"constant/transportProperties": "transportModel Newtonian; nu 1e-05;"}, "p/rho", ("",)),
    "rhoPimpleFoam": ({"constant/thermophysicalProperties": GAS}, "p T", ("",)),
    "buoyantPimpleFoam": ({"constant/thermophysicalProperties": GAS}, "p p_rgh T", ("",)),
    "interFoam": ({"constant/transportProperties": WATER_AND_AIR}, "p_rgh alpha", ("",)),
    "compressibleInterFoam": (
        {"constant/thermophysicalProperties": "phases (water air); pMin 1e4; sigma 0.07;",
         "constant/thermophysicalProperties.air": GAS, "constant/thermophysicalProperties.water": LIQUID},
        "p p_rgh T alpha", ("", ".air", ".water")),
    "MPPICInterFoam": (
        {"constant/transportProperties": WATER_AND_AIR, "constant/kinematicCloudProperties": CLOUD}, "p_rgh alpha", ("",)),
    **{f"reacting{kind}EulerFoam": (
        {"constant/phaseProperties": f"type {basic};\n{BOTH}",
         "constant/thermophysicalProperties.air": GAS, "constant/thermophysicalProperties.water": LIQUID},
        "p p_rgh T alpha", (".air", ".water"))
       for kind, basic in (("TwoPhase", "basicTwoPhaseSystem"), ("Multiphase", "basicMultiphaseSystem"))},
}


def write_field(folder, name, dimensions, value, lid="type zeroGradient;", walls=None):
    dictionaries.write_field(folder, name, dimensions, value, {
        "frontAndBack": "type empty;", "lid": lid, "walls": walls or lid})


def write(folder, solver):
    """Write the case, without turbulenceProperties."""
    texts, scalars, groups = SOLVERS[solver]
    pressure = 0 if solver in ("pimpleFoam", "interFoam", "MPPICInterFoam") else 1e5
    dictionaries.write_all(folder, {**COMMON, **texts})
    dictionaries.change(folder/"system/fvSolution", ("<pressure>", str(pressure)))
    (folder/"constant/grains").write_text(dictionaries.HEADER.format("vectorField", "grains") + GRAINS)
    for group in groups:
        write_field(folder, "U" + group, "0 1 -1", "(0 0 0)", "type fixedValue; value uniform (1 0 0);", "type noSlip;")
        write_field(folder, "k" + group, "0 2 -2", 0.00325, "type kqRWallFunction; value uniform 0.00325;")
        write_field(folder, "epsilon" + group, "0 2 -3", 0.000765, "type epsilonWallFunction; value uniform 0.000765;")
        write_field(folder, "nut" + group, "0 2 -1", 0, "type nutkWallFunction; value uniform 0;")
        write_field(folder, "alphat" + group, "1 -1 -1", 0, "type calculated; value uniform 0;")
        if "T" in scalars:
            write_field(folder, "T" + group, "[0 0 0 1 0 0 0]", 300)
    for name in ("p", "p_rgh"):
        if name in scalars.split() or name + "/rho" in scalars:
            kind = "fixedFluxPressure" if name == "p_rgh" else "calculated" if "p_rgh" in scalars else "zeroGradient"
            write_field(folder, name, "0 2 -2" if "p/rho" in scalars else "1 -1 -2", pressure,
                        f"type {kind}; value uniform {pressure};")
    if "alpha" in scalars:
        # drops and bubbles: stock kEpsilon of a phase cannot be solved where there is nothing of it
        water = numpy.repeat([0.95]*(SIDE//2 - 1) + [0.7, 0.2] + [0.05]*(SIDE//2 - 1), SIDE)
        write_field(folder, "alpha.water", "0 0 0", dictionaries.nonuniform(water))
        write_field(folder, "alpha.air", "0 0 0", dictionaries.nonuniform(1 - water))


class Comparison(grainjet.Case):
    """jetKEpsilon beside kEpsilon in one solver."""

    def prepare(self, solver, phases=()):
        """The case; phases: those with turbulence of their own, if any have."""
        self.solver, self.phases = solver, phases
        write(self.folder, solver)
        if phases and "Euler" not in solver:
            dictionaries.write(self.folder/"constant/turbulenceProperties", "simulationType twoPhaseTransport;")
        self.foam("blockMesh")
        self.foam("decomposePar")

    def results(self, model, ranks=0, **coefficients):
        """{file: contents} of all fields after the last step."""
        for name in [f"turbulenceProperties.{phase}" for phase in self.phases] or ["turbulenceProperties"]:
            box.write_turbulence(self.folder, model, name=name, **coefficients)
        self.log = self.foam(self.solver, ranks=ranks).output
        found = {}
        for root in sorted(self.folder.glob("processor*")) if ranks else [self.folder]:
            last = root/str(STEPS*DT)
            found.update({str(path.relative_to(self.folder)): path.read_text()
                          for path in last.iterdir() if path.is_file()})
            shutil.rmtree(last)
        self.assertTrue(any("/epsilon" in name for name in found))
        return found

    def assertSame(self, a, b):
        self.assertEqual([name for name in a if a[name] != b.get(name)], [])
        self.assertEqual(a.keys(), b.keys())

    def compare(self):
        """Bit for bit kEpsilon with its coefficients, and with those of jetKEpsilon; one result on 1 and 2 ranks."""
        for ranks in (0, 2):
            stock = self.results("kEpsilon", ranks)
            self.assertSame(stock, self.results("jetKEpsilon", ranks, **STOCK, roundJetCorrection="none"))
            if not ranks:
                jet = self.results("jetKEpsilon")
                self.assertIn("C1              1.52;", self.log)
                self.assertSame(self.results("kEpsilon", **JET), jet)
                self.assertNotEqual(stock, jet, "the defaults must differ")
        self.compare_ranks()

    def compare_ranks(self):
        """With Pope's correction; the linear solvers leave 1e-11 of their own."""
        serial = self.results("jetKEpsilon", roundJetCorrection="Pope")
        parallel = self.results("jetKEpsilon", 2, roundJetCorrection="Pope")
        for name, text in serial.items():
            field = name.split("/")[-1]
            if field.split(".")[0] not in ("U", "k", "epsilon", "nut"):
                continue
            whole = self.internal(text).reshape(SIDE, SIDE, -1)
            halves = [self.internal(parallel[f"processor{rank}/{name}"]).reshape(SIDE, SIDE//2, -1) for rank in (0, 1)]
            self.assertLess(abs(numpy.concatenate(halves, axis=1) - whole).max(), 1e-6*abs(whole).max(), field)

    def internal(self, text):
        path = self.folder/"field"
        path.write_text(text)
        return numpy.array(dictionaries.internal(path))
