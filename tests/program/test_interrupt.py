# SPDX-License-Identifier: Apache-2.0
"""An interrupted run keeps what it finished, and --resume ends with the same result."""

import json
import pathlib
import shutil
import signal
import subprocess
import unittest

import h5py
import numpy

from program import PROGRAM, QUICK, ROLLERS, ProgramTest, signals, summary

# A mesh and steps that serve to test the bookkeeping, not the physics.
SMALL = (QUICK, "--set", "numerics.mesh_refinement=0.3", "--set", "numerics.time_refinement=0.3", *ROLLERS)


class Interrupt(ProgramTest):
    def stages(self):
        """Statement of the manifest in `out` on each stage."""
        try:
            manifest = json.loads((self.folder / "out" / "manifest.json").read_text())
        except (OSError, ValueError):
            return {}
        return manifest.get("stages", {})

    whole = None

    def undisturbed(self):
        """Signals of a run that nothing interrupts, made once."""
        if Interrupt.whole is None:
            self.run_case(*SMALL, "-o", "whole")
            Interrupt.whole = signals(self.folder / "whole")
        return Interrupt.whole

    def assert_resumes_to_the_same(self):
        self.run_case(*SMALL, "-o", "out", "--resume")
        resumed, whole = signals(self.folder / "out"), self.undisturbed()
        for name in ("time", "charge_top", "current_top", "mean_shear", "normal_force"):
            numpy.testing.assert_array_equal(resumed[name], whole[name], name)

    def test_during_mechanics(self):
        self.end_at_progress("mechanics", "run", *SMALL, "--no-report", "-o", "out")
        self.assertFalse((self.folder / "out" / "signals.csv").exists())
        self.assert_resumes_to_the_same()

    def test_during_electrochemistry(self):
        self.end_at_progress("ion transport", "run", *SMALL, "--no-report", "-o", "out", how=signal.SIGTERM)
        with h5py.File(self.folder / "out" / "results.h5") as file:
            self.assertTrue(numpy.isfinite(file["strain/gamma"][...]).all())
        self.assertEqual(list((self.folder / "out").glob("*.ionskin-pending")), [])
        self.assert_resumes_to_the_same()

    def test_while_water_moves(self):
        """The law `poroelastic` remembers: where its water stands is part of what a run goes on from."""
        time = numpy.linspace(0, 4, 401)
        wave = numpy.sin(40 * time)[:, None] * numpy.linspace(0, 1, 60)
        with h5py.File(self.folder / "pressure.h5", "w") as file:
            file["grid/x"], file["grid/y"] = numpy.linspace(0, 15e-3, 61), [0, 2e-3]
            file["grid/z"], file["time"] = [0, 180e-6], time
            pressure = numpy.stack([wave, 0 * wave], axis=1)[:, :, None, :]
            file["channels/undrained_pressure"] = 1e5 * pressure
            file["channels/undrained_pressure"].attrs["unit"] = "Pa"
            file.attrs.update({"format": "ionskin-strain", "version": 2, "measure": "given", "frame": "skin"})
        case = self.write("wet.toml", QUICK.read_text().replace("coefficient = 0.1", 'law = "poroelastic"') + """
[strain]
source = "file"
file = "pressure.h5"
[water]
drag_number = 2.5
drained_poissons_ratio = 0.4
mobility = "5e-17 m2/(Pa s)"
""")
        self.end_at_progress("ion transport", "run", case, "--no-report", "-o", "out")
        with h5py.File(self.folder / "out" / "checkpoint.h5") as file:
            self.assertIn("water/pressure", file)
        self.run_case(case, "-o", "out", "--resume")
        self.run_case(case, "-o", "whole")
        numpy.testing.assert_array_equal(signals(self.folder / "out")["charge_top"],
                                         signals(self.folder / "whole")["charge_top"])

    def test_during_the_error_estimate(self):
        """Both studies are finished and kept to their end."""
        self.end_at_progress("error estimate", "run", *SMALL, "--no-report", "-o", "out")
        self.assertFalse((self.folder / "out" / "signals.csv").exists())
        with h5py.File(self.folder / "out" / "checkpoint.h5") as file:
            last = file["rows/time"][-1]
        kept = self.stages()
        self.assert_resumes_to_the_same()
        self.assertEqual(self.stages()["mechanics"], kept["mechanics"])
        self.assertEqual(signals(self.folder / "out")["time"][-1], last)

    def test_another_build_does_everything_again(self):
        solver = self.folder / "ionskin-solver"
        shutil.copy(pathlib.Path(PROGRAM).with_name("ionskin-solver"), solver)
        with open(solver, "ab") as file:
            file.write(b"0")
        small = [*SMALL, "-o", "out", "--only", "mechanics"]
        self.run_case(*small)
        kept = self.stages()
        subprocess.run([solver, "run", *small, "--no-report", "--resume"], cwd=self.folder, capture_output=True, check=True)
        self.assertNotEqual(self.stages()["mechanics"], kept["mechanics"])
        self.assertIn("Another build of ionskin began this run: everything is done again.",
                      summary(self.folder / "out")["warnings"])

    def test_one_study_after_the_other(self):
        self.run_case(*SMALL, "-o", "apart", "--only", "electrochemistry", expect=2)
        self.run_case(*SMALL, "-o", "out", "--only", "mechanics")
        mechanics = signals(self.folder / "out")
        self.assertTrue(numpy.isnan(mechanics["current_top"]).all())
        self.assertGreater(mechanics["normal_force"].max(), 50)
        self.run_case(*SMALL, "-o", "out", "--only", "electrochemistry")
        numpy.testing.assert_array_equal(signals(self.folder / "out")["current_top"], self.undisturbed()["current_top"])
        # Study 1 is never removed before it is read.
        self.run_case(*SMALL, "-o", "out", "--only", "electrochemistry", "--overwrite", "--set", "coupling.coefficient=0.05")
        numpy.testing.assert_allclose(signals(self.folder / "out")["current_top"], self.undisturbed()["current_top"] / 2,
                                      rtol=0.01, atol=1e-3 * numpy.abs(self.undisturbed()["current_top"]).max())
        self.run_case(*SMALL, "-o", "out", "--only", "electrochemistry", "--overwrite")
        numpy.testing.assert_array_equal(signals(self.folder / "out")["current_top"], self.undisturbed()["current_top"])

    def test_solver_that_gives_up_keeps_the_mechanics(self):
        """A fixed charge below zero that only Study 1 reveals: exit 3, the strain is kept."""
        process = self.run_case(QUICK, "-o", "out", "--set", "coupling.coefficient=-30", expect=3)
        for words in ("fixed charge", "remedy"):
            self.assertIn(words, process.stderr)
        with h5py.File(self.folder / "out" / "results.h5") as file:
            self.assertGreater(file["strain/gamma"][...].max(), 0)
            self.assertIn("contact/touchdown/pressure", file)
        kept = signals(self.folder / "out")
        self.assertGreater(kept["normal_force"].max(), 60)
        self.assertTrue(numpy.isnan(kept["current_top"]).all())
        self.assert_unfinished()

    def assert_unfinished(self):
        """The folder says so, and has no figure of the currents."""
        self.assertEqual(json.loads((self.folder / "out" / "manifest.json").read_text())["state"], "failed")
        self.assertTrue(any("The run is unfinished" in warning for warning in summary(self.folder / "out")["warnings"]))
        self.assertFalse([name for name in summary(self.folder / "out")["metrics"] if "current" in name])
        self.assertIn("--resume", self.run_program("report", "out", expect=2).stderr)

    def test_solver_that_gives_up_on_its_way_keeps_the_signals_until_then(self):
        """Ions too crowded for the charge that shear asks for: exit 3 in the middle, and --resume continues from there."""
        case = (QUICK, "-o", "out", *(word for edit in (
            "skin.sides=symmetry", "skin.length=10 mm", "motion.stroke=1 mm", "numerics.mesh_refinement=0.3", "numerics.time_refinement=0.3",
            "numerics.error_estimate=off", "electrochemistry.ion_model=steric",
            "electrochemistry.largest_concentration=1210 mol/m3", "coupling.coefficient=10") for word in ("--set", edit)))
        lines = []
        for option in ((), ("--resume",)):
            self.assertIn("makes no progress", self.run_case(*case, *option, expect=3).stderr)
            with h5py.File(self.folder / "out" / "checkpoint.h5") as file:
                time, charge = file["rows/time"][...], file["rows/charge_top"][...]
            kept = signals(self.folder / "out")
            numpy.testing.assert_array_equal(kept["time"], time)
            numpy.testing.assert_array_equal(kept["charge_top"], charge)
            self.assertLess(time[-1], 1)
            sampled = signals(self.folder / "out", "sampled")
            self.assertLess(time[-1] - sampled["time"][-1], 0.01 * (1 + 1e-9))
            self.assertGreater(numpy.abs(sampled["current_top"]).max(), 0)
            self.assert_unfinished()
            lines.append((self.folder / "out" / "signals.csv").read_text().splitlines())
        self.assertGreater(len(lines[1]), len(lines[0]))
        self.assertEqual(lines[1][:len(lines[0]) - 1], lines[0][:-1])

    def test_contact_that_gives_up_keeps_the_signals_until_then(self):
        """A slider that swings on its drive to the edge of the skin; and one of which not even the first step is solved."""
        edits = {"skin.sides": "symmetry", "contact.law": "stribeck", "contact.kinetic_friction": "0.01", "contact.stribeck_speed": "1 mm/s",
                 "motion.drive.stiffness": "100 N/m", "motion.drive.mass": "5 g", "motion.preload": "0.5 N", "motion.stroke": "2 mm",
                 "slider.start": '["12 mm", "1 mm"]', "slider.size": '["1 mm", "0.4 mm"]', "numerics.mesh_refinement": "0.3",
                 "numerics.time_refinement": "0.3", "numerics.error_estimate": "off"}
        swings = (QUICK, "-o", "out", *(word for key, value in edits.items() for word in ("--set", f"{key}={value}")))
        adheres = (QUICK, "-o", "out", "--overwrite", "--set", "contact.law=adhesive", "--set", "contact.work_of_adhesion=0.01 J/m2",
                   "--set", "contact.cohesive_strength=1 MPa")
        for case, what, remedy in ((swings, "swings too far", "raise motion.drive.stiffness"), (adheres, "mesh is too coarse", "lower contact.cohesive")):
            told = self.run_case(*case, expect=3).stderr
            reason = json.loads((self.folder / "out" / "manifest.json").read_text())["reason"]
            warning = summary(self.folder / "out")["warnings"][-1]
            for text in (told, reason, warning):
                self.assertIn(what, text)
                self.assertIn(remedy, text)
            self.assert_unfinished()
            self.assertEqual(summary(self.folder / "out")["metrics"], {})
            self.assertFalse((self.folder / "out" / "results.h5").exists())
            if case == swings:
                kept = signals(self.folder / "out")
                self.assertGreater(len(kept["time"]), 10)
                self.assertLess(kept["time"][-1], 2.5)
                self.assertIn(f"end at {kept['time'][-1]:.6g} s", warning)
                self.assertAlmostEqual(kept["normal_force"][-1], 0.5, places=9)
                self.assertGreater(kept["slider_x"][-1], 13.9e-3)
                self.assertGreater(kept["mean_shear"].max(), 0)
                self.assertTrue(numpy.isnan(kept["current_top"]).all())
        self.assertFalse((self.folder / "out" / "signals.csv").exists())

    def test_resume_refuses_another_case(self):
        self.end_at_progress("ion transport", "run", *SMALL, "--no-report", "-o", "out")
        process = self.run_case(*SMALL, "-o", "out", "--resume", "--set", "contact.friction=0.1",
                                   expect=2)
        self.assertIn("--overwrite", process.stderr)


if __name__ == "__main__":
    unittest.main()
