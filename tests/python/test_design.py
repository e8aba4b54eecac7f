# SPDX-License-Identifier: Apache-2.0
"""Design: a problem with a known optimum, a case, mistakes."""

import json
import subprocess
import sys
import unittest

import numpy

import ionskin
from package import CASES, PROGRAM, PackageTest


class KnownOptimum(unittest.TestCase):
    def test_hs71(self):
        """Problem 71 of Hock and Schittkowski (1981): 17.0140173 at (1, 4.743, 3.8211, 1.3794)."""
        study = ionskin.Design(None, {f"x{i}": ("1", "5") for i in range(4)}, "f", subject_to=["p >= 25", "q == 40"], budget=80)
        while trials := study.ask():
            for trial in trials:
                x = numpy.array(list(trial.values.values()))
                study.tell(trial, {"f": x[0] * x[3] * x[:3].sum() + x[2], "p": x.prod(), "q": (x**2).sum()})
        trial, metrics = study.best()
        self.assertAlmostEqual(metrics["f"], 17.0140173, delta=2e-3)
        self.assertGreater(metrics["p"], 25 * (1 - 1e-4))
        self.assertAlmostEqual(metrics["q"], 40, delta=40e-4)
        self.assertLess(len(study.trials), 80)

    def test_binding_constraint(self):
        """Current [uA] and shear of a skin over its thickness, about; the objective at the infeasible end is far better."""
        for bound in (5.2, 4.95):  # two of the first evaluations meet it; none does
            study = ionskin.Design(None, {"x": ("1", "2") if bound > 5 else ("1.1", "2")}, "f", maximise=True,
                                   subject_to=[f"g < {bound}"], budget=16)
            while trials := study.ask():
                for trial in trials:
                    x = trial.values["x"]
                    study.tell(trial, {"f": 41 - 35 * (2 - x) ** 1.5, "g": 4.7 + 1.3 * (x - 1) - 0.15 * (x - 1) ** 2})
            trial, metrics = study.best()
            self.assertLess(len(study.trials), 16)
            self.assertLess(metrics["g"], bound * (1 + 1e-4))
            self.assertAlmostEqual(metrics["g"], bound, delta=bound * 2e-4)

    def test_none_is_feasible(self):
        study = ionskin.Design(None, {"x": ("0", "1")}, "f", maximise=True, subject_to=["f > 2"], budget=9)
        while trials := study.ask():
            for trial in trials:
                study.tell(trial, {"f": trial.values["x"]})
        self.assertIsNone(study.best())


class OfACase(PackageTest):
    def command(self, *more):
        words = [PROGRAM, "design", self.folder / "case.toml", "--output", self.folder / "out",
                 "--set=numerics.preset=coarse", "--free=coupling.coefficient=0.05:0.15", "--maximise=rms_current_difference",
                 "--budget=12", *more]
        return subprocess.run(words, capture_output=True, text=True, check=False)

    def test_of_a_case(self):
        subprocess.run([sys.executable, CASES / "make_strain.py", self.folder / "strain.h5"], check=True)
        (self.folder / "case.toml").write_text((CASES / "strain_file.toml").read_text())
        for word, mistake in (("metric is in A", "--subject-to=peak_current_top < 1 V"), ("not a constraint", "--subject-to=a ? 3"),
                              ("not a metric", "--subject-to=peak_force < 3 N"),
                              ("mean rms_current_difference?", "--subject-to=rms_curent_difference < 3 A")):
            wrong = self.command(mistake, "--overwrite")
            self.assertEqual(wrong.returncode, 2)
            self.assertIn(word, wrong.stderr)
        done = self.command("--subject-to=peak_current_top < 1 A", "--overwrite")
        self.assertEqual(done.returncode, 0, done.stderr)
        found = json.loads((self.folder / "out" / "design.json").read_text())
        self.assertAlmostEqual(found["values"]["coupling.coefficient"]["value"], 0.15, delta=1e-6)  # the current goes with k
        before = (self.folder / "out" / "evaluations.csv").read_text()
        (self.folder / "out" / "points" / "000002.npz").unlink()
        again = self.command("--subject-to=peak_current_top < 1 A", "--resume")
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertEqual((self.folder / "out" / "evaluations.csv").read_text(), before)
        self.assertEqual(ionskin.Case.from_file(self.folder / "out" / "best.toml")["coupling.coefficient"],
                         found["values"]["coupling.coefficient"]["value"])


if __name__ == "__main__":
    unittest.main()
