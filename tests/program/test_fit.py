# SPDX-License-Identifier: Apache-2.0
"""`ionskin fit`: a key of the mechanics, and mistakes that end before any work."""

import json
import os
import unittest

from program import QUICK, ProgramTest

SMALL = ("--set", "numerics.mesh_refinement=0.5", "--set", "numerics.time_refinement=0.3")


class Fit(ProgramTest):
    def test_recovers_a_mechanical_key(self):
        os.environ["IONSKIN_CACHE_LIMIT"] = "1 GB"  # the preload leaves the factorised positions as they are
        self.run_case(QUICK, "-o", "truth", *SMALL)
        process = self.run_program(
            "fit", QUICK, "--data", "truth/sampled.csv", "--column", "current_difference", "-o", "fitted", *SMALL,
            "--free", "motion.preload", "--set", "motion.preload=0.9 um")
        self.assertIn("motion.preload", process.stdout)
        fit = json.loads((self.folder / "fitted" / "fit.json").read_text())
        self.assertAlmostEqual(fit["parameters"]["motion.preload"]["value"] / 1e-6, 1, delta=1e-3)
        self.assertEqual(fit["parameters"]["motion.preload"]["unit"], "m")
        self.assertGreaterEqual(fit["mechanics_solves"], 3)
        self.run_program("check", "fitted/fitted.toml")

    def test_mistakes_end_before_any_work(self):
        good = self.write("good.csv", "time [s],current_difference [A]\n1,0\n2,0\n3,0\n")
        for arguments, words in ((("--data", "none.csv", "--free", "coupling.coefficient"), "cannot be read"),
                                 (("--data", QUICK, "--free", "coupling.coefficient"), "no column time"),
                                 (("--data", good, "--free", "coupling.coeficient"), "did you mean coupling.coefficient"),
                                 (("--data", good, "--free", "coupling.coefficient", "--column", "x"), "known:"),
                                 (("--data", good, "--free", "coupling.coefficient", "--set", "contact.friction=9"), "at most 2")):
            with self.subTest(words):
                process = self.run_program("fit", QUICK, *arguments, "-o", "out", expect=2)
                self.assertIn(words, process.stderr)
                self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    unittest.main()
