# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Solvers, meshes and fluids that grains cannot be coupled to: one error before the first momentum equation is
solved, which says why and what works, exit code 1."""
# processors: 2
# label: long

import unittest

import bad_case
from grainjet import coupled_box as box

THERMO = """
thermoType { type hePsiThermo; mixture pureMixture; transport const; thermo hConst;
             equationOfState perfectGas; specie specie; energy sensibleInternalEnergy; }
mixture { specie { molWeight 28.9; } thermodynamics { Cp 1007; Hf 0; } transport { mu 1.8e-5; Pr 0.7; } }
"""

TWO_PHASES = """
phases (water air);
water { transportModel Newtonian; nu 1e-6; rho 1000; }
air { transportModel Newtonian; nu 1.5e-5; rho 1.2; }
sigma 0.07;
"""


class Fluids(bad_case.BadCase):

    def solution(self, folder, algorithm):
        self.change(folder, "system/fvSolution", ("PIMPLE", algorithm))

    # solvers

    def compressible(self, density="rho [1 -3 0 0 0 0 0] 1.2;"):
        folder = self.fresh()
        self.put(folder, "constant/thermophysicalProperties", THERMO)
        (folder / "constant/transportProperties").unlink()
        self.field(folder, "p", "[1 -1 -2 0 0 0 0]", "1e5")
        self.field(folder, "T", "[0 0 0 1 0 0 0]", "300")
        self.change(folder, "system/fvSolution", ("solvers\n{", "solvers\n{ \"rho.*\" { solver diagonal; }"))
        return folder

    def test_compressible(self):
        """Before the user is asked for transportProperties and rho."""
        for ranks in (0, 2):
            folder = self.compressible()
            if ranks:
                self.assertEqual(bad_case.grainjet.run(["decomposePar", "-force"], folder).code, 0)
            self.assertRefused(folder, "rhoPimpleFoam is a compressible solver", "incompressible", "pimpleFoam",
                               "constant/fvOptions", solver="rhoPimpleFoam", ranks=ranks)

    def test_multiphase(self):
        folder = self.fresh()
        self.put(folder, "constant/transportProperties", TWO_PHASES)
        self.put(folder, "constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 0 -9.81);\n",
                 "uniformDimensionedVectorField")
        self.field(folder, "p_rgh", "[1 -1 -2 0 0 0 0]", "0")
        self.field(folder, "alpha.water", "[0 0 0 0 0 0 0]", "0.5")
        self.change(folder, "system/fvSolution", (
            "solvers\n{", 'solvers\n{ "alpha.*" { nAlphaCorr 1; nAlphaSubCycles 1; cAlpha 1; }'))
        self.change(folder, "system/controlDict", ("deltaT", "adjustTimeStep no; maxCo 1; maxAlphaCo 1; deltaT"))
        self.assertRefused(folder, "interFoam is a multiphase solver", "alpha.", "incompressible",
                           "constant/fvOptions", solver="interFoam")

    def test_steady(self):
        folder = self.fresh()
        self.solution(folder, "SIMPLE")
        self.assertRefused(folder, "simpleFoam is a steady solver", "constant/fvOptions", solver="simpleFoam")

    def test_schemes_without_a_common_time(self):
        for scheme in ("steadyState", "localEuler", "bounded CoEuler phi"):
            folder = self.fresh()
            self.change(folder, "system/fvSchemes", ("default Euler", f"default Euler; ddt(U) {scheme}"))
            self.assertRefused(folder, "ddtSchemes", "ddt(U)", "fvSchemes")

    def test_other_solvers_work(self):
        """pisoFoam, and pimpleFoam with a mesh that is called dynamic but stands still."""
        folder = self.fresh()
        self.solution(folder, "PISO")
        self.assertRuns(folder, solver="pisoFoam")
        folder = self.fresh()
        self.put(folder, "constant/dynamicMeshDict", "dynamicFvMesh staticFvMesh;\n")
        self.assertRuns(folder)

    def buoyant(self, folder):
        """What the solvers for buoyant and rotating flow need besides."""
        self.put(folder, "constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 0 -9.81);\n",
                 "uniformDimensionedVectorField")
        self.change(folder, "constant/transportProperties", (
            "nu [0 2", "beta [0 0 0 -1 0 0 0] 3e-3; TRef [0 0 0 1 0 0 0] 300; Pr [0 0 0 0 0 0 0] 0.7; "
            "Prt [0 0 0 0 0 0 0] 0.85; nu [0 2"))
        self.field(folder, "T", "[0 0 0 1 0 0 0]", "300")
        self.field(folder, "p_rgh", "[0 2 -2 0 0 0 0]", "0",
                   'boundaryField { ".*" { type fixedFluxPressure; rho rhok; value uniform 0; } }\n')
        self.field(folder, "alphat", "[0 2 -1 0 0 0 0]", "0",
                   'boundaryField { ".*" { type calculated; value uniform 0; } }\n')
        self.change(folder, "system/fvSolution", ('"U.*"', '"(U|T).*"'))

    def test_buoyant_flow_works(self):
        """Incompressible with a field rhok, which is no density."""
        folder = self.fresh()
        self.buoyant(folder)
        result = self.assertRuns(folder, solver="buoyantBoussinesqPimpleFoam")
        self.assertIn("liggghtsCoupling: grains 1", result.output)

    def test_rotating_frame(self):
        folder = self.fresh()
        (folder / "0/Urel").write_text((folder / "0/U").read_text().replace("object U", "object Urel"))
        self.put(folder, "constant/SRFProperties", "SRFModel rpm; origin (0 0 0); axis (0 0 1); rpmCoeffs { rpm 10; }\n")
        box.fv_options(folder, U="Urel")
        self.assertRefused(folder, "SRFPimpleFoam", "rotating frame", "constant/fvOptions", solver="SRFPimpleFoam")

    # meshes

    def test_changing_meshes(self):
        for mesh, more in (
                ("dynamicRefineFvMesh", "correctFluxes ((phi none)); dumpLevel no; refineInterval 10;"),
                ("dynamicMotionSolverFvMesh", 'motionSolverLibs ("libfvMotionSolvers.so"); '
                 "motionSolver solidBody; solidBodyMotionFunction linearMotion; "
                 "linearMotionCoeffs { velocity (1 0 0); }")):
            folder = self.fresh()
            self.put(folder, "constant/dynamicMeshDict", f"dynamicFvMesh {mesh}; {more}\n")
            self.assertRefused(folder, mesh, "a mesh that does not move", "dynamicMeshDict", "constant/fvOptions")

    # fields

    def test_velocity_of_another_name(self):
        for ranks in (0, 2):
            folder = self.fresh()
            box.fv_options(folder, U="Ugas")
            self.assertRefused(folder, "U Ugas", "momentum equation is for U", "constant/fvOptions", ranks=ranks)
        box.fv_options(folder, U="p")
        self.assertRefused(folder, "U p", "momentum equation is for U", "constant/fvOptions")

    def test_velocity_of_another_equation(self):
        """A field that exists, but is not what the momentum equation is for (here the one of the time before,
        which OpenFOAM reads if it is there): said when the solver asks for its sources."""
        for ranks in (0, 2):
            folder = self.fresh()
            self.field(folder, "U_0", "[0 1 -1 0 0 0 0]", "(0 0 0)", 'boundaryField { ".*" { type noSlip; } }\n')
            self.assertEqual(bad_case.grainjet.run(["decomposePar", "-force"], folder).code, 0)
            box.fv_options(folder, U="U_0")
            self.assertRefused(folder, "U U_0", "momentum equation is for U", "constant/fvOptions", ranks=ranks)

    def test_pressure_of_another_name(self):
        folder = self.fresh()
        box.fv_options(folder, p="pp")
        self.assertRefused(folder, "p pp", "no volScalarField", "constant/fvOptions")
        box.fv_options(folder, p="U")
        self.assertRefused(folder, "p U", "no volScalarField", "constant/fvOptions")

    def test_dimensions_of_fields(self):
        folder = self.fresh()
        self.change(folder, "0/p", ("[0 2 -2 0 0 0 0]", "[1 -1 -2 0 0 0 0]"))
        self.assertRefused(folder, "p p", "dimensions", "[0 2 -2 0 0 0 0]", "constant/fvOptions")
        folder = self.fresh()
        self.change(folder, "0/U", ("[0 1 -1 0 0 0 0]", "[0 1 0 0 0 0 0]"))
        self.assertRefused(folder, "dimensions")

    # numbers of the fluid

    def test_density(self):
        for ranks, text in ((0, "rho [1 -3 0 0 0 0 0] 0;"), (2, "rho [1 -3 0 0 0 0 0] -1;"),
                            (0, "rho [1 -3 0 0 0 0 0] 1e300;"), (0, "rho [1 -3 0 0 0 0 0] nan;"),
                            (0, "rho [0 2 -1 0 0 0 0] 1.2;"), (2, "rho [0 2 -1 0 0 0 0] 1.2;"),
                            (0, "rho air;"), (0, "rho ;"), (0, "rho (1 2);"), (0, "rho { a 1; }"),
                            (0, "rho 1 2;")):
            with self.subTest(text=text, ranks=ranks):
                folder = self.fresh()
                self.change(folder, "constant/transportProperties", ("rho [1 -3 0 0 0 0 0] 1.2;", text))
                self.assertRefused(folder, "rho", "transportProperties", ranks=ranks)

    def test_viscosity(self):
        for ranks, value in ((0, "0"), (2, "0"), (0, "-1e-5"), (0, "1e300"), (0, "1e-300")):
            with self.subTest(value=value, ranks=ranks):
                folder = self.fresh()
                self.change(folder, "constant/transportProperties", ("1.5e-05", value))
                self.assertRefused(folder, "nu", "transportProperties", ranks=ranks)

    # turbulence

    def chen_wood(self, folder, **more):
        box.fv_options(folder, turbulenceSources="ChenWood", **more)

    def test_sources_need_k_and_epsilon(self):
        for model, fields, kind, word in (
                ("kOmegaSST", ("k", "omega"), "RAS", "kOmegaSST"), ("kEqn", ("k",), "LES", "kEqn"),
                ("Smagorinsky", ("k",), "LES", "Smagorinsky"),
                ("LienCubicKE", ("k", "epsilon"), "RAS", "LienCubicKE")):
            with self.subTest(model=model):
                folder = self.fresh()
                self.turbulent(folder, model, *fields, kind=kind)
                self.chen_wood(folder)
                self.assertRefused(folder, "turbulenceSources ChenWood", "k and epsilon", word, "constant/fvOptions")

    def test_sources_in_laminar_flow(self):
        for ranks in (0, 2):
            folder = self.fresh()
            self.chen_wood(folder)
            self.assertRefused(folder, "turbulenceSources ChenWood", "k and epsilon", "laminar",
                               "constant/fvOptions", ranks=ranks)

    def test_sources_one_way_or_switched_off(self):
        folder = self.fresh()
        self.turbulent(folder, "kEpsilon", "k", "epsilon")
        self.chen_wood(folder, coupling="oneWay")
        self.assertRefused(folder, "turbulenceSources ChenWood", "twoWay", "constant/fvOptions")
        self.chen_wood(folder)
        self.change(folder, "constant/turbulenceProperties", ("turbulence on", "turbulence off"))
        self.assertRefused(folder, "turbulenceSources ChenWood", "turbulence off", "constant/fvOptions")
        self.change(folder, "constant/turbulenceProperties", ("turbulence off", "turbulence on"))
        self.assertRuns(folder)


if __name__ == "__main__":
    unittest.main()
