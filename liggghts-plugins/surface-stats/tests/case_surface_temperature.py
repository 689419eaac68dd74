# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""fix surface/stats where grains have a temperature (property Temp): that at the first contact is in the table and in the
events, and all else stays as it is without.
"""
# processors: 2

import csv
import unittest

from surface_case import D, STATS, SurfaceCase, sheet

TEMP = "fix Temp all property/atom Temp scalar yes yes no 300"
EACH = "run 0\nvariable T atom 300+id^2\nset group all property/atom Temp v_T\n"
GRAINS = [(0.001 * (i - 3), 0.0003 * i, (2 * i + 1) * D, 0.5, 0, -2.0 - 0.1 * i) for i in range(6)]
FILES = ("table.csv", "events.csv", "spectra.csv")


class Temperature(SurfaceCase):

    def without_temperature(self, name):
        """The text of a file with its columns of temperatures taken out."""
        with open(self.folder / name, newline="") as file:
            rows = list(csv.reader(file))
        kept = [i for i, column in enumerate(rows[0]) if not column.startswith("temperature")]
        return "".join(",".join(row[i] for i in kept) + "\n" for row in rows)

    def test_table_and_events(self):
        """Each grain has its own temperature: exact in the events, the mean is theirs, on 1 and 2 ranks and over a restart in
        the middle of a contact. All other columns and files are those of a run without, byte for byte."""
        self.data(GRAINS)
        self.mesh(sheet())
        body = "{}\n" + STATS + "\n{}run 1050\n{}run 5000"
        self.liggghts(self.script(body.format("", "", "")))
        plain = [(self.folder / name).read_text() for name in FILES]
        drawn = (self.folder / "map.vtp").read_bytes()
        self.assertNotIn("temperature", "".join(plain))
        for ranks in (1, 2):
            self.liggghts(self.script(body.format(TEMP, EACH, "write_restart mid.restart\n")), ranks)
            through = [(self.folder / name).read_text() for name in FILES]
            self.assertEqual([self.without_temperature(name) for name in FILES], plain)
            self.assertEqual((self.folder / "map.vtp").read_bytes(), drawn)
            events = self.events()
            self.assertEqual(len(events), len(GRAINS))
            for event in events:
                self.assertEqual(event["temperature"], 300 + event["id"] ** 2)
            mean = sum(e["temperature"] for e in events) / len(events)
            # ten digits of the table
            self.assertAlmostEqual(self.table()["all"]["temperature_mean"] / mean, 1, delta=1e-9)
            self.assertAlmostEqual(self.table()["m"]["temperature_mean"] / mean, 1, delta=1e-9)
        self.liggghts(self.script(f"{TEMP}\n{STATS}\nrun 5000", read="read_restart mid.restart"), 2)
        self.assertEqual([(self.folder / name).read_text() for name in FILES], through)


if __name__ == "__main__":
    unittest.main()
