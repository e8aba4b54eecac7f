# SPDX-License-Identifier: Apache-2.0
"""Uncertainty: exact indices of known functions, refusals, mistakes, and a study of a case that is stopped and resumed."""

import json
import os
import pathlib
import shutil
import subprocess
import sys
import unittest

import numpy

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent / "unit" / "results"))
import ionskin
import page_faults
from browser import browser_page
from ionskin.evaluation import LocalEngine, StudyFolder
from ionskin.uncertainty.distributions import parse
from package import CASES, PROGRAM, PackageTest

K, D = "coupling.coefficient", "electrochemistry.diffusivity"
PI = numpy.pi


def told(study, function):
    """The study after every trial is answered by a function of the array of values."""
    for trial in study.ask():
        study.tell(trial, {"y": function(numpy.array(list(trial.values.values())))})
    return study.analyse()["y"]


def ishigami(x):
    return numpy.sin(x[0]) + 7 * numpy.sin(x[1]) ** 2 + 0.1 * x[2] ** 4 * numpy.sin(x[0])


class KnownFunctions(unittest.TestCase):
    def assert_indices(self, found, first, total):
        self.assertEqual(found.refusal, "")
        for exact, order in ((first, found.first), (total, found.total)):
            for wanted, (index, lower, upper) in zip(exact, order.values()):
                self.assertAlmostEqual(index, wanted, delta=0.01)
                self.assertTrue(lower - 1e-12 <= upper)

    def test_ishigami(self):
        study = ionskin.Uncertainty(None, {name: f"uniform({-PI}, {PI})" for name in "abc"}, samples=256)
        found = told(study, ishigami)
        variances = 0.5 * (1 + 0.1 * PI**4 / 5) ** 2, 49 / 8, 0.01 * PI**8 * 8 / 225
        whole = sum(variances)
        self.assert_indices(found, [variances[0] / whole, variances[1] / whole, 0.0],
                            [(variances[0] + variances[2]) / whole, variances[1] / whole, variances[2] / whole])
        self.assertAlmostEqual(found.mean, 3.5, delta=0.1)

    def test_g_function(self):
        weights = numpy.array([0, 1, 4.5, 9])
        study = ionskin.Uncertainty(None, {f"x{i}": "uniform(0, 1)" for i in range(4)}, samples=512)
        found = told(study, lambda x: numpy.prod((numpy.abs(4 * x - 2) + weights) / (1 + weights)))
        alone = 1 / 3 / (1 + weights) ** 2
        whole = numpy.prod(1 + alone) - 1
        self.assert_indices(found, alone / whole, alone * numpy.prod(1 + alone) / (1 + alone) / whole)

    def test_distributions(self):
        """The variance of a sum is that of its parts."""
        vary = {"a": "normal(10, 20 %)", "b": "lognormal(2, 0.5)", "c": "triangular(0, 1, 3)", "d": "normal(0, 1, -1, 1)"}
        found = told(ionskin.Uncertainty(None, vary, samples=256), sum)
        variances = numpy.array([4, 0.25, (0 + 1 + 9 - 0 - 0 - 3) / 18, 0.29112509])
        self.assert_indices(found, variances / variances.sum(), variances / variances.sum())
        self.assertAlmostEqual(found.deviation / variances.sum() ** 0.5, 1, delta=0.02)

    def test_what_the_basis_does_not_hold_is_refused(self):
        study = ionskin.Uncertainty(None, {"a": "uniform(-1, 1)", "b": "uniform(-1, 1)"}, samples=128)
        found = told(study, lambda x: numpy.sign(numpy.sin(40 * x[0] + 31 * x[1])))
        self.assertEqual((found.first, found.total, found.samples_needed), ({}, {}, 0))
        self.assertIn("more samples hardly help", found.refusal)

    def test_too_few_samples_are_refused_and_the_number_that_is_asked_for_does(self):
        def study(samples):
            return ionskin.Uncertainty(None, {name: f"uniform({-PI}, {PI})" for name in "abc"}, samples=samples)

        found = told(study(48), ishigami)
        self.assertEqual(found.first, {})
        self.assertTrue(48 < found.samples_needed < 1000, found.refusal)
        self.assertIn(f"({found.samples_needed - 48} more)", found.refusal)

    def test_few_samples_of_many_keys_do_not_condemn_the_function(self):
        """16 samples cannot tell a quadratic function of six keys; four times as many can."""
        def study(samples):
            return ionskin.Uncertainty(None, {f"x{i}": "uniform(-1, 1)" for i in range(6)}, samples=samples)

        def product(x):
            return x[0] * x[1] + x[2] * x[3] + x[4] * x[5]

        found = told(study(16), product)
        self.assertEqual((found.first, found.samples_needed), ({}, 64))
        self.assertNotIn("hardly help", found.refusal)
        self.assertEqual(told(study(64), product).refusal, "")

    def test_failures_are_left_out(self):
        study = ionskin.Uncertainty(None, {"a": "uniform(0, 1)"}, samples=32)
        for trial in study.ask():
            study.tell(trial, ionskin.SolverError("gave up") if trial.number == 3 else {"y": trial.values["a"]})
        self.assertEqual(study.ask(), [])
        self.assertEqual(len(study.finished()), 31)
        self.assertAlmostEqual(study.analyse()["y"].first["a"][0], 1, delta=1e-6)

    def test_a_longer_sobol_design_begins_with_the_shorter_one(self):
        vary = {"a": "normal(0, 1)", "b": "uniform(0, 1)"}
        short, long = (ionskin.Uncertainty(None, vary, samples=count).trials for count in (16, 40))
        self.assertEqual(short, long[:16])


class OfACase(PackageTest):
    """Uncertainty on a step of shear from a file: ion transport alone."""

    def setUp(self):
        super().setUp()
        subprocess.run([sys.executable, CASES / "make_strain.py", self.folder / "strain.h5"], check=True)
        text = (CASES / "strain_file.toml").read_text()
        self.case = ionskin.Case.from_text(text, self.folder)
        self.case["numerics.preset"] = "coarse"
        self.path = self.folder / "case.toml"
        self.path.write_text(self.case.text)
        self.vary = {D: "lognormal(7e-11 m2/s, 20 %)", K: "uniform(0.05, 0.15)"}

    def command(self, *more, folder="out"):
        words = [PROGRAM, "uncertainty", self.path, "--output", self.folder / folder, "--samples", "16",
                 "--metrics", "rms_current_difference", *more]
        words += [f"--vary={key}={text}" for key, text in self.vary.items()]
        return subprocess.run(words, capture_output=True, text=True, check=False)

    def test_stopped_and_resumed_with_any_number_of_workers(self):
        study = ionskin.Uncertainty(self.case, self.vary, samples=16)

        def stop(trial, outcome):
            if trial.number == 2:
                raise KeyboardInterrupt

        whole = self.command("--threads=2")
        self.assertEqual(whole.returncode, 0, whole.stderr)
        for name in ("uncertainty.json", "samples.csv", "bands.csv", "report.html", "figures/bands.png"):
            self.assertTrue((self.folder / "out" / name).exists(), name)
        shutil.copytree(self.folder / "out", self.folder / "cut")
        for path in sorted((self.folder / "cut" / "points").iterdir())[3:]:
            path.unlink()
        (self.folder / "cut" / "points" / "000001.npz").write_bytes(b"damaged")
        kept = StudyFolder(self.folder / "stopped", {"study": "test"})
        with self.assertRaises(KeyboardInterrupt):
            LocalEngine(1).evaluate(self.case, study.trials[:4], kept.points, stop)
        self.assertGreaterEqual(set(kept.finished()), {0, 1, 2})
        resumed = self.command("--resume", "--threads=1", folder="cut")
        self.assertEqual(resumed.returncode, 0, resumed.stderr)
        for name in ("uncertainty.json", "samples.csv", "bands.csv"):
            self.assertEqual((self.folder / "out" / name).read_text(), (self.folder / "cut" / name).read_text(), name)
        with browser_page(self.folder / "out" / "report.html") as page:
            for width in page_faults.WIDTHS:
                self.assertEqual(page_faults.faults(page, width), [], f"at {width} pixels")
        indices = json.loads((self.folder / "out" / "uncertainty.json").read_text())["metrics"]["rms_current_difference"]
        self.assertGreater(indices["sobol_indices"][K]["first"]["value"], 0.8)  # the current goes with k
        other = self.command("--resume", "--seed=2")
        self.assertEqual(other.returncode, 2)
        self.assertIn("seed", other.stderr)
        self.assertEqual(self.command().returncode, 2)

    def test_texts_that_are_not_wholly_understood(self):
        """None is taken for less than it says: 5 % % was 0.05 %."""
        case = ionskin.Case.from_file(CASES / "paper" / "coarse.toml")
        for written in ("normal(0.3, 5 % %)", "normal(0.3, 5 %%)", "normal(0.3, 5 percent)", "normal(0.3, 5 % 5 %)",
                        "normal(0.3, 5 % 1)", "normal(0.3, 5 %2)", "normal(0.3, 5 %.%)", "normal(0.3, 5 %/1)", "normal(0.3, 5 % m/m)",
                        "normal(0.3, \uff15 %)", "normal(0.3, + 5 %)", "normal(0.3, 5 '%')", "normal(0.3, 0.02 (0.1))",
                        "normal(0.3 0.2, 0.05)", "normal(0.3, 0.05))", "normal((0.3), 0.05)", "uniform(0.1 % %, 0.4)",
                        "uniform(0.1, 0.4) x", "uniform(0.1, 0.4) uniform(0.2, 0.3)", "x uniform(0.1, 0.4)", "uniform(0.1, 0.4,)",
                        "uniform(0.1, 0.4);", "uniform(0x1, 0.4)", "uniform(0.1_0, 0.4)", "uniform(\u0660.\u0661, 0.4)",
                        "uniform(0.1 - 0.05, 0.4)", "uniform(0.1, inf)", "uniform(nan, 1)", "uniform(0.1, 1e999)"):
            for of in (case, None):
                with self.subTest(written, case=of is not None), self.assertRaises(ionskin.CaseError):
                    parse("contact.friction", written, of)
        for written in ("normal(0.3, 5%)", " NORMAL ( 30 % , 5. % ) ", "normal(.3, 0.015)", "normal(+3e-1, 1.5e-2)"):
            self.assertAlmostEqual(parse("contact.friction", written, case).scale, 0.015, msg=written)

    def test_mistakes(self):
        for key, written, words in (
                (D, "lognormal(7e-11 m, 20 %)", D), (K, "gaussian(1, 2)", "known: uniform"), (K, "uniform(0.2, 0.1)", "ascend"),
                ("coupling.coeficient", "uniform(0, 1)", "did you mean coupling.coefficient"),
                (D, "normal(7e-11 m2/s, 50 %)", "truncate it: normal(7e-11 m2/s, 50 %, lowest, highest)"),
                (D, "uniform(-1e-11 m2/s, 1e-11 m2/s)", "narrower"), (K, "uniform(0.1)", "uniform(lowest, highest)"),
                ("electrochemistry.temperature", "normal(20 degC, 2 degC)", "deviation in K"),
                (K, "normal(0.1, 0)", "not above 0"), ("coupling.law", "uniform(0, 1)", "not a single real number")):
            with self.subTest(written), self.assertRaises(ionskin.CaseError) as raised:
                ionskin.Uncertainty(self.case, {key: written})
            self.assertIn(words, str(raised.exception))
        misspelt = self.command("--metrics=rms_curent_difference")
        self.assertEqual(misspelt.returncode, 2)
        self.assertIn("did you mean rms_current_difference?", misspelt.stderr)
        self.assertLess(len(list((self.folder / "out" / "points").iterdir())), 16)  # told by the first result
        with self.assertRaises(ionskin.CaseError):
            ionskin.Uncertainty(self.case, {})
        os.makedirs(self.folder / "mine")
        (self.folder / "mine" / "file").write_text("x")
        with self.assertRaises(ionskin.CaseError):
            StudyFolder(self.folder / "mine", {}, overwrite=True)


if __name__ == "__main__":
    unittest.main()
