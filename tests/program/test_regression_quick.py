# SPDX-License-Identifier: Apache-2.0
"""Named figures of cases/paper/coarse.toml. A change here is a change of the numbers that users get: explain it."""

import unittest

from program import QUICK, ProgramTest, metric

# name: (value, relative tolerance)
FIGURES = {
    "normal_force_touchdown": (68.15586, 1e-5),
    "normal_force_slide": (64.887, 1e-5),
    "tangential_force_slide": (19.466, 1e-5),
    "mean_shear_touchdown": (2.512353e-3, 1e-5),
    "mean_shear_slide": (8.460749e-3, 1e-5),
    "p99_shear_slide": (3.101237e-2, 1e-4),
    "shear_first_moment_slide": (-7.988724e-5, 1e-4),
    "element_max_shear_slide": (4.112694e-2, 1e-4),
    "peak_sampled_current_top": (2.584755e-2, 1e-4),
    "peak_sampled_current_bottom": (2.682950e-2, 1e-4),
    "peak_sampled_current_difference": (4.909730e-4, 1e-3),
    "rms_current_top": (6.507271e-3, 1e-3),
    "rms_current_difference": (1.479213e-4, 1e-3),
    "nonlinearity": (0.4302871, 1e-4),
    # An extreme in time, which finer time steps take to 0.6421.
    "min_concentration_ratio": (0.6456551, 1e-4),
}
# name: upper bound
BOUNDS = {
    "charge_identity_error": 1e-9,
    # Forces on the cells against those through levels of the core, which modes are summed for to the accuracy of the preset.
    "equilibrium_residual": 1e-3,
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
