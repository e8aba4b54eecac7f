# SPDX-License-Identifier: Apache-2.0
"""Every mistake of a user ends with exit code 2 before any work, and with a message that helps."""

import ctypes
import os
import unittest

import numpy

from program import PAPER, QUICK, ProgramTest, write_strain_file


def replaced(text, old, new):
    """The case text with one passage replaced; the passage must be there."""
    assert text.count(old) >= 1, f"'{old}' is not in the case"
    return text.replace(old, new, 1)


def without_privileges():
    """Modes of files bind root as anybody else in the program that this process becomes."""
    if os.geteuid() == 0:
        for capability in (1, 2):  # CAP_DAC_OVERRIDE, CAP_DAC_READ_SEARCH
            ctypes.CDLL(None).prctl(24, capability, 0, 0, 0)  # PR_CAPBSET_DROP


# name, --set edits, words that the message must hold (what, value, remedy)
EDITS = [
    ("unknown key", ["slider.colour=3"], ["slider.colour", "unknown"]),
    ("misspelt key", ["contact.fricton=0.3"], ["contact.fricton", "friction"]),
    ("missing unit", ["motion.stroke=6"], ["motion.stroke", "unit", "mm"]),
    ("wrong dimension", ["motion.stroke=6 s"], ["motion.stroke", "length"]),
    ("unknown unit", ["motion.stroke=6 furlongz"], ["motion.stroke", "furlongz"]),
    ("negative thickness", ["skin.layers[1].thickness=-1 um"], ["thickness", "-1"]),
    ("incompressible", ["materials.nafion.poissons_ratio=0.5"], ["poissons_ratio", "0.5"]),
    ("slider off the skin", ["motion.stroke=20 mm"], ["stroke", "skin"]),
    ("zero duration", ["motion.slide=0 s"], ["motion.slide", "0"]),
    ("unknown material", ["skin.layers[1].material=nafoin"], ["nafoin", "nafion"]),
    ("unknown law", ["coupling.law=column-neutrall"], ["column-neutral"]),
    ("unknown ion model", ["electrochemistry.ion_model=sterik"], ["ion_model", "sterik", "steric"]),
    ("steric ions of no size", ["electrochemistry.ion_model=steric"],
     ["missing key electrochemistry.largest_concentration", "mol/m3"]),
    ("size of dilute ions", ["electrochemistry.largest_concentration=5000 mol/m3"],
     ["largest_concentration", "dilute", 'ion_model = "steric"']),
    ("ions that do not fit", ["electrochemistry.ion_model=steric", "electrochemistry.largest_concentration=900 mol/m3"],
     ["do not fit", "900 mol/m3", "must exceed 1200 mol/m3"]),
    ("negative friction", ["contact.friction=-0.1"], ["contact.friction", "-0.1"]),
    ("no strain file", ["strain.source=file"], ["strain.file"]),
    ("missing strain file", ["strain.source=file", "strain.file=nothing.h5"], ["nothing.h5"]),
]


class BadInput(ProgramTest):
    def assert_refused(self, words, *arguments):
        """The program exits with 2 at once, says the words and leaves no results."""
        process = self.run_program("run", *arguments, expect=2, processor_seconds=5)  # the work takes more than ten
        for word in words:
            self.assertIn(word, process.stderr)
        self.assertFalse((self.folder / "out" / "signals.csv").exists())
        return process.stderr

    def test_edits(self):
        for name, edits, words in EDITS:
            with self.subTest(name):
                options = [option for edit in edits for option in ("--set", edit)]
                self.assert_refused(words, PAPER, "-o", "out", *options)

    def test_line_and_caret(self):
        text = replaced(PAPER.read_text(), "stroke", "strok")
        path = self.write("case.toml", text)
        message = self.assert_refused(["strok", "stroke", "^"], path, "-o", "out")
        line = next(i for i, line in enumerate(text.splitlines(), 1) if line.strip().startswith("strok "))
        self.assertIn(str(line), message)

    def test_broken_toml(self):
        path = self.write("case.toml", PAPER.read_text() + "\n[broken\n")
        self.assert_refused(["case.toml"], path, "-o", "out")

    def test_no_layers_and_two_cores(self):
        text = PAPER.read_text()
        begin = text.index("[[skin.layers]]")
        end = text.index("\n[", text.rindex("[[skin.layers]]") + 1)
        self.assert_refused(["layers"], self.write("none.toml", text[:begin] + text[end:]), "-o", "out")
        two = replaced(text, 'role = "electrode"', 'role = "core"')
        self.assert_refused(["core"], self.write("two.toml", two), "-o", "out")

    def test_unreadable_case(self):
        self.assert_refused(["nowhere.toml"], "nowhere.toml", "-o", "out")

    def test_unwritable_folder(self):
        self.write("file", "")
        self.assert_refused(["file"], QUICK, "-o", "file/out")
        self.assertNotIn("free below", self.assert_refused(["/proc/ionskin"], QUICK, "-o", "/proc/ionskin"))

    def test_existing_folder(self):
        (self.folder / "out").mkdir()
        (self.folder / "out" / "summary.json").write_text("{}")
        message = self.assert_refused(["out", "--overwrite"], QUICK, "-o", "out")
        self.assertNotIn("internal", message)
        self.assertEqual((self.folder / "out" / "summary.json").read_text(), "{}")


class BadStrainFile(ProgramTest):
    def assert_refused(self, words, **file):
        """A run on a strain file with this content is refused."""
        write_strain_file(self.folder / "strain.h5", **file)
        self.refuse(words)

    def refuse(self, words, *edits, **settings):
        strain = self.folder / "strain.h5"
        options = [option for edit in edits for option in ("--set", edit)]
        process = self.run_program("run", PAPER, "-o", "out", "--set", "strain.source=file", "--set",
                                   f'strain.file="{strain}"', *options, expect=2, **settings)
        for word in words:
            self.assertIn(word, process.stderr)
        self.assertFalse((self.folder / "out" / "signals.csv").exists())

    def test_not_a_number(self):
        gamma = numpy.zeros((3, 2, 1, 1))
        gamma[1, 0, 0, 0] = numpy.nan
        self.assert_refused(["gamma", "NaN"], gamma=gamma, time=[0, 1, 2])

    def test_does_not_cover_the_core(self):
        self.assert_refused(["cover"], gamma=numpy.zeros((2, 2, 1, 1)), time=[0, 1], x=(0, 14e-3))

    def test_negative_fixed_charge(self):
        self.assert_refused(["fixed charge", "-1"], gamma=numpy.full((2, 2, 1, 1), -20.0), time=[0, 1])

    def test_released_ions_without_room(self):
        write_strain_file(self.folder / "strain.h5", gamma=numpy.full((2, 2, 1, 1), 5.0), time=[0, 1])
        self.refuse(["pair-generation", "room", "largest_concentration"], "coupling.law=pair-generation",
                    "electrochemistry.ion_model=steric", "electrochemistry.largest_concentration=1500 mol/m3")

    def test_only_mechanics_of_a_strain_file(self):
        write_strain_file(self.folder / "strain.h5", gamma=numpy.zeros((2, 2, 1, 1)), time=[0, 1])
        strain = self.folder / "strain.h5"
        process = self.run_program("run", PAPER, "-o", "out", "--only", "mechanics", "--set",
                                   "strain.source=file", "--set", f'strain.file="{strain}"', expect=2)
        self.assertIn("--only mechanics", process.stderr)

    def test_wrong_shape(self):
        self.assert_refused(["gamma"], gamma=numpy.zeros((2, 3, 1, 1)), time=[0, 1])

    def test_time_not_ascending(self):
        self.assert_refused(["time"], gamma=numpy.zeros((3, 2, 1, 1)), time=[0, 2, 1])

    def test_wrong_format(self):
        self.assert_refused(["format"], gamma=numpy.zeros((2, 2, 1, 1)), time=[0, 1], format="other")

    def test_not_hdf5(self):
        (self.folder / "strain.h5").write_text("no data")
        self.refuse(["strain.h5", "HDF5"])

    def test_unreadable(self):
        write_strain_file(self.folder / "strain.h5", gamma=numpy.zeros((2, 2, 1, 1)), time=[0, 1])
        (self.folder / "strain.h5").chmod(0)
        self.refuse(["strain.h5", "cannot be read", "permissions"], preexec_fn=without_privileges)


if __name__ == "__main__":
    unittest.main()
