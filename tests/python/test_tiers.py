# SPDX-License-Identifier: Apache-2.0
"""run_file.py and scripts/run_tests.py: which tests run, and that a skipped, a missing or an unlabelled one is a failure."""

import contextlib
import io
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))
import run_tests  # noqa: E402

FILE = """import unittest
from tiers import long_test

class Some(unittest.TestCase):
    def test_short(self):
        print("short ran")

    @long_test
    def test_long(self):
        print("long ran")

@long_test
class Whole(unittest.TestCase):
    def test_also(self):
        print("class ran")

class Skipped(unittest.TestCase):
    def test_it(self):
        self.skipTest("no telescope")
"""
LOG = '''"fast" start time: Nov 28 04:00 UTC
Output:
----------------------------------------------------------
processor time: 0.4 s
<end of output>
Test time =   1.50 sec
"slow" start time: Nov 28 04:00 UTC
Output:
----------------------------------------------------------
skipped unexpectedly: some.test: no telescope
<end of output>
Test time =  20.25 sec
'''


class RunFile(unittest.TestCase):
    def run_file(self, *options, expect=0):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "test_some.py"
            file.write_text(FILE)
            process = subprocess.run([sys.executable, ROOT / "tests" / "run_file.py", *options, file], capture_output=True,
                                     text=True, check=False)
        self.assertEqual(process.returncode, expect, process.stdout + process.stderr)
        return process.stdout

    def test_parts(self):
        allowed = ("--may-skip", "telescope")
        for options, ran in (((), {"short", "long", "class"}), (("--part", "short"), {"short"}),
                             (("--part", "long"), {"long", "class"}), (("-k", "Some"), {"short", "long"})):
            told = self.run_file(*options, *allowed)
            self.assertEqual({word for word in ("short", "long", "class") if f"{word} ran" in told}, ran, options)

    def test_a_skipped_test_is_a_failure_unless_its_reason_is_allowed(self):
        self.assertIn("skipped unexpectedly: test_some.Skipped.test_it: no telescope", self.run_file(expect=1))
        self.assertIn("skipped: test_some.Skipped.test_it: no telescope", self.run_file("--may-skip", "telescope"))
        self.run_file("--may-skip", "microscope", expect=1)

    def test_no_test_is_a_failure(self):
        self.run_file("-k", "nothing", expect=1)


class RunTests(unittest.TestCase):
    def test_every_test_has_a_tier_and_a_time_limit(self):
        limit, tier = {"name": "TIMEOUT", "value": 60.0}, {"name": "LABELS", "value": ["check", "program"]}
        two = {"name": "LABELS", "value": ["check", "long"]}
        for properties, wrong in (([limit, tier], 0), ([tier], 1), ([limit], 1), ([], 2), ([limit, two], 1)):
            self.assertEqual(len([*run_tests.complaints([{"name": "one", "properties": properties}])]), wrong, properties)

    def test_the_longest_and_the_skipped_are_reported(self):
        found = [(float(seconds), name) for name, _, seconds in run_tests.TEST.findall(LOG)]
        self.assertEqual(found, [(1.5, "fast"), (20.25, "slow")])
        self.assertEqual(run_tests.SKIPPED.findall(LOG), ["skipped unexpectedly: some.test: no telescope"])
        told = io.StringIO()
        with contextlib.redirect_stdout(told):
            run_tests.sum_up(LOG, 21.75, 40)
        lines = [line.strip() for line in told.getvalue().splitlines()]
        self.assertEqual(lines[2:], ["20.2  slow", "1.5  fast (0.4)", "2 tests of ctest ran, 1 tests in them were skipped",
                                     "slow: skipped unexpectedly: some.test: no telescope", "22 s, 40 s of processor time"])


if __name__ == "__main__":
    unittest.main()
