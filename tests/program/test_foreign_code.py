# SPDX-License-Identifier: Apache-2.0
"""No file in the working folder and no variable of Python's decides what the program runs."""

import os
import unittest

from program import QUICK, SMALL, ProgramTest, summary

MODULES = ("tomllib", "json", "numpy", "sitecustomize", "usercustomize", "argparse", "h5py", "matplotlib")


class ForeignCode(ProgramTest):
    def setUp(self):
        super().setUp()
        self.run_case(QUICK, "-o", "one", *SMALL)
        self.run_case(QUICK, "-o", "two", *SMALL, "--set", "contact.friction=0.1")
        spoiler = f"open({str(self.folder / 'executed')!r}, 'a').write(__name__ + '\\n')\n"
        for module in MODULES:
            self.write(f"{module}.py", spoiler)
        (self.folder / "ionskin").mkdir()
        for name in ("__init__", "report", "isolated"):
            self.write(f"ionskin/{name}.py", spoiler)
        # A picture of this setting would start LaTeX.
        self.write("matplotlibrc", "text.usetex: True\n")
        self.spoil_environment(PYTHONPATH=self.folder, PYTHONSTARTUP=self.folder / "json.py", PYTHONUSERBASE=self.folder,
                               PYTHONHOME="", IONSKIN_PYTHON_PATH="")

    def spoil_environment(self, **variables):
        former = {name: os.environ.get(name) for name in variables}

        def restore():
            for name, value in former.items():
                os.environ.pop(name, None)
                if value is not None:
                    os.environ[name] = value
        self.addCleanup(restore)
        os.environ.update({name: str(value) for name, value in variables.items()})

    def test_every_verb_that_starts_python(self):
        self.run_program("report", "one", "--figure", "fig09_current")
        self.run_program("compare", "one", "two")
        self.run_program("doctor")
        self.run_program("impedance", QUICK, "--from", "1Hz", "--to", "10Hz", "-o", "spectrum")
        self.assertTrue((self.folder / "spectrum" / "figures" / "bode.png").exists())
        self.run_program("run", QUICK, "-o", "one", "--resume", *SMALL)
        self.assertTrue((self.folder / "one" / "report.html").exists())
        self.assertFalse((self.folder / "executed").exists())

    def test_package_elsewhere(self):
        """IONSKIN_PYTHON_PATH, which the user sets on purpose, replaces the package's place."""
        os.environ["IONSKIN_PYTHON_PATH"] = str(self.folder)
        self.run_program("compare", "one", "two")
        self.assertTrue((self.folder / "executed").exists())

    def test_report_that_cannot_be_made_is_a_failure_with_the_reason(self):
        (self.folder / "given" / "ionskin").mkdir(parents=True)
        self.write("given/ionskin/isolated.py", "import sys\nprint('Trace\\nerror: no such\\n  glyph', file=sys.stderr)\n"
                                                "sys.exit(2)\n")
        os.environ["IONSKIN_PYTHON_PATH"] = str(self.folder / "given")
        said = self.run_program("run", QUICK, "-o", "drawn", *SMALL, expect=4)
        self.assertIn("made: no such glyph.", " ".join((said.stderr + said.stdout).split()))
        self.assertNotIn("report: ", said.stdout)
        [warning] = [text for text in summary(self.folder / "drawn")["warnings"] if "No report was made" in text]
        self.assertIn("made: no such glyph.", warning)
        self.assertNotIn("python3-numpy", warning)
        said = self.run_program("report", "drawn", "--quiet", expect=2)
        self.assertEqual((said.stdout, said.stderr), ("", "error: no such glyph\n"))


if __name__ == "__main__":
    unittest.main()
