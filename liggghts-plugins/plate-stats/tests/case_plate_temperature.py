# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""fix plate/stats where grains have a temperature (property Temp): that at the first contact is in the table and in the
events, and all else stays as it is without.
"""
# processors: 2

import csv
import math
import unittest

import numpy

from plate_case import D, MASS, PLATE, PlateCase

TEMP = "fix Temp all property/atom Temp scalar yes yes no 300"
EACH = "run 0\nvariable T atom 300+id^2\nset group all property/atom Temp v_T\n"
COLUMNS = [f"temperature_{kind}" for kind in ("mean", "variance", "skewness", "standard_error")]

GRAINS = [(0.0005 * (i + 1), 0, (2 * i + 1) * D, 0, 0, -2.0 - 0.1 * i) for i in range(8)]


class Temperature(PlateCase):

    def without_temperature(self, name):
        """The text of a file with its columns of temperatures taken out."""
        with open(self.folder / name, newline="") as file:
            rows = list(csv.reader(file))
        kept = [i for i, column in enumerate(rows[0]) if not column.startswith("temperature")]
        return "".join(",".join(row[i] for i in kept) + "\n" for row in rows)

    def test_table_and_events(self):
        """Each grain has its own temperature: exact in the events, and the moments are those of the events, on 1 and 2
        ranks. The other columns are those of a run without temperatures, byte for byte."""
        self.data(GRAINS)
        body = "{}\n" + PLATE + "\n{}run 6000"
        self.liggghts(self.script(body.format("", "")))
        plain = [(self.folder / name).read_text() for name in ("plate.csv", "events.csv")]
        self.assertNotIn("temperature", plain[0] + plain[1])
        for ranks in (0, 2):
            self.liggghts(self.script(body.format(TEMP, EACH)), ranks)
            self.assertEqual([self.without_temperature(name) for name in ("plate.csv", "events.csv")], plain)
            events = self.events()
            self.assertEqual(len(events), len(GRAINS))
            self.assertEqual(list(events[0])[-1], "temperature")
            for event in events:
                self.assertEqual(event["temperature"], 300 + event["id"] ** 2)
            for region, low, high in (("all", 0, 5), ("ring2", 1, 2)):
                row = self.table()[region]
                values = numpy.array([e["temperature"] for e in events if low <= 1e3 * math.hypot(e["x"], e["y"]) < high])
                self.assertEqual(len(values), row["collisions"])
                self.assertGreater(len(values), 1)
                deviation = values - values.mean()
                variance = (deviation ** 2).sum() / (len(values) - 1)
                # ten digits of the table
                self.assertAlmostEqual(row["temperature_mean"] / values.mean(), 1, delta=1e-9)
                self.assertAlmostEqual(row["temperature_variance"] / variance, 1, delta=1e-9)
                self.assertAlmostEqual(row["temperature_standard_error"] / math.sqrt(variance / len(values)), 1, delta=1e-9)
        skew = (deviation ** 3).mean()
        self.assertTrue(math.isfinite(skew))
        self.assertEqual([c for c in row if c.startswith("temperature")], COLUMNS)

    def test_a_grain_that_is_heated(self):
        """With fix fluid/heat the recorded one is that before the step of the first contact: on the exact curve there."""
        self.data([(0, 0, 9 * D, 0, 0, -2.0)])
        nusselt_rest, k = 2.0, 1.2 * 1.5e-5 * 1005 / 0.7
        rate = nusselt_rest * k * math.pi * D / (MASS * 800)
        self.liggghts(self.script(f"""
            plugin load fluidheatplugin.so
            plugin load fluidforceplugin.so
            fix c all property/global thermalCapacity peratomtype 800
            fix h all fluid/heat uniform 500 1.2 1.5e-5 1005 0.7 velocity 0 0 -2 temperature 300
            {PLATE}
            run 5000"""))
        event, = self.events()
        self.assertGreater(event["temperature"], 300.5)
        # at rest against the fluid until then; nine digits
        exact = 500 - 200 * math.exp(-rate * (event["time"] - 1e-7))
        self.assertAlmostEqual(event["temperature"], exact, delta=1e-6)

    def test_restart(self):
        """In the middle of a contact: the rest of the run is as without, bit for bit."""
        self.data(GRAINS[:3])
        body = f"{TEMP}\n{PLATE}\n{{}}run 1050\n{{}}\nrun 2000"
        self.liggghts(self.script(body.format(EACH, "write_restart mid.restart")))
        through = [(self.folder / name).read_text() for name in ("plate.csv", "events.csv")]
        self.assertEqual(len(self.events()), 3)
        for ranks in (1, 2):
            self.liggghts(self.script(f"{TEMP}\n{PLATE}\nrun 2000", read="read_restart mid.restart"), ranks)
            self.assertEqual([(self.folder / name).read_text() for name in ("plate.csv", "events.csv")], through)

    def test_restart_with_or_without(self):
        """A file of statistics with temperatures does not go on without them, nor the reverse; anew they do."""
        self.data(GRAINS[:3])
        for first, second, words in ((TEMP, "", "grains with a temperature (property Temp"), ("", TEMP, "grains without temperature (property Temp)")):
            self.liggghts(self.script(f"{first}\n{PLATE}\nrun 1050\nwrite_restart mid.restart"))
            result = self.liggghts(self.script(f"{second}\n{PLATE}\nrun 2000", read="read_restart mid.restart"), check=False)
            self.assertFails(result, "Fix plate/stats (ID p)", words)
            anew = PLATE.replace("plate.csv", "new.csv").replace("events.csv", "new_events.csv") + " stats_start 0.000106"
            self.liggghts(self.script(f"{second}\n{anew}\nrun 2000", read="read_restart mid.restart"))
            # of three impacts one is over by then and one has begun
            self.assertEqual(len(self.events("new_events.csv")), 1)

    def test_order_and_end_of_temperatures(self):
        """Temp behind the fix comes too late for its files: a warning. Temp that goes is an error."""
        self.data(GRAINS[:1])
        late = self.liggghts(self.script(f"{PLATE}\n{TEMP}\nrun 10\nrun 10"))
        self.assertEqual(late.output.count("WARNING: Fix plate/stats (ID p): the property Temp came behind this fix"), 1)
        self.assertNotIn("temperature", (self.folder / "plate.csv").read_text())
        gone = self.liggghts(self.script(f"{TEMP}\n{PLATE}\nrun 10\nunfix Temp\nrun 10"), check=False)
        self.assertFails(gone, "Fix plate/stats (ID p): the property Temp is gone")


if __name__ == "__main__":
    unittest.main()
