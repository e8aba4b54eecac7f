# SPDX-License-Identifier: Apache-2.0
"""A run that its audits condemn ends with exit 3, keeps its results and marks them; one near a limit warns."""

import csv
import json
import unittest

from program import QUICK, ProgramTest, summary

SMALL = ("--only", "mechanics", "--set", "numerics.mesh_refinement=0.5", "--set", "numerics.error_estimate=off")


class Audits(ProgramTest):
    def run_pressed(self, preload, expect):
        """A touch so deep that its shear is not a small strain; the finished process."""
        return self.run_case(QUICK, *SMALL, "--set", f"motion.preload={preload}", "-o", "out", expect=expect)

    def state(self):
        return json.loads((self.folder / "out" / "manifest.json").read_text(encoding="utf-8"))["state"]

    def test_a_failed_audit_is_exit_3_with_the_results_kept_and_marked(self):
        process = self.run_pressed("40 um", expect=3)
        for part in ("largest_p99_shear", "above 1", "marked as failed", "remedy: lower motion.preload"):
            self.assertIn(part, process.stderr)
        audit = summary(self.folder / "out")["audits"]["largest_p99_shear"]
        self.assertEqual((audit["verdict"], audit["warn_above"], audit["fail_above"]), ("failed", 0.1, 1.0))
        self.assertGreater(audit["value"], 1)
        self.assertEqual(self.state(), "failed")
        self.assertTrue((self.folder / "out" / "signals.csv").exists())
        self.assertTrue(any(text.startswith("FAILED AUDIT") for text in summary(self.folder / "out")["warnings"]))

    def test_near_a_limit_is_a_warning(self):
        process = self.run_pressed("5 um", expect=0)
        self.assertIn("warning: Audit: ", process.stdout + process.stderr)
        self.assertEqual(summary(self.folder / "out")["audits"]["largest_p99_shear"]["verdict"], "warned")
        self.assertEqual(self.state(), "finished")

    def test_a_point_that_fails_its_audit_leaves_the_others(self):
        process = self.run_program("sweep", QUICK, *SMALL, "--over", "motion.preload=1 um,40 um", "--no-report", "-o", "sweep")
        self.assertIn("1 of 2 points failed", process.stderr)
        with open(self.folder / "sweep" / "sweep.csv", encoding="utf-8") as table:
            rows = list(csv.DictReader(table))
        self.assertEqual(len(rows), 2)
        self.assertNotIn("do not pass their audits", str(rows[0]))
        self.assertIn("do not pass their audits", str(rows[1]))

    def test_friction_gives_no_more_than_it_took(self):
        """Elastic slip wound up under 1 N and given back under 20 N, and the other way round, in closed cycles."""
        for name, there, back in (("rising", 1, 20), ("falling", 20, 1)):
            time, rows = 0.5, [(0, 5, "1", ""), (0.5, 5, "", there)]
            for _ in range(3):
                for x, force in ((5.05, there), (5.05, back), (5, back), (5, there)):
                    time += 0.1
                    rows.append((round(time, 3), x, "", force))
            rows.append((time + 0.5, 5, "1", ""))
            self.write("path.csv", "time [s], x [mm], y [mm], height [mm], force [N]\n"
                       + "".join(f"{t},{x},1,{height},{force}\n" for t, x, height, force in rows))
            head, rest = QUICK.read_text().replace('start = ["4.5 mm", "1 mm"]\n', "").split("[motion]")
            self.write("case.toml", head + '[motion]\nkind = "waypoints"\nfile = "path.csv"\n[contact]' + rest.split("[contact]")[1])
            self.run_case("case.toml", *SMALL, "--set", "contact.law=regularised", "--set", "contact.friction=0.5",
                          "--set", "contact.slip_length=100 um", "-o", name)
            metrics = summary(self.folder / name)["metrics"]
            work = metrics["external_work"]["value"]
            self.assertGreater(work, 0, name)
            self.assertGreater(metrics["friction_work"]["value"], 0.5 * work, name)
            audit = summary(self.folder / name)["audits"]["energy_creation_error"]
            self.assertEqual(audit["verdict"], "passed", name)
            self.assertLess(audit["value"], 1e-8, name)


if __name__ == "__main__":
    unittest.main()
