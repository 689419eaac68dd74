# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""fix plate/stats: files that exist and are not its own are never overwritten; its own are."""
# processors: 2
# label: long

import os
import unittest

from plate_case import D, PLATE, PlateCase

KEEP = "what somebody has measured\n1,2,3\n"


class OutputFiles(PlateCase):

    def setUp(self):
        super().setUp()
        self.data([(0, 0, D, 0, 0, -2.0)])
        (self.folder / "sub").mkdir()

    def plate(self, file="plate.csv", events="events.csv", name="p"):
        head, _ = PLATE.replace("fix p ", f"fix {name} ").split(" file ")
        return f"{head} file {file} events {events}"

    def snapshot(self):
        """All that lies in the folder but the script and the log."""
        return {p.relative_to(self.folder): (os.lstat(p).st_ino, os.lstat(p).st_mode,
                                             p.read_text() if p.is_file() and not p.is_symlink() else "")
                for p in self.folder.rglob("*") if p.name not in ("in.test", "log.liggghts")}

    def refused(self, body, *words, ranks=0, late=False):
        before = self.snapshot()
        script = self.script(f"{body}\nrun 100")
        result = self.liggghts(script, ranks, check=False)
        self.assertFails(result, "Fix plate/stats (ID ", *words)
        self.assertEqual(result.code, 1, result)
        self.assertEqual(result.output.count("ERROR"), 1, result)
        self.assertEqual((self.folder / "in.test").read_text(), script)
        if not late:
            self.assertNotIn("Setting up", result.output)
            self.assertEqual(self.snapshot(), before)
        return result

    def test_what_is_there_already(self):
        keep = self.folder / "keep.csv"
        keep.write_text(KEEP)
        (self.folder / "empty").write_text("")
        (self.folder / "half").write_text("region,r_in")
        os.mkfifo(self.folder / "pipe")
        (self.folder / "link").symlink_to("keep.csv")
        (self.folder / "dangling").symlink_to("nowhere")
        os.link(keep, self.folder / "hard")
        (self.folder / "old.csv.new").write_text(KEEP)
        cases = {"in.test": "in use by this run", "./in.test": "in use by this run",
                 "log.liggghts": "in use by this run", "keep.csv": "not overwritten",
                 "empty": "not overwritten", "half": "not overwritten", "pipe": "pipe",
                 "link": "symbolic link", "dangling": "symbolic link", "hard": "not overwritten",
                 "sub": "directory", ".": "directory", "/": "directory", "/dev/null": "device",
                 "/dev/stdout": "symbolic link", "/proc/self/exe": "symbolic link", "grains.data": "not overwritten",
                 "no/such/plate.csv": "cannot write", "keep.csv/plate.csv": "cannot write",
                 "x" * 300: "cannot write"}
        for path, words in cases.items():
            with self.subTest(path):
                self.refused(self.plate(file=path), path, words)
        for path in ("in.test", "log.liggghts", "keep.csv", "pipe", "dangling", "hard", "sub", "no/such/plate.csv"):
            with self.subTest(f"events {path}"):
                self.refused(self.plate(events=path), path, cases[path])
        self.refused(self.plate(file="old.csv"), "old.csv.new", "not overwritten")
        self.refused(self.plate(file="x" * 253), "cannot write")          # no room for .new
        self.refused(self.plate(file="in.test"), "in use by this run", ranks=2)
        self.refused(self.plate(events="keep.csv"), "not overwritten", ranks=2)
        self.refused(self.plate(file="no/such/plate.csv"), "cannot write", ranks=2)

    def test_own_files_are_written_again(self):
        """Also where a killed run has left half a table; who keeps an old file under another name (hard
        link) keeps it."""
        run = self.plate(file="sub/plate.csv") + "\nrun 1000"
        self.liggghts(self.script(run))
        table, events = (self.folder / n for n in ("sub/plate.csv", "events.csv"))
        text = table.read_text(), events.read_text()
        events.write_text(events.read_text() + "0.5," * 13 + "1\n")
        kept = events.read_text()
        for path, name in ((table, "old.csv"), (events, "old-events.csv")):
            os.link(path, self.folder / name)
        for half in ("", text[0][:20], text[0][:-30]):
            (self.folder / "sub/plate.csv.new").write_text(half)
            self.liggghts(self.script(run), 2)
            self.assertEqual((table.read_text(), events.read_text()), text)
            self.assertEqual((self.folder / "old.csv").read_text(), text[0])
            self.assertEqual((self.folder / "old-events.csv").read_text(), kept)
            self.assertFalse((self.folder / "sub/plate.csv.new").exists())

    def test_one_file_for_two(self):
        self.liggghts(self.script(self.plate() + "\nrun 1000"))           # old output of its own
        os.link(self.folder / "plate.csv", self.folder / "again.csv")
        os.link(self.folder / "events.csv", self.folder / "events2.csv")
        (self.folder / "way").symlink_to("sub")
        for events in ("plate.csv", "./plate.csv", "sub/../plate.csv", str(self.folder / "plate.csv"),
                       "plate.csv.new", "again.csv"):
            self.refused(self.plate(events=events), "are one file")
        self.refused(self.plate(events="plate.csv"), "are one file", ranks=2)
        self.refused(self.plate(file="new.csv", events="./new.csv"), "are one file")
        self.refused(self.plate(file="sub/new.csv", events="way/new.csv"), "are one file")

    def test_one_file_for_two_fixes(self):
        for other in (self.plate(file="plate.csv", events="e.csv", name="q"),
                      self.plate(file="./plate.csv", events="e.csv", name="q"),
                      self.plate(file="sub/../plate.csv", events="e.csv", name="q"),
                      self.plate(file="q.csv", events="./events.csv", name="q"),
                      self.plate(file="q.csv", events="plate.csv.new", name="q"),
                      self.plate(file="events.csv", events="e.csv", name="q")):
            for name in ("plate.csv", "events.csv", "q.csv", "e.csv"):
                (self.folder / name).unlink(missing_ok=True)
            result = self.liggghts(self.script(f"{self.plate()}\n{other}\nrun 100"), 2, check=False)
            self.assertFails(result, "Fix plate/stats (ID q)", "plate/stats (ID p)", "another path")
            self.assertEqual(result.output.count("ERROR"), 1, result)
        # hard links of old output
        self.liggghts(self.script(self.plate() + "\nrun 100"))
        os.link(self.folder / "plate.csv", self.folder / "again.csv")
        result = self.liggghts(self.script(
            f"{self.plate()}\n{self.plate(file='again.csv', events='e.csv', name='q')}\nrun 100"), check=False)
        self.assertFails(result, "Fix plate/stats (ID q)", "plate/stats (ID p)")
        # the same name once more replaces the fix, and two names with files of their own live together
        self.liggghts(self.script(f"{self.plate()}\n{self.plate()}\n"
                                  f"{self.plate(file='q.csv', events='e.csv', name='q')}\nrun 1000"))
        self.assertEqual((self.folder / "q.csv").read_text(), (self.folder / "plate.csv").read_text())

    def test_files_of_other_commands(self):
        """Known at the start of the run, whichever comes first."""
        dump = "dump d all custom 10 {} id x"
        note = "fix note all print 10 \"step\" file {} screen no"
        turn = 0
        for path in ("plate.csv", "events.csv", "plate.csv.new"):
            for other, words in ((dump, "dump d"), (note, "in use by this run"), ("log {}", "in use by this run")):
                turn += 1
                order = ("{0}\n{1}", "{1}\n{0}")[turn % 2]
                for name in ("plate.csv", "events.csv", "plate.csv.new"):
                    (self.folder / name).unlink(missing_ok=True)
                with self.subTest((path, other, order)):
                    result = self.refused(order.format(self.plate(), other.format(path)), path, words, late=True)
                    self.assertNotIn("Setting up", result.output)

    def test_a_file_that_changes_during_the_run(self):
        """What has taken the place of the table stays; the statistics are beside it, with a word."""
        (self.folder / "other.csv").write_text(KEEP)
        for ranks in (0, 2):
            result = self.liggghts(self.script(
                f"{self.plate()}\nrun 500\nshell cp other.csv plate.csv\nrun 500\nrun 10"), ranks)
            self.assertEqual(result.output.count("'plate.csv.new'"), 1)
            self.assertEqual((self.folder / "plate.csv").read_text(), KEEP)
            self.assertEqual(self.table("plate.csv.new")["all"]["collisions"], 1)
            (self.folder / "plate.csv").unlink()

    def test_events_of_a_continued_run(self):
        """They are needed where the restart file left them; another path may begin a new file."""
        self.data([(0.0005, 0, D, 0, 0, -2.0), (0.0015, 0, 4 * D, 0, 0, -2.0)])
        self.liggghts(self.script(f"{self.plate()}\nrun 800\nwrite_restart r.restart"))
        read = "read_restart r.restart"
        (self.folder / "events.csv").rename(self.folder / "away.csv")
        for ranks in (0, 2):
            result = self.liggghts(self.script(self.plate(), read=read), ranks, check=False)
            self.assertFails(result, "Fix plate/stats (ID p)", "'events.csv'", "t = 8e-05 s", "is missing")
        os.mkfifo(self.folder / "pipe")
        result = self.liggghts(self.script(self.plate(events="pipe"), read=read), check=False)
        self.assertFails(result, "'pipe'", "regular file")
        self.liggghts(self.script(f"{self.plate(events='later.csv')}\nrun 2000", read=read))
        self.assertEqual([e["id"] for e in self.events("later.csv")], [2])
        self.liggghts(self.script(f"{self.plate(events='away.csv')}\nrun 2000", read=read))
        self.assertEqual([e["id"] for e in self.events("away.csv")], [1, 2])


if __name__ == "__main__":
    unittest.main()
