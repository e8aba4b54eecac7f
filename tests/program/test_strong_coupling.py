# SPDX-License-Identifier: Apache-2.0
"""Strong coupling and thin double layers: runs that must end, and cases that have no solution."""

import unittest

import numpy

from program import QUICK, ProgramTest, metric, write_strain_file

THIN = "electrochemistry.permittivity=7.1e-10 F/m"  # 80 times that of vacuum: a Debye length of 0.4 nm


class StrongCoupling(ProgramTest):
    def setUp(self):
        super().setUp()
        # Contact within half a millisecond, a slide of the footprint by its own length, lift-off; as strong as the
        # baseline's shear, more so towards the top.
        place = numpy.array([[0, 1, 0.2, 0], [0, 1, 0.2, 0], [0, 0.2, 1, 0], [0, 0, 0, 0]])
        profile = numpy.array([0.3, 1.0])
        gamma = 0.04 * numpy.array([0, 1, 1.5, 0])[:, None, None] * profile[None, :, None] * place[:, None, :]
        self.strain = self.folder / "strain.h5"
        write_strain_file(self.strain, gamma[:, :, None, :], [0.0, 5e-4, 1.0, 1.0005],
                          x=(0, 3e-3, 6e-3, 9e-3, 15e-3))

    def run_on(self, out, *edits, expect=0):
        options = [option for edit in edits for option in ("--set", edit)]
        return self.run_case(QUICK, "-o", out, "--set", "strain.source=file", "--set",
                                f'strain.file="{self.strain}"', *options, expect=expect)

    def test_neutral_laws_at_full_strength(self):
        for law in ("column-neutral", "volume-neutral"):
            with self.subTest(law):
                self.run_on(law, f"coupling.law={law}", "coupling.coefficient=1")
                self.assertGreater(metric(self.folder / law, "min_concentration_ratio"), 0)
                self.assertLess(metric(self.folder / law, "charge_identity_error"), 1e-9)

    def test_double_layers_of_water(self):
        for law in ("column-neutral", "pair-generation"):
            with self.subTest(law):
                self.run_on(law, f"coupling.law={law}", "coupling.coefficient=1e-3", THIN)
                self.assertGreater(metric(self.folder / law, "min_concentration_ratio"), 0)
                self.assertLess(metric(self.folder / law, "charge_identity_error"), 1e-9)

    def test_no_sane_solution(self):
        check = self.run_program("check", QUICK, "--set", THIN)
        process = self.run_on("out", THIN, expect=3)
        for text in (check.stdout, process.stderr):
            self.assertRegex(text, r"no sane solution.*needs at least [0-9.e+]+ V")
            self.assertIn("column-neutral", text)


if __name__ == "__main__":
    unittest.main()
