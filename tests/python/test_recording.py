# SPDX-License-Identifier: Apache-2.0
"""Paths made of recordings of robots by `ionskin.motion`: noise, spikes, stamps, tilt, mistakes."""

import unittest

import numpy

import ionskin
from ionskin.reading.recording import contact
from package import PackageTest


class Touch(PackageTest):
    """One touch of 0.5 N at 125 Hz, with noise of 4 mN: 0.5 s above the skin, 1.4 s on it, 0.7 s above it."""

    def setUp(self):
        super().setUp()
        self.time = numpy.arange(326) / 125
        self.x = numpy.interp(self.time, (0.9, 1.7), (4.5, 8.5))
        self.height = numpy.interp(self.time, (0, 0.5, 0.52, 1.88, 1.9, 2.6), (1, 0, -0.02, -0.02, 0, 1))
        self.force = numpy.interp(self.time, (0.5, 0.6, 1.8, 1.9), (0, 0.5, 0.5, 0))
        self.force += numpy.random.default_rng(2).normal(0, 0.004, len(self.time))

    def table(self, name, **columns):
        """Writes a recording of columns by their titles and returns its path."""
        lines = [",".join(columns), *(",".join(map(repr, row)) for row in zip(*(
            numpy.asarray(column).tolist() for column in columns.values())))]
        (self.folder / name).write_text("\n".join(lines) + "\n")
        return self.folder / name

    def touch(self, **changes):
        """Writes the touch with some columns changed or added."""
        return self.table("touch.csv", **{"time": self.time, "x_mm": self.x, "y_mm": 0 * self.x, "z_mm": self.height,
                                          "force": self.force, **changes})

    def assert_one_touch(self, path):
        """Asserts that the path presses once, about as long as the finger touched."""
        spans = contact.parts(numpy.isfinite(path.force))
        self.assertEqual(len(spans), 1, path.notes)
        first, last = path.time[spans[0][0]], path.time[spans[0][1] - 1]
        self.assertAlmostEqual(first, 0.5, delta=0.02)
        self.assertAlmostEqual(last, 1.9, delta=0.02)

    def test_noise_is_that_of_the_recorded_rows(self):
        """Straight lines between the rows have no noise: a resampled touch was six."""
        recording = self.touch()
        self.assert_one_touch(ionskin.motion(recording))
        self.assert_one_touch(ionskin.motion(recording, rate="1 kHz"))
        clock = numpy.arange(2500) / 1000
        fast = self.table("fast.csv", time=clock, x_mm=0 * clock, y_mm=0 * clock)
        force = self.table("force.csv", time=self.time, force=self.force)
        self.assert_one_touch(ionskin.motion([fast, force]))
        self.assert_one_touch(ionskin.motion([force, fast], rate="1 kHz"))

    def test_filter_leaves_a_part_of_the_noise(self):
        """Filtered noise is smooth, and larger than its second differences say."""
        for seed in range(5):
            force = self.force + numpy.random.default_rng(seed).normal(0, 0.08, len(self.time))
            path = ionskin.motion(self.touch(force=force), filter="5 Hz", rate="500 Hz")
            self.assertEqual(len(contact.parts(numpy.isfinite(path.force))), 1, path.notes)

    def test_a_spike_hides_no_touch(self):
        """One wrong row, of either sign, decides neither the threshold nor the sign; it is told."""
        for row in (0, 20, 150, 325):
            for spike in (80, -80):
                for sign in (1, -1):
                    force = self.force.copy()
                    force[row] = spike
                    path = ionskin.motion(self.touch(force=sign * force), rate="1 kHz")
                    told = [note for note in path.notes if f"one row alone has {spike} N" in note]
                    spans = contact.parts(numpy.isfinite(path.force))
                    pressed = sum(path.time[behind - 1] - path.time[first] for first, behind in spans)
                    with self.subTest(row=row, spike=spike, sign=sign):
                        self.assertEqual(len(told), 1, path.notes)
                        self.assertTrue(all(f" {row / 125:.4g} s after the first row" in note for note in told), told)
                        self.assertLessEqual(len(spans), 2)
                        self.assertAlmostEqual(pressed, 1.4, delta=0.05)

    def test_a_short_real_peak_is_kept(self):
        """Taps of one and of two rows, alone and beside a touch."""
        for rows, beside, touches in (([200], 0, 1), ([100, 200], 0, 2), ([260], 1, 2), ([270, 271], 1, 2)):
            force = beside * self.force
            force[rows] += 3
            path = ionskin.motion(self.touch(force=force))
            with self.subTest(rows=rows, beside=beside):
                self.assertTrue(numpy.isfinite(path.force[rows]).all())
                numpy.testing.assert_allclose(path.force[rows], 3, atol=0.02)
                self.assertEqual(len(contact.parts(numpy.isfinite(path.force))), touches)
                self.assertEqual(any("one row alone" in note for note in path.notes), rows == [260])

    def test_each_row_that_stands_alone_is_reported(self):
        """A row may lift the finger in the middle of a touch, by a force that is no larger than that of the touch."""
        for change, part in (({150: -0.4}, "one row alone has -0.4 N, 1.2 s after the first row"),
                             ({150: 0}, "one row alone has 0 N, 1.2 s after the first row"),
                             ({20: 50, 150: -40}, "2 rows, each alone, have 50 N at 0.16 s, -40 N at 1.2 s after the first")):
            force = self.force.copy()
            force[list(change)] = list(change.values())
            notes = ionskin.motion(self.touch(force=force)).notes
            with self.subTest(part):
                self.assertEqual([note for note in notes if "alone ha" in note or "each alone" in note],
                                 [note for note in notes if part in note])
                self.assertTrue(any(part in note for note in notes), notes)
        self.assertFalse(any("alone" in note for note in ionskin.motion(self.touch()).notes))

    def test_a_force_at_the_limit_of_its_sensor_is_reported(self):
        """The flat top says nothing about the noise."""
        cut = numpy.minimum(self.force, 0.3)
        for sign in (1, -1):
            for tare in (False, True):
                path = ionskin.motion(self.touch(force=sign * cut), tare=tare)
                self.assert_one_touch(path)
                told = [note for note in path.notes if "the force stays at its largest value, 0.3 N, in 16" in note]
                self.assertEqual(len(told), 1, path.notes)
        exact = numpy.interp(self.time, (0.5, 0.6, 1.8, 1.9), (0, 0.5, 0.5, 0))
        for force in (self.force, exact):
            self.assertFalse(any("its largest value" in note for note in ionskin.motion(self.touch(force=force)).notes))

    def test_a_touch_that_does_not_end_is_reported(self):
        told = "the last touch does not end: the last row has 0.1"
        notes = ionskin.motion(self.touch(force=self.force + 0.05 * self.time)).notes
        self.assertTrue(any(told in note for note in notes), notes)
        self.assertFalse(any("does not end" in note for note in ionskin.motion(self.touch()).notes))

    def test_a_level_or_a_frame_that_is_none(self):
        for arguments, word in (({"level": "x"}, "--level = 'x' is none of auto, height, force\n  = choose"),
                                ({"force_in": "x"}, "--force-in = 'x' is none of skin, recording, tool\n  = choose")):
            with self.assertRaisesRegex(ionskin.CaseError, word):
                ionskin.motion(self.touch(), **arguments)

    def test_two_columns_of_one_name(self):
        """They are refused unless they are the same."""
        recording = self.touch()
        for other, refused in ((self.x + 1, True), (self.x, False)):
            lines = recording.read_text().splitlines()
            doubled = [f"{line},{value}" for line, value in zip(lines, ["x_mm", *other.tolist()])]
            (self.folder / "doubled.csv").write_text("\n".join(doubled) + "\n")
            for columns in ((), ("x=x_mm [mm]",)):
                with self.subTest(refused=refused, columns=columns):
                    if refused:
                        with self.assertRaisesRegex(ionskin.CaseError, "2 columns .* named x_mm, and differ: .*\n  = rename"):
                            ionskin.motion(self.folder / "doubled.csv", columns=columns)
                    else:
                        self.assert_one_touch(ionskin.motion(self.folder / "doubled.csv", columns=columns))

    def test_touches_within_the_noise_are_told(self):
        """A recording that was resampled before tells no noise."""
        clock = numpy.arange(2600) / 1000
        force = self.table("held.csv", time=clock, x_mm=0 * clock, y_mm=0 * clock,
                           force=self.force[numpy.searchsorted(self.time, clock, side="right") - 1])
        path = ionskin.motion(force)
        self.assertGreater(len(contact.parts(numpy.isfinite(path.force))), 1)
        self.assertTrue(any("set a larger one with --contact-force" in note for note in path.notes), path.notes)
        self.assertFalse(any("set a larger one" in note for note in ionskin.motion(self.touch()).notes))

    def test_recordings_that_do_not_overlap(self):
        """The message gives the span of each recording, and the offset that lets them begin together."""
        nothing = 0 * self.time
        places = self.table("places.csv", time=self.time + 1764446200.25, x_mm=self.x, y_mm=nothing)
        force = self.table("force.csv", time=self.time + 12, force=self.force)
        spans = {places: r"\S*places.csv from 1764446200.25 to 1764446202.85 s", force: r"\S*force.csv from 12 to 14.6 s"}
        for files in ([places, force], [force, places]):
            with self.subTest(files[0].name), self.assertRaisesRegex(
                    ionskin.CaseError, f"the recordings do not overlap in time: {', '.join(spans[one] for one in files)}\n"
                    r"  = correct the offset between the clocks \(if \S*places.csv and \S*force.csv began at one instant, subtract "
                    r"1764446188.25 s from the times of \S*places.csv\), or name the unit of the times with --column"):
                ionskin.motion(files)
        short = self.table("short.csv", time=[12.001, 12.002, 12.003], x_mm=[4.5] * 3, y_mm=[0.5] * 3)
        with self.assertRaisesRegex(ionskin.CaseError, r"fewer than two rows of \S*force.csv lie within the time that all "
                                    r"recordings cover: .*short.csv from 12.001 to 12.003 s\n  = name a recording with more rows first"):
            ionskin.motion([force, short])

    def test_a_quaternion_of_zeros_is_told_with_its_row(self):
        nothing, one = 0 * self.time, 1 + 0 * self.time
        zeros = self.touch(qx=nothing, qy=nothing, qz=nothing, qw=nothing)
        with self.assertRaisesRegex(ionskin.CaseError, r"--tool needs .*touch.csv \(qx, qy, qz, qw\) is 0, .* in row 1 and all"):
            ionskin.motion(zeros, tool=(0, 0, 0.1))
        with self.assertRaisesRegex(ionskin.CaseError, "the recording has none"):
            ionskin.motion(self.touch(), tool=(0, 0, 0.1))
        wrench = {"fx": nothing, "fy": nothing, "fz": self.force}
        pose = self.table("pose.csv", time=self.time, x_mm=self.x, y_mm=nothing, z_mm=self.height, **wrench)
        with self.assertRaisesRegex(ionskin.CaseError, "--force-in tool needs a quaternion, and the recording has none"):
            ionskin.motion(pose, force_in="tool")
        one[[7, 9]] = 0
        path = ionskin.motion(self.touch(qx=one, qy=nothing, qz=nothing, qw=nothing))
        self.assertTrue(any("0, which is no orientation, in 2 rows, the first of which is row 8" in note for note in path.notes),
                        path.notes)

    def test_axes_that_are_not_perpendicular(self):
        recording = self.touch()
        for axes, word in (({"x_axis": (0, 1, 0)}, "--x-axis 0,1,0 and --y-axis 0,1,0 are not perpendicular, but at 0 degrees; .*"
                            "\n.*--y-axis=-1,0,0"),
                           ({"x_axis": "0,1,0"}, "--x-axis 0,1,0 and --y-axis 0,1,0 are"),
                           ({"y_axis": (1, 1, 0)}, "--x-axis 1,0,0 and --y-axis 1,1,0 are not perpendicular, but at 45 degrees"),
                           ({"x_axis": (0, 0, 0)}, "--x-axis 0,0,0 is not a direction"),
                           ({"y_axis": "0,nan,0"}, "--y-axis 0,nan,0 is not a direction")):
            with self.subTest(axes), self.assertRaisesRegex(ionskin.CaseError, word):
                ionskin.motion(recording, **axes)

    def test_a_file_that_cannot_be_written(self):
        path = ionskin.motion(self.touch())
        (self.folder / "there").mkdir()
        for name, word in (("none/k.csv", "there is no folder .*none\n  = make it"), ("there", "is a folder"),
                           ("touch.csv", "is there already"), ("touch.csv/k.csv", "there is no folder")):
            with self.subTest(name), self.assertRaisesRegex(ionskin.CaseError, word) as raised:
                path.write(self.folder / name)
            self.assertNotIn("pending", str(raised.exception))
        with self.assertRaises(OSError) as long:
            path.write(self.folder / ("k" * 300))
        self.assertNotIn("pending", str(long.exception))

    def test_stamps_that_tell_no_rows_apart(self):
        """Most stamps repeat: refused where they are cut to seconds, told where rows are averaged finely or are the same."""
        cut = self.touch(time=[1764446202 + int(one) for one in self.time])
        word = (r"touch.csv, time: the time stamps have a resolution of 1 s: 326 rows have 3 different stamps\n"
                "  = write the stamps with the fractions of a second, name a column")
        with self.assertRaisesRegex(ionskin.CaseError, word):
            ionskin.motion(cut)
        with self.assertRaisesRegex(ionskin.CaseError, "resolution of 0.1 s: 326 rows have 27 different"):
            ionskin.motion(self.touch(time=numpy.floor(10 * self.time + 1e-9) / 10))
        with self.assertRaisesRegex(ionskin.CaseError, "touch.csv, time: all 326 rows have one time stamp"):
            ionskin.motion(self.touch(time=[1764446202] * 326))
        fine = ionskin.motion(self.touch(time=numpy.floor(50 * self.time + 1e-9) / 50))
        self.assertEqual(len(fine.time), 131)
        self.assertTrue(any("resolution of 0.02 s: 326 rows have 131 different stamps, and the rows of one stamp are averaged: "
                            "is there a column of finer times?" in note for note in fine.notes), fine.notes)
        every, again = slice(None, None, 25), numpy.repeat(numpy.arange(14), 3)
        same = ionskin.motion(self.touch(time=(self.time[every])[again], x_mm=self.x[every][again], y_mm=0.0 * again,
                                         z_mm=self.height[every][again], force=self.force[every][again]))
        self.assertEqual(len(same.time), 14)
        self.assertFalse(any("finer" in note for note in same.notes), same.notes)

    def test_rounded_frames_leave_a_path_on_the_middle_line(self):
        off = 1e-6 * numpy.sin(self.time)  # mm
        path = ionskin.motion(self.touch(y_mm=3 + off, x_mm=self.x + 1e-6))
        self.assertEqual(set(path.position[:, 1]), {3e-3})
        numpy.testing.assert_allclose(path.position[:, 0], 1e-3 * self.x, atol=1e-8)

    def test_normal_force_of_a_path_is_a_number_in_every_row(self):
        path = ionskin.motion(self.touch())
        pressed = numpy.isfinite(path.force)
        numpy.testing.assert_array_equal(path.normal_force, numpy.where(pressed, path.force, 0))
        self.assertFalse(pressed.all())
        heights = ionskin.motion(self.touch(), level="height")
        with self.assertRaisesRegex(ionskin.CaseError, "heights alone, .*\n  = give a live skin heights=path.height"):
            self.assertIsNone(heights.normal_force)

    def turned(self, roll, pitch, yaw, mount):
        """Quaternion columns of a finger that is turned by roll, pitch and yaw [deg] on the skin and held by a tool that is
        mounted by a quaternion."""
        def product(a, b):
            vector = a[3] * b[:3] + b[3] * a[:3] + numpy.cross(a[:3], b[:3])
            return numpy.append(vector, a[3] * b[3] - a[:3] @ b[:3])

        rows = []
        for angles in zip(*(numpy.radians(numpy.broadcast_to(one, self.time.shape)) / 2 for one in (roll, pitch, yaw))):
            one = [numpy.append(numpy.sin(angle) * axis, numpy.cos(angle)) for angle, axis in zip(angles, numpy.eye(3))]
            rows.append(product(product(one[2], product(one[1], one[0])), mount))
        return dict(zip(("qx", "qy", "qz", "qw"), numpy.transpose(rows)))

    def test_a_tilt_in_contact_is_told_or_taken(self):
        down = numpy.array([1.0, 0, 0, 0])
        oblique = numpy.append(numpy.sin(0.4) * numpy.array([0.6, 0.8, 0]), numpy.cos(0.4))
        ramp = numpy.interp(self.time, (0.7, 1.0), (0, 1))
        for mount, what, since in ((down, "the tool's z axis", "the skin's normal"),
                                   (oblique, "the tool", "its direction at the first touch")):
            with self.subTest(what):
                steep = self.touch(**self.turned(0, 10 * ramp, 0, mount))
                for level in ("auto", "force", "height"):
                    told = [note for note in ionskin.motion(steep, level=level).notes if "in contact" in note]
                    self.assertRegex(told[0], rf"{what} tilts by up to 10 degrees from {since} \(roll 0, pitch 10 degrees, at "
                                     r"[0-9.]+ s\), which the path leaves out: .*height map")
                with self.assertRaisesRegex(ionskin.CaseError, "tilts by up to 10 degrees .*\n  = leave out --angles; a"):
                    ionskin.motion(steep, angles=True)
                slight = self.touch(**self.turned(-3 * ramp, 2 * ramp, 40 * ramp, mount))
                told = [note for note in ionskin.motion(slight).notes if "in contact" in note]
                self.assertRegex(told[0], "tilts by up to 3.61 degrees .*turns about the normal by up to 40, .*: --angles takes it")
                path = ionskin.motion(slight, angles=True)
                self.assertFalse([note for note in path.notes if "in contact" in note])
                pressed = numpy.isfinite(path.force)
                expected = numpy.outer(ramp, (-3, 2, 40))
                numpy.testing.assert_allclose(numpy.degrees(path.angles[pressed]), expected[pressed], atol=1e-6)
                path.write(self.folder / "path.csv", overwrite=True)
                lines = (self.folder / "path.csv").read_text().splitlines()
                self.assertTrue(lines[0].endswith(",force [N],roll [deg],pitch [deg],yaw [deg]"))
                self.assertEqual(lines[1 + 200].split(",")[5:], ["-3.000000", "2.000000", "40.000000"])
        upright = self.touch(**self.turned(0, 10 * (self.time > 2), 0, down))
        self.assertFalse([note for note in ionskin.motion(upright).notes if "in contact" in note])
        for changes, word in (({"level": "height"}, "--angles needs a force"), ({}, "--angles needs a quaternion")):
            recording = upright if changes else self.touch()
            with self.assertRaisesRegex(ionskin.CaseError, word):
                ionskin.motion(recording, angles=True, **changes)


if __name__ == "__main__":
    unittest.main()
