# SPDX-License-Identifier: Apache-2.0
"""Runs the built program in a scratch folder; shared by the program tests."""

import json
import os
import pathlib
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

import h5py
import numpy

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PROGRAM = pathlib.Path(os.environ.get("IONSKIN_PROGRAM", ROOT / "build" / "ionskin"))
QUICK = ROOT / "cases" / "quick.toml"
PAPER = ROOT / "cases" / "paper.toml"


class ProgramTest(unittest.TestCase):
    """A test with a scratch folder of its own in `self.folder`."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="ionskin-test-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        # Tests compare runs digit by digit: no cache but in its own tests, and there one of their own.
        os.environ["IONSKIN_CACHE"] = str(self.folder / "cache")
        os.environ["IONSKIN_CACHE_LIMIT"] = "0 GB"

    def run_program(self, *arguments, expect=0):
        """Runs `ionskin ARGUMENTS`; asserts the exit code; returns the finished process."""
        process = subprocess.run(
            [PROGRAM, *map(str, arguments)], capture_output=True, text=True, cwd=self.folder, check=False
        )
        self.assertEqual(process.returncode, expect, f"{arguments}\n{process.stdout}\n{process.stderr}")
        return process

    def run_case(self, *arguments, expect=0):
        """`ionskin run` without the report, whose drawing takes longer than a quick case."""
        return self.run_program("run", *arguments, "--no-report", expect=expect)

    def interrupt_program(self, *arguments, when, how=signal.SIGINT, expect=130):
        """Starts the program, sends a signal once `when()` holds, and asserts the exit code."""
        with subprocess.Popen(
            [PROGRAM, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
            cwd=self.folder,
        ) as process:
            deadline = time.monotonic() + 300
            while not when() and process.poll() is None and time.monotonic() < deadline:
                time.sleep(0.01)
            self.assertIsNone(process.poll(), "the run ended before it could be interrupted")
            process.send_signal(how)
            _, errors = process.communicate(timeout=300)
        self.assertEqual(process.returncode, expect, errors)
        return errors

    def write(self, name, text):
        """Writes a text file into the scratch folder and returns its path."""
        path = self.folder / name
        path.write_text(text)
        return path


def signals(folder, table="signals"):
    """The columns of signals.csv or sampled.csv by name without unit; text columns stay text."""
    lines = (pathlib.Path(folder) / f"{table}.csv").read_text().splitlines()
    names = [name.split(" [")[0] for name in lines[0].split(",")]
    rows = [line.split(",") for line in lines[1:]]
    columns = {}
    for index, name in enumerate(names):
        cells = [row[index] for row in rows]
        if name == "phase":
            columns[name] = numpy.array(cells)
        else:
            columns[name] = numpy.array([float(cell) if cell else numpy.nan for cell in cells])
    return columns


def summary(folder):
    """summary.json of a run."""
    return json.loads((pathlib.Path(folder) / "summary.json").read_text())


def metric(folder, name):
    """The value of one metric of summary.json."""
    return summary(folder)["metrics"][name]["value"]


def write_strain_file(path, gamma, time, x=(0, 15e-3), y=(0, 2e-3), z=(0, 180e-6), **attributes):
    """Writes a strain file in the documented layout. gamma: [time, z, y, x]."""
    with h5py.File(path, "w") as file:
        for name, values in (("x", x), ("y", y), ("z", z)):
            file[f"grid/{name}"] = numpy.asarray(values, dtype=float)
        file["time"] = numpy.asarray(time, dtype=float)
        file["gamma"] = numpy.asarray(gamma, dtype=float)
        file["gamma"].attrs["unit"] = "1"
        file.attrs.update({"format": "ionskin-strain", "version": 1, "measure": "off-diagonal",
                           "frame": "skin", **attributes})
