# SPDX-License-Identifier: Apache-2.0
"""`ionskin fit`: a key of the mechanics, interrupt and resume, and mistakes that end before any work."""

import json
import signal
import subprocess
import unittest

from program import QUICK, ROOT, SMALL, ProgramTest


class Fit(ProgramTest):
    def test_recovers_a_mechanical_key(self):
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

    def fit_of(self, folder, *more, data="data.csv"):
        """Arguments of a fit of two keys to a signal in proportion to that of a strain file's run."""
        return ("fit", self.case, *self.edits, "--data", data, "--column", "current_difference", "-o", folder, "--free",
                "coupling.coefficient,electrochemistry.diffusivity", *more)

    def test_an_interrupted_fit_goes_on(self):
        """Interrupted once and killed once, a fit ends with what an untouched one finds."""
        subprocess.run(["/usr/bin/python3", ROOT / "cases" / "make_strain.py", self.folder / "strain.h5"], check=True)
        self.case = ROOT / "cases" / "strain_file.toml"
        self.edits = ("--set", f'strain.file="{self.folder / "strain.h5"}"', "--set", "numerics.preset=coarse",
                      "--threads", "1")
        self.run_case(self.case, *self.edits, "--set", "coupling.coefficient=0.15", "--set",
                      "electrochemistry.diffusivity=1e-10 m2/s", "-o", "truth")
        (self.folder / "truth" / "sampled.csv").rename(self.folder / "data.csv")
        self.run_program(*self.fit_of("whole"))

        errors = self.end_at_file(3, *self.fit_of("out"), below="out/evaluations", how=signal.SIGINT, expect=130)
        self.assertIn("--resume", errors)
        self.assertEqual(json.loads((self.folder / "out" / "manifest.json").read_text())["state"], "interrupted")
        self.end_at_file(5, *self.fit_of("out", "--resume"), below="out/evaluations")
        shorter = self.write("shorter.csv", "".join((self.folder / "data.csv").read_text().splitlines(True)[:-1]))
        for other in (self.fit_of("out", "--resume", data=shorter),
                      self.fit_of("out", "--resume", "--set", "coupling.coefficient=0.2")):
            self.assertIn("another fit", self.run_program(*other, expect=2).stderr)
        self.run_program(*self.fit_of("out", "--resume"))

        whole, resumed = (json.loads((self.folder / name / "fit.json").read_text()) for name in ("whole", "out"))
        self.assertGreaterEqual(resumed["evaluations_taken_up"], 6)
        self.assertEqual(resumed["evaluations_taken_up"] + resumed["ion_transport_solves"], whole["ion_transport_solves"])
        for entries in (whole, resumed):
            for last_start in ("evaluations_taken_up", "ion_transport_solves", "mechanics_solves", "seconds"):
                del entries[last_start]
        self.assertEqual(whole, resumed)
        for name in ("fit.csv", "fitted.toml"):
            self.assertEqual((self.folder / "whole" / name).read_text(), (self.folder / "out" / name).read_text())
        self.assertFalse((self.folder / "out" / "evaluations").exists())

    def test_mistakes_end_before_any_work(self):
        good = self.write("good.csv", "time [s],current_difference [A]\n1,0\n2,0\n3,0\n")
        for arguments, words in ((("--data", "none.csv", "--free", "coupling.coefficient"), "cannot be read"),
                                 (("--data", QUICK, "--free", "coupling.coefficient"), "neither a comma"),
                                 (("--data", good, "--free", "coupling.coeficient"), "did you mean coupling.coefficient"),
                                 (("--data", good, "--free", "coupling.coefficient", "--column", "x"), "known:"),
                                 (("--data", good, "--free", "coupling.coefficient", "--set", "contact.friction=9"), "at most 2")):
            with self.subTest(words):
                process = self.run_program("fit", QUICK, *arguments, "-o", "out", expect=2)
                self.assertIn(words, process.stderr)
                self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    unittest.main()
