# SPDX-License-Identifier: Apache-2.0
"""Paths made of recordings of robots by `ionskin.motion`: noise, spikes, stamps, tilt, mistakes."""

import unittest

import numpy

import ionskin
from ionskin.reading.recording import contact
from package import PackageTest


class Touch(PackageTest):
    """One touch of 0.5 N at 125 Hz, with noise of 4 mN: 0.5 s above the skin, 1.4 s on it, 0.7 s above it."""

    def setUp(self):
        super().setUp()
        self.time = numpy.arange(326) / 125
        self.x = numpy.interp(self.time, (0.9, 1.7), (4.5, 8.5))
        self.height = numpy.interp(self.time, (0, 0.5, 0.52, 1.88, 1.9, 2.6), (1, 0, -0.02, -0.02, 0, 1))
        self.force = numpy.interp(self.time, (0.5, 0.6, 1.8, 1.9), (0, 0.5, 0.5, 0))
        self.force += numpy.random.default_rng(2).normal(0, 0.004, len(self.time))

    def table(self, name, **columns):
        """Writes a recording of columns by their titles and returns its path."""
        lines = [",".join(columns), *(",".join(map(repr, row)) for row in zip(*(
            numpy.asarray(column).tolist() for column in columns.values())))]
        (self.folder / name).write_text("\n".join(lines) + "\n")
        return self.folder / name

    def touch(self, **changes):
        """Writes the touch with some columns changed or added."""
        return self.table("touch.csv", **{"time": self.time, "x_mm": self.x, "y_mm": 0 * self.x, "z_mm": self.height,
                                          "force": self.force, **changes})

    def assert_one_touch(self, path):
        """Asserts that the path presses once, about as long as the finger touched."""
        spans = contact.parts(numpy.isfinite(path.force))
        self.assertEqual(len(spans), 1, path.notes)
        first, last = path.time[spans[0][0]], path.time[spans[0][1] - 1]
        self.assertAlmostEqual(first, 0.5, delta=0.02)
        self.assertAlmostEqual(last, 1.9, delta=0.02)

    def test_noise_is_that_of_the_recorded_rows(self):
        """Straight lines between the rows have no noise: a resampled touch was six."""
        recording = self.touch()
        self.assert_one_touch(ionskin.motion(recording))
        self.assert_one_touch(ionskin.motion(recording, rate="1 kHz"))
        clock = numpy.arange(2500) / 1000
        fast = self.table("fast.csv", time=clock, x_mm=0 * clock, y_mm=0 * clock)
        force = self.table("force.csv", time=self.time, force=self.force)
        self.assert_one_touch(ionskin.motion([fast, force]))
        self.assert_one_touch(ionskin.motion([force, fast], rate="1 kHz"))

    def test_filter_leaves_a_part_of_the_noise(self):
        """Filtered noise is smooth, and larger than its second differences say."""
        for seed in range(5):
            force = self.force + numpy.random.default_rng(seed).normal(0, 0.08, len(self.time))
            path = ionskin.motion(self.touch(force=force), filter="5 Hz", rate="500 Hz")
            self.assertEqual(len(contact.parts(numpy.isfinite(path.force))), 1, path.notes)


if __name__ == "__main__":
    unittest.main()
