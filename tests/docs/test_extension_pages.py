# SPDX-License-Identifier: Apache-2.0
"""docs/laws.md, docs/circuits.md, docs/shapes.md and docs/small-additions.md, carried out step by step on a copy of the sources
and of the build."""

import filecmp
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

from documented import console_blocks, first_difference
from moved_build import move_build
from program import PROGRAM, ROOT, metric, signals, summary
from tiers import long_test

LAWS, CIRCUITS, SHAPES, SMALL = (ROOT / "docs" / f"{name}.md" for name in ("laws", "circuits", "shapes", "small-additions"))
COPIED = ("apps", "benchmarks", "cases", "cmake", "docs", "examples", "fuzz", "materials", "packaging", "python", "src",
          "studio", "tests", "verification", "CHANGELOG.md", "CITATION.cff", "CMakeLists.txt", "CMakePresets.json",
          "LICENSE", "Makefile", "README.md")
NEW = re.compile(r"New file `([^`]+)`:\n\n```\w+\n(.*?)^```", re.DOTALL | re.MULTILINE)
FILE = re.compile(r"\b[Ii]n `([^`]+)`")
EDIT = re.compile(r"in\s+place\s+of\n\n```\w+\n(.*?)\n```\n\nwrite\n\n```\w+\n(.*?)\n```", re.DOTALL)


def steps(text):
    """The page's steps in order: ("new", file, content) and ("edit", file, old, new)."""
    found = [(match.start(), ("new", *match.groups())) for match in NEW.finditer(text)]
    for match in EDIT.finditer(text):
        file = FILE.findall(text[:match.start()])[-1]
        found.append((match.start(), ("edit", file, *match.groups())))
    return [step for _, step in sorted(found)]


def copy_sources(tree):
    """With their times, so that only what the steps touch is built again."""
    tree.mkdir()
    for name in COPIED:
        (shutil.copytree if (ROOT / name).is_dir() else shutil.copy2)(ROOT / name, tree / name)


def carry_out(page, tree):
    """Takes all steps of a page; returns the files that it names."""
    named = set()
    for kind, name, *texts in steps(page.read_text()):
        file = tree / name
        named.add(name)
        if kind == "new":
            assert not file.exists(), name
            file.write_text(texts[0])
            continue
        before = file.read_text()
        assert before.count(texts[0]) == 1, f"{page}, {name}: {texts[0]}"
        file.write_text(before.replace(texts[0], texts[1]))
    return named


class Steps(unittest.TestCase):
    """All pages carried out on one copy of the sources."""

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="ionskin-test-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        cls.tree = cls.folder / "tree"
        copy_sources(cls.tree)
        cls.named = {page: carry_out(page, cls.tree) for page in (LAWS, CIRCUITS, SHAPES, SMALL)}

    def test_the_files_that_the_pages_name_are_all_that_differ(self):
        touched = set()
        for name in COPIED:
            files = [self.tree / name] if (self.tree / name).is_file() else (self.tree / name).rglob("*")
            for file in files:
                own = file.relative_to(self.tree)
                if file.is_file() and "__pycache__" not in own.parts and not (
                        (ROOT / own).is_file() and filecmp.cmp(file, ROOT / own, shallow=False)):
                    touched.add(str(own))
        self.assertEqual(touched, set.union(*self.named.values()))

    def test_a_circuit_and_a_shape_touch_their_own_folders_and_the_words_of_a_figure(self):
        self.assertEqual(self.named[CIRCUITS], {
            "src/ionskin/circuits/voltmeter.hpp", "src/ionskin/circuits/voltmeter.cpp", "src/ionskin/circuits/circuit.cpp",
            "src/ionskin/circuits/charge_amplifier.hpp", "src/ionskin/circuits/charge_amplifier.cpp",
            "src/ionskin/circuits/CMakeLists.txt", "tests/unit/circuits/voltmeter_test.cpp",
            "tests/unit/circuits/charge_amplifier_test.cpp", "tests/unit/circuits/CMakeLists.txt",
            "python/ionskin/page/quantities.py"})
        self.assertEqual(self.named[SHAPES], {
            "src/ionskin/shapes/paraboloid.hpp", "src/ionskin/shapes/paraboloid.cpp", "src/ionskin/shapes/shape.cpp",
            "src/ionskin/shapes/CMakeLists.txt", "tests/unit/shapes/paraboloid_test.cpp",
            "tests/unit/shapes/CMakeLists.txt"})
        self.assertEqual(self.named[SMALL], {
            "src/ionskin/circuits/instruments.cpp", "materials/example_gel.toml", "python/ionskin/figures.py",
            "tests/unit/results/report_test.py"})


@long_test
class Built(Steps):
    """The copy is built, and does what the pages say. One build serves them."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        shutil.copytree(PROGRAM.parent, cls.tree / "build", symlinks=True,
                        ignore=shutil.ignore_patterns("unit_*", "docs", "benchmarks", "Testing"))
        move_build(cls.tree / "build", ROOT, cls.tree)

    def shell(self, command, expect=0):
        """Runs a line of a page in the copy; returns the finished process."""
        process = subprocess.run(["bash", "-c", command], cwd=self.tree, capture_output=True, text=True, check=False,
                                 env={**os.environ, "IONSKIN_DATA": str(self.tree), "PATH": f"/usr/bin:{os.environ['PATH']}"})
        self.assertEqual(process.returncode, expect, f"{command}\n{process.stdout[-3000:]}\n{process.stderr[-2000:]}")
        return process

    def run_commands(self, page):
        for command, expected in console_blocks(page.read_text()):
            self.assertIsNone(first_difference(expected, self.shell(command).stdout.splitlines()), command)

    def test_laws(self):
        self.run_commands(LAWS)
        stored = (self.tree / "out" / "case.toml").read_text()
        self.assertIn('law = "softening"', stored)
        self.assertIn('law = "yielding-charge"', stored)
        self.laws_act()
        self.parameters_belong_to_their_law()

    def test_circuits(self):
        self.run_commands(CIRCUITS)
        told = summary(self.tree / "voltmeter")
        self.assertEqual(told["circuit"]["words"], "voltmeter of 1000 ohm behind 2e-10 F of cable")
        self.assertEqual(told["circuit"]["top_potential"], "φ = U, I = U/R + C dU/dt")
        open_voltage, voltage = (metric(self.tree / name, "peak_voltage") for name in ("open", "voltmeter"))
        self.assertLess(voltage, open_voltage)
        self.assertGreater(voltage, 0.9 * open_voltage)
        reading = signals(self.tree / "charge", "circuit")
        self.assertGreater(abs(reading["charge"]).max(), 0)
        self.assertAlmostEqual(metric(self.tree / "charge", "peak_amplifier_voltage") * 1e-5 / abs(reading["charge"]).max(), 1, delta=1e-6)
        self.assertIn("missing key readout.cable_length",
                      self.shell("build/ionskin check cases/paper/coarse.toml --set readout.circuit=voltmeter", expect=2).stderr)
        refused = self.shell("build/ionskin check cases/paper/coarse.toml --set readout.cable_length='\"2 m\"'", expect=2).stderr
        self.assertIn("readout.cable_length is given, but the circuit has none", refused)
        self.assertIn('set readout.circuit = "voltmeter"', refused)

    def test_shapes(self):
        self.run_commands(SHAPES)
        sphere, paraboloid = (metric(self.tree / name, "normal_force_slide") for name in ("sphere", "paraboloid"))
        self.assertGreater(sphere, 0)
        self.assertAlmostEqual(paraboloid / sphere, 1, delta=1e-3)
        self.assertIn("missing key slider.radius_x",
                      self.shell("build/ionskin check cases/paper/coarse.toml --set slider.shape=paraboloid", expect=2).stderr)
        refused = self.shell("build/ionskin check cases/paper/coarse.toml --set slider.radius_x='\"8 mm\"'", expect=2).stderr
        self.assertIn("slider.radius_x does not belong to this shape of slider", refused)
        self.assertIn('choose slider.shape = "paraboloid"', refused)

    def test_an_instrument_a_material_and_a_figure(self):
        self.run_commands(SMALL)
        self.assertIn("a bench amplifier and a 12-bit converter", self.shell("build/ionskin keys readout.instrument").stdout)
        explained = self.shell("build/ionskin check cases/paper/coarse.toml --explain --set skin.layers[1].material=example_gel").stdout
        self.assertRegex(explained, r"materials.example_gel.youngs_modulus\s+1000000 Pa")

    def parameters_belong_to_their_law(self):
        """A parameter of another law is refused, a missing one asked for, the stored case says both laws' own."""
        stored = (self.tree / "out" / "case.toml").read_text()
        self.assertRegex(stored, r'pressure_scale = "10 MPa"')
        self.assertRegex(stored, r"saturation = 0.01")
        for edits, expected in ((["contact.pressure_scale='\"4 MPa\"'"], "has no such parameter"),
                                (["contact.law=softening"], "missing key contact.pressure_scale"),
                                (["contact.law=softening", "contact.pressure_scale='\"4 MPa\"'",
                                  "contact.high_pressure_friction=3"], "must be")):
            command = " ".join(["build/ionskin check cases/paper/coarse.toml", *(f"--set {edit}" for edit in edits)])
            self.assertIn(expected, self.shell(command, expect=2).stderr)

    def laws_act(self):
        """Friction falls with pressure; the coupling makes the charge of its formula."""
        coulomb, softening = (metric(self.tree / name, "tangential_force_slide") for name in ("coulomb", "out"))
        self.assertLess(softening, 0.8 * coulomb)
        self.assertGreater(softening, 0.33 * coulomb)
        current = signals(self.tree / "out")["current_top"]
        self.assertGreater(abs(current).max(), 0)


if __name__ == "__main__":
    unittest.main()
