# SPDX-License-Identifier: Apache-2.0
"""Named figures of cases/paper/coarse.toml. A change here is a change of the numbers that users get: explain it."""

import unittest

from program import QUICK, ProgramTest, metric

# name: (value, relative tolerance)
FIGURES = {
    "normal_force_touchdown": (68.15586, 1e-5),
    "normal_force_slide": (64.88678, 1e-5),
    "tangential_force_slide": (19.466, 1e-5),
    "mean_shear_touchdown": (0.002501881, 1e-5),
    "mean_shear_slide": (0.008455391, 1e-5),
    "p99_shear_slide": (0.03100203, 1e-4),
    "shear_first_moment_slide": (-7.90695e-05, 1e-4),
    "element_max_shear_slide": (0.04113436, 1e-4),
    "peak_sampled_current_top": (0.02583937, 1e-4),
    "peak_sampled_current_bottom": (0.02680943, 1e-4),
    "peak_sampled_current_difference": (0.0004850329, 1e-3),
    "rms_current_top": (0.006504913, 1e-3),
    "rms_current_difference": (0.0001445601, 1e-3),
    "nonlinearity": (0.4302389, 1e-4),
    # An extreme in time, which finer time steps take to 0.6421.
    "min_concentration_ratio": (0.6458503, 1e-4),
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
