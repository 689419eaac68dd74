# Grainjet: coarse-grained CFD-DEM for particle-laden jets
# Copyright (C) 2026 The Grainjet developers
# SPDX-License-Identifier: GPL-3.0-or-later
"""particleSamplingPlanes against a stream of which every crossing is known."""

# processors: 2
# label: long

import math
import unittest

import numpy

import ballistic_stream as stream
import grainjet
from grainjet import tables

END = 2.3        # s: by then all have left
PARCELS = 100    # of each injector


def table(folder, plane, start="0"):
    """Columns of a profile by name."""
    return tables.read(folder/f"postProcessing/profiles/{start}/plane_{plane:g}D.dat")


def expected():
    """Per plane the known crossings, one row per injector: ring, direction, axial, radial,
    tangential velocity, time of flight, diameter."""
    result = {plane: [] for plane in stream.PLANES}
    for plane, direction, place, velocity, flight, diameter in stream.crossings():
        r = math.hypot(place[0], place[1])
        radial = (velocity[0]*place[0] + velocity[1]*place[1])/r
        tangential = (velocity[1]*place[0] - velocity[0]*place[1])/r
        ring = int(r/stream.DIAMETER/stream.MAX_RADIUS*stream.RINGS)
        result[plane].append((ring, direction, velocity[2], radial, tangential, flight, diameter))
    return {plane: numpy.array(rows) for plane, rows in result.items()}


class Sampling(grainjet.Case):

    def sample(self, folder, end=END, ranks=0, **options):
        stream.write(folder, end, **options)
        self.foam("blockMesh", folder)
        if ranks:
            self.foam("decomposePar", folder)
        return self.foam("icoUncoupledKinematicParcelFoam", folder, ranks=ranks)

    def test_counts_and_averages_are_the_known_ones(self):
        log = self.sample(self.folder).output
        self.assertIn(f"parcels added               = {50*PARCELS}", log)
        for plane, rows in expected().items():
            got = table(self.folder, plane)
            for ring in range(stream.RINGS):
                _, direction, axial, radial, tangential, _, diameter = rows[rows[:, 0] == ring].T
                inner, outer = (0.1*stream.MAX_RADIUS*k/stream.RINGS for k in (ring, ring + 1))
                area = math.pi*(outer**2 - inner**2)
                self.assertEqual(got["crossings"][ring], PARCELS*len(axial), (plane, ring))
                self.assertEqual(got["forward"][ring], PARCELS*(direction > 0).sum())
                weight = 1/abs(axial)
                per_injector = PARCELS*stream.N_PARTICLE/(area*END)
                flux = per_injector*direction.sum()
                mass_flux = per_injector*(direction*stream.RHO*math.pi/6*diameter**3).sum()
                # Sums of at most 10^4 numbers, printed with 10 digits
                for name, value in (
                        ("flux_weighted_mean_axial", axial.mean()),
                        ("flux_weighted_mean_radial", radial.mean()),
                        ("flux_weighted_mean_tangential", tangential.mean()),
                        ("flux_weighted_rms_axial", axial.std()),
                        ("flux_weighted_rms_radial", radial.std()),
                        ("flux_weighted_rms_tangential", tangential.std()),
                        ("concentration_weighted_mean_axial", (weight*axial).sum()/weight.sum()),
                        ("concentration_weighted_mean_radial", (weight*radial).sum()/weight.sum()),
                        ("number_flux", flux), ("mass_flux", mass_flux)):
                    self.assertAlmostEqual(got[name][ring], value, delta=1e-8*(1e-3 + abs(value)), msg=(plane, ring, name))

    def test_ranks_do_not_change_the_counts(self):
        # A cut in the plane at 5D, then one along the axis
        serial, across, along = (self.folder/name for name in ("serial", "across", "along"))
        events = stream.sampling(events="yes")
        self.sample(serial, functions=events)
        self.sample(across, ranks=2, cut="(1 1 2)", functions=events)
        self.sample(along, ranks=2, cut="(2 1 1)", functions=events)
        total = 0
        for plane in stream.PLANES:
            one = table(serial, plane)
            total += PARCELS*len(expected()[plane])
            for folder in (across, along):
                two = table(folder, plane)
                for name in ("crossings", "forward", "backward", "number_flux"):
                    self.assertEqual(list(one[name]), list(two[name]), (plane, name))
                for name in one:
                    numpy.testing.assert_allclose(two[name], one[name], rtol=1e-7, atol=1e-9, err_msg=name)
        for folder in (serial, across, along):
            events = numpy.loadtxt(folder/"postProcessing/profiles/0/events.dat")
            self.assertEqual(len(events), total)
            self.assertTrue((numpy.diff(events[:, 0]) >= 0).all(), "in order of time")
        self.check_errors(serial, numpy.loadtxt(serial/"postProcessing/profiles/0/events.dat"))

    def check_errors(self, folder, events):
        """Standard errors from the events: 230 steps make batches of 8 steps, the last of 6."""
        steps = round(END/stream.DT)
        batch = (numpy.ceil(events[:, 0]/stream.DT - 1e-6).astype(int) - 1)//8
        durations = numpy.full(math.ceil(steps/8), 8*stream.DT)
        durations[-1] = (steps - 8*(len(durations) - 1))*stream.DT
        radius = numpy.hypot(events[:, 5], events[:, 6])
        ring = (radius/stream.DIAMETER/stream.MAX_RADIUS*stream.RINGS).astype(int)

        def error(x, y):
            return math.sqrt(len(x)/(len(x) - 1)*((x - x.sum()/y.sum()*y)**2).sum())/abs(y.sum())

        for plane in stream.PLANES:
            got = table(folder, plane)
            for k in range(stream.RINGS):
                mine = (events[:, 1] == plane) & (ring == k)

                def per_batch(values):
                    return numpy.bincount(batch[mine], values, minlength=len(durations))

                weight = events[mine, 11]
                area = math.pi*(0.1*stream.MAX_RADIUS/stream.RINGS)**2*((k + 1)**2 - k**2)
                mean = error(per_batch(weight*events[mine, 8]), per_batch(weight))
                rate = error(per_batch(weight*events[mine, 2]), durations)/area
                # zero, up to round-off, in a ring with parcels of one speed only
                self.assertAlmostEqual(got["stderr_flux_weighted_mean_axial"][k], mean, delta=1e-6*mean + 1e-12)
                self.assertAlmostEqual(got["stderr_number_flux"][k]/rate, 1, delta=1e-6)

    def test_restart_continues(self):
        once, twice = self.folder/"once", self.folder/"twice"
        self.sample(once, ranks=2)
        self.sample(twice, ranks=2, end=0.8)
        stream.control(twice, END, start="latestTime")
        log = self.foam("icoUncoupledKinematicParcelFoam", twice, ranks=2).output
        self.assertIn("continues with 0.8 s sampled before", log)
        for plane in stream.PLANES:
            a, b = table(once, plane), table(twice, plane, "0.8")
            self.assertEqual(list(a["crossings"]), list(b["crossings"]))
            for name in a:                      # the state is kept with 16 digits
                numpy.testing.assert_allclose(a[name], b[name], rtol=1e-8, atol=1e-10, err_msg=name)

    def test_restart_on_other_numbers_of_ranks(self):
        # serial to 0.8 s, 2 ranks to 1.4 s, serial to the end
        once, changed = self.folder/"once", self.folder/"changed"
        self.sample(once)
        self.sample(changed, end=0.8)
        grainjet.run(["decomposePar", "-latestTime"], changed)
        stream.control(changed, 1.4, start="latestTime")
        self.foam("icoUncoupledKinematicParcelFoam", changed, ranks=2)
        grainjet.run(["reconstructPar", "-latestTime"], changed)
        stream.control(changed, END, start="latestTime")
        self.foam("icoUncoupledKinematicParcelFoam", changed)
        for plane in stream.PLANES:
            a, b = table(once, plane), table(changed, plane, "1.4")
            self.assertEqual(list(a["crossings"]), list(b["crossings"]))

    def test_time_window(self):
        # 0.75 < t <= 0.95; the step that ends at 0.75 only fixes the places. Where all have
        # arrived by then, one parcel per injector crosses in each of the 20 steps; +-1 for
        # the two ends of the window
        self.sample(self.folder, functions=stream.sampling(timeStart=0.75, timeEnd=0.95))
        for plane in (0.3, 1):
            rows, got = expected()[plane], table(self.folder, plane)
            self.assertLess(rows[:, 5].max(), 0.7)
            for ring in range(stream.RINGS):
                n = (rows[:, 0] == ring).sum()
                self.assertAlmostEqual(got["crossings"][ring], 20*n, delta=n)
        self.assertIn("sampled time = 0.2 s",
                      (self.folder/"postProcessing/profiles/0/plane_0.3D.dat").read_text())

    def test_size_classes(self):
        sizes = "(0 1.5e-3 2.5e-3)"
        self.sample(self.folder, functions=stream.sampling(sizeClasses=sizes))
        for plane, rows in expected().items():
            for k, size in ((1, stream.SMALL), (2, stream.LARGE)):
                path = self.folder/f"postProcessing/profiles/0/plane_{plane:g}D_size{k}.dat"
                columns = numpy.loadtxt(path).T
                for ring in range(stream.RINGS):
                    mine = rows[(rows[:, 0] == ring) & (rows[:, 6] == size)]
                    self.assertEqual(columns[1][ring], PARCELS*len(mine))
                    if len(mine):
                        self.assertAlmostEqual(columns[2][ring], mine[:, 2].mean(), delta=1e-7)

    def test_post_processing_leaves_it_alone(self):
        self.sample(self.folder, end=0.2)
        profile = self.folder/"postProcessing/profiles/0/plane_1D.dat"
        before = profile.read_bytes()
        result = grainjet.run(["postProcess"], self.folder)
        self.assertEqual(result.code, 0, result)
        self.assertIn("post-processing has no particles of cloud", result.output)
        self.assertEqual(profile.read_bytes(), before)


if __name__ == "__main__":
    unittest.main()
