# SPDX-License-Identifier: Apache-2.0
"""The paper's case at the standard preset against independent codes (verification M6)."""

import unittest

import numpy

from program import PAPER, ProgramTest, metric, signals
from tiers import long_test

# friction: ranges of normal force [N] and mean shear at the end of touchdown and in steady sliding
REFERENCE = {
    0.05: ((65.7, 66.3), 2.60e-3, (64.9, 65.2), (3.08e-3, 3.08e-3)),
    0.3: ((67.8, 68.8), 2.54e-3, (64.7, 65.3), (8.45e-3, 8.50e-3)),
    0.5: ((67.9, 68.9), 2.535e-3, (64.4, 65.0), (1.335e-2, 1.344e-2)),
}
TOLERANCE = 0.02


class PaperCase(ProgramTest):
    def assert_within(self, value, low, high):
        self.assertGreaterEqual(value, low * (1 - TOLERANCE))
        self.assertLessEqual(value, high * (1 + TOLERANCE))

    def assert_reference_values(self, friction):
        touch_force, touch_shear, slide_force, slide_shear = REFERENCE[friction]
        self.run_case(PAPER, "-o", f"out{friction}", "--set", f"contact.friction={friction}")
        out = self.folder / f"out{friction}"
        self.assert_within(metric(out, "normal_force_touchdown"), *touch_force)
        self.assert_within(metric(out, "mean_shear_touchdown"), touch_shear, touch_shear)
        self.assert_within(metric(out, "normal_force_slide"), *slide_force)
        self.assert_within(metric(out, "mean_shear_slide"), *slide_shear)
        self.assertLess(metric(out, "charge_identity_error"), 1e-9)
        result = signals(out)
        sliding = (result["time"] > 1) & (result["time"] < 2.5)
        numpy.testing.assert_allclose(result["tangential_force"][sliding], friction * result["normal_force"][sliding], rtol=1e-8)
        self.assert_no_spike_behind_the_onset(result, friction)
        self.assert_partial_relaxation(result)

    def test_reference_values(self):
        self.assert_reference_values(0.3)

    @long_test
    def test_reference_values_of_less_and_of_more_friction(self):
        for friction in sorted(set(REFERENCE) - {0.3}):
            with self.subTest(friction=friction):
                self.assert_reference_values(friction)

    def assert_no_spike_behind_the_onset(self, result, friction):
        """The difference current behind the onset of slip stays below the slow tail that follows: no spike."""
        end = 0.5 + 0.9 * friction * 45e-6 / 3e-3
        current = numpy.abs(result["current_difference"])
        near = (result["time"] > end) & (result["time"] <= end + 0.02)
        tail = (result["time"] > end + 0.02) & (result["time"] < end + 0.2)
        self.assertGreaterEqual(numpy.count_nonzero(near), 3)
        self.assertLess(current[near].max(), 1.05 * current[tail].max())

    def assert_partial_relaxation(self, result):
        """The second cycle starts from a charge that has not relaxed, so its currents differ."""
        start = numpy.interp([4.0, 8.0], result["time"], result["charge_top"] - result["charge_bottom"])
        largest = numpy.abs(result["charge_top"] - result["charge_bottom"]).max()
        self.assertGreater(abs(start[0]) / largest, 1e-3)
        self.assertGreater(abs(start[1] - start[0]) / largest, 1e-5)


if __name__ == "__main__":
    unittest.main()
