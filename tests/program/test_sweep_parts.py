# SPDX-License-Identifier: Apache-2.0
"""Sweeps in parts: planned, done batch by batch in any order and beside each other, collected; damage and mistakes."""

import json
import os
import subprocess
import unittest

from program import PROGRAM, QUICK, SMALL, ProgramTest

GRID = (*SMALL, "--over", "contact.friction=0.1,0.2", "--over", "motion.preload=1 um,1.5 um")
DEEP = '{"program": {"name": "ionskin"}, "digest": "", "metrics": ' + "[" * 1_000_000 + "]" * 1_000_000 + "}"
MECHANICS = (*SMALL, "--only", "mechanics", "--over", "motion.preload=1 um,1.5 um")


class SweepParts(ProgramTest):
    def plan(self, *arguments, folder="parts"):
        """Plans a sweep and returns plan.json."""
        self.run_program("sweep", QUICK, *arguments, "--plan", "-o", folder)
        return json.loads((self.folder / folder / "plan.json").read_text())

    def do_batch(self, number, expect=0):
        return self.run_program("sweep", "--do-batch", number, "-o", "parts", expect=expect)

    def collect(self, expect=0):
        return self.run_program("sweep", "--collect", "-o", "parts", "--no-report", expect=expect)

    def assert_same_tables(self):
        """Asserts that the tables of the sweep in parts and of the serial one are the same to the last bit."""
        for name in ("sweep.csv", "case.toml"):
            self.assertEqual(*((self.folder / out / name).read_text() for out in ("parts", "serial")))

    def test_batches_beside_each_other_with_one_killed_give_the_serial_tables(self):
        self.run_program("sweep", QUICK, *GRID, "-o", "serial", "--no-report", "--threads", 1)
        plan = self.plan(*GRID)
        self.assertEqual([[point["edits"] for point in batch["points"]] for batch in plan["batches"]],
                         [[[f"contact.friction={f}", f"motion.preload={p}"] for f in ("0.1", "0.2")] for p in ("1 um", "1.5 um")])
        for batch in plan["batches"]:
            self.assertEqual((batch["threads"], batch["contact_solutions"]), (1, 2))
            self.assertGreater(batch["memory_bytes"], 1e8)
            self.assertGreater(batch["seconds"], 0.1)
        self.assertIn("4 of 4 points are still to be solved", self.collect(expect=4).stderr)
        self.end_at_file(3, "sweep", "--do-batch", 1, "-o", "parts", "--quiet", below="parts/staging")
        self.assertTrue(list(self.folder.glob("parts/staging/*/*/*")))
        with subprocess.Popen([PROGRAM, "sweep", "--do-batch", "0", "-o", "parts", "--quiet"], cwd=self.folder) as beside:
            self.do_batch(1)
            self.assertEqual(beside.wait(), 0)
        self.collect()
        self.assert_same_tables()
        self.assertFalse((self.folder / "parts" / "staging").exists())
        files = {path: path.stat().st_mtime_ns for path in self.folder.glob("parts/points/*/*")}
        self.do_batch(0)
        self.assertEqual(files, {path: path.stat().st_mtime_ns for path in self.folder.glob("parts/points/*/*")})

    def test_a_point_that_fails_is_a_row(self):
        """A fixed charge below zero fails one of two points."""
        over = (*SMALL, "--over", "coupling.coefficient=0.1,-40")
        self.run_program("sweep", QUICK, *over, "-o", "serial", "--no-report")
        for batch in range(len(self.plan(*over)["batches"])):
            process = self.run_program("sweep", "--do-batch", batch, "-o", "parts")
            self.assertIn("1 of 2 points failed", process.stderr)
        self.collect()
        self.assert_same_tables()

    def test_resume_finishes_what_batches_left(self):
        self.run_program("sweep", QUICK, *MECHANICS, "-o", "serial", "--no-report")
        self.plan(*MECHANICS)
        self.do_batch(1)
        self.assertIn("1 of 2 points are still to be solved", self.collect(expect=4).stderr)
        self.run_program("sweep", QUICK, *MECHANICS, "-o", "parts", "--resume", "--no-report")
        self.assert_same_tables()

    def test_sampled_sweeps(self):
        sampled = (*SMALL, "--only", "mechanics", "--samples", 2, "--seed", 5, "--over", "motion.preload=0.5:1.5 um")
        self.run_program("sweep", QUICK, *sampled, "-o", "serial", "--no-report")
        for batch in range(len(self.plan(*sampled)["batches"])):
            self.do_batch(batch)
        self.collect()
        self.assert_same_tables()

    def test_mistakes(self):
        self.assertIn("no plan.json", self.do_batch(0, expect=2).stderr)
        self.assertIn("no plan.json", self.collect(expect=2).stderr)
        self.plan(*MECHANICS)
        self.assertIn("its batches are 0 to 1", self.do_batch(2, expect=2).stderr)
        self.assertIn("-1 is not a whole number", self.do_batch(-1, expect=2).stderr)
        self.run_program("sweep", QUICK, "--do-batch", 0, "-o", "parts", expect=2)
        self.run_program("sweep", "-o", "parts", expect=2)
        path = self.folder / "parts" / "plan.json"
        plan = path.read_text()
        for changed, words in ((plan.replace("1 um", "2 um"), "damaged"), (plan[:-100], "damaged"), ("{}", "damaged"),
                               ("[]", "damaged")):
            path.write_text(changed)
            self.assertIn(words, self.do_batch(0, expect=2).stderr)
            self.assertIn(words, self.collect(expect=2).stderr)
        path.write_text(DEEP)
        self.assertIn("damaged", self.do_batch(0, expect=2).stderr)
        self.assertIn("damaged", self.collect(expect=2).stderr)
        path.unlink()
        os.mkfifo(path)
        self.assertIn("a pipe", self.do_batch(0, expect=2).stderr)
        self.assertIn("a pipe", self.collect(expect=2).stderr)

    def test_records_of_points_that_are_none(self):
        """A point whose records are nested deep, of wrong types, pipes or folders is one that is still to be solved."""
        self.plan(*MECHANICS)
        self.do_batch(0)
        self.do_batch(1)
        self.collect()
        first, second = sorted((self.folder / "parts" / "points").iterdir())
        for name in ("manifest.json", "summary.json"):
            path = first / name
            whole = path.read_bytes()
            for content in (DEEP.encode(), b"[" * 1_000_000, b"{}", b"3", b'{"program": {"name": 3}}', whole[:100],
                            whole.replace(b'"', b"'"), whole.replace(b": ", b": -")):
                path.write_bytes(content)
                self.assertIn("1 of 2 points are still to be solved", self.collect(expect=4).stderr, (name, content[:40]))
            path.unlink()
            for make in (os.mkfifo, os.mkdir, lambda place: place.symlink_to(place)):
                make(path)
                self.assertIn("1 of 2 points are still to be solved", self.collect(expect=4).stderr, name)
                path.rmdir() if path.is_dir() else path.unlink()
            path.write_bytes(whole)
        self.collect()
        (first / "manifest.json").write_text(DEEP)
        self.run_program("sweep", QUICK, *MECHANICS, "-o", "parts", "--resume", "--no-report")
        self.assertIn("finished", (self.folder / "parts" / "sweep.csv").read_text())
        self.assertTrue(second.is_dir())

    def test_a_running_sweep_keeps_batches_out(self):
        self.plan(*MECHANICS)
        whole = ("sweep", QUICK, *MECHANICS, "-o", "parts", "--resume", "--no-report", "--quiet")
        with self.stopped_at_file(1, *whole, below="parts/staging"):
            self.assertIn("another ionskin is writing", self.do_batch(0, expect=2).stderr)
        self.do_batch(0)


if __name__ == "__main__":
    unittest.main()
