# SPDX-License-Identifier: Apache-2.0
"""A live skin as an FMU: what it holds, that it steps as `Skin.step` does to the last bit, and that it goes back."""

import ctypes
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
import zipfile

import fmu_importer
from fmu_importer import DISCARD, ERROR, OK, Fmu, Instance
from program import PROGRAM, ROOT, ProgramTest

sys.path.insert(0, str(PROGRAM.parent / "python"))
import ionskin.live  # noqa: E402

SMALL = ["--set", "numerics.mesh_refinement=0.5", "--set", "numerics.time_refinement=0.3", "--set", "motion.stroke=2 mm",
         "--set", "motion.slide=0.7 s", "--trajectories", "2", "--validation", "2"]
STEP = 1e-3


class FmuTest(ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.made = pathlib.Path(tempfile.mkdtemp(prefix="ionskin-fmu-"))
        cls.addClassCleanup(shutil.rmtree, cls.made)
        # A name and a folder that a URI must escape.
        cls.skin_file, cls.fmu_file = cls.made / "skin.live", cls.made / "a skin & 100 %.fmu"
        subprocess.run([PROGRAM, "live", ROOT / "cases" / "paper" / "taxels.toml", *SMALL, "-o", cls.skin_file, "--fmu",
                        cls.fmu_file, "--quiet"], check=True)
        cls.fmu = Fmu(cls.fmu_file, cls.made / "unpacked %41")

    def setUp(self):
        super().setUp()
        self.skin = ionskin.live.Skin(self.skin_file)

    def stroke(self, steps):
        """Inputs step by step: a touch that slides, presses harder, and changes its control."""
        for i in range(steps):
            yield {"x": 5e-3 + 1e-6 * i, "y": 1e-3, "height": -4e-7 - 1e-10 * i, "force": 20 + 0.01 * i,
                   "force_control": 100 <= i < 200}

    def expected(self, time, inputs):
        load = {"force": inputs["force"]} if inputs["force_control"] else {"height": inputs["height"]}
        return self.skin.step(time, (inputs["x"], inputs["y"]), **load)

    def test_holds_what_the_standard_asks_for(self):
        with zipfile.ZipFile(self.fmu_file) as archive:
            self.assertEqual(archive.namelist(), ["modelDescription.xml", "resources/skin.live",
                                                  "binaries/linux64/ionskin_live.so"])
        self.assertEqual(fmu_importer.mistakes(self.fmu.description), [])
        self.assertIn('modelName="a skin &amp; 100 %"', self.fmu.description)
        by_schema = fmu_importer.schema_mistakes(self.fmu.description_file)
        self.assertFalse(by_schema, by_schema)
        self.assertEqual((self.fmu.folder / "resources" / "skin.live").read_bytes(), self.skin_file.read_bytes())
        self.assertEqual([name for name, variable in self.fmu.variables.items()
                          if variable.get("causality") == "output"], ["flags", *self.skin.names])
        self.assertEqual(list(self.fmu.variables)[:6], ["x", "y", "height", "force", "friction", "force_control"])
        self.assertLessEqual({f"{signal}_{taxel}" for signal in ("charge_top", "current_top") for taxel in "abcd"},
                             set(self.fmu.variables))
        for name, unit in (("x", "m"), ("force", "N"), ("contact_area", "m2"), ("tangential_force_x", "N"), ("moment_y", "N.m"),
                           ("charge_top_b", "C"), ("current_top_b", "A"), ("stick_share", None), ("friction", None)):
            self.assertEqual(self.fmu.variables[name][0].get("unit"), unit, name)

    def test_rules_of_the_importer_find_mistakes(self):
        for right, wrong in (('fmiVersion="2.0"', 'fmiVersion="3.0"'), ('name="height"', 'name="force"'),
                             ('initial="calculated"', 'initial="exact"'), ('unit="C"', 'unit="coulomb"'),
                             ('<Unknown index="7"/>', ""), ("<Integer/>", "<Real/><Real/>"),
                             ('causality="input" variability="continuous"', 'causality="input" variability="fixed"')):
            self.assertIn(right, self.fmu.description)
            self.assertTrue(fmu_importer.mistakes(self.fmu.description.replace(right, wrong, 1)), wrong)

    def test_library_stands_alone(self):
        """It exports the standard's functions alone, needs the C library alone, and names no place of this machine."""
        listed = subprocess.run(["nm", "-D", "--defined-only", self.fmu.binary], capture_output=True, text=True, check=True)
        self.assertEqual({line.split()[2] for line in listed.stdout.splitlines()}, fmu_importer.FUNCTIONS)
        dynamic = subprocess.run(["readelf", "-d", self.fmu.binary], capture_output=True, text=True, check=True).stdout
        needed = {line.split("[")[1].rstrip("]") for line in dynamic.splitlines() if "NEEDED" in line}
        self.assertLessEqual(needed, {"libc.so.6", "libm.so.6", "ld-linux-x86-64.so.2"})
        self.assertNotIn("RUNPATH", dynamic)
        self.assertNotIn(str(ROOT).encode(), self.fmu.binary.read_bytes())
        self.assertEqual(self.fmu.library.fmi2GetVersion(), b"2.0")
        self.assertEqual(self.fmu.library.fmi2GetTypesPlatform(), b"default")

    def test_steps_as_the_skin_to_the_last_bit(self):
        instance = Instance(self.fmu)
        self.assertTrue(instance.handle, instance.logged)
        strokes = list(self.stroke(300))
        self.assertEqual(set(instance.begin(0.5, **strokes[0])), {OK})
        expected = self.expected(0.5, strokes[0])
        for i, inputs in enumerate(strokes[1:], 1):
            self.assertEqual(instance.get(self.skin.names), [expected[name] for name in expected], i)
            self.assertEqual(instance.flags(), expected.flags)
            instance.set(**inputs)
            point = 0.5 + STEP * (i - 1)
            self.assertEqual(instance.step(point, STEP), OK, instance.logged)
            expected = self.expected(point + STEP, inputs)
        self.assertGreater(expected["normal_force"], 0)
        self.assertEqual(instance.call("Terminate"), OK)
        self.assertEqual(instance.get(self.skin.names), [expected[name] for name in expected])
        # Once more, from the start.
        self.assertEqual(instance.call("Reset"), OK)
        self.assertEqual(set(instance.begin(0.5, **strokes[0])), {OK})
        self.skin.reset()
        expected = self.expected(0.5, strokes[0])
        self.assertEqual(instance.get(self.skin.names), [expected[name] for name in expected])
        instance.call("FreeInstance")

    def test_outputs_follow_inputs_in_the_initialization_mode(self):
        instance = Instance(self.fmu)
        instance.call("EnterInitializationMode")
        self.assertEqual(instance.get(["normal_force"]), [0])
        for height in (-8e-7, -4e-7):
            instance.set(height=height)
            self.skin.reset()
            inputs = dict(zip(("x", "y"), instance.get(["x", "y"])), height=height, force_control=False)
            self.assertEqual(instance.get(["normal_force"])[0], self.expected(0, inputs)["normal_force"])
        instance.call("FreeInstance")

    def run_from(self, instance, steps):
        rows = []
        for i, inputs in enumerate(self.stroke(steps)):
            if i >= 100:
                instance.set(**inputs)
                self.assertEqual(instance.step(STEP * (i - 1), STEP), OK, instance.logged)
                rows.append(instance.get(self.skin.names))
        return rows

    def test_goes_back_exactly(self):
        instance, other = Instance(self.fmu), Instance(self.fmu)
        for i, inputs in enumerate(self.stroke(100)):
            if i == 0:
                instance.begin(**inputs)
            else:
                instance.set(**inputs)
                instance.step(STEP * (i - 1), STEP)
        before = instance.get(self.skin.names)
        state = instance.state()
        content = instance.serialized(state)
        expected = self.run_from(instance, 250)
        self.assertEqual(instance.call("SetFMUstate", state), OK)
        self.assertEqual(instance.get(self.skin.names), before)
        self.assertEqual(self.run_from(instance, 250), expected)
        later = instance.serialized(instance.state(into=state))  # the memory is used again
        self.assertNotEqual(later, content)

        # In another instance, as in another process.
        copy = ctypes.c_void_p()
        self.assertEqual(other.call("DeSerializeFMUstate", content, ctypes.c_size_t(len(content)), ctypes.byref(copy)), OK)
        self.assertEqual(other.call("SetFMUstate", copy), OK)
        self.assertEqual(other.get(self.skin.names), before)
        self.assertEqual(self.run_from(other, 250), expected)
        for wrong in (content[:-1], b"x" + content[1:], b""):
            none = ctypes.c_void_p()
            self.assertEqual(other.call("DeSerializeFMUstate", wrong, ctypes.c_size_t(len(wrong)), ctypes.byref(none)),
                             ERROR)
            self.assertIsNone(none.value)
        for owner, kept in ((instance, state), (other, copy)):
            self.assertEqual(owner.call("FreeFMUstate", ctypes.byref(kept)), OK)
            self.assertIsNone(kept.value)
            owner.call("FreeInstance")

    def test_refuses_what_it_cannot_do(self):
        for arguments, part in ((dict(guid="{0}"), "GUID"), (dict(kind=0), "co-simulation"),
                                (dict(resources="file:///nowhere"), "/nowhere/skin.live")):
            refused = Instance(self.fmu, **arguments)
            self.assertFalse(refused.handle)
            self.assertIn(part, refused.logged[-1][2])
            self.assertEqual(refused.logged[-1][:2], (ERROR, "logStatusError"))
        instance = Instance(self.fmu)
        self.assertEqual(instance.step(0, STEP), ERROR)
        self.assertEqual(set(instance.begin(x=5e-3, height=-4e-7)), {OK})
        before = instance.get(self.skin.names)
        time = ctypes.c_double(-1)
        for value in (math.nan, math.inf):
            instance.set(x=value)
            self.assertEqual(instance.step(0, STEP), DISCARD)
            self.assertEqual(instance.call("GetRealStatus", fmu_importer.LAST_SUCCESSFUL_TIME, ctypes.byref(time)), OK)
            self.assertEqual(time.value, 0)
        self.assertEqual(instance.get(self.skin.names), before)
        instance.set(x=5e-3)
        for point, size in ((0, 0), (0, -STEP), (0, math.nan), (0.1, STEP), (math.nan, STEP)):
            self.assertEqual(instance.step(point, size), ERROR, (point, size))
        self.assertEqual(instance.step(0, STEP), OK)
        one = ctypes.c_size_t(1)
        for reference in (5, 6, 999, 2**32 - 1):
            self.assertEqual(instance.call("GetReal", (ctypes.c_uint * 1)(reference), one, (ctypes.c_double * 1)()), ERROR)
        for reference in (6, 7, 999):
            self.assertEqual(instance.call("SetReal", (ctypes.c_uint * 1)(reference), one, (ctypes.c_double * 1)()), ERROR)
        self.assertEqual(instance.call("GetDirectionalDerivative", None, one, None, one, None, None), ERROR)
        self.assertEqual(self.fmu.library.fmi2DoStep(None, ctypes.c_double(0), ctypes.c_double(1), 0), ERROR)
        instance.call("FreeInstance")

    def test_is_made_from_a_skin_that_is_there(self):
        """The unit is the same to the last byte, but for its name."""
        self.run_program("live", self.skin_file, "--fmu", self.fmu_file.name)
        self.assertEqual((self.folder / self.fmu_file.name).read_bytes(), self.fmu_file.read_bytes())
        for arguments, part in ((("--fmu", self.fmu_file.name), "--overwrite"), (("--fmu", "skin"), ".fmu"),
                                (("--fmu", "no/skin.fmu"), "no folder"), ((), "no file to write"),
                                (("-o", "other.live", "--fmu", "a.fmu"), "trained already"),
                                (("--set", "contact.friction=0.2", "--fmu", "a.fmu"), "trained already"),
                                (("--seed", "1", "--fmu", "a.fmu"), "trained already")):
            with self.subTest(part):
                self.assertIn(part, self.run_program("live", self.skin_file, *arguments, expect=2).stderr)
        self.assertFalse((self.folder / "a.fmu").exists())
        damaged = self.folder / "damaged.live"
        damaged.write_bytes(self.skin_file.read_bytes()[:-100])
        self.assertIn("damaged", self.run_program("live", damaged, "--fmu", "a.fmu", expect=2).stderr)
        self.assertIn("same file", self.run_program("live", ROOT / "cases" / "paper" / "coarse.toml", "-o", "b.fmu", "--fmu",
                                                    "./b.fmu", expect=2).stderr)


if __name__ == "__main__":
    unittest.main()
