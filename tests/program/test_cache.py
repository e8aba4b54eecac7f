# SPDX-License-Identifier: Apache-2.0
"""The cache of factorised slider positions and of mechanics saves time and never changes a result."""

import json
import os
import resource
import shutil
import subprocess
import unittest

import h5py
import numpy

from program import PROGRAM, QUICK, SMALL, ProgramTest, signals, summary

ARGUMENTS = ("--only", "mechanics", "--quiet", "--no-report", *SMALL)
FORCES = ("normal_force", "tangential_force")
SHEARS = ("mean_shear", "rms_shear", "shear_first_moment")


class Cache(ProgramTest):
    def mechanics(self, out, *arguments):
        """Study 1 with a return of its own, which no earlier run had, so that only slider positions come again."""
        self.returns += 1
        self.run_program("run", QUICK, "-o", out, *ARGUMENTS, "--set", f"motion.return={1000 + self.returns} ms", *arguments)

    def setUp(self):
        super().setUp()
        os.environ["IONSKIN_CACHE_LIMIT"] = "1 GB"
        self.returns = 0
        self.mechanics("plain", "--no-cache")
        self.assertEqual(self.entries(), [])

    def entries(self, mechanics=False):
        """Entries of slider positions, or those of the whole mechanics, which are HDF5 files."""
        entries = sorted((self.folder / "cache").glob("*.ionskin-cache"))
        return [path for path in entries if (b"\x89HDF" in path.read_bytes()[:200]) == mechanics]

    def notes(self, out):
        return [text for text in summary(self.folder / out)["warnings"] if "cache" in text]

    def assert_agrees(self, out, reference="plain"):
        """With the reference, to the last digit."""
        found, expected = signals(self.folder / out), signals(self.folder / reference)
        for name in (*FORCES, *SHEARS):
            numpy.testing.assert_array_equal(found[name], expected[name], name)

    def test_points_of_a_sweep_take_their_mechanics_from_the_cache(self):
        def sweep(out, *arguments):
            self.run_program("sweep", QUICK, "-o", out, *ARGUMENTS, "--over", "contact.friction=0.1,0.3", *arguments)
            points = sorted((self.folder / out / "points").iterdir())
            solved = ["mechanics" in json.loads((point / "manifest.json").read_text())["stages"] for point in points]
            return (self.folder / out / "sweep.csv").read_text(), solved

        table, solved = sweep("sweep")
        self.assertEqual(solved, [True, True])
        self.assertEqual(len(self.entries(mechanics=True)), 2)
        self.assertEqual(sweep("again"), (table, [False, False]))
        self.assertEqual(sweep("uncached", "--no-cache")[1], [True, True])
        # A run finds what the sweep kept.
        self.run_program("run", QUICK, "-o", "run", *ARGUMENTS, "--set", "contact.friction=0.1")
        self.assertNotIn("mechanics", json.loads((self.folder / "run" / "manifest.json").read_text())["stages"])

    def test_cached_run_repeats_the_plain_one_and_damage_is_repaired(self):
        self.mechanics("first", "--set", "contact.friction=0.1")
        kept = self.entries()
        self.mechanics("cached")
        self.assertEqual(self.entries(), kept)  # positions serve any friction
        self.assert_agrees("cached")
        # A truncated entry, one of another version, and one with a changed number.
        first, second, third = self.entries()[:3]
        os.truncate(first, first.stat().st_size // 2)
        for path, place in ((second, 8), (third, third.stat().st_size - 100)):
            content = bytearray(path.read_bytes())
            content[place] ^= 1
            path.write_bytes(content)
        self.mechanics("damaged")
        self.assert_agrees("damaged")
        self.assertEqual(len(self.notes("damaged")), 1)
        self.assertIn("ignored and is replaced", self.notes("damaged")[0])
        self.mechanics("repaired")
        self.assert_agrees("repaired")
        self.assertEqual(self.notes("repaired"), [])

    def test_study_2_alone_changed_takes_up_the_mechanics(self):
        self.run_case(QUICK, *SMALL, "-o", "first")
        told = self.run_case(QUICK, *SMALL, "-o", "second", "--set", "coupling.coefficient=2e-4", "--progress", "lines").stderr
        self.assertIn("mechanics, from the cache", told)
        manifest = json.loads((self.folder / "second" / "manifest.json").read_text())
        self.assertNotIn("mechanics", manifest["stages"])
        self.assertEqual(manifest["stages"]["strain"]["source"], "cache")
        told = self.run_case(QUICK, *SMALL, "-o", "second", "--set", "coupling.coefficient=2e-4", "--only",
                             "electrochemistry", "--progress", "lines").stderr
        self.assertIn("mechanics, from an earlier run", told)
        first, second = signals(self.folder / "first"), signals(self.folder / "second")
        for name in (*FORCES, *SHEARS):
            self.assertEqual(numpy.interp(first["time"], second["time"], second[name]).max(), first[name].max(), name)
        with h5py.File(self.folder / "second" / "results.h5") as file:
            self.assertIn("contact/touchdown/pressure", file)
        [entry] = self.entries(mechanics=True)
        os.truncate(entry, entry.stat().st_size // 2)
        self.run_case(QUICK, *SMALL, "-o", "third")
        self.assertEqual(len(self.notes("third")), 1)
        numpy.testing.assert_array_equal(signals(self.folder / "third")["current_top"], first["current_top"])

    def test_killed_run_and_two_runs_at_once(self):
        self.end_at_file(2, "run", QUICK, "-o", "killed", *ARGUMENTS, below="cache")
        self.assertEqual(len(self.entries()), 1)
        both = [subprocess.Popen([PROGRAM, "run", QUICK, "-o", out, *ARGUMENTS], cwd=self.folder)
                for out in ("one", "other")]
        self.assertEqual([process.wait() for process in both], [0, 0])
        for out in ("one", "other"):
            self.assert_agrees(out)
            self.assertEqual(self.notes(out), [])

    def test_full_disk_costs_the_cache_only(self):
        finer = ("--set", "numerics.mesh_refinement=0.8")  # whose entries are larger than its results
        self.mechanics("first", *finer)
        sizes = {path: path.stat().st_size for path in self.entries()}
        limit = max(sizes.values()) - 1
        self.assertGreater(limit, (self.folder / "first" / "results.h5").stat().st_size)
        shutil.rmtree(self.folder / "cache")
        outcome = subprocess.run(
            [PROGRAM, "run", QUICK, "-o", "full", *ARGUMENTS, *finer], cwd=self.folder, check=False,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
        self.assertEqual(outcome.returncode, 0)
        self.assert_agrees("full", "first")
        self.assertEqual(len(self.notes("full")), 1)
        self.assertIn("Nothing was kept in the cache", self.notes("full")[0])
        # The largest entries found no room; nothing half-written stays behind.
        now = {path: path.stat().st_size for path in (self.folder / "cache").iterdir()
               if path not in self.entries(mechanics=True)}
        self.assertEqual(now, {path: size for path, size in sizes.items() if size <= limit})


class CacheSettings(ProgramTest):
    def test_limit_that_cannot_be_read_is_a_mistake(self):
        os.environ["IONSKIN_CACHE_LIMIT"] = "plenty"
        process = self.run_program("run", QUICK, "-o", "out", expect=2)
        self.assertIn("IONSKIN_CACHE_LIMIT", process.stderr)
        self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    unittest.main()
