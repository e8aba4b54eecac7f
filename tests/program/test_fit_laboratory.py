# SPDX-License-Identifier: Apache-2.0
"""`ionskin fit` on records as instruments leave them: the value lies in its interval, or a message says what to do."""

import json
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy

from program import PROGRAM, QUICK, SMALL, ProgramTest

K, SHIFT, BASELINE, DRIFT, GAIN = ("coupling.coefficient", "data.time_shift", "data.baseline", "data.drift", "data.gain")
TRUTH = 0.1  # of K; each fit starts from 0.12
EPOCH = 1403636580.838555


class LaboratoryData(ProgramTest):
    """The signal of one touch, landing and leaving sharp, with noise of half a per cent of its peak."""
    edits = (*SMALL, "--set", "readout.sample_interval=10 ms")

    @classmethod
    def setUpClass(cls):
        """The contact is solved once: every fit takes its strain, which gives the same signal to the bit."""
        super().setUpClass()
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        truth = Path(scratch.name) / "truth"
        subprocess.run([PROGRAM, "run", QUICK, "-o", truth, *cls.edits, "--no-report", "--quiet"], check=True)
        with open(truth / "sampled.csv", encoding="utf-8") as table:
            column = [title.split()[0] for title in table.readline().split(",")].index("current_difference")
            cls.time, cls.current = numpy.loadtxt(table, delimiter=",", usecols=(0, column), unpack=True)
        with open(truth / "signals.csv", encoding="utf-8") as table:
            titles = [title.split()[0] for title in table.readline().split(",")]
            columns = [titles.index(name) for name in ("time", "charge_top", "charge_bottom")]
            rows, top, bottom = numpy.loadtxt(table, delimiter=",", usecols=columns, unpack=True)
        cls.charge_at = staticmethod(lambda time: numpy.interp(time, rows, (top - bottom) / 2))
        cls.edits = (*cls.edits, "--set", "strain.source=file", "--set", f"strain.file={truth / 'results.h5'}")
        cls.size = numpy.abs(cls.current).max()
        cls.noise = numpy.random.default_rng(1).normal(0, 0.005 * cls.size, len(cls.time))

    def data(self, time, values, unit="s"):
        """A file of a record; values that are not numbers stay empty."""
        rows = [f"{t!r},{'' if numpy.isnan(v) else repr(v)}" for t, v in zip(map(float, time), map(float, values))]
        return self.write("data.csv", "\n".join([f"time [{unit}],current_difference [A]", *rows]) + "\n")

    def fit(self, data, *free, expect=0):
        """fit.json, or what a refusal says."""
        process = self.run_program("fit", QUICK, *self.edits, "--set", f"{K}=0.12", "--data", data, "--free",
                                   ",".join(free or (K,)), "-o", "out", "--overwrite", "--threads", "1", expect=expect)
        return process.stderr if expect else json.loads((self.folder / "out" / "fit.json").read_text())

    def by_own_clock(self, late):
        """Mean currents over the intervals of a clock that is late."""
        charge = self.charge_at(numpy.concatenate([[self.time[0] - 0.01], self.time]) - late)
        return numpy.diff(charge) / 0.01 + self.noise

    def assert_holds(self, fit, key, value):
        one = fit["parameters"][key]
        self.assertLessEqual(one["lower_95"], value, one)
        self.assertGreaterEqual(one["upper_95"], value, one)

    def assert_warns(self, fit, *words):
        for word in words:
            self.assertTrue(any(word in text for text in fit["warnings"]), (word, fit["warnings"]))

    def test_records_that_fit_with_what_their_instrument_did(self):
        noisy = self.current + self.noise
        clean = self.fit(self.data(self.time, noisy))
        self.assert_holds(clean, K, TRUTH)
        self.assertFalse([text for text in clean["warnings"] if "data" in text], clean["warnings"])
        gaps = noisy.copy()
        gaps[60:90] = numpy.nan  # in the slide
        gaps[45:52] = numpy.nan  # where it lands
        kept = numpy.isfinite(gaps)
        drift = 0.05 * self.size
        records = {
            "late, with a baseline": (self.time + 0.013, noisy + 0.02 * self.size, {SHIFT: 0.013, BASELINE: 0.02 * self.size}),
            "early": (self.time - 0.0267, noisy, {SHIFT: -0.0267}),
            "by the clock of the host": (self.time + EPOCH, noisy, {SHIFT: EPOCH}),
            "with empty rows": (self.time, gaps, {}),
            "with rows missing": (self.time[kept], gaps[kept], {}),
            "with a drift": (self.time, noisy + drift * (self.time - self.time[0]), {BASELINE: 0, DRIFT: drift}),
        }
        for name, (time, values, found) in records.items():
            with self.subTest(name):
                fit = self.fit(self.data(time, values), K, *found)
                self.assert_holds(fit, K, TRUTH)
                for key, value in found.items():
                    self.assert_holds(fit, key, value)
                self.assertLess(abs(fit["parameters"][K]["value"] / TRUTH - 1), 0.02)
                self.assertLessEqual(fit["ion_transport_solves"], 10 * clean["ion_transport_solves"])
        # A clock of its own: a pulse that is shorter than a row fits alike over a part of the row.
        for late in (0.0164, -0.0031):
            with self.subTest("by a clock of its own", late=late):
                fit = self.fit(self.data(self.time[3:-3], self.by_own_clock(late)[3:-3]), K, SHIFT)
                self.assert_holds(fit, SHIFT, late)
                self.assert_holds(fit, K, TRUTH)
        turned = self.fit(self.data(self.time, -noisy * TRUTH / 0.12), GAIN)
        self.assertLess(turned["parameters"][GAIN]["value"], 0)
        self.assert_warns(turned, "electrodes are swapped")
        # Without its landing the record is like the model in another place, too: where it lands.
        leaving = self.fit(self.data(self.time[60:], -noisy[60:] * TRUTH / 0.12), GAIN)
        self.assertAlmostEqual(leaving["parameters"][GAIN]["value"], -((TRUTH / 0.12) ** 2), delta=0.02)

    def test_records_that_end_with_what_to_do_before_any_search(self):
        noisy = self.current + self.noise
        twice = numpy.insert(self.time, 60, self.time[60])
        records = {
            "swapped": (self.time, -noisy, "correlate with minus the model"),
            "swapped and late": (self.time[:-5] + 0.05, -noisy[:-5], "correlate with minus the model"),
            "swapped, the shift being free": (self.time[3:-3], -self.by_own_clock(0.0164)[3:-3],
                                              "correlate with minus the model", SHIFT),
            "zero": (self.time, 0 * noisy, "the data hold no signal"),
            "constant": (self.time, 0 * noisy + 3.5e-5, "the data are constant"),
            "twice": (twice, numpy.insert(noisy, 60, 0), "appears twice"),
            "behind": (self.time + 5, noisy, "subtract it: 5 s"),
            "epoch": (self.time + EPOCH, noisy, "subtract it: 1403636580.8"),
            "late": (self.time[:-2] + 0.013, noisy[:-2] + 0.02 * self.size, "--free data.time_shift"),
            "in ms": (1e3 * self.time, noisy, "time [ms]"),
            "in TA": (self.time, 1e-12 * noisy, "check the unit in the header"),
            "in nA": (self.time, 1e3 * noisy, "check the unit in the header"),
        }
        for name, (time, values, words, *free) in records.items():
            with self.subTest(name):
                message = self.fit(self.data(time, values), K, *free, expect=2)
                self.assertIn(words, message)
                self.assertFalse((self.folder / "out" / "fit.json").exists())
        self.run_program("fit", QUICK, *self.edits, "--data", self.data(self.time, noisy), "--free", K, "-o", "out")

    def test_records_that_are_worse_than_the_interval_says_are_reported(self):
        limit = 0.5 * self.size
        clipped = self.fit(self.data(self.time, numpy.clip(self.current, -limit, limit)))
        self.assert_warns(clipped, "saturated")
        limit = 0.3 * self.size  # two peaks alone are above it, and leave the others' noise
        peaks = self.fit(self.data(self.time, numpy.clip(self.current + self.noise, -limit, limit)))
        self.assert_warns(peaks, "saturated")
        limit = 0.6 * self.size
        drifted = self.current + 0.1 * self.size * (self.time - self.time[0])
        self.assert_warns(self.fit(self.data(self.time, numpy.clip(drifted, -limit, limit)), K, BASELINE, DRIFT), "saturated")
        smooth = self.fit(self.data(self.time, numpy.convolve(self.current, (0.25, 0.5, 0.25), "same") + self.noise))
        self.assert_warns(smooth, "rows hold")
        offset = self.fit(self.data(self.time, self.current + self.noise + 0.1 * self.size))
        self.assert_warns(offset, "--free data.baseline")
        small = self.fit(self.data(self.time, (self.current + self.noise) / 50))
        self.assert_warns(small, "times the size of the start's signal")
        noise = self.fit(self.data(self.time, self.noise))
        self.assert_warns(noise, "do not follow the model at all")

    def test_the_fitted_case_tells_of_its_values_alone(self):
        case = self.write("case.toml", QUICK.read_text().replace(
            "coefficient = 0.1", "# 0.1 has been guessed\n# by nobody\ncoefficient = 0.1"))
        self.run_program("fit", case, *self.edits, "--set", f"{K}=0.12", "--data",
                         self.data(self.time, self.current + self.noise), "--free", f"{K},{BASELINE}", "-o", "out")
        text = (self.folder / "out" / "fitted.toml").read_text()
        self.assertTrue(text.startswith(f"# Fitted to data.csv: {K}\n"), text)
        for word in ("guess", "nobody", "no measurement"):
            self.assertNotIn(word, text)
        self.assertIn("# an installed preset", text)
        self.run_program("check", "out/fitted.toml")

    def test_keys_of_the_data_are_known(self):
        message = self.fit(self.data(self.time, self.current), K, "data.offset", expect=2)
        self.assertIn("data.time_shift, data.baseline, data.drift, data.gain", message)


if __name__ == "__main__":
    unittest.main()
