# SPDX-License-Identifier: Apache-2.0
"""First commands of a newcomer: help, init, check, run; and the files a run leaves."""

import json
import os
import re
import subprocess
import unittest
import unittest.mock

import h5py
import numpy

from program import PAPER, QUICK, ROOT, ProgramTest, signals, summary
from tiers import long_test

# A mesh that serves where no figure is compared.
SMALL = (QUICK, "--set", "numerics.mesh_refinement=0.5")
SIGNAL_COLUMNS = [
    "time [s]", "cycle", "phase", "slider_x [m]", "slider_z [m]", "normal_force [N]",
    "tangential_force [N]", "mean_shear [1]", "rms_shear [1]", "p99_shear [1]", "shear_first_moment [1]",
    "mean_shear_rate [1/s]", "charge_top [C]", "charge_bottom [C]", "current_top [A]", "current_bottom [A]",
    "current_difference [A]", "current_common [A]", "slider_y [m]", "contact_area [m2]", "stick_share [1]", "slip [m]",
    "slip_state [1]", "tangential_force_x [N]", "tangential_force_y [N]",
    "moment_x [N m]", "moment_y [N m]", "moment_z [N m]",
]
METRICS = [
    "normal_force_touchdown", "normal_force_slide", "tangential_force_slide", "mean_shear_touchdown",
    "mean_shear_slide", "peak_mean_shear", "time_mean_shear", "rms_mean_shear", "p95_shear_slide",
    "p99_shear_slide", "element_max_shear_slide", "peak_pressure_slide", "peak_current_top", "peak_current_bottom",
    "peak_current_difference", "rms_current_top", "rms_current_difference", "peak_sampled_current_top",
    "peak_sampled_current_difference", "charge_identity_error", "nonlinearity", "min_concentration_ratio",
]


class FirstMinutes(ProgramTest):
    def test_help_and_version(self):
        for arguments in ((), ("--help",), ("run", "--help"), ("verify", "--help")):
            self.assertIn("ionskin", self.run_program(*arguments).stdout)
        self.assertRegex(self.run_program("--version").stdout, r"ionskin \d+\.\d+\.\d+")
        self.run_program("rnu", expect=2)

    def test_init_check_explain(self):
        self.run_program("init", "my_skin.toml")
        self.run_program("init", "my_skin.toml", expect=2)
        self.assertIn("valid", self.run_program("check", "my_skin.toml").stdout)
        (self.folder / "out").mkdir()  # of an earlier case: a run into it would be refused
        self.assertIn("ionskin run second.toml -o second\n", self.run_program("init", "second.toml").stdout)
        # An edit takes one word, wherever it stands.
        self.run_program("check", "--set", "contact.friction=0.1", PAPER, "--explain")
        explained = self.run_program("check", PAPER, "--explain").stdout
        for words in ("Debye length", "contact", "unknowns", "memory", "contact.friction"):
            self.assertIn(words, explained)

    def test_a_round_contact_is_found_before_its_cost_is_reported(self):
        ball = ("check", QUICK, "--json", "--set", "slider.shape=sphere", "--set", "slider.radius=4 mm",
                "--set", "numerics.mesh_refinement=0.5")
        guessed = json.loads(self.run_program(*ball).stdout)["cost"]
        found = json.loads(self.run_program(*ball, "--explain").stdout)["cost"]
        self.assertNotEqual(found["memory_bytes"], guessed["memory_bytes"])

    def test_keys_without_a_meaning_in_a_case_are_distinguished(self):
        applicable = json.loads(self.run_program("check", QUICK, "--json").stdout)["applicable"]
        self.assertIn("slider.youngs_modulus", applicable)
        self.assertNotIn("slider.poissons_ratio", applicable)
        self.assertNotIn("contact.kinetic_friction", applicable)
        self.assertNotIn("numerics.shared_positions.from", applicable)  # of older versions: no form offers it
        stribeck = ("check", QUICK, "--json", "--set", "contact.law=stribeck", "--set", "contact.kinetic_friction=0.2",
                    "--set", "contact.stribeck_speed=1 mm/s")
        self.assertIn("contact.kinetic_friction", json.loads(self.run_program(*stribeck).stdout)["applicable"])

    def test_files_of_a_run(self):
        self.run_program("run", *SMALL, "-o", "out", "--threads", 2)
        out = self.folder / "out"
        for name in ("manifest.json", "case.toml", "summary.json", "signals.csv", "sampled.csv", "results.h5",
                     "report.html"):
            self.assertTrue((out / name).stat().st_size > 0, name)
        self.assertTrue(list((out / "fields").glob("*.vtu")))
        self.assertTrue(list((out / "fields").glob("*.pvd")))
        self.assertFalse((out / "figures").exists())
        self.assertEqual((out / "signals.csv").read_text().splitlines()[0].split(","), SIGNAL_COLUMNS)
        self.assertLessEqual(set(METRICS), set(summary(out)["metrics"]))
        self.assertLessEqual({"mechanics", "strain", "electrochemistry", "output", "total"},
                             set(summary(out)["timing"]))
        with h5py.File(out / "results.h5") as file:
            for path in ("signals/time", "sampled/time", "strain/gamma", "ions/grid", "contact", "case",
                         "manifest"):
                self.assertIn(path, file)
        manifest = json.loads((out / "manifest.json").read_text())
        self.assertIn("peak_memory", json.dumps(manifest))
        self.assertEqual(sorted(set(signals(out)["phase"][1:])), ["lift", "return", "slide", "touchdown"])

        self.figures_and_comparison_of_a_run()

    def figures_and_comparison_of_a_run(self):
        """`report` and `compare` on the run in `out`; `fig05_shear` needs no several runs, the maps do."""
        (self.folder / "out" / "report.html").unlink()
        said = self.run_program("report", "out", "--progress", "json")
        self.assertIn("report: out/report.html", said.stdout)
        self.assertEqual(json.loads(said.stderr.splitlines()[-1])["fraction"], 1.0)
        self.assertTrue((self.folder / "out" / "report.html").exists())
        self.assertFalse((self.folder / "out" / "figures").exists())
        self.assertIn("figures", self.run_program("report", "out", "--figure", "fig05_shear").stdout)
        for kind in ("png", "svg", "pdf"):
            self.assertTrue((self.folder / "out" / "figures" / f"fig05_shear.{kind}").exists())
        process = self.run_program("report", "out", "--figure", "fig06_shear_map")
        self.assertIn("several runs", process.stdout)
        self.assertIn("fig01_model", self.run_program("report", "out", "--figure", "fig99", expect=2).stderr)
        self.assertIn("no differences", self.run_program("compare", "out", "out").stdout)
        self.assertIn("no folder nowhere", self.run_program("compare", "out", "nowhere", expect=2).stderr)

    def test_starter_cases_and_keys(self):
        self.run_program("init", "finger.toml", "--from", "finger")
        self.assertIn("sphere", (self.folder / "finger.toml").read_text())
        self.assertIn("paper, quick, finger", self.run_program("init", "x.toml", "--from", "hand", expect=2).stderr)
        for name in ("quick", "taxels", "reciprocating", "waypoints", "rolling", "pinch", "poroelastic", "bending", "strain_file"):
            wrote = self.run_program("init", f"{name}.toml", "--from", name).stdout
            if name == "strain_file":  # what it needs is named, and serves
                subprocess.run(re.search("First: (.*)", wrote)[1].split(), cwd=self.folder, check=True)
            told = self.run_program("check", f"{name}.toml", "--explain").stdout
            self.assertNotRegex(told, "(?m)^(warning|note): ", name)
        keys = self.run_program("keys").stdout
        self.assertRegex(keys, r"readout\.circuit .* one of short, open, load, parallel-rc, amplifier  \[\"short\"\]")
        self.assertRegex(keys, r"numerics\.mesh_refinement .*  at least 0\.1 and at most 10  \[1\]")
        for key in ("readout.taxels.rows", "readout.taxels.gap", "readout.taxels[].name"):
            self.assertIn(key, keys)
        lines = self.run_program("keys", "friction").stdout.splitlines()
        self.assertTrue(all(re.match(r"contact\.\w*friction ", line) for line in lines))
        self.assertTrue(any(line.startswith("contact.friction ") for line in lines))
        self.assertIn("did you mean contact.friction?", self.run_program("keys", "fricton", expect=2).stderr)

    def test_comparison_names_defaults(self):
        small = ("--only", "mechanics", "--set", "numerics.mesh_refinement=0.3")
        self.run_case(QUICK, "-o", "one", *small)
        self.run_case(QUICK, "-o", "two", *small, "--set", "coupling.law=column-neutral", "--set", "contact.law=coulomb",
                      "--set", "contact.friction=0.35")
        compared = self.run_program("compare", "one", "two").stdout
        self.assertIn("  coupling.law: 'fixed-charge' (default) | 'column-neutral'\n", compared)
        self.assertNotIn("contact.law", compared)
        self.assertRegex(compared, r"  Mean shear, mid-slide +0\.0\d+ ± [\d.]+ % +0\.0\d+ ± [\d.]+ % +[\d.]+ % +\w+ the stated errors +mean_shear_slide")
        self.assertRegex(compared, r"  Tangential force, mid-slide +[\d.]+ N .*[\d.]+ N .* tangential_force_slide")

    def test_doctor_and_cite(self):
        whole = self.run_program("doctor").stdout
        self.assertIn("Nothing is missing", whole)
        self.assertRegex(whole, r"ok +Python module openturns: for ionskin uncertainty")
        with unittest.mock.patch.dict("os.environ", IONSKIN_DATA="nowhere"):
            lacking = self.run_program("doctor", expect=2).stdout
        self.assertRegex(lacking, r"MISSING +cases and materials in nowhere")
        self.assertIn("IONSKIN_DATA", lacking)
        cited = self.run_program("cite").stdout
        for words in ("@software", "@article", "https://doi.org/10.3390/s26102930"):
            self.assertIn(words, cited)
        entries = cited.split("@")[3:]  # after program and article: the methods
        self.assertGreater(len(entries), 12)
        for entry in entries:
            for field in ("author", "title", "year", "doi", "url"):
                self.assertRegex(entry, rf"\n  {field} = {{.+}}")
        self.assertIn("Not confirmed by a second source, check it: author, volume, pages and doi.\n@article{small1984", cited)
        dry, wet = (self.run_program("cite", ROOT / "cases" / f"{name}.toml").stdout for name in ("quick", "poroelastic"))
        self.assertNotIn("biot1941", dry)
        self.assertIn("biot1941", wet)
        self.assertIn("no case.toml", self.run_program("cite", ".", expect=2).stderr)

    def starter(self, name):
        """A starter case as `ionskin init` writes it, with what it says has to be done first; its text."""
        wrote = self.run_program("init", f"{name}.toml", "--from", name).stdout
        for command in re.findall("First: (.*)", wrote):
            subprocess.run(command.split(), cwd=self.folder, check=True)
        return (self.folder / f"{name}.toml").read_text()

    def test_starters_press_as_a_finger_does(self):
        self.run_program("init", "first.toml")
        self.assertRegex((self.folder / "first.toml").read_text(), r"preload = \"1 N\"")
        for name in ("quick", "finger", "taxels", "reciprocating", "waypoints", "rolling", "poroelastic"):
            text = self.starter(name)
            pressed = [float(newtons) for newtons in re.findall(r'^(?:preload|force) = "(.*) N"', text, re.MULTILINE)]
            self.assertTrue(pressed and all(1 <= newtons <= 10 for newtons in pressed), name)
            self.assertIn("a finger presses with 1 to 10 N", text, name)
        self.assertIn("it takes 65 N, where a finger presses with 1 to 10 N", self.starter("paper"))  # what the article states

    def ends_without_avoidable_warning(self, *names):
        for name in names:
            with self.subTest(name):
                self.starter(name)
                self.run_case(f"{name}.toml", "-o", name)
                self.assertEqual([text for text in summary(self.folder / name)["warnings"] if "not calibrated" not in text], [])

    def test_a_starter_ends_without_a_warning_that_its_author_could_have_avoided(self):
        self.ends_without_avoidable_warning("bending", "strain_file")

    @long_test
    def test_so_do_those_with_a_contact(self):
        self.ends_without_avoidable_warning("quick", "taxels", "poroelastic", "finger", "reciprocating", "waypoints", "rolling", "pinch")

    def test_an_edit_of_the_shape_does_not_silently_keep_the_plan_of_another(self):
        ball = ("check", QUICK, "--set", "slider.shape=sphere", "--set", "slider.radius=8 mm")
        told = self.run_program(*ball).stdout
        self.assertIn('note: slider.shape is changed to "sphere", and keeps the plan of the shape in the file, 3 mm x 1.5 mm', told)
        self.assertIn('slider.size=["16 mm", "16 mm"]', told)
        self.assertNotIn("note:", self.run_program(*ball, "--set", 'slider.size=["16 mm", "16 mm"]').stdout)
        self.assertNotIn("note:", self.run_program("check", QUICK).stdout)

    def test_processors_are_those_that_a_job_may_run_on(self):
        allowed = os.sched_getaffinity(0)
        self.addCleanup(os.sched_setaffinity, 0, allowed)
        for processors in ({min(allowed)}, allowed):
            os.sched_setaffinity(0, processors)
            self.assertIn(f" {len(processors)} threads\n", self.run_program("doctor").stdout)

    def test_json_progress(self):
        process = self.run_case(*SMALL, "-o", "out", "--log", "json")
        lines = [json.loads(line) for line in process.stderr.splitlines() if line.startswith("{")]
        self.assertGreater(len(lines), 5)
        self.assertEqual(lines[-1]["fraction"], 1)


class Physics(ProgramTest):
    def test_no_coupling_no_current(self):
        """C1: zero coupling gives exactly zero current; zero friction does not."""
        self.run_case(*SMALL, "-o", "none", "--set", "coupling.coefficient=0")
        result = signals(self.folder / "none")
        self.assertEqual(abs(result["current_top"]).max(), 0)
        self.assertEqual(abs(result["current_bottom"]).max(), 0)
        self.run_case(*SMALL, "-o", "smooth", "--set", "contact.friction=0")
        self.assertGreater(abs(signals(self.folder / "smooth")["current_difference"]).max(), 0)

    def test_press_and_hold(self):
        """A zero stroke holds the touchdown state."""
        self.run_case(*SMALL, "-o", "out", "--set", "motion.stroke=0 mm")
        result = signals(self.folder / "out")
        held = result["normal_force"][result["phase"] == "slide"]
        self.assertLess(abs(held - held[-1]).max(), 1e-9 * held[-1])

    def test_stroke_too_short_to_slide(self):
        """A stroke within onset runs, and the friction force stays below its limit while the slider holds."""
        self.run_case(*SMALL, "-o", "out", "--set", "motion.stroke=2 um")
        result = signals(self.folder / "out")
        sliding = result["phase"] == "slide"
        friction = result["tangential_force"][sliding] / result["normal_force"][sliding]
        self.assertLess(friction.max(), 0.29)
        self.assertGreater(friction.max(), 0.05)

    def test_threads_do_not_change_the_result(self):
        for threads in (1, 2):
            self.run_case(*SMALL, "-o", f"out{threads}", "--threads", threads)
        one, two = ((self.folder / f"out{threads}" / "signals.csv").read_text() for threads in (1, 2))
        self.assertEqual(one, two)


if __name__ == "__main__":
    unittest.main()
