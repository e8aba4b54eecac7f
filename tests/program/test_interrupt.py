# SPDX-License-Identifier: Apache-2.0
"""An interrupted run keeps what it finished, and --resume ends with the same result."""

import json
import signal
import unittest

import h5py
import numpy

from program import QUICK, ProgramTest, signals


class Interrupt(ProgramTest):
    def stage_finished(self, stage):
        """True once the manifest in `out` says that a stage is finished."""
        try:
            manifest = json.loads((self.folder / "out" / "manifest.json").read_text())
        except (OSError, ValueError):
            return False
        return manifest.get("stages", {}).get(stage, {}).get("state") == "finished"

    def assert_resumes_to_the_same(self):
        self.run_case(QUICK, "-o", "out", "--resume")
        self.run_case(QUICK, "-o", "whole")
        resumed, whole = signals(self.folder / "out"), signals(self.folder / "whole")
        for name in ("time", "charge_top", "current_top", "mean_shear", "normal_force"):
            numpy.testing.assert_array_equal(resumed[name], whole[name], name)

    def test_during_mechanics(self):
        self.interrupt_program("run", QUICK, "--no-report", "-o", "out", when=(self.folder / "out" / "case.toml").exists)
        self.assertFalse((self.folder / "out" / "signals.csv").exists())
        self.assert_resumes_to_the_same()

    def test_during_electrochemistry(self):
        self.interrupt_program("run", QUICK, "--no-report", "-o", "out", how=signal.SIGTERM,
                               when=lambda: self.stage_finished("strain"))
        with h5py.File(self.folder / "out" / "results.h5") as file:
            self.assertTrue(numpy.isfinite(file["strain/gamma"][...]).all())
        self.assertEqual(list((self.folder / "out").glob("*.ionskin-pending")), [])
        self.assert_resumes_to_the_same()

    def test_one_study_after_the_other(self):
        self.run_case(QUICK, "-o", "apart", "--only", "electrochemistry", expect=2)
        self.run_case(QUICK, "-o", "out", "--only", "mechanics")
        mechanics = signals(self.folder / "out")
        self.assertTrue(numpy.isnan(mechanics["current_top"]).all())
        self.assertGreater(mechanics["normal_force"].max(), 60)
        self.run_case(QUICK, "-o", "out", "--only", "electrochemistry")
        self.run_case(QUICK, "-o", "whole")
        numpy.testing.assert_array_equal(signals(self.folder / "out")["current_top"],
                                         signals(self.folder / "whole")["current_top"])

    def test_solver_that_gives_up_keeps_the_mechanics(self):
        """A fixed charge below zero that only Study 1 reveals: exit 3, the strain is kept."""
        process = self.run_case(QUICK, "-o", "out", "--set", "coupling.coefficient=-40", expect=3)
        for words in ("fixed charge", "remedy"):
            self.assertIn(words, process.stderr)
        with h5py.File(self.folder / "out" / "results.h5") as file:
            self.assertGreater(file["strain/gamma"][...].max(), 0)
            self.assertIn("contact/touchdown/pressure", file)
        self.assertFalse((self.folder / "out" / "signals.csv").exists())

    def test_resume_refuses_another_case(self):
        self.interrupt_program("run", QUICK, "--no-report", "-o", "out", when=lambda: self.stage_finished("strain"))
        process = self.run_case(QUICK, "-o", "out", "--resume", "--set", "contact.friction=0.1",
                                   expect=2)
        self.assertIn("--overwrite", process.stderr)


if __name__ == "__main__":
    unittest.main()
