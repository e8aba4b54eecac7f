# SPDX-License-Identifier: Apache-2.0
"""Runs and sweeps from Python: results, progress, interrupts, errors."""

import os
import signal
import threading
import time
import unittest

import numpy

import ionskin
from package import PackageTest, small_case


class Run(PackageTest):
    def test_results_and_progress(self):
        seen = []
        result = ionskin.run(small_case(), self.folder / "out", threads=2, progress=lambda *state: seen.append(state))
        self.assertEqual(result.signals.units["current_difference"], "A")
        self.assertEqual(result.signals["current_difference"].shape, result.signals["time"].shape)
        self.assertGreater(result.metrics["normal_force_slide"].value, 50)
        self.assertLessEqual({"mechanics", "strain history", "ion transport", "results and report"}, {name for name, _ in seen})
        self.assertTrue(all(0 <= fraction <= 1 for _, fraction in seen))
        opened = ionskin.open_results(self.folder / "out")
        numpy.testing.assert_array_equal(opened.signals["charge_top"], result.signals["charge_top"])
        self.assertEqual(opened.to_xarray()["current_top"].attrs["units"], "A")
        with self.assertRaises(ionskin.CaseError) as raised:
            ionskin.run(small_case(), self.folder / "out")
        self.assertIn("already holds files", str(raised.exception))
        electro = small_case()
        electro["coupling.coefficient"] = 0.2
        twice = ionskin.run(electro, self.folder / "out", only="electrochemistry")
        self.assertGreater(twice.metrics["rms_current_top"].value, 1.5 * result.metrics["rms_current_top"].value)

    def test_the_mechanics_of_a_run_that_goes_on_can_be_read(self):
        folder = self.folder / "out"
        refused, partial = [], []

        def look(activity, fraction):
            if activity == "mechanics" and not refused:
                with self.assertRaises(FileNotFoundError) as raised:
                    ionskin.open_results(folder)
                refused.append(str(raised.exception))
            if activity == "ion transport" and fraction > 0 and not partial:
                partial.append(ionskin.open_results(folder))
                with self.assertRaisesRegex(FileNotFoundError, "not ended in its stage electrochemistry"):
                    ionskin.Results(folder)

        result = ionskin.run(small_case(), folder, progress=look)
        self.assertIn("not ended in its stage mechanics", refused[0])
        begun = partial[0]
        self.assertEqual((begun.complete, result.complete), (False, True))
        self.assertEqual(begun.signals.units["normal_force"], "N")
        self.assertFalse(begun.sampled.has("current_top"))
        self.assertEqual(begun.phases(), [])
        for name in ("slider_x", "slider_z", "normal_force", "tangential_force"):
            numpy.testing.assert_allclose(begun.signals[name], result.signals.at(name, begun.signals["time"]),
                                          rtol=1e-9, atol=1e-15)
        self.assertEqual(begun.metrics["contact_area_slide"], result.metrics["contact_area_slide"])

    def test_tangential_force_has_two_components(self):
        case = small_case()
        case["motion.direction"], case["motion.stroke"] = [0.96, 0.28], "0.5 mm"
        case["numerics.mesh_refinement"], case["numerics.error_estimate"] = 0.25, "off"
        signals = ionskin.run(case, only="mechanics").signals
        x, y, along = (signals[f"tangential_force{end}"] for end in ("_x", "_y", ""))
        numpy.testing.assert_allclose(0.96 * x + 0.28 * y, along, rtol=1e-12, atol=1e-12)
        end = case["motion.touchdown"] + case["motion.slide"]  # what landing turned has slipped by then
        ratio = signals.at("tangential_force_y", end) / signals.at("tangential_force_x", end)
        self.assertAlmostEqual(ratio, 0.28 / 0.96, delta=1e-3)

    def test_temporary_results_live_as_long_as_they_are_held(self):
        result = ionskin.run(small_case(), only="mechanics")
        with result.open_fields() as file:
            self.assertIn("strain", file)
        folder = result.folder
        del result
        self.assertFalse(folder.exists())

    def test_an_exception_in_progress_stops_the_run(self):
        def stop(activity, fraction):
            if activity == "ion transport" and fraction > 0.2:
                raise ZeroDivisionError("enough")

        with self.assertRaises(ZeroDivisionError):
            ionskin.run(small_case(), self.folder / "out", progress=stop)
        self.assertFalse((self.folder / "out" / "signals.csv").exists())
        self.assertIsInstance(ionskin.run(small_case(), self.folder / "out", resume=True), ionskin.Results)

    def test_interrupt(self):
        """SIGINT stops a run from the middle of the solver; Python's own handler is back afterwards."""
        def interrupt(activity, fraction):
            if activity == "ion transport" and 0.2 < fraction < 0.5:
                os.kill(os.getpid(), signal.SIGINT)

        before = signal.getsignal(signal.SIGINT)
        with self.assertRaises(KeyboardInterrupt):
            ionskin.run(small_case(), self.folder / "out", progress=interrupt)
        self.assertFalse((self.folder / "out" / "signals.csv").exists())
        self.assertEqual(signal.getsignal(signal.SIGINT), before)
        with self.assertRaises(KeyboardInterrupt):
            os.kill(os.getpid(), signal.SIGINT)

    def test_other_threads_go_on(self):
        """While one thread solves, this one works: the interpreter's lock is free."""
        done, turns = [], 0
        worker = threading.Thread(target=lambda: done.append(ionskin.run(small_case())))
        worker.start()
        while worker.is_alive():
            turns += 1
            time.sleep(0.002)
        self.assertEqual(len(done), 1)
        self.assertGreater(turns, 30)

    def test_a_solver_that_gives_up(self):
        case = small_case()
        case["coupling.coefficient"] = -30
        with self.assertRaises(ionskin.SolverError) as raised:
            ionskin.run(case, self.folder / "out")
        self.assertIn("fixed charge", str(raised.exception))
        self.assertIn("coupling.coefficient", raised.exception.remedy)
        with self.assertRaisesRegex(FileNotFoundError, "did not end .failed in its stage electrochemistry."):
            ionskin.Results(self.folder / "out")
        kept = ionskin.open_results(self.folder / "out")
        self.assertFalse(kept.complete)
        self.assertGreater(kept.signals["normal_force"].max(), 50)
        self.assertTrue(numpy.isnan(kept.signals["current_top"]).all())
        self.assertGreater(kept.metrics["normal_force_slide"].value, 50)


class Sweep(PackageTest):
    def test_grid_with_a_failing_point(self):
        swept = ionskin.sweep(small_case(), {"coupling.coefficient": [0.1, -60], "motion.preload": ["1 um", 0.5e-6]},
                              self.folder / "out")
        self.assertEqual([point.status for point in swept.points], ["finished", "finished", "failed", "failed"])
        numpy.testing.assert_allclose(swept.values("motion.preload"), [1e-6, 0.5e-6] * 2, rtol=1e-12)
        forces = swept.metric("normal_force_slide")
        self.assertAlmostEqual(forces[0] / forces[1], 2, delta=1e-6)
        self.assertTrue(numpy.isnan(forces[2]))
        single = small_case()
        single["motion.preload"] = 0.5e-6
        numpy.testing.assert_allclose(swept.result(1).signals["charge_top"], ionskin.run(single).signals["charge_top"],
                                      rtol=0, atol=1e-15)
        opened = ionskin.open_results(self.folder / "out")
        self.assertEqual(len(opened), 4)
        self.assertEqual(opened.keys, {"coupling.coefficient": "1", "motion.preload": "m"})

    def test_samples_and_mistakes(self):
        swept = ionskin.sweep(small_case(), {"contact.friction": (0.1, 0.5)}, samples=2, seed=3, only="mechanics")
        self.assertTrue(((0.1 <= swept.values("contact.friction")) & (swept.values("contact.friction") <= 0.5)).all())
        for over, settings, words in (({"contact.friction": [0.1, 5]}, {}, "point 2"), ({}, {}, "at least one key"),
                                      ({"contact.friction": [1, 2, 3]}, {"samples": 2}, "pair"),
                                      ({"contact.friction": "0.1"}, {"only": "ions"}, "mechanics"),
                                      ({"contact.friction": "0.1"}, {"overwrite": True, "resume": True}, "exclude")):
            with self.subTest(over), self.assertRaises(ionskin.CaseError) as raised:
                ionskin.sweep(small_case(), over, **settings)
            self.assertIn(words, str(raised.exception))

    def test_no_point_left(self):
        with self.assertRaises(ionskin.SolverError):
            ionskin.sweep(small_case(), {"coupling.coefficient": [-60]})


if __name__ == "__main__":
    unittest.main()
