# SPDX-License-Identifier: Apache-2.0
"""Nothing is kept in the home folder; what older versions left there is shown and cleared."""

import json
import os
import pathlib
import unittest
from unittest import mock

from program import QUICK, SMALL, ProgramTest, summary

KEY = "0123456789abcdef" * 2
ARGUMENTS = ("--only", "mechanics", "--no-report", *SMALL)


class Cache(ProgramTest):
    def setUp(self):
        super().setUp()
        changed = mock.patch.dict(os.environ, {"IONSKIN_CACHE": str(self.folder / "cache")})
        changed.start()
        self.addCleanup(changed.stop)

    def write(self, name, text):
        (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
        return super().write(name, text)

    def cache(self, *arguments):
        return self.run_program("cache", *arguments).stdout

    def left(self, count=3):
        """Files as older versions left them, and some of the user's own beside them."""
        for number in range(count):
            self.write(f"cache/{number:032x}.ionskin-cache", "x" * 1_000_000)
        self.write(f"cache/{KEY}-77-0.ionskin-pending", "x" * 500_000)
        own = ["notes.txt", "notes.ionskin-cache", "draft.ionskin-pending", f"{KEY}.txt", f"{KEY}-old.ionskin-cache"]
        for name in own:
            self.write(f"cache/{name}", "mine")
        os.symlink("notes.txt", self.folder / "cache" / f"{KEY}.ionskin-cache")
        return sorted([*own, f"{KEY}.ionskin-cache"])

    def test_runs_sweeps_and_fits_keep_nothing_at_home(self):
        home = self.folder / "home"
        home.mkdir()
        os.environ |= {"HOME": str(home), "XDG_CACHE_HOME": str(home / "xdg")}
        told = self.run_case(QUICK, *ARGUMENTS, "-o", "run").stderr
        self.assertNotIn("cache", told)
        self.run_program("sweep", QUICK, "-o", "sweep", *ARGUMENTS, "--quiet", "--over", "contact.friction=0.1,0.3")
        del os.environ["IONSKIN_CACHE"]
        self.run_case(QUICK, *ARGUMENTS, "-o", "plain")
        self.assertEqual([path for path in home.rglob("*") if path.is_file()], [])
        self.assertFalse((self.folder / "cache").exists())

    def test_no_cache_and_its_limit_are_accepted_and_come_to_nothing(self):
        os.environ["IONSKIN_CACHE_LIMIT"] = "plenty"
        self.run_case(QUICK, *ARGUMENTS, "-o", "with")
        self.run_case(QUICK, *ARGUMENTS, "--no-cache", "-o", "without")
        with_it, without = (json.loads((self.folder / out / "summary.json").read_text())["metrics"] for out in ("with", "without"))
        self.assertEqual(with_it, without)
        for verb in ("run", "sweep", "fit", "uncertainty", "generate"):
            words = " ".join(self.run_program(verb, "--help").stdout.split())
            self.assertIn("--no-cache Has no effect any more", words, verb)

    def test_what_older_versions_left_is_shown_and_cleared(self):
        own = self.left()
        shown = self.cache()
        for words in ("older versions left 4 files, 3.5 MB", str(self.folder / "cache"), "ionskin cache clear"):
            self.assertIn(words, shown)
        self.assertIn(shown.strip(), self.run_program("doctor").stdout)
        cleared = self.cache("clear")
        self.assertIn("4 files, 3.5 MB removed", cleared)
        self.assertIn("no files of older versions", cleared)
        self.assertEqual(sorted(path.name for path in (self.folder / "cache").iterdir()), own)
        self.assertEqual((self.folder / "cache" / "notes.txt").read_text(), "mine")

    def test_an_empty_folder_goes_and_one_that_is_not_there_is_no_mistake(self):
        self.write(f"cache/{KEY}.ionskin-cache", "x")
        self.assertIn("1 file", self.cache("clear"))
        self.assertFalse((self.folder / "cache").exists())
        self.assertIn("no files of older versions", self.cache("clear"))

    def test_places_of_the_environment(self):
        for name in ("IONSKIN_CACHE", "XDG_CACHE_HOME", "HOME"):
            os.environ.pop(name, None)
        self.assertIn("names a place", self.cache())
        for name, below in (("HOME", ".cache/ionskin"), ("XDG_CACHE_HOME", "ionskin"), ("IONSKIN_CACHE", ".")):
            os.environ[name] = str(self.folder / name)
            path = pathlib.Path(name, below, f"{KEY}.ionskin-cache")
            self.write(path, "x")
            self.assertIn("left 1 file, ", self.cache(), name)


class SharedPositions(ProgramTest):
    def test_keys_of_older_versions_are_noted_by_check_and_run(self):
        keys = ("--set", 'numerics.shared_positions.from=["4 mm", "0.9 mm"]',
                "--set", 'numerics.shared_positions.to=["1 mm", "0.8 mm"]')
        note = "numerics.shared_positions.from, numerics.shared_positions.to have no effect any more: remove them."
        self.assertIn("note: " + note, " ".join(self.run_program("check", QUICK, *keys).stdout.split()))
        self.run_case(QUICK, *ARGUMENTS, *keys, "-o", "with")
        self.run_case(QUICK, *ARGUMENTS, "-o", "without")
        noted, plain = summary(self.folder / "with"), summary(self.folder / "without")
        self.assertIn(note, noted["warnings"])
        self.assertNotIn(note, plain["warnings"])
        self.assertEqual(noted["metrics"], plain["metrics"])


if __name__ == "__main__":
    unittest.main()
