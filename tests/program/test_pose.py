# SPDX-License-Identifier: Apache-2.0
"""Sliders that are tilted and turned: their wrench in signals.csv and results.h5, the audit of energy, and what refuses them."""

import re
import unittest

import h5py
import numpy

from program import QUICK, ROOT, SMALL, ProgramTest, metric, signals

MECHANICS = (*SMALL, "--set", "skin.sides=free", "--only", "mechanics", "--quiet")
ROLLING = ROOT / "cases" / "rolling.toml"
ROWS = """time [s], x [mm], y [mm], height [um], pitch [deg], yaw [deg]
0,   4.5, 1, 1000, 0,   0
0.5, 4.5, 1, -2,   0,   0
0.7, 4.5, 1, -2,   0,   6
0.9, 4.5, 1, -2,   0,   -6
1.1, 4.5, 1, -2,   0.1, -6
1.3, 5.0, 1, -2,   0.1, -6
1.5, 5.0, 1, 1000, 0,   0
"""


class Pose(ProgramTest):
    def setUp(self):
        super().setUp()
        text = re.sub(r"\[motion\][^[]*", '[motion]\nkind = "waypoints"\nfile = "path.csv"\n\n', QUICK.read_text())
        text = re.sub(r'(?m)^(start|size|edge_radius) = .*\n', "", text)
        self.write("turning.toml", text.replace("[slider]\n", '[slider]\nshape = "sphere"\nradius = "4 mm"\n'))
        self.write("path.csv", ROWS)

    def test_a_finger_that_spins_and_tilts(self):
        self.run_case("turning.toml", "-o", "out", *MECHANICS)
        columns = signals(self.folder / "out")
        at = {name: lambda time, name=name: numpy.interp(time, columns["time"], columns[name])
              for name in ("normal_force", "moment_x", "moment_y", "moment_z", "tangential_force_x", "slip")}
        left, right = at["moment_z"](0.7), at["moment_z"](0.9)
        self.assertGreater(left, 0)  # friction turns the skin with the finger
        self.assertAlmostEqual(right / left, -1, delta=0.02)
        self.assertLess(abs(at["tangential_force_x"](0.9)), 0.02 * 0.3 * at["normal_force"](0.9))
        self.assertGreater(at["slip"](0.9), at["slip"](0.55))
        # Pitched by 0.1 deg it touches 4 mm times that in front of its centre; a slide then shows friction alone.
        self.assertAlmostEqual(at["moment_y"](1.1) / at["normal_force"](1.1), 4e-3 * numpy.radians(0.1), delta=2.5e-6)
        self.assertLess(abs(at["moment_z"](1.3)), 0.5 * left)
        self.assertLess(metric(self.folder / "out", "energy_balance_error"), 0.02)
        with h5py.File(self.folder / "out" / "results.h5") as file:
            self.assertEqual(file["path/moment_z"].attrs["unit"], "N m")
            self.assertAlmostEqual(numpy.interp(0.7, file["path/time"][:], file["path/moment_z"][:]) / left, 1, delta=1e-6)

    def test_a_ball_that_rolls_transmits_no_friction_and_one_that_slides_all_of_it(self):
        """Free rolling takes next to no tangential force (Carter 1926; Johnson, Contact Mechanics, 1985, section 8.3)."""
        mechanics = ("--set", "numerics.mesh_refinement=0.8", "--set", "numerics.time_refinement=1", "--set",
                     "numerics.error_estimate=off", "--only", "mechanics", "--quiet", "--no-report")
        text = ROLLING.read_text()
        self.write("rolling.toml", text)
        sliding = re.sub(r"(?m)^pitch = .*\n", "", text)
        for x in ("5.757 mm", "5.757 mm", "9.243 mm", "9.243 mm"):
            sliding = sliding.replace('position = ["7.5 mm"', f'position = ["{x}"', 1)
        self.write("sliding.toml", sliding)
        self.run_case("rolling.toml", "-o", "rolled", *mechanics)
        self.run_case("sliding.toml", "-o", "slid", *mechanics)
        rolled, slid = signals(self.folder / "rolled"), signals(self.folder / "slid")
        rolls = (rolled["time"] > 0.5) & (rolled["time"] <= 2)
        limit = 0.3 * rolled["normal_force"][rolls]
        self.assertGreater(rolls.sum(), 10)
        self.assertLess(numpy.abs(rolled["tangential_force_x"][rolls] / limit).max(), 1e-3)
        self.assertGreater(rolled["stick_share"][rolls].min(), 0.99)
        slides = (slid["time"] > 0.6) & (slid["time"] <= 2)
        numpy.testing.assert_allclose(slid["tangential_force_x"][slides], 0.3 * slid["normal_force"][slides], rtol=1e-3)
        # The contact goes from one side of the point about which the ball is tilted to the other.
        pitch = numpy.interp(rolled["time"][rolls], (0.5, 2), numpy.radians((-5, 5)))
        arm = rolled["moment_y"][rolls] / rolled["normal_force"][rolls]
        numpy.testing.assert_allclose(arm, 20e-3 * numpy.sin(pitch), atol=0.03 * 20e-3 * numpy.sin(pitch[-1]))

    def test_what_refuses_a_pose(self):
        tilted = ("--set", "slider.pitch=1 deg")
        for arguments, problem in (
                (("live", QUICK, *tilted, "-o", "finger.live"), "a live skin is given the angles with each step"),
                (("live", QUICK, "--tilt", "6", "-o", "finger.live"), "must be from 0 to 5 degrees"),
                (("live", QUICK, "--spin", "10", "-o", "finger.live"), "round them by slider.edge_radius"),
                (("check", QUICK, "--set", "slider.pitch=6 deg"), "slider.pitch"),
                (("check", QUICK, "--set", "slider.yaw=6"), "slider.yaw has no unit"),
                (("check", "turning.toml", "--set", "skin.sides=symmetry"), "can be pitched alone"),
                (("check", "turning.toml", "--set", "contact.law=adhesive", "--set", "contact.work_of_adhesion=0.1 J/m2",
                  "--set", "contact.cohesive_strength=1 MPa"), "takes a slider that keeps its angles"),
                (("check", "turning.toml", "--set", "motion.drive.stiffness=1 kN/m", "--set", "motion.drive.damping=1 N s/m"),
                 "a slider on a drive keeps its angles"),
                (("check", QUICK, "--set", "skin.sides=symmetry", "--set", 'slider.size=["3 mm", "2 mm"]', "--set", "slider.roll=1 deg"),
                 "can be pitched alone")):
            with self.subTest(problem):
                self.assertIn(problem, self.run_program(*arguments, expect=2).stderr)
        self.run_program("check", QUICK, *tilted)
        self.run_program("check", "turning.toml")


if __name__ == "__main__":
    unittest.main()
