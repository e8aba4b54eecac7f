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

    def check_on(self, *edits, expect=0):
        options = [option for edit in edits for option in ("--set", edit)]
        return self.run_program("check", QUICK, "--set", "strain.source=file", "--set", f'strain.file="{self.strain}"',
                                *options, expect=expect)

    def test_check_says_of_a_strain_file_what_run_says(self):
        for edits in (("coupling.coefficient=-40",), ("skin.width=3 mm", "slider.start=[\"4.5 mm\", \"1.5 mm\"]")):
            with self.subTest(edits[0]):
                checked = self.check_on(*edits, expect=2)
                ran = self.run_on("out", *edits, expect=2)
                self.assertIn(str(self.strain), checked.stderr)
                self.assertEqual(checked.stderr, ran.stderr)
        self.strain.write_text("no HDF5")
        self.assertIn(str(self.strain), self.check_on(expect=2).stderr)
        self.strain.unlink()
        self.assertIn(str(self.strain), self.check_on(expect=2).stderr)

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
        check = self.run_program("check", QUICK, "--set", THIN, expect=2)
        run = self.run_case(QUICK, "-o", "refused", "--set", THIN, expect=2)
        check_of_file = self.check_on(THIN)
        process = self.run_on("out", THIN, expect=3)
        for text in (check.stderr, run.stderr, check_of_file.stdout, process.stderr):
            self.assertRegex(text, r"no sane solution.*needs at least [0-9.e+]+ V")
            self.assertIn("column-neutral", text)
        # The file's shear is known, that of a slider is estimated.
        reason = process.stderr.partition("the law")[2].partition(" thick)")[0]
        self.assertIn(reason, check_of_file.stdout)
        self.assertIn("is valid", check_of_file.stdout)
        self.assertNotIn("warning", self.check_on("coupling.law=column-neutral", THIN).stdout)

    def test_check_tells_what_its_estimate_foresees(self):
        edit = ("--set", "coupling.coefficient=-20")
        self.assertIn("warning: the fixed charge becomes negative", self.run_program("check", QUICK, *edit).stdout)
        edit = ("--set", "coupling.coefficient=-50")
        for process in (self.run_program("check", QUICK, *edit, expect=2),
                        self.run_case(QUICK, "-o", "out", *edit, expect=2)):
            self.assertRegex(process.stderr, "fixed charge becomes negative.*\n  = make coupling.coefficient smaller")


if __name__ == "__main__":
    unittest.main()
