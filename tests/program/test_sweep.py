# SPDX-License-Identifier: Apache-2.0
"""Sweeps: sharing, killing and resuming, points that fail, bad input."""

import csv
import os
import re
import resource
import shutil
import signal
import subprocess
import unittest

import h5py
import numpy

from program import PROGRAM, QUICK, SMALL, ProgramTest, metric, signals

SWEEP = ("sweep", QUICK, "-o", "out", "--no-report", *SMALL, "--over", "contact.friction=0.1,0.4")


def rows(folder):
    """sweep.csv as dictionaries."""
    with open(folder / "sweep.csv", newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


class Sweep(ProgramTest):
    def assert_same_tables(self, first, second):
        """Asserts that two tables are the same to the last digit."""
        self.assertEqual(len(rows(first)), len(rows(second)))
        for one, two in zip(rows(first), rows(second)):
            self.assertEqual(one, two)

    def test_kill_and_resume(self):
        """Killed ten times, each time before a certain file gets its name, or without one of its points, the sweep ends with
        the table of an untouched one on one thread, which equals a run of its point's case, which has the ParaView files, too."""
        self.run_program(*SWEEP[:2], "-o", "whole", *SWEEP[4:], "--threads", 1)
        points = (("out/staging", (1, 2, 3, 5, 8, 12, 16)), ("out/points", (1, 2)), ("out/sweep.h5", (1,)))
        for place, number in ((place, number) for place, numbers in points for number in numbers):
            resumed = ["--resume"] if (self.folder / "out").exists() else []
            self.end_at_file(number, *SWEEP, *resumed, below=place)
        self.run_program(*SWEEP, "--resume")
        self.assert_same_tables(self.folder / "out", self.folder / "whole")
        self.assertEqual([row["status"] for row in rows(self.folder / "out")], ["finished"] * 2)
        point = self.folder / "out" / "points" / "0002_friction=0.4"
        self.run_case(point / "case.toml", "-o", "single")
        self.assertFalse((point / "fields").exists())
        self.assertTrue((self.folder / "single" / "fields" / "fields.pvd").exists())
        swept = signals(point)
        for table in ("signals.csv", "sampled.csv"):
            self.assertEqual((point / table).read_text(), (self.folder / "single" / table).read_text())
        with h5py.File(self.folder / "out" / "sweep.h5") as file:
            numpy.testing.assert_array_equal(file["points/0002_friction=0.4/signals/current_top"], swept["current_top"])
            numpy.testing.assert_array_equal(file["swept/contact.friction"], [0.1, 0.4])
            self.assertEqual(file["metrics/normal_force_slide"].attrs["unit"], "N")
        shutil.rmtree(point)
        self.run_program(*SWEEP, "--resume")
        self.assert_same_tables(self.folder / "out", self.folder / "whole")

    def test_resuming_a_finished_sweep_leaves_its_points(self):
        self.run_program(*SWEEP, "--only", "mechanics")
        files = sorted((self.folder / "out" / "points").glob("*/*.*"))
        before = [(path, path.stat().st_mtime_ns) for path in files]
        self.run_program(*SWEEP, "--only", "mechanics", "--resume")
        self.assertEqual(before, [(path, path.stat().st_mtime_ns) for path in files])

    def test_interrupt_keeps_finished_points(self):
        self.end_at_file(1, *SWEEP, "--threads", "1", below="out/points", how=signal.SIGINT, expect=130)
        self.assertEqual([row["status"] for row in rows(self.folder / "out")], ["finished", "pending"])
        process = self.run_program(*SWEEP, "--over", "motion.stroke=3 mm", "--resume", expect=2)
        self.assertIn("another case", process.stderr)

    def test_a_poisoned_point_leaves_the_others(self):
        """A fixed charge below zero fails one of two points; mechanics is the same for both."""
        small = (*SMALL, "--set", "numerics.error_estimate=on")
        sweep = ("sweep", QUICK, "--no-report", *small, "--over", "coupling.coefficient=0.1,-40")
        process = self.run_program(*sweep, "-o", "out")
        self.assertIn("1 of 2 points failed", process.stderr)
        good, bad = rows(self.folder / "out")
        self.assertEqual((good["status"], bad["status"]), ("finished", "failed"))
        self.assertIn("fixed charge", bad["reason"])
        self.run_case(QUICK, "-o", "single", *small)
        self.assertAlmostEqual(float(good["rms_current_difference [A]"]),
                               metric(self.folder / "single", "rms_current_difference"), delta=1e-15)
        self.run_program(*sweep[:-1], "coupling.coefficient=-40", "-o", "none", expect=3)

    def test_a_mesh_too_large_for_the_memory_is_refused_or_leaves_the_other_points(self):
        bound = 1024**3

        def sweep(**environment):
            return subprocess.run(
                [PROGRAM, "sweep", QUICK, "-o", "out", "--no-report", "--only", "mechanics", "--threads", "1", *SMALL,
                 "--over", "numerics.mesh_refinement=0.3,6"], capture_output=True, text=True, cwd=self.folder, check=False,
                timeout=300, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (bound, bound)),
                env={**os.environ, **environment})

        refused = sweep()
        self.assertEqual(refused.returncode, 2, refused.stderr)
        self.assertIn("IONSKIN_MEMORY_LIMIT", refused.stderr)
        self.assertFalse((self.folder / "out").exists())
        process = sweep(IONSKIN_MEMORY_LIMIT="64 GB")
        self.assertEqual(process.returncode, 0, process.stderr)
        small, large = rows(self.folder / "out")
        self.assertEqual((large["status"], small["status"]), ("failed", "finished"))
        self.assertIn("out of memory", large["reason"])

    def test_a_contact_off_the_skin_leaves_the_other_points(self):
        """The contact of a cylinder is known to leave the skin only once it is solved: too late to end the sweep."""
        near_edge = ("--set", "slider.shape=cylinder", "--set", "slider.radius=3 mm", "--set", 'slider.size=["6 mm", "1.5 mm"]',
                     "--set", 'slider.start=["0.2 mm", "1 mm"]', "--set", "motion.stroke=1 mm")
        sweep = ("sweep", QUICK, "--no-report", *SMALL, "--set", "numerics.error_estimate=off", *near_edge, "--only", "mechanics", "--over", "contact.friction=0.1,0.3")
        process = self.run_program(*sweep, "--over", "motion.preload=2 um,20 um", "-o", "out")
        self.assertIn("2 of 4 points failed", process.stderr)
        by_preload = {(row["motion.preload [m]"], row["contact.friction [1]"]): row for row in rows(self.folder / "out")}
        for (preload, _), row in by_preload.items():
            good = float(preload) < 1e-5
            self.assertEqual(row["status"], "finished" if good else "failed")
            self.assertRegex(row["reason"], "^$" if good else "^the contact reaches the edge of the skin along x: it needs more than "
                             "the .* mm on each side .*; move slider.start, shorten motion.stroke, lower motion.preload")
        process = self.run_program(*sweep, "--over", "motion.preload=20 um", "-o", "none", expect=3)
        self.assertEqual([row["status"] for row in rows(self.folder / "none")], ["failed"] * 2)

    def test_bad_sweeps_do_no_work(self):
        for over, words in (("contact.friction=0.1,5", "point 2"), ("contact.fricton=0.1,0.2", "contact.friction"),
                            ("motion.stroke=1 mm:1 um:2 mm", "units"), ("contact.friction=0.1:0.2", "--samples")):
            with self.subTest(over):
                process = self.run_program("sweep", QUICK, "-o", "out", "--over", over, expect=2)
                self.assertIn(words, process.stderr)
                self.assertFalse((self.folder / "out").exists())

    def test_tells_its_cost_beforehand(self):
        """Answering --explain does no work."""
        shared = self.run_program("sweep", QUICK, "-o", "out", *SMALL, "--over", "contact.friction=0.1:0.1:0.5", "--explain")
        self.assertRegex(shared.stdout, r"^5 points, 5 contact solutions that share 1 skin; about .* s with ")
        seconds = []
        for points in (3, 40):
            apart = self.run_program("sweep", QUICK, "-o", "out", *SMALL, "--over", "slider.start[0]=4:5 mm", "--samples",
                                     points, "--explain").stdout
            told = re.match(f"{points} points, {points} contact solutions; about ([\\d.]+) (s|min) ", apart)
            seconds.append(float(told[1]) * {"s": 1, "min": 60}[told[2]])
        self.assertGreater(seconds[1], 1.5 * seconds[0])
        self.assertFalse((self.folder / "out").exists())

    def test_entries_of_lists_are_numbers_with_units(self):
        self.run_program("sweep", QUICK, "-o", "out", "--no-report", *SMALL, "--only", "mechanics", "--over",
                         "slider.start[0]=4.4 mm,0.0046 m")
        self.assertEqual([row["slider.start[0] [m]"] for row in rows(self.folder / "out")], ["0.0044", "0.0046"])

    def test_sampled_mechanics(self):
        """A seeded design over two keys, mechanics alone."""
        self.run_program("sweep", QUICK, "-o", "out", "--no-report", *SMALL, "--only", "mechanics", "--samples", 2, "--seed", 5,
                         "--over", "contact.friction=0.1:0.5", "--over", "motion.preload=0.5:1.5 um")
        for row in rows(self.folder / "out"):
            self.assertEqual(row["status"], "finished")
            self.assertTrue(0.5e-6 <= float(row["motion.preload [m]"]) <= 1.5e-6)
            # Flat slider: the force is in proportion to the preload; 65 N/um for more cells and free sides.
            self.assertAlmostEqual(float(row["normal_force_slide [N]"]) / float(row["motion.preload [m]"]), 63.5e6,
                                   delta=0.6e6)


if __name__ == "__main__":
    unittest.main()
