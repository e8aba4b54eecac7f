# SPDX-License-Identifier: Apache-2.0
"""`ionskin motion`: recordings in the formats of robots become paths that run."""

import re
import unittest

import numpy

from program import QUICK, SMALL, ProgramTest

EPOCH = 1403636580838555648  # ns
ORIGIN = numpy.array([0.4, -0.1, 0.032])  # of the skin in the frame of the robot
AXES = numpy.array([[0, 1, 0], [-1, 0, 0], [0, 0, 1.0]])  # the skin's x, y and normal there
TOOL = numpy.array([0, 0.01, -0.08])
FRAME = ("--origin", "0.4 m, -100 mm, 32 mm", "--x-axis", "0,1,0", "--y-axis=-1,0,0")


class Recording(ProgramTest):
    """One touch: down, a slide of 3 mm with 2 N in 1 s, up, at 100 Hz, with noise of 5 mN about zero force."""

    def setUp(self):
        super().setUp()
        self.time = numpy.arange(201) / 100
        knots = (0, 0.4, 0.5, 1.5, 1.6, 2.0)
        self.x = numpy.interp(self.time, (0, 0.5, 1.5, 2), (4.5e-3, 4.5e-3, 7.5e-3, 7.5e-3))
        self.y = numpy.full(201, 1e-3)
        self.height = numpy.interp(self.time, knots, (5e-4, 0, -5e-7, -5e-7, 0, 5e-4))
        self.load = numpy.interp(self.time, knots, (0, 0, 2, 2, 0, 0))
        self.force = self.load + numpy.random.default_rng(1).normal(0, 0.005, 201)
        text = re.sub(r"\[motion\][^[]*", '[motion]\nkind = "waypoints"\nfile = "path.csv"\n\n', QUICK.read_text())
        self.case = self.write("case.toml", re.sub(r"(?m)^start = .*\n", "", text))

    def robot(self):
        """Places of a flange whose tool ends at the tip, and its quaternions x, y, z, w: turned about the vertical by 2 s."""
        tip = ORIGIN + numpy.column_stack((self.x, self.y, self.height)) @ AXES
        half = 0.2 * self.time
        turn = numpy.column_stack((0 * half, 0 * half, numpy.sin(half), numpy.cos(half)))
        angle = 2 * half
        arm = numpy.column_stack((-numpy.sin(angle) * TOOL[1], numpy.cos(angle) * TOOL[1], 0 * angle + TOOL[2]))
        return tip - arm, turn

    def table(self, name, header, *columns, separator=",", begin=""):
        cells = (column if isinstance(column, list) else column.tolist() for column in columns)
        rows = [separator.join(map(str, row)) for row in zip(*cells)]
        (self.folder / name).write_text(begin + "\n".join([header, *rows]) + "\n", encoding="utf-8")
        return name

    def stamps(self):
        return [EPOCH + 10_000_000 * row for row in range(len(self.time))]

    def path(self, *arguments):
        """Output of the program, and time, x, y, height and force of the path."""
        process = self.run_program("motion", *arguments, "-o", "path.csv", "--overwrite")
        lines = (self.folder / "path.csv").read_text().splitlines()
        self.assertEqual(lines[0], "time [s],x [mm],y [mm],height [mm],force [N]")
        return process.stdout, numpy.array([[float(cell or "nan") for cell in line.split(",")] for line in lines[1:]]).T

    def assert_touch(self, *arguments, force=True, height=True):
        told, (time, x, y, heights, forces) = self.path(*arguments)
        self.assertEqual(len(time), len(self.time))
        numpy.testing.assert_allclose(time, self.time, atol=5e-7)  # a double holds 2.4e-7 s of an epoch
        numpy.testing.assert_allclose(x, 1e3 * self.x, atol=2e-6)
        numpy.testing.assert_allclose(y, 1e3 * self.y, atol=2e-6)
        if force:
            touches = numpy.isfinite(forces)
            numpy.testing.assert_array_equal(touches, numpy.isnan(heights))
            numpy.testing.assert_allclose(forces[touches], self.load[touches], atol=0.03)
            self.assertTrue(touches[self.load > 0.1].all())
            self.assertFalse(touches[self.load == 0].any())
            heights = heights[~touches]
            expected = numpy.maximum(self.height[~touches], 0) if height else numpy.full(len(heights), 1e-3)
        else:
            self.assertTrue(numpy.isnan(forces).all())
            expected = self.height
        numpy.testing.assert_allclose(heights, 1e3 * expected, atol=2e-6)
        return told

    def run_path(self):
        self.run_program("run", self.case, *SMALL, "-o", "out", "--overwrite", "--no-report", "--only", "mechanics")

    def coarser(self, *arguments):
        """Runs the path with few rows."""
        self.path(*arguments, "--rate", "20 Hz")
        self.run_path()

    def each(self, *arguments, **kinds):
        told = self.assert_touch(*arguments, **kinds)
        self.coarser(*arguments)
        return told

    def test_ros_bags(self):
        place, turn = self.robot()
        zero = [0] * len(self.time)
        names = ["base"] * len(self.time)
        tool = ("--tool", "0, 10 mm, -80 mm")
        pose = [*place.T, *turn.T]
        ten = [f"position.{axis}" for axis in "xyz"] + [f"orientation.{axis}" for axis in "xyzw"]
        with self.subTest("rostopic echo -p"):
            head = "%time,field.header.seq,field.header.stamp,field.header.frame_id,"
            first = self.table("pose.csv", head + ",".join(f"field.pose.{one}" for one in ten),
                               self.stamps(), zero, self.stamps(), names, *pose)
            wrench = ",".join(f"field.wrench.{part}.{axis}" for part in ("force", "torque") for axis in "xyz")
            second = self.table(
                "wrench.csv", head + wrench,
                self.stamps(), zero, self.stamps(), names, zero, zero, -self.force, zero, zero, zero)
            told = self.each(first, second, *FRAME, *tool, "--force-in", "recording")
            self.assertIn("field.header.stamp in ns", told)
            self.assertIn("sign of the force is turned", told)
        seconds, nanoseconds = ([stamp // 10**9 for stamp in self.stamps()], [stamp % 10**9 for stamp in self.stamps()])
        with self.subTest("bagpy"):
            head = "Time,header.seq,header.stamp.secs,header.stamp.nsecs,header.frame_id,"
            force = ",wrench.force.x,wrench.force.y,wrench.force.z"
            name = self.table(
                "bagpy.csv", head + ",".join(f"pose.pose.{one}" for one in ten) + force,
                [stamp / 1e9 for stamp in self.stamps()], zero, seconds, nanoseconds, names, *pose, zero, zero, self.force)
            self.each(name, *FRAME, *tool, "--force-in", "recording")
        with self.subTest("ROS 2"):
            name = self.table("ros2.csv", "header.stamp.sec,header.stamp.nanosec,header.frame_id," +
                              ",".join(f"pose.{one}" for one in ten) + ",wrench.force.x,wrench.force.y,wrench.force.z",
                              seconds, nanoseconds, names, *pose, zero, zero, self.force)
            self.each(name, *FRAME, *tool, "--force-in", "tool")
        with self.subTest("PlotJuggler"):
            name = self.table("jug.csv", "__time,/tip/pose/position/x,/tip/pose/position/y,/tip/pose/position/z,/ft/wrench/force/z",
                              [stamp / 1e9 for stamp in self.stamps()], self.x, self.y, self.height, self.force)
            self.each(name)

    def test_formats_of_robots_and_sensors(self):
        zero = [0] * len(self.time)
        place, turn = self.robot()
        with self.subTest("EuRoC"):
            name = self.table("euroc.csv", "#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],"
                              "q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z []",
                              self.stamps(), *place.T, turn[:, 3], *turn[:, :3].T)
            self.each(name, *FRAME, "--tool", "0, 10 mm, -80 mm", force=False)
        with self.subTest("force-torque sensor"):
            places = self.table("places.csv", "Time (s),X (mm),Y (mm)", self.time, 1e3 * self.x, 1e3 * self.y)
            sensor = self.table("ft.csv", "Time (s),Fx (N),Fy (N),Fz (N),Tx (N-m),Ty (N-m),Tz (N-m)", self.time, zero, zero,
                                self.force - 12, zero, zero, zero)
            message = self.run_program("motion", places, sensor, "-o", "other.csv", expect=2).stderr
            self.assertIn("--tare", message)
            told = self.each(places, sensor, "--tare", height=False)
            self.assertIn("N, is subtracted", told)
        with self.subTest("UR RTDE"):
            name = self.table("rtde.csv", "timestamp," + ",".join(f"actual_TCP_pose_{i}" for i in range(6)) + "," + ",".join(
                f"actual_TCP_force_{i}" for i in range(6)), self.time + 5123.4, self.x, self.y, self.height, zero, zero, zero,
                zero, zero, self.force, zero, zero, zero)
            self.each(name)
        with self.subTest("Franka"):
            matrix = [zero] * 12 + [self.x, self.y, self.height, [1] * len(self.time)]
            name = self.table("franka.csv", "time," + ",".join(f"O_T_EE[{i}]" for i in range(16)) + "," + ",".join(
                f"O_F_ext_hat_K[{i}]" for i in range(6)), self.time, *matrix, zero, zero, -self.force, zero, zero, zero)
            self.each(name)
        with self.subTest("spreadsheet with decimal commas"):
            cells = [[f"{value:.9f}".replace(".", ",") for value in column] for column in
                     (self.time, 1e3 * self.x, 1e3 * self.y, 1e3 * self.height, self.force)]
            name = self.table("sheet.csv", "Time (s);X (mm);Y (mm);Z (mm);Force (N)", *cells, separator=";", begin="\ufeff")
            self.each(name)
        with self.subTest("pandas"):
            name = self.table("frame.csv", ",timestamp_ms,x_mm,y_mm,z_mm,force_n", list(range(201)),
                              [stamp // 10**6 for stamp in self.stamps()], 1e3 * self.x, 1e3 * self.y, 1e3 * self.height,
                              self.force)
            self.each(name)

    def test_a_turn_is_taken_into_the_path(self):
        place, turn = self.robot()  # turns by 0.4 rad/s
        name = self.table("turned.csv", "t,x [m],y [m],z [m],qx,qy,qz,qw,force", self.time, *place.T, *turn.T, self.force)
        arguments = ("motion", name, *FRAME, "--tool", "0, 10 mm, -80 mm", "-o", "path.csv", "--overwrite")
        self.assertRegex(self.run_program(*arguments).stdout, "turns about the normal by up to .*: --angles takes it into the path")
        told = self.run_program(*arguments, "--angles").stdout
        self.assertNotIn("turns about the normal", told)
        lines = (self.folder / "path.csv").read_text().splitlines()
        self.assertEqual(lines[0], "time [s],x [mm],y [mm],height [mm],force [N],roll [deg],pitch [deg],yaw [deg]")
        rows = numpy.array([[float(cell or "nan") for cell in line.split(",")] for line in lines[1:]])
        pressed = rows[numpy.isfinite(rows[:, 4])]
        numpy.testing.assert_allclose(pressed[:, 5:7], 0, atol=1e-5)
        numpy.testing.assert_allclose(pressed[:, 7], numpy.degrees(0.4 * (pressed[:, 0] - pressed[0, 0])), atol=1e-4)

    def test_what_recorders_do_to_a_table(self):
        header, columns = "t,x [m],y [m],z [m],force", (self.time, self.x, self.y, self.height, self.force)
        mixed = [numpy.concatenate((one[:100], one[99:])) for one in columns]  # a stamp twice ...
        mixed[4] = mixed[4] + numpy.where(numpy.arange(202) == 100, 0.02, 0)  # ... with two forces
        order = numpy.arange(202)
        order[[30, 31]] = 31, 30
        told = self.assert_touch(self.table("twice.csv", header, *(one[order] for one in mixed)))
        self.assertIn("1 stamps repeat", told)
        self.assertIn("1 stamps go back", told)
        holes = [list(one) for one in columns]
        holes[1][50], holes[4][51] = "", "nan"
        told, path = self.path(self.table("holes.csv", header, *holes))
        self.assertIn("2 of 201 rows lack a number", told)
        self.assertEqual(len(path[0]), 199)
        nothing = 0 * self.time
        turnless = self.table("turnless.csv", header + ",qx,qy,qz,qw", *columns, nothing, nothing, nothing, nothing)
        self.assertIn("the quaternion is 0 in every row", self.assert_touch(turnless))
        self.assertIn("turnless.csv (qx, qy, qz, qw) is 0, which is no orientation, in row 1",
                      self.run_program("motion", turnless, "--tool", "0,0,1 mm", "-o", "none.csv", expect=2).stderr)
        on = self.load > 1.9  # begins and ends on the skin
        told, path = self.path(self.table("on.csv", header, *(one[on] for one in columns)), "--contact-force", "0.1 N")
        self.assertIn("begins on the skin", told)
        self.assertEqual(path[3][0], 1)
        self.run_program("check", self.case, "--set", "output.fields=[0.5 s]")

    def test_filter_and_rate(self):
        self.force = self.load + 0.05 * numpy.sin(2 * numpy.pi * 45 * self.time)
        name = self.table("noisy.csv", "t,x [m],y [m],z [m],force [N]", self.time, self.x, self.y, self.height, self.force)
        raw = self.path(name, "--contact-force", "0.5 N")[1]
        told, smooth = self.path(name, "--filter", "10Hz", "--rate", "50 Hz", "--contact-force", "0.5 N")
        self.assertIn("resampled from 201 to 101 rows", told)
        slide = (raw[0] > 0.7) & (raw[0] < 1.3)
        self.assertGreater(numpy.std(raw[4][slide]), 0.03)
        slide = (smooth[0] > 0.7) & (smooth[0] < 1.3)
        self.assertLess(numpy.std(smooth[4][slide]), 1e-3)
        undelayed = numpy.interp(smooth[0][slide], self.time, 1e3 * self.x)
        numpy.testing.assert_allclose(smooth[1][slide], undelayed, atol=1e-3)

    def test_mistakes(self):
        good = self.table("good.csv", "t,a,b,z [m],force", self.time, self.x, self.y, self.height, self.force)
        words = {
            (good,): "no columns of x and y",
            (good, "--column", "x=c"): "no column is named 'c'",
            (good, "--column", "speed=a"): "is not a role",
            (good, "--column", "x=a [kg]", "--column", "y=b"): "does not convert to m",
            (good, "--column", "x=a", "--column", "y=b", "--tool", "0,0,1 mm"): "needs a quaternion",
            (good, "--column", "x=a", "--column", "y=b", "--x-axis", "1,1,0"): "are not perpendicular",
            (good, "--column", "x=a", "--column", "y=b", "--rate", "20 kg"): "is not a quantity in Hz",
            (good, "--column", "x=a", "--column", "y=b", "--rate", "10 MHz"): "a path may have 1000000",
            (good, "--column", "x=a", "--column", "y=b", "--contact-force", "50 N"): "never rises above 50 N",
            (self.table("empty.csv", "t,x,y,z"),): "no row stands below the header",
            (self.table("bare.csv", "0,1,2,3", [1], [2], [3], [4]),): "has no header",
            (self.table("dates.csv", "time,x,y,z", ["2026-11-29T08:00:00Z", "2026-11-29T08:00:01Z"], [1, 2], [1, 2], [0, 1]),):
                'time holds "2026-11-29T08:00:00Z" in line 2, which is not a number',
            (self.table("marks.csv", "time,x,y,z", [0, 1], [1, 2], [1, 2], [0, "\u22121"]),): "in line 3, which is not a number",
            (self.table("capital.csv", "TIME (S),X (mm),Y (mm),Z (mm)", [0, 1], [1, 2], [1, 2], [0, 1]),):
                "the unit [S] of time does not convert to s",
            (self.table("bars.csv", "time|x|y|z", [0, 1], [1, 2], [1, 2], [0, 1], separator="|"),): "tr -s '|' ','",
            ("none.csv",): "cannot be read",
        }
        for arguments, word in words.items():
            with self.subTest(word):
                self.assertIn(word, self.run_program("motion", *arguments, "-o", "path.csv", expect=2).stderr)
                self.assertFalse((self.folder / "path.csv").exists())
        named = (good, "--column", "x=a [m]", "--column", "y=b [m]")
        self.assert_touch(*named)
        self.assertIn("there is no folder none\n  = make it",
                      self.run_program("motion", *named, "-o", "none/path.csv", expect=2).stderr)
        self.assertIn("is there already", self.run_program("motion", *named, "-o", "path.csv", expect=2).stderr)


if __name__ == "__main__":
    unittest.main()
