# SPDX-License-Identifier: Apache-2.0
"""Named figures of cases/quick.toml. A change here is a change of the numbers that users get: explain it."""

import unittest

from program import QUICK, ProgramTest, metric

# name: (value, relative tolerance)
FIGURES = {
    "normal_force_touchdown": (68.54480, 1e-5),
    "normal_force_slide": (65.23275, 1e-5),
    "tangential_force_slide": (19.56982, 1e-5),
    "mean_shear_touchdown": (2.512230e-3, 1e-5),
    "mean_shear_slide": (8.493970e-3, 1e-5),
    "p99_shear_slide": (3.108859e-2, 1e-4),
    "shear_first_moment_slide": (-7.813262e-5, 1e-4),
    "element_max_shear_slide": (4.127812e-2, 1e-4),
    "peak_sampled_current_top": (2.595979e-2, 1e-4),
    "peak_sampled_current_bottom": (2.692133e-2, 1e-4),
    "peak_sampled_current_difference": (4.807680e-4, 1e-3),
    "rms_current_top": (6.531353e-3, 1e-3),
    "rms_current_difference": (1.469873e-4, 1e-3),
    "nonlinearity": (0.4263908, 1e-4),
    # An extreme in time, which finer time steps take to 0.6426: steps that end on the instants of the path come nearer.
    "min_concentration_ratio": (0.6474704, 1e-4),
}
# name: upper bound
BOUNDS = {
    "charge_identity_error": 1e-9,
    "equilibrium_residual": 1e-9,
    "complementarity_residual": 1e-8,
}


class QuickCase(ProgramTest):
    def test_figures(self):
        self.run_case(QUICK, "-o", "out")
        out = self.folder / "out"
        for name, (expected, tolerance) in FIGURES.items():
            with self.subTest(name):
                self.assertAlmostEqual(metric(out, name), expected, delta=tolerance * abs(expected))
        for name, bound in BOUNDS.items():
            with self.subTest(name):
                self.assertLess(metric(out, name), bound)


if __name__ == "__main__":
    unittest.main()
