# SPDX-License-Identifier: Apache-2.0
"""benchmarks/peers.py without the other codes: its help, errors and ratios, the meshes and the history it hands out."""

import pathlib
import subprocess
import sys
import unittest

BENCHMARKS = pathlib.Path(__file__).resolve().parents[2] / "benchmarks"
sys.path.insert(0, str(BENCHMARKS))
from foreign import cycle, ionskin_runs, skin, tables  # noqa: E402


def run(code, seconds, memory, charge):
    return {"code": code, "setting": f"{seconds}", "unknowns": 1, "processor_s": seconds, "peak_MB": memory,
            "figures": {"charge": charge}}


class Ratios(unittest.TestCase):
    def compared(self, *runs):
        return tables.equal_accuracy([tables.with_errors(one, {"charge": 2.0}) for one in runs])

    def test_the_cheapest_run_that_is_no_less_accurate_counts(self):
        *_, other = self.compared(run("ionskin", 1, 5, 2.2), run("ionskin", 4, 10, 2.02), run("ionskin", 9, 20, 2.001),
                                  run("other", 8, 40, 1.9))
        self.assertAlmostEqual(other["error"], 0.05)
        self.assertFalse(other["bound"])
        self.assertEqual((other["time_ratio"], other["memory_ratio"]), (2, 4))

    def test_a_code_that_is_more_accurate_than_every_run_gets_a_bound(self):
        *_, other = self.compared(run("ionskin", 1, 5, 2.2), run("ionskin", 4, 10, 2.02), run("other", 2, 5, 2.001))
        self.assertTrue(other["bound"])
        self.assertEqual(other["time_ratio"], 0.5)
        self.assertIn("below 0.5", tables.markdown([other]))

    def test_errors_that_the_reference_does_not_tell_are_alike(self):
        ours, other = tables.equal_accuracy([tables.with_errors(one, {"charge": 2.0}, 2e-3)
                                             for one in (run("ionskin", 1, 5, 2.002), run("other", 8, 40, 2.001))])
        self.assertFalse(other["bound"])
        self.assertEqual(other["time_ratio"], 8)
        self.assertIn("below 0.20%", tables.markdown([ours]))

    def test_rows_are_as_long_as_the_head(self):
        rows = tables.markdown(self.compared(run("ionskin", 1, 5, 2.2), run("other", 8, 40, 1.9))).splitlines()
        self.assertEqual(len({row.count("|") for row in rows}), 1)
        self.assertEqual(len(rows), 4)


class Problems(unittest.TestCase):
    def test_lines_fill_the_skin_and_are_fine_where_the_sphere_touches(self):
        x, y, z = skin.mesh_lines(0.05, 3)
        for line, end in ((x, skin.LENGTH), (y, skin.WIDTH / 2), (z, skin.HEIGHT)):
            self.assertAlmostEqual(line[0], 0)
            self.assertAlmostEqual(line[-1], end)
            self.assertTrue(all(line[1:] > line[:-1]))
        sizes = (x[1:] - x[:-1])[(x[:-1] > skin.START - skin.REACH) & (x[1:] < skin.START + skin.SLIDE + skin.REACH)]
        self.assertLessEqual(sizes.max(), 0.05)

    def test_the_patch_keeps_its_area_while_it_moves(self):
        _, _, shear = cycle.cells()
        cell = cycle.LENGTH * cycle.WIDTH / shear[0].size
        for moment in shear[2:-2]:
            self.assertAlmostEqual(moment.sum() * cell / (cycle.SHEAR * cycle.PATCH[0] * cycle.PATCH[1]), 1)
        self.assertEqual(abs(shear[[0, 1, -2, -1]]).max(), 0)

    def test_the_current_is_the_change_of_charge_at_the_end_of_the_slide(self):
        figures = cycle.figures([0, cycle.CURRENT_FROM, cycle.OFF], [0, 1.0, 3.0])
        self.assertAlmostEqual(figures["charge"], 3)
        self.assertAlmostEqual(figures["current"], 2 / 0.1)

    def test_the_path_has_a_touch_and_ten_steps(self):
        self.assertEqual(len(ionskin_runs.path().splitlines()), 1 + 2 + 10 + 1)


class Program(unittest.TestCase):
    def answer(self, *words):
        return subprocess.run([sys.executable, BENCHMARKS / "peers.py", *words], capture_output=True, text=True, check=False)

    def test_help(self):
        told = self.answer("--help")
        self.assertEqual(told.returncode, 0, told.stderr)
        self.assertIn("--reference", told.stdout)

    def test_a_missing_program_is_reported_before_any_work(self):
        told = self.answer("no/such/ionskin")
        self.assertEqual(told.returncode, 2)
        self.assertIn("no/such/ionskin", told.stderr)


if __name__ == "__main__":
    unittest.main()
