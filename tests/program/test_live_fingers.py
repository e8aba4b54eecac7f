# SPDX-License-Identifier: Apache-2.0
"""Several live fingers on one skin: sums, flags, states, what is refused, and the full model of two sliders."""

import functools
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import types
import unittest

import numpy

from program import PROGRAM, ProgramTest, signals
from test_sliders import FAST, pads
from tiers import long_test

sys.path.insert(0, str(PROGRAM.parent / "python"))
import ionskin.live  # noqa: E402
from ionskin.live import fingers  # noqa: E402

COARSE = ("--set", "numerics.preset=coarse")


class Fingers(ProgramTest):
    @classmethod
    @functools.cache
    def files(cls):
        """Files of two pads, trained one by one from the case that has both."""
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        case = pathlib.Path(scratch.name) / "both.toml"
        case.write_text(pads(0, 1))
        files = [case.with_name(f"{number}.live") for number in (1, 2)]
        for number, file in enumerate(files, 1):
            subprocess.run([PROGRAM, "live", case, *COARSE, "--set", "numerics.mesh_refinement=0.5", "--slider", str(number),
                            "--trajectories", "2", "--validation", "1", "--quiet", "-o", file], check=True)
        return files

    @long_test
    def test_charges_add_up(self):
        one, other = map(ionskin.live.Skin, self.files())
        fingers = ionskin.live.Fingers(self.files())
        times, way = 1e-3 * numpy.arange(60), 1e-7 * numpy.arange(60)
        forces = numpy.column_stack([numpy.linspace(0.5, 1, 60), numpy.where(times < 0.03, 0, 0.8)])
        positions = numpy.full((60, 2, 2), 1e-3)
        positions[:, 0, 0], positions[:, 1, 0] = one.range.lowest[0] + way, other.range.highest[0] - way
        both = fingers.copy().run(times, positions, forces=forces)
        self.assertFalse(both.flags.any() or both.outside.any())
        own = [skin.run(times, positions[:, i], forces=forces[:, i]) for i, skin in enumerate((one, other))]
        for name in own[0]:
            with self.subTest(name):
                if name.startswith(("charge_", "current_")):
                    numpy.testing.assert_array_equal(both[name], own[0][name] + own[1][name])
                    self.assertNotIn(name + "_2", both)
                else:
                    numpy.testing.assert_array_equal(both[name], own[0][name])
                    numpy.testing.assert_array_equal(both[name + "_2"], own[1][name])
        self.assertGreater(min(abs(each["charge_top"]).max() for each in own), 0)
        self.assertEqual(fingers.errors["charge_top"].worst, one.errors["charge_top"].worst + other.errors["charge_top"].worst)
        self.assertEqual(fingers.errors["normal_force_2"], other.errors["normal_force"])
        step = fingers.step(0, positions[0], forces=forces[0])
        self.assertEqual(step.array.tolist(), both.array[0].tolist())
        state = fingers.save()
        again = fingers.step(1e-3, positions[1], heights=[-6e-7, 1e-4])
        fingers.restore(state)
        self.assertEqual(fingers.step(1e-3, positions[1], heights=[-6e-7, 1e-4]).array.tolist(), again.array.tolist())
        for wrong, pattern in (({"forces": [1]}, "forces: the shape"), ({"forces": [1, math.nan]}, "NaN"),
                               ({"time": 0, "forces": [1, 1]}, "comes before")):
            with self.subTest(pattern), self.assertRaisesRegex(ValueError, pattern):
                fingers.step(wrong.pop("time", 1), positions[2], **wrong)
        with self.assertRaisesRegex(ValueError, "damaged"):
            fingers.restore([state[0], b"12345678"])
        self.assertEqual([skin.time for skin in fingers], [1e-3] * 2)  # as it was

    @long_test
    def test_fingers_that_are_near_are_flagged_while_both_touch(self):
        fingers = ionskin.live.Fingers([self.files()[0]] * 2)
        low, high = (end[0] for end in (fingers[0].range.lowest, fingers[0].range.highest))
        touching = fingers.step(0, [(low, 1e-3), (high, 1e-3)], forces=[1, 1])
        self.assertEqual((touching.flags & ionskin.live.TOO_NEAR).tolist(), [ionskin.live.TOO_NEAR] * 2)
        self.assertTrue(touching.outside.all())
        self.assertFalse((fingers.step(1e-3, [(low, 1e-3), (high, 1e-3)], forces=[1, 0]).flags & ionskin.live.TOO_NEAR).any())

    def test_a_finger_outside_its_range_is_near_at_the_place_that_was_given(self):
        """Finger 2 is given a place beside finger 1, and its nearest trained place is 4 mm away."""
        pair = object.__new__(ionskin.live.Fingers)
        pair.skins = [types.SimpleNamespace(footprint=(-1e-3, -1e-3, 1e-3, 1e-3), core_thickness=2e-4,
                                            names=("slider_x", "slider_y", "normal_force"))] * 2
        pair._names()
        taken = numpy.array([[5e-3, 3e-3, 1, 9e-3, 3e-3, 1]] * 2)
        flags = numpy.zeros((2, 2), dtype=numpy.uint32)
        pair._flag_near(taken, numpy.array([[[5e-3, 3e-3], [9e-3, 3e-3]], [[5e-3, 3e-3], [7.2e-3, 3e-3]]]), flags)
        self.assertEqual(flags.tolist(), [[0, 0], [ionskin.live.TOO_NEAR] * 2])

    @long_test
    def test_one_file_is_one_finger(self):
        for one in (str(self.files()[0]), self.files()[0], ionskin.live.Skin(self.files()[0])):
            self.assertEqual(len(ionskin.live.Fingers(one)), 1)

    @long_test
    def test_skins_that_make_no_fingers(self):
        one = ionskin.live.Skin(self.files()[0])
        for skins, pattern in (([], "0 fingers"), ([self.files()[0]] * 5, "5 fingers"), ([one, one], "stands twice")):
            with self.subTest(pattern), self.assertRaisesRegex(ValueError, pattern):
                ionskin.live.Fingers(skins)

    def test_cases_whose_charges_do_not_add_up_are_refused(self):
        fingers.require_additive([types.SimpleNamespace(case=pads(0, 1))] * 2)
        for edit, pattern in (('law = "fixed-charge"', "are no sums"), ("coefficient = 0.2", r"\[coupling\] differs")):
            words = pads(0, 1)
            key = edit.split()[0]
            changed = re.sub(f"(?m)^{key} = .*$", edit, words)
            self.assertNotEqual(changed, words)
            first = types.SimpleNamespace(case=changed)
            second = types.SimpleNamespace(case=changed if "law" in edit else words)
            with self.subTest(pattern), self.assertRaisesRegex(ValueError, pattern):
                fingers.require_additive([first, second])

    @long_test
    def test_they_tell_what_the_full_model_tells(self):
        """Stepped together along the motion of both. In full runs at any preset the charges of both pads differ by 1.4 % of the largest
        from the sum of those of each: pads that pull against each other stretch the skin between them."""
        case = self.write("both.toml", pads(0, 1))
        files = [self.folder / f"{number}.live" for number in (1, 2)]
        for number, file in enumerate(files, 1):
            self.run_program("live", case, *COARSE, "--slider", number, "--trajectories", "4", "--validation", "6", "-o", file, "--quiet")
        self.run_case(case, "-o", "full", *COARSE, *FAST)
        full = signals(self.folder / "full")
        times = numpy.arange(int(1e3 * full["time"][-1]) + 1) / 1e3
        of = {name: numpy.interp(times, full["time"], values) for name, values in full.items() if values.dtype.kind == "f"}
        fingers, ends = ionskin.live.Fingers(files), ("", "_2")
        told = fingers.run(times, numpy.stack([numpy.column_stack([of["slider_x" + end], of["slider_y" + end]]) for end in ends], axis=1),
                           heights=numpy.column_stack([of["slider_z" + end] for end in ends]))
        self.assertFalse(told.flags.any())
        for name, share in (("normal_force", 0.002), ("normal_force_2", 0.002), ("tangential_force_x", 0.01),
                            ("tangential_force_x_2", 0.01), ("charge_top", 0.02)):
            with self.subTest(name):
                error, largest = told[name] - of[name], numpy.abs(of[name]).max()
                self.assertLess(numpy.sqrt((error**2).mean()), share * largest)


if __name__ == "__main__":
    unittest.main()
