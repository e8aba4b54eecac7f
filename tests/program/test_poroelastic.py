# SPDX-License-Identifier: Apache-2.0
"""A touch under the law `poroelastic`."""

import unittest

from program import ROOT, ProgramTest, metric

CASE = ROOT / "cases" / "paper" / "water.toml"


class Touch(ProgramTest):
    def test_far_from_the_rim_a_wide_sealed_cell_feels_nothing(self):
        """Equilibrium makes the mean pressure the same at every height: only rims and sides leave a difference."""
        text = CASE.read_text()
        for old, new in (('length = "15 mm"', 'length = "40 mm"'), ('sides = "free"', 'sides = "symmetry"'),
                         ('size = ["3 mm", "1.5 mm"]', 'size = ["3 mm", "2 mm"]'),
                         ('start = ["4.5 mm", "1 mm"]', 'start = ["20 mm", "1 mm"]'), ('stroke = "6 mm"', 'stroke = "0 mm"')):
            self.assertIn(old, text)
            text = text.replace(old, new)
        self.run_case(self.write("wide.toml", text), "-o", "out", "--set", "numerics.preset=coarse", "--set", "output.fields=[]",
                      "--set", "contact.friction=0.05")
        self.assertGreater(metric(self.folder / "out", "peak_pore_pressure"), 1e7)
        self.assertLess(metric(self.folder / "out", "pressure_asymmetry"), 1e-3)


if __name__ == "__main__":
    unittest.main()
