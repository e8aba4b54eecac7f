# SPDX-License-Identifier: Apache-2.0
"""docs/laws.md, carried out step by step on a copy of the sources and of the build."""

import os
import pathlib
import re
import shutil
import subprocess
import unittest

from documented import console_blocks, first_difference
from moved_build import move_build
from program import PROGRAM, ROOT, ProgramTest, metric, signals

PAGE = ROOT / "docs" / "laws.md"
COPIED = ("apps", "benchmarks", "cases", "cmake", "docs", "examples", "fuzz", "materials", "packaging", "python", "src",
          "studio", "tests", "verification", "CHANGELOG.md", "CITATION.cff", "CMakeLists.txt", "CMakePresets.json",
          "LICENSE", "Makefile", "README.md")
NEW = re.compile(r"New file `([^`]+)`:\n\n```cpp\n(.*?)^```", re.DOTALL | re.MULTILINE)
FILE = re.compile(r"\b[Ii]n `([^`]+)`")
EDIT = re.compile(r"in\s+place\s+of\n\n```\w+\n(.*?)\n```\n\nwrite\n\n```\w+\n(.*?)\n```", re.DOTALL)


def steps(text):
    """The page's steps in order: ("new", file, content) and ("edit", file, old, new)."""
    found = [(match.start(), ("new", *match.groups())) for match in NEW.finditer(text)]
    for match in EDIT.finditer(text):
        file = FILE.findall(text[:match.start()])[-1]
        found.append((match.start(), ("edit", file, *match.groups())))
    return [step for _, step in sorted(found)]


class LawsPage(ProgramTest):
    def copy_tree(self):
        """Sources with their times and the build folder, so that only what the steps touch is built again."""
        tree = self.folder / "tree"
        tree.mkdir()
        for name in COPIED:
            (shutil.copytree if (ROOT / name).is_dir() else shutil.copy2)(ROOT / name, tree / name)
        shutil.copytree(PROGRAM.parent, tree / "build", symlinks=True,
                        ignore=shutil.ignore_patterns("unit_*", "docs", "benchmarks", "Testing"))
        return tree

    def carry_out(self, tree):
        """All steps of the page."""
        for kind, name, *texts in steps(PAGE.read_text()):
            file = tree / name
            if kind == "new":
                self.assertFalse(file.exists(), name)
                file.write_text(texts[0])
                continue
            before = file.read_text()
            self.assertEqual(before.count(texts[0]), 1, f"{name}: {texts[0]}")
            file.write_text(before.replace(texts[0], texts[1]))

    def shell(self, tree, command):
        environment = {**os.environ, "IONSKIN_DATA": str(tree)}
        process = subprocess.run(["bash", "-c", command], cwd=tree, capture_output=True, text=True, check=False,
                                 env=environment)
        self.assertEqual(process.returncode, 0, f"{command}\n{process.stdout[-3000:]}\n{process.stderr[-2000:]}")
        return process.stdout.splitlines()

    def test_page(self):
        tree = self.copy_tree()
        move_build(tree / "build", ROOT, tree)
        self.carry_out(tree)
        for command, expected in console_blocks(PAGE.read_text()):
            self.assertIsNone(first_difference(expected, self.shell(tree, command)), command)
        self.assertIn('law = "softening"', (tree / "out" / "case.toml").read_text())
        self.assertIn('law = "yielding-charge"', (tree / "out" / "case.toml").read_text())
        self.laws_act(tree)
        self.parameters_belong_to_their_law(tree)

    def parameters_belong_to_their_law(self, tree):
        """A parameter of another law is refused, a missing one asked for, the stored case says both laws' own."""
        stored = (tree / "out" / "case.toml").read_text()
        self.assertRegex(stored, r'pressure_scale = "10 MPa"')
        self.assertRegex(stored, r"saturation = 0.01")
        for edits, expected in ((["contact.pressure_scale='\"4 MPa\"'"], "has no such parameter"),
                                (["contact.law=softening"], "missing key contact.pressure_scale"),
                                (["contact.law=softening", "contact.pressure_scale='\"4 MPa\"'",
                                  "contact.high_pressure_friction=3"], "must be")):
            command = " ".join(["build/ionskin check cases/quick.toml", *(f"--set {edit}" for edit in edits)])
            process = subprocess.run(["bash", "-c", command], cwd=tree, capture_output=True, text=True, check=False,
                                     env={**os.environ, "IONSKIN_DATA": str(tree)})
            self.assertEqual(process.returncode, 2, command)
            self.assertIn(expected, process.stderr)

    def laws_act(self, tree):
        """Friction falls with pressure; the coupling makes the charge of its formula."""
        coulomb, softening = (metric(tree / name, "tangential_force_slide") for name in ("coulomb", "out"))
        self.assertLess(softening, 0.8 * coulomb)
        self.assertGreater(softening, 0.33 * coulomb)
        current = signals(tree / "out")["current_top"]
        self.assertGreater(abs(current).max(), 0)


if __name__ == "__main__":
    unittest.main()
