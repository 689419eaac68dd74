# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which kind of fluid a solver has. Solvers, meshes and fluids that grains cannot be coupled to: one error before the
first momentum equation is solved, which says why and what works, exit code 1."""
# processors: 2
# label: long

import unittest

import bad_case
import fluid_cases
from grainjet import coupled_box as box

THERMO = """
thermoType { type hePsiThermo; mixture pureMixture; transport const; thermo hConst;
             equationOfState perfectGas; specie specie; energy sensibleInternalEnergy; }
mixture { specie { molWeight 28.9; } thermodynamics { Cp 1007; Hf 0; } transport { mu 1.8e-5; Pr 0.7; } }
"""


class Fluids(bad_case.BadCase):

    def solution(self, folder, algorithm):
        self.change(folder, "system/fvSolution", ("PIMPLE", algorithm))

    # solvers

    def gravity(self, folder, g=9.81, direction="0 0 -1"):
        """A script with gravity."""
        box.script(folder, grains=bad_case.GRAIN, boundary="f f f", gravity=f"fix g all gravity {g} vector {direction}")

    def compressible(self):
        folder = self.fresh()
        self.put(folder, "constant/thermophysicalProperties", THERMO)
        (folder / "constant/transportProperties").unlink()
        self.field(folder, "p", "[1 -1 -2 0 0 0 0]", "1e5")
        self.field(folder, "T", "[0 0 0 1 0 0 0]", "300")
        self.change(folder, "system/fvSolution", (
            "solvers\n{", "solvers\n{ \"rho.*\" { solver diagonal; }"), ('"U.*"', '"(U|e).*"'))
        return folder

    def transonic(self):
        folder = self.compressible()
        self.change(folder, "system/fvSolution", ("solver PCG; preconditioner DIC", "solver PBiCGStab; preconditioner DILU"))
        return folder

    def kind(self, make, g=-9.81):
        """A folder with water and air, or another kind of fluid with gravity, and a script with that gravity."""
        folder = self.fresh()
        make(folder, (0, 0, g))
        self.gravity(folder)
        return folder

    def water(self, **more):
        return self.kind(lambda folder, g: fluid_cases.inter_foam(folder, "0.5", g), **more)

    def air(self):
        return self.kind(lambda folder, g: fluid_cases.buoyant_pimple(folder, "1e5", g))

    def warm(self):
        return self.kind(lambda folder, g: fluid_cases.boussinesq(folder, "300", g))

    def with_gravity(self):
        return ((self.water, "interFoam"), (self.warm, "buoyantBoussinesqPimpleFoam"), (self.air, "buoyantPimpleFoam"))

    def test_kinds_are_found_out(self):
        """No entry says which kind of fluid it is. On two ranks as well."""
        for make, solver, kind in (
                (self.compressible, "rhoPimpleFoam", "compressible"), (self.transonic, "sonicFoam", "compressible"),
                (self.water, "interFoam", "VOF"), (self.water, "interIsoFoam", "VOF"),
                (self.warm, "buoyantBoussinesqPimpleFoam", "Boussinesq"),
                (self.air, "buoyantPimpleFoam", "buoyantCompressible")):
            with self.subTest(solver=solver):
                folder = make()
                result = self.assertRuns(folder, solver=solver)
                self.assertIn("liggghtsCoupling: grains 1", result.output)
                self.assertIn(f"Fluid: {kind}\n", result.output)
        folder = self.water()
        self.assertEqual(bad_case.grainjet.run(["decomposePar", "-force"], folder).code, 0)
        self.assertRuns(folder, solver="interFoam", ranks=2)

    def test_entry_that_does_not_fit(self):
        """Before the user is asked for transportProperties and rho."""
        for make, solver, entry, words in (
                (self.compressible, "rhoPimpleFoam", "incompressible", ("compressible solver", "pimpleFoam and pisoFoam")),
                (self.water, "interFoam", "incompressible", ("multiphase solver", "alpha.")),
                (self.warm, "buoyantBoussinesqPimpleFoam", "incompressible", ("not uniform", "rhok")),
                (self.fresh, "pimpleFoam", "VOF", ("phase fraction", "interFoam and interIsoFoam")),
                (self.fresh, "pimpleFoam", "Boussinesq", ("rhok",)),
                (self.air, "buoyantPimpleFoam", "compressible", ("p_rgh", "rhoPimpleFoam and sonicFoam")),
                (self.compressible, "rhoPimpleFoam", "buoyantCompressible", ("p_rgh",))):
            with self.subTest(solver=solver, entry=entry):
                folder = make()
                box.fv_options(folder, fluid=entry)
                self.assertRefused(folder, f"fluid {entry}", solver, "constant/fvOptions", *words, solver=solver)

    def test_gravity_of_the_script(self):
        """It must be that of the solver: both are named, with what to write."""
        for ranks in (0, 2):
            folder = self.water()
            box.script(folder, grains=bad_case.GRAIN, boundary="f f f")
            self.assertEqual(bad_case.grainjet.run(["decomposePar", "-force"], folder).code, 0)
            self.assertRefused(folder, "no fix gravity", "constant/g", "gravity 9.81 vector 0 0 -1", "fvOptions",
                               solver="interFoam", ranks=ranks)
        for make, solver in self.with_gravity():
            folder = make()
            self.gravity(folder, 9.8)
            self.assertRefused(folder, "gravity is (0 0 -9.8)", "(0 0 -9.81)", "gravity 9.81 vector 0 0 -1", solver=solver)
        folder = self.water(g=0)
        self.assertRefused(folder, "gravity is (0 0 -9.81)", "Take fix gravity out", solver="interFoam")

    def test_buoyancy_twice(self):
        """The pressure gradient holds buoyancy already."""
        for make, solver in self.with_gravity():
            folder = make()
            box.fv_options(folder, forces="(pressureGradient buoyancy)")
            self.assertRefused(folder, "pressureGradient holds buoyancy", "fvOptions", solver=solver)

    def test_full_equations_with_gravity_in_a_gas(self):
        folder = self.air()
        box.fv_options(folder, voidFraction=box.void_fraction("full"))
        self.assertRefused(folder, "equations full", "buoyantPimpleFoam", "equations neglected", "fvOptions",
                           solver="buoyantPimpleFoam")

    def test_without_p_rgh(self):
        """The solver itself asks for it."""
        folder = self.water()
        (folder / "0/p_rgh").unlink()
        self.assertRefused(folder, "p_rgh", solver="interFoam")

    def test_solvers_that_never_ask(self):
        """They would run as without grains."""
        for solver, other in (("rhoCentralFoam", "transonic yes"), ("icoFoam", "pimpleFoam")):
            for ranks in (0, 2):
                folder = self.fresh()
                self.assertRefused(folder, solver, "never asks", other, "constant/fvOptions", solver=solver, ranks=ranks,
                                   at_reading=True)
        folder = self.fresh()
        box.fv_options(folder, active="no")
        self.solution(folder, "PISO")
        self.assertRuns(folder, solver="icoFoam")

    def test_steady(self):
        folder = self.fresh()
        self.solution(folder, "SIMPLE")
        self.assertRefused(folder, "simpleFoam is a steady solver", "Take pimpleFoam", "constant/fvOptions", solver="simpleFoam")
        folder = self.compressible()
        self.solution(folder, "SIMPLE")
        self.assertRefused(folder, "rhoSimpleFoam is a steady solver", "Take rhoPimpleFoam", "constant/fvOptions",
                           solver="rhoSimpleFoam")

    def test_schemes_without_a_common_time(self):
        for scheme in ("steadyState", "localEuler", "bounded CoEuler phi"):
            folder = self.fresh()
            self.change(folder, "system/fvSchemes", ("default Euler", f"default Euler; ddt(U) {scheme}"))
            self.assertRefused(folder, "ddtSchemes", "ddt(U)", "fvSchemes")

    def test_once_for_all_ranks(self):
        """What each rank finds out by itself is printed by one of them."""
        for change, words, solver in (
                (lambda f: self.change(f, "system/fvSchemes", ("default Euler", "default localEuler")), ("has no time that all cells", "ddtSchemes"), "pimpleFoam"),
                (lambda f: self.solution(f, "SIMPLE"), ("is a steady solver",), "simpleFoam"),
                (lambda f: box.fv_options(f, fluid="VOF"), ("does not fit", "phase fraction"), "pimpleFoam"),
                (lambda f: self.put(f, "constant/dynamicMeshDict", "dynamicFvMesh dynamicRefineFvMesh; correctFluxes ((phi none)); "
                                    "dumpLevel no; refineInterval 10;\n"), ("a mesh that does not move",), "pimpleFoam")):
            with self.subTest(words=words):
                folder = self.fresh()
                change(folder)
                result = self.assertRefused(folder, *words, solver=solver, ranks=2)
                self.assertEqual(result.output.count(words[0]), 1, result)

    def test_other_solvers_work(self):
        """pisoFoam, and pimpleFoam with a mesh that is called dynamic but stands still."""
        folder = self.fresh()
        self.solution(folder, "PISO")
        self.assertRuns(folder, solver="pisoFoam")
        folder = self.fresh()
        self.put(folder, "constant/dynamicMeshDict", "dynamicFvMesh staticFvMesh;\n")
        self.assertRuns(folder)

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
