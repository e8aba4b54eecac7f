# SPDX-License-Identifier: Apache-2.0
"""Benchmarks that are tests, too, by what they do not let pass: error_coverage.py, evidence.py and live_steps.py."""

import argparse
import dataclasses
import math
import pathlib
import sys
import types
import unittest

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "benchmarks"))
import error_coverage  # noqa: E402
import evidence_rows  # noqa: E402
import live_steps  # noqa: E402


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


class LiveSteps(unittest.TestCase):
    """Two environments in steady contact, to which each test adds one fault."""

    TRAINED = types.SimpleNamespace(lowest=(0, 0), highest=(1, 1), force=10.0, indentation=1e-3, speed=1.0, friction=(0.3, 0.3),
                                    tilt=0.0, turn=0.0)

    def asked(self, load=1.0, by_force=True, x=0.0, held=False):
        rows = numpy.ones(2)
        return live_steps.Asked(by_force, 1e-3 * rows, numpy.column_stack([x * rows, 0 * rows]), numpy.zeros((2, 3)), load * rows,
                                rows < 0, (rows > 0) & held)

    def signals(self, normal=1.0, height=-1e-4, tangential=0.3, flags=0):
        class Stepped(dict):
            array = numpy.tile([normal, height, tangential], (2, 1))
        stepped = Stepped({name: numpy.zeros(2) for name in live_steps.COMPARED}, normal_force=numpy.full(2, normal),
                          slider_z=numpy.full(2, height), tangential_force_x=numpy.full(2, tangential))
        stepped.flags = numpy.full(2, flags)
        return stepped

    def found(self, asked, signals, earlier=None, relaxes=False):
        masks = live_steps.faults(asked, self.asked(held=earlier is not None), self.TRAINED, signals, self.signals(),
                                  earlier or self.signals(), 0.3, relaxes)
        return {name for name, mask in masks.items() if mask.all()}

    def test_a_step_that_does_as_asked_has_no_fault(self):
        self.assertEqual(self.found(self.asked(held=True), self.signals()), set())
        self.assertEqual(self.found(self.asked(-1e-4, by_force=False), self.signals()), set())
        self.assertEqual(self.found(self.asked(0), self.signals(0, tangential=0)), set())

    def test_each_fault_is_found(self):
        self.assertEqual(self.found(self.asked(), self.signals(1.002, tangential=0)), {"force missed"})
        self.assertEqual(self.found(self.asked(), self.signals(tangential=0.302)), {"too much friction"})
        self.assertEqual(self.found(self.asked(0), self.signals(1e-9, tangential=0)), {"not detached"})
        self.assertEqual(self.found(self.asked(-1e-4, by_force=False), self.signals(height=-1.1e-4)), {"height missed"})
        higher, lower = self.signals(height=-0.9e-4), self.signals(height=-1.1e-4)
        self.assertEqual(self.found(self.asked(held=True), lower), {"not at rest"})
        self.assertEqual(self.found(self.asked(held=True), lower, higher, relaxes=True), set())
        self.assertEqual(self.found(self.asked(held=True), lower, lower, relaxes=True), {"oscillates"})
        self.assertEqual(self.found(self.asked(-1e-4, by_force=False, held=True), self.signals(1.02)), {"not at rest"})
        self.assertLessEqual({"force missed", "contact lost"}, self.found(self.asked(held=True), self.signals(0, tangential=0)))
        self.assertLessEqual({"pulls", "force missed"}, self.found(self.asked(), self.signals(-1)))
        self.assertLessEqual({"not finite", "force missed", "pulls"}, self.found(self.asked(), self.signals(math.nan)))

    def test_flags_need_a_cause_and_a_cause_needs_a_flag(self):
        self.assertEqual(self.found(self.asked(), self.signals(flags=8)), {"flag unconverged without cause"})
        self.assertEqual(self.found(self.asked(), self.signals(flags=4)), {"flag speed without cause"})
        self.assertEqual(self.found(self.asked(x=1.5e-3), self.signals(flags=4)), set())
        self.assertEqual(self.found(self.asked(x=1.5e-3), self.signals()), {"flag speed missing"})
        self.assertEqual(self.found(self.asked(-1), self.signals(0, tangential=0, flags=32)), set())
        self.assertEqual(self.found(self.asked(-1), self.signals(0, tangential=0)), {"flag pulled missing"})
        deep = self.asked(-1e-3, by_force=False)
        self.assertEqual(self.found(deep, self.signals(11, height=-1e-3)), {"flag load missing"})
        self.assertEqual(self.found(deep, self.signals(11, height=-1e-3, flags=2)), set())

    def test_a_step_beyond_the_range_is_that_to_the_nearest_trained_inputs(self):
        def wrong(bit, signals, nearest):
            return live_steps.beyond_faults(bit, signals, nearest).any()
        self.assertFalse(wrong(2, self.signals(flags=2), self.signals()))
        self.assertTrue(wrong(2, self.signals(), self.signals()))
        self.assertTrue(wrong(2, self.signals(flags=10), self.signals()))
        self.assertTrue(wrong(2, self.signals(1.002, flags=2), self.signals()))
        lifted = self.signals(0, tangential=0)
        self.assertFalse(wrong(1, lifted, lifted))
        self.assertTrue(wrong(32, lifted, lifted))

    def test_inputs_beyond_the_range_are(self):
        asked = self.asked()
        for name, bit, out, nearest in live_steps.beyond(self.TRAINED, numpy.random.default_rng(1), asked, False):
            with self.subTest(name):
                differ = [key for key in out if not numpy.array_equal(out[key], numpy.broadcast_to(nearest[key], out[key].shape))]
                self.assertEqual(len(differ), 1)
                self.assertTrue((nearest["positions"] >= 0).all() and (nearest["positions"] <= 1).all())
                self.assertEqual(bit in (1, 64), differ[0] in ("positions", "angles"))

    def test_a_walk_stays_within_the_range_and_holds_what_it_says(self):
        walk, before = live_steps.Walk(self.TRAINED, 50, numpy.random.default_rng(1)), None
        held, steps = 0, 200
        for step in range(steps):
            none = numpy.zeros(50, dtype=bool)
            asked = walk.next(none, none)
            self.assertTrue((asked.place >= 0).all() and (asked.place <= 1).all() and (asked.interval >= 0).all())
            largest = self.TRAINED.force if asked.by_force else -self.TRAINED.indentation
            self.assertLessEqual((asked.load / largest).max(), 1)
            if before:
                for values in ("place", "angles", "load"):
                    numpy.testing.assert_array_equal(getattr(asked, values)[asked.held], getattr(before, values)[asked.held])
                self.assertFalse(asked.held.any() and asked.by_force != before.by_force)
            before, held = asked, held + asked.held.sum()
        self.assertGreater(held, 0.1 * 50 * steps)


if __name__ == "__main__":
    unittest.main()
