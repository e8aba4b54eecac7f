# SPDX-License-Identifier: Apache-2.0
"""Several sliders on one skin: their signals, what adds up, resume, sweeps, pages, and what refuses them."""

import csv
import re
import tomllib
import unittest

import h5py
import numpy

from program import ROOT, ProgramTest, metric, signals
from tiers import long_test

QUICK, PINCH = (ROOT / "cases" / name for name in ("quick.toml", "pinch.toml"))
NEIGHBOUR = '\n[[slider]]\nsize = ["1 mm", "1 mm"]\nedge_radius = "0.1 mm"\nstart = ["10.5 mm", "1 mm"]\nmotion.direction = [-1, 0]\n\n'
FAST = ("--set", "numerics.error_estimate=off", "--quiet")


def pads(*numbers):
    """The quick case with pads that press with 1 N and slide by 0.3 mm: the first at 3 mm along, the second at 10.5 mm."""
    text = re.sub(r'(?m)^(start|size|edge_radius) = .*\n', "", QUICK.read_text()).replace('"6 mm"', '"0.3 mm"').replace('"2 N"', '"1 N"')
    text = re.sub(r"(?m)^fields = .*$", 'fields = ["1 s"]', text)
    first = NEIGHBOUR.replace('"10.5 mm"', '"3 mm"').replace("[-1, 0]", "[1, 0]")
    return text.replace("[slider]\n", "".join((first, NEIGHBOUR)[number] for number in numbers))


class Sliders(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("both.toml", pads(0, 1))

    @long_test
    def test_what_two_sliders_do_adds_up(self):
        measure = ("--set", "coupling.measure=signed-xz", *FAST)
        both = self.run_case("both.toml", "-o", "both", *measure)
        self.assertNotIn("warning: The violation", both.stderr)
        for number, name in enumerate(("left", "right")):
            self.write(f"{name}.toml", pads(number))
            self.run_case(f"{name}.toml", "-o", name, *measure)
        columns, left, right = (signals(self.folder / name) for name in ("both", "left", "right"))
        # Each keeps its force; they pull the skin against each other, and the mean of a linear shear is their sum.
        for suffix, alone in (("", left), ("_2", right)):
            at = {name: numpy.interp(1.5, columns["time"], columns[name + suffix]) for name in ("normal_force", "tangential_force", "slider_x")}
            for name, value in at.items():
                self.assertAlmostEqual(value, numpy.interp(1.5, alone["time"], alone[name]), delta=2e-3 * abs(value), msg=name + suffix)
        self.assertAlmostEqual(numpy.interp(1.5, columns["time"], columns["tangential_force_x"] + columns["tangential_force_x_2"]), 0, delta=2e-3)
        for name in ("external_work", "friction_work"):
            self.assertAlmostEqual(metric(self.folder / "both", name), sum(metric(self.folder / one, name) for one in ("left", "right")), delta=2e-6)
        self.assertLess(metric(self.folder / "both", "energy_balance_error"), 1e-3)
        self.assertLess(abs(metric(self.folder / "both", "mean_shear_slide")), 0.05 * metric(self.folder / "left", "mean_shear_slide"))
        charge = {name: numpy.interp(1.5, each["time"], each["charge_top"]) for name, each in (("both", columns), ("left", left), ("right", right))}
        # The first moment of a linear shear vanishes, as either force passes straight through the core: what moves charge is its size.
        self.assertLess(max(map(abs, charge.values())), 1e-10)

    def test_a_run_keeps_every_slider_and_resumes(self):
        self.run_case("both.toml", "-o", "out", *FAST, "--only", "mechanics")
        with h5py.File(self.folder / "out" / "results.h5") as file:
            for group in ("path", "path_2", "contact", "contact_2", "slider", "slider_2"):
                self.assertIn(group, file)
            self.assertEqual(file["strain"].attrs["frame"], "skin")
        for name in ("layers_2", "contact_2", "slider_2"):
            self.assertTrue((self.folder / "out" / "fields" / f"{name}_0000.vtu").exists(), name)
        self.assertIn("slider_2_0000.vtu", (self.folder / "out" / "fields" / "fields.pvd").read_text())
        again = self.run_case("both.toml", "-o", "out", "--resume", "--set", "numerics.error_estimate=off")
        self.assertIn("mechanics, from an earlier run", again.stderr + again.stdout)
        self.assertAlmostEqual(metric(self.folder / "out", "normal_force_slide_2"), 1, delta=1e-6)
        self.assertEqual(len(tomllib.loads((self.folder / "out" / "case.toml").read_text())["slider"]), 2)
        with open(self.folder / "out" / "signals.csv", encoding="utf-8") as file:
            self.assertIn("moment_z_2 [N m]", next(csv.reader(file)))

    @long_test
    def test_a_page_shows_every_slider(self):
        self.run_case("both.toml", "-o", "out", *FAST)
        self.run_program("report", "out", "--figures")
        page = (self.folder / "out" / "report.html").read_text()
        for words in ("Slider 2", "Motion of slider 2", "Normal force, mid-slide, slider 2", "Force on the full skin, slider 2"):
            self.assertIn(words, page)

    @long_test
    def test_runs_are_compared_slider_by_slider(self):
        for name, friction in (("smooth", 0.2), ("rough", 0.4)):
            self.run_case("both.toml", "-o", name, "--only", "mechanics", *FAST, "--set", f"slider[1].contact.friction={friction}")
        told = self.run_program("compare", "smooth", "rough").stdout
        self.assertRegex(told, r"slider\[1\]\.contact\.friction: 0\.2 \| 0\.4")
        self.assertRegex(told, "(?i)tangential force, mid-slide, slider 2")

    def test_what_refuses_several_sliders(self):
        near = ("--set", 'slider[1].start=["4 mm", "1 mm"]')
        for arguments, problem in (
                (("check", "both.toml", *near), "sliders 1 and 2 come within"),
                (("run", "both.toml", "-o", "near", *near), "sliders 1 and 2 come within"),
                (("check", PINCH, "--set", 'slider[1].start=["6 mm", "3 mm"]'), "sliders 1 and 2 come within"),
                (("live", "both.toml", "-o", "two.live"), "train each with --slider NUMBER"),
                (("live", "both.toml", "-o", "two.live", "--slider", "3"), "--slider 3: the case has 2 sliders"),
                (("generate", "both.toml", "--touches", "2", "-o", "store"), "are of one slider"),
                (("check", "both.toml", "--set", "slider.size=1 mm"), "slider is a list")):
            with self.subTest(problem=problem, verb=arguments[0]):
                self.assertIn(problem, self.run_program(*arguments, expect=2).stderr)
        explained = self.run_program("check", "--explain", "both.toml").stdout
        for words in ("slider[0]\n", "slider[1]\n", "slider[1].start"):
            self.assertIn(words, explained)


if __name__ == "__main__":
    unittest.main()
