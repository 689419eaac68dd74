# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a continued run lacks is an error that names file and time, never a fresh start; and so is
a script that does not continue the grains it is given."""
# processors: 2
# label: long

import re
import shutil
import unittest

import grainjet
from grainjet import coupled_box as box
from grainjet.coupled_box import end_at, swarm

LAST = "0.0004"


class Missing(grainjet.Case):

    def first_run(self, ranks=0, name="case", steps=4, every=4, grains=None, convection="linear", **script):
        folder = self.folder / name
        box.write(folder, steps=steps, write_every=every, walls=True, convection=convection)
        x, v = swarm(5, 3) if grains is None else grains
        box.script(folder, grains=box.grains(x, v), **script)
        box.fv_options(folder)
        self.foam("blockMesh", folder)
        if ranks:
            self.foam("decomposePar", folder)
        self.foam("pimpleFoam", folder, ranks)
        end_at(folder, steps + 2)
        return folder

    def go_on(self, folder, ranks=0, check=False):
        return self.foam("pimpleFoam", folder, ranks, check=check, timeout=120)

    def assertRefused(self, folder, *words, ranks=0):
        def state():
            return {path: path.read_bytes() for path in folder.glob(f"**/{LAST}/**/*")
                    if path.is_file() and "postProcessing" not in path.parts}

        before = state()
        result = self.go_on(folder, ranks)
        self.assertFails(result, *words)
        self.assertNotRegex(result.output, box.SOLVED)
        self.assertEqual(before, state())

    def damaged(self, good, damage, ranks=0):
        bad = self.folder / "bad"
        shutil.rmtree(bad, ignore_errors=True)
        shutil.copytree(good, bad)
        damage(bad / ("processor0" if ranks else "") / LAST)
        return bad

    @staticmethod
    def cut(path, to):
        with open(path, "r+b") as file:
            file.truncate(int(path.stat().st_size * to))

    def check_files(self, ranks):
        good = self.first_run(ranks)
        grains = "uniform/liggghts.restart"
        table = [
            (lambda t: (t / grains).unlink(), "grains of time 0.0004 are missing"),
            (lambda t: (t / grains).rename(t / (grains + ".partial")), "grains of time 0.0004 are missing"),
            (lambda t: shutil.rmtree(t / "uniform"), "grains of time 0.0004 are missing"),
            (lambda t: self.cut(t / grains, 0), "has 0 bytes instead of"),
            (lambda t: self.cut(t / grains, 0.7), "bytes instead of"),
            (lambda t: (t / "uniform/liggghtsCouplingProperties").unlink(), "liggghtsCouplingProperties"),
            (lambda t: self.cut(t / "uniform/liggghtsCouplingProperties", 0.6), "liggghtsCouplingProperties"),
            (lambda t: (t / "particleMomentumOwed").unlink(), "particleMomentumOwed"),
            (lambda t: self.cut(t / "particleMomentumOwed", 0), "particleMomentumOwed"),
            (lambda t: self.cut(t / "particleMomentumOwed", 0.5), "particleMomentumOwed"),
            (lambda t: (t / "phi").unlink(), "/phi"),
            (lambda t: self.cut(t / "phi", 0), "/phi"),
        ]
        if ranks:
            table = table[::4]
        for number, (damage, words) in enumerate(table):
            with self.subTest(number=number, words=words):
                self.assertRefused(self.damaged(good, damage, ranks), words, LAST, ranks=ranks)
        self.assertIn("continued grains", self.go_on(good, ranks, check=True).output)

    def test_files(self):
        self.check_files(0)

    def test_files_parallel(self):
        self.check_files(2)

    def test_message(self):
        """Once for all ranks, and with the folder of the time that is incomplete, although the solver has begun
        the step after it."""
        for ranks, part in ((0, ""), (2, "processor0/")):
            with self.subTest(ranks=ranks):
                good = self.first_run(ranks, name=f"good{ranks}")
                bad = self.damaged(good, lambda t: (t / "uniform/liggghts.restart").unlink(), ranks)
                result = self.go_on(bad, ranks)
                self.assertFails(result, f'Remove the folder "{part}{LAST}"', f'in "{part}{LAST}"')
                self.assertEqual(result.output.count("FOAM FATAL"), 1, result)

    def test_missing_on_one_rank_only(self):
        good = self.first_run(2)
        for name in ("particleMomentumOwed", "phi"):
            with self.subTest(name=name):
                bad = self.damaged(good, lambda t: (t.parents[1] / "processor1" / LAST / name).unlink(), 2)
                self.assertRefused(bad, name, LAST, ranks=2)

    def test_old_time_of_a_second_order_scheme(self):
        """The flow of a step before, which OpenFOAM would do without silently."""
        folder = self.folder / "case"
        box.write(folder, steps=4, walls=True)
        schemes = folder / "system/fvSchemes"
        schemes.write_text(schemes.read_text().replace("default Euler", "default backward"))
        box.script(folder, grains=box.grains(*swarm(5, 3)))
        box.fv_options(folder)
        self.foam("blockMesh", folder)
        self.foam("pimpleFoam", folder)
        end_at(folder, 6)
        self.assertIn("continued grains", self.go_on(folder, check=True).output)
        shutil.rmtree(folder / "0.0006", ignore_errors=True)
        (folder / LAST / "U_0").unlink()
        self.assertRefused(folder, "U_0", LAST)

    def test_killed_in_the_first_write(self):
        """Nothing of the coupling is there yet: the table of the balance proves that grains are."""
        folder = self.first_run()
        shutil.rmtree(folder / LAST / "uniform")
        for name in ("voidFraction", "particleVelocity", "dragCoefficient", "particleMomentumSource",
                     "particleMomentumOwed", "momentumOfLostGrains"):
            (folder / LAST / name).unlink()
        self.assertRefused(folder, "grains of time 0.0004 are missing", "balance.dat")
        # as the message says: without the trace it is another flow to begin in
        shutil.rmtree(folder / "postProcessing")
        self.assertIn("5 new grains", self.go_on(folder, check=True).output)

    def test_new_grains_in_a_flow_without_grains(self):
        """A developed flow of a run without coupling is a place to begin."""
        folder = self.folder / "case"
        box.write(folder, steps=4, walls=True)
        self.foam("blockMesh", folder)
        self.foam("pimpleFoam", folder)
        end_at(folder, 6)
        box.script(folder, grains=box.grains(*swarm(5, 3)))
        box.fv_options(folder)
        self.assertIn("5 new grains", self.go_on(folder, check=True).output)

    @staticmethod
    def has_come_to(log, time, words):
        """Whether a log holds words (a pattern) in a step later than a time."""
        steps = list(re.finditer(r"(?m)^Time = (\S+)$", log))
        later = [step for step in steps if float(step[1]) > time]
        return bool(later and re.search(words, log[later[0].start():]))

    def test_kill(self):
        """Killed at any moment, a run goes on bit for bit or says what is incomplete. Without that time it goes on."""
        whole = self.first_run(steps=40, every=1, name="whole")
        end_at(whole, 40)
        killed = self.folder / "killed"
        # the time after which it is killed, and what it does then: a step's begin, momentum, pressure, end
        for moment, words in ((0.0006, "Time = "), (0.002, "liggghtsCoupling: grains"), (0.0025, "GAMG|PCG"),
                              (0.0036, "ExecutionTime")):
            shutil.rmtree(killed, ignore_errors=True)
            shutil.copytree(whole, killed, ignore=shutil.ignore_patterns("0.0*", "postProcessing", "log*"))
            with grainjet.start(["pimpleFoam"], killed, killed / "log.killed") as run:
                run.wait_for(lambda: self.has_come_to(run.printed(), moment, words), f"'{words}' after {moment} s")
            result = self.go_on(killed)
            if result.code:
                self.assertTrue("was written by a coupled run" in result.output
                                or "FOAM FATAL IO ERROR" in result.output
                                or "cannot find file" in result.output, result)
                shutil.rmtree(max((path for path in killed.glob("0.0*")), key=lambda path: float(path.name)))
                result = self.go_on(killed, check=True)
            self.assertIn("continued grains", result.output)
            for field in ("U", "p", "phi", "particleMomentumOwed"):
                self.assertEqual((whole / "0.004" / field).read_bytes(),
                                 (killed / "0.004" / field).read_bytes(), field)

    # ---- scripts

    def edit(self, folder, *pairs):
        script = folder / "constant/in.particles"
        text = script.read_text()
        for old, new in pairs:
            self.assertIn(old, text)
            text = text.replace(old, new)
        script.write_text(text)

    def test_grains_that_are_not_read(self):
        """With and without a run of its own, which used to make the DEM step look like that of a
        continued run. The text that the message recommends works as it is printed."""
        for run in ("", "run 1", "run 40"):
            with self.subTest(run=run):
                shutil.rmtree(self.folder / "case", ignore_errors=True)
                folder = self.first_run()
                self.edit(folder, ('if "${continued}" then "jump SELF continued"\n', ""), ("thermo 1000", run))
                result = self.go_on(folder)
                self.assertFails(result, "has not read its grains from 0.0004/uniform/liggghts.restart",
                                 'if "${continued}" then "jump SELF continued"')

                said = result.output[result.output.index('    if "${continued}"'):]
                said = said[:said.index("label ready") + len("label ready")]
                said = said.replace("region box block ...", "region box block 0 0.02 0 0.02 0 0.04 units box")
                script = folder / "constant/in.particles"
                text = script.read_text()
                start, stop = text.index("include constant/new.grains"), text.index("label ready\n")
                script.write_text(text[:start] + said + text[stop + len("label ready"):].replace(run, ""))
                self.assertIn("5 continued grains", self.go_on(folder, check=True).output)

    def test_grains_of_another_file(self):
        folder = self.first_run(steps=4, every=2)
        self.edit(folder, ("read_restart ${restart}", "read_restart 0.0002/uniform/liggghts.restart"))
        self.assertRefused(folder, "of DEM step 20, not 40", "read_restart ${restart}")

    def test_run_that_is_made_again(self):
        """The text that the message recommends works as it is printed; run 0 moves nothing."""
        folder = self.first_run()
        self.edit(folder, ("thermo 1000", "run 7"))
        result = self.go_on(folder)
        self.assertFails(result, "from DEM step 40", "to step 47", 'if "${continued} == 0" then "run 1000"')
        self.edit(folder, ("run 7", 'if "${continued} == 0" then "run 7"\nrun 0'))
        self.assertIn("5 continued grains", self.go_on(folder, check=True).output)
        shutil.rmtree(folder / LAST)
        self.assertIn("5 new grains", self.go_on(folder, check=True).output)

    def test_grains_that_are_made_again(self):
        folder = self.first_run()
        self.edit(folder, ("thermo 1000", "run 0\ngroup one id 1\ndelete_atoms group one"))
        self.assertRefused(folder, "makes 4 grains of the 5 of 0.0004/uniform/liggghts.restart")

    def test_another_name_of_the_fix(self):
        folder = self.first_run()
        self.edit(folder, ("fix fluid all", "fix another all"))
        self.assertRefused(folder, "gives fix fluid/force another ID", "0.0004/uniform/liggghts.restart")

    # ---- files that are whole but wrong

    @staticmethod
    def overwrite(path, bytes_at):
        with open(path, "r+b") as file:
            for at, value in bytes_at:
                file.seek(at)
                file.write(value)

    def test_damaged_grains(self):
        """One bit, or nothing but zeros as after a power cut: LIGGGHTS would go on, crash, or print without end."""
        for ranks in (0, 2):
            good = self.first_run(ranks, name=f"case{ranks}")
            grains = "uniform/liggghts.restart"
            size = next(good.glob(f"**/{LAST}/{grains}")).stat().st_size
            middle = next(good.glob(f"**/{LAST}/{grains}")).read_bytes()[size // 2]
            for what in ([(size // 2, bytes([middle ^ 16]))], [(0, bytes(size))]):
                bad = self.damaged(good, lambda t: self.overwrite(t / grains, what), ranks)
                self.assertRefused(bad, "is damaged: its checksum differs", LAST, ranks=ranks)

    def test_grains_of_another_time(self):
        folder = self.first_run(steps=4, every=2)
        for name in ("liggghts.restart", "liggghtsCouplingProperties"):
            shutil.copy(folder / "0.0002/uniform" / name, folder / LAST / "uniform" / name)
        self.assertRefused(folder, "The grains in time 0.0004 were written at time 0.0002", "liggghtsCouplingProperties")

        # a folder renamed on purpose: the message says how to go on
        shutil.rmtree(folder / LAST)
        (folder / "0.0002").rename(folder / LAST)
        shutil.rmtree(folder / "postProcessing")
        self.assertRefused(folder, "set the entry time of")
        properties = folder / LAST / "uniform/liggghtsCouplingProperties"
        text = properties.read_text()
        self.assertRegex(text, r"\ntime +0.0002;")
        properties.write_text(text.replace("0.0002;", "0.0004;"))
        shutil.rmtree(folder / "0.0002", ignore_errors=True)
        self.assertIn("continued grains", self.go_on(folder, check=True).output)

    def test_begun_again_where_it_began(self):
        """Initial conditions at 0.5, run twice from there: new grains both times."""
        folder = self.first_run()
        for path in folder.glob("0.0*"):
            shutil.rmtree(path)
        shutil.rmtree(folder / "postProcessing", ignore_errors=True)
        (folder / "0").rename(folder / "0.5")
        control = folder / "system/controlDict"
        text = control.read_text()
        control.write_text(text + "\nstartFrom startTime;\nstartTime 0.5;\nendTime 0.5004;\n")
        for _ in range(2):
            self.assertIn("new grains", self.go_on(folder, check=True).output)

    def test_missing_on_one_rank_with_master_reading(self):
        """Ranks that read through the master must all come to the error, none waits for another one."""
        good = self.first_run(2)
        control = good / "system/controlDict"
        control.write_text(control.read_text() + '\nOptimisationSwitches { fileHandler masterUncollated; }\n')
        for processor in ("processor0", "processor1"):
            bad = self.damaged(good, lambda t: (t.parents[1] / processor / LAST / "particleMomentumOwed").unlink(), 2)
            self.assertRefused(bad, "particleMomentumOwed", LAST, ranks=2)

    # ---- the log, and two runs at once

    def test_log_is_kept(self):
        folder = self.first_run()
        first = (folder / "log.liggghts").read_text()
        self.go_on(folder, check=True)
        self.assertTrue((folder / "log.liggghts").read_text().startswith(first))

    def test_two_runs_in_one_case(self):
        for log in ('"log.liggghts"', "none"):
            with self.subTest(log=log):
                self.two_runs(log)

    def two_runs(self, log):
        folder = self.first_run(name="case-" + log.strip(chr(34))[:4])
        box.fv_options(folder, log=log)
        end_at(folder, 100000)
        control = folder / "system/controlDict"
        control.write_text(control.read_text().replace("writeInterval 4", "writeInterval 100000"))
        with grainjet.start(["pimpleFoam"], folder, folder / "log.other") as other:
            other.wait_for_words("\nTime = ")
            self.assertFails(self.go_on(folder), "Another run works in")
            self.assertIsNone(other.process.poll(), "the other run ended by itself")
        end_at(folder, 6)
        self.assertEqual(self.go_on(folder).code, 0)


if __name__ == "__main__":
    unittest.main()
