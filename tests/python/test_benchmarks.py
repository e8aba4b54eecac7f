# SPDX-License-Identifier: Apache-2.0
"""Benchmarks that are tests, too, by what they do not let pass: error_coverage.py and evidence.py."""

import argparse
import dataclasses
import math
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "benchmarks"))
import error_coverage  # noqa: E402
import evidence_rows  # noqa: E402


class ErrorCoverage(unittest.TestCase):
    def lacks(self, rows, marked=0, **asked):
        arguments = argparse.Namespace(**{"least": 0.95, "most_ratio": 5, "most_marked": 0.3, **asked})
        return [*error_coverage.shortcomings(rows, marked, arguments)]

    def test_errors_must_hold_be_no_larger_than_needed_and_be_stated(self):
        good = [("force", 0.03, 0.01)] * 19
        self.assertEqual(self.lacks(good), [])
        self.assertEqual(self.lacks([*good, ("area", 0.01, 0.02)]), [])
        self.assertIn("90.5% of the stated errors hold", *self.lacks([*good, *[("area", 0.01, 0.02)] * 2]))
        self.assertIn("6.0 times the true ones", *self.lacks([("force", 0.06, 0.01)] * 19))
        self.assertEqual(self.lacks(good, marked=8), [])
        self.assertIn("9 of 28 metrics are marked", *self.lacks(good, marked=9))
        self.assertIn("no stated error", *self.lacks([], marked=3))
        self.assertEqual(self.lacks([("force", 0.06, 0.01)], marked=9, most_ratio=math.inf, most_marked=1), [])


class Evidence(unittest.TestCase):
    def rows(self):
        return [evidence_rows.Row(name, "", "", "", "", verdict, value=math.nan if value is None else value)
                for name, (verdict, value) in evidence_rows.STANDS.items()]

    def test_each_verdict_and_number_is_that_of_the_page(self):
        rows = self.rows()
        self.assertEqual([*evidence_rows.departures(rows)], [])
        self.assertIn(f"{rows[0].name} is missing", *evidence_rows.departures(rows[1:]))
        other = dataclasses.replace(rows[0], verdict="disagrees")
        self.assertIn("disagrees, and the page was written for agrees", *evidence_rows.departures([other, *rows[1:]]))
        place = next(i for i, row in enumerate(rows) if not math.isnan(row.value))
        for value, wrong in ((1.01 * rows[place].value, 0), (1.03 * rows[place].value, 1), (math.nan, 1)):
            rows[place] = dataclasses.replace(rows[place], value=value)
            self.assertEqual(len([*evidence_rows.departures(rows)]), wrong)
            rows = self.rows()
        added = dataclasses.replace(rows[0], name="Another")
        self.assertIn("Another is new", *evidence_rows.departures([*rows, added]))


if __name__ == "__main__":
    unittest.main()
