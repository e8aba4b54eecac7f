# SPDX-License-Identifier: Apache-2.0
"""Fits: recovery from noisy data, unidentifiable keys, mistakes."""

import subprocess
import sys
import unittest

import numpy

import ionskin
from package import CASES, PackageTest

K, D = "coupling.coefficient", "electrochemistry.diffusivity"
NOISE = 0.02  # of the rms


class Fit(PackageTest):
    """Fits on a step of shear from a file: ion transport alone, within a fraction of a second."""

    def setUp(self):
        super().setUp()
        subprocess.run([sys.executable, CASES / "make_strain.py", self.folder / "strain.h5"], check=True)
        self.case = ionskin.Case.from_text((CASES / "strain_file.toml").read_text(), self.folder)
        self.case["numerics.preset"] = "coarse"
        self.case["readout.sample_interval"] = "50 ms"
        sampled = ionskin.run(self.case).sampled
        self.time, self.current = sampled["time"], sampled["current_difference"]
        self.rms = numpy.sqrt(numpy.mean(self.current**2))

    def noisy(self, seed):
        return self.current + numpy.random.default_rng(seed).normal(0, NOISE * self.rms, len(self.current))

    def off(self):
        """The case away from the truth."""
        case = self.case.copy()
        case[K], case[D] = 1.5 * self.case[K], 0.6 * self.case[D]
        return case

    def test_recovers_the_truth(self):
        model = ionskin.FitModel(self.off(), [K, D])
        exact = model.fit(self.time, self.current)
        for key in (K, D):
            self.assertAlmostEqual(exact[key] / self.case[key], 1, delta=2e-4)
        self.assertTrue(exact.summary["converged"])
        self.assertEqual(exact.summary["mechanics_solves"], 0)
        before = exact.summary["ion_transport_solves"]
        inside = []
        for seed in range(3):
            fit = model.fit(self.time, self.noisy(seed))
            inside += [fit.parameters[key].lower_95 <= self.case[key] <= fit.parameters[key].upper_95 for key in (K, D)]
            half_width = numpy.log(fit.parameters[K].upper_95 / fit.parameters[K].lower_95) / 2
            self.assertTrue(0.001 < half_width < 0.05, half_width)
            self.assertAlmostEqual(fit.summary["residual_deviation"]["value"] / (NOISE * self.rms), 1, delta=0.3)
        self.assertGreaterEqual(sum(inside), 5)
        again = model.fit(self.time, self.current)
        self.assertEqual(again[K], exact[K])
        self.assertLess(before, 60)

    def test_keys_that_the_data_cannot_distinguish(self):
        """In linear response to a small coupling, c0 and k act as their product."""
        fit = ionskin.FitModel(self.off(), [K, D, "electrochemistry.fixed_charge_concentration",
                                            "electrochemistry.permittivity"]).fit(self.time, self.noisy(1))
        self.assertTrue(any("cannot distinguish all free keys" in text for text in fit.warnings), fit.warnings)
        self.assertGreater(fit.condition_number, 1e3)

    def test_files_of_a_fit(self):
        rows = [f"{1e3 * t},{1e6 * i}" for t, i in zip(self.time, self.noisy(0))]
        data = self.folder / "measured.csv"
        data.write_text("\n".join(["time [ms],current_difference [uA]", *rows]))
        fit = ionskin.fit(self.off(), data, [K, D], self.folder / "fitted", report=True)
        for name in ("fitted.toml", "fit.json", "fit.csv", "manifest.json", "figures/fit.png", "figures/fit.pdf"):
            self.assertTrue((self.folder / "fitted" / name).exists(), name)
        fitted = ionskin.Case.from_file(self.folder / "fitted" / "fitted.toml")
        for key in (K, D):
            self.assertAlmostEqual(fitted[key] / fit[key], 1, delta=1e-12)
        sampled = ionskin.run(fitted).sampled
        numpy.testing.assert_allclose(sampled["current_difference"], fit.fitted, rtol=0, atol=1e-6 * self.rms)
        numpy.testing.assert_allclose(fit.measured - fit.fitted, self.noisy(0) - fit.fitted, atol=1e-9 * self.rms)
        with self.assertRaises(ionskin.CaseError):
            ionskin.fit(self.off(), data, [K], self.folder / "fitted")

    def test_a_stopped_fit_goes_on(self):
        data = self.folder / "measured.csv"
        data.write_text("\n".join(["time [s],current_difference [A]", *(f"{t},{i}" for t, i in zip(self.time, self.noisy(0)))]))

        def stop(activity, fraction):
            if activity == "least squares" and fraction > 0:
                raise ZeroDivisionError("enough")

        arguments = (self.off(), data, [K, D], self.folder / "fitted")
        with self.assertRaises(ZeroDivisionError):
            ionskin.fit(*arguments, progress=stop)
        with self.assertRaises(ionskin.CaseError):
            ionskin.fit(*arguments)
        resumed = ionskin.fit(*arguments, resume=True)
        whole = ionskin.fit(*arguments[:3], self.folder / "whole")
        self.assertGreaterEqual(resumed.summary["evaluations_taken_up"], 5)
        self.assertEqual(resumed.parameters, whole.parameters)

    def test_a_negative_key_keeps_its_sign(self):
        case = self.case.copy()
        case[K] = -0.05
        fit = ionskin.FitModel(case, [K]).fit(self.time, -self.current)
        self.assertAlmostEqual(fit[K], -0.1, delta=1e-4)
        self.assertLess(fit.parameters[K].lower_95, fit[K])
        self.assertLess(fit[K], fit.parameters[K].upper_95)

    def test_mistakes(self):
        for free, words in ((["coupling.coeficient"], "did you mean coupling.coefficient"), (["coupling.law"], "single real"),
                            (["skin.layers"], "unknown key"), ([], "no free key"), ([K, K], "twice"),
                            (["electrochemistry.valence"], "single real"), (["numerics.mesh_refinement"], "how to compute")):
            with self.subTest(free), self.assertRaises(ionskin.CaseError) as raised:
                ionskin.FitModel(self.case, free)
            self.assertIn(words, str(raised.exception))
        model = ionskin.FitModel(self.case, [K, D])
        for time, values, column, words in (([1, 2], [0, 0], "current_top", "2 rows"), ([1, 2, 9], [0] * 3, "charge_top", "ends at"),
                                            ([1, 2, 3], [0] * 3, "voltage", "readout.circuit"), ([1, 2], [0], "voltage", "one length"),
                                            ([2, 1], [0, 0], "voltage", "ascend"), ([1], [0], "force", "known:")):
            with self.subTest(words), self.assertRaises(ionskin.CaseError) as raised:
                model.fit(time, values, column)
            self.assertIn(words, str(raised.exception))


if __name__ == "__main__":
    unittest.main()
