# SPDX-License-Identifier: Apache-2.0
"""Runs the built program in a scratch folder; shared by the program tests."""

import contextlib
import json
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import tempfile
import unittest

import h5py
import numpy

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PROGRAM = pathlib.Path(os.environ.get("IONSKIN_PROGRAM", ROOT / "build" / "ionskin"))
QUICK = ROOT / "cases" / "paper" / "coarse.toml"
FAULTS = PROGRAM.parent / "tests" / "fault_injection" / "libionskin_fault_injection.so"
PAPER = ROOT / "cases" / "paper.toml"
# Mesh and time steps that serve to test the bookkeeping, not the physics, at a tenth of the work of cases/paper/coarse.toml;
# to free the sides of the skin costs as much as all the rest.
# Coarser solutions, which state the errors, double it: test_stated_errors.py, test_interrupt.py and test_sweep.py have them.
ROLLERS = ("--set", "skin.sides=symmetry")
SMALL = ROLLERS + tuple(word for edit in ("mesh_refinement=0.3", "time_refinement=0.3", "error_estimate=off")
                        for word in ("--set", f"numerics.{edit}"))


class ProgramTest(unittest.TestCase):
    """A test with a scratch folder of its own in `self.folder`."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="ionskin-test-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def run_program(self, *arguments, expect=0, processor_seconds=None, **settings):
        """Runs `ionskin ARGUMENTS`; asserts the exit code; returns the finished process. One that works longer than so many
        seconds of a processor is ended, however busy the machine is."""
        def limit():
            resource.setrlimit(resource.RLIMIT_CPU, (processor_seconds, processor_seconds))

        process = subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, check=False, **{
            "capture_output": True, "text": True, "preexec_fn": limit if processor_seconds else None, **settings})
        self.assertEqual(process.returncode, expect, f"{arguments}\n{process.stdout}\n{process.stderr}")
        return process

    def run_case(self, *arguments, expect=0):
        """`ionskin run` without the report, whose drawing takes longer than a quick case."""
        return self.run_program("run", *arguments, "--no-report", expect=expect)

    def observed(self, **point):
        """An environment in which tests/fault_injection/fault_injection.c sends the program a signal at a named point."""
        self.assertTrue(FAULTS.exists(), "cmake --build build --target unit_tests builds it")
        return {**os.environ, "LD_PRELOAD": str(FAULTS),
                **{f"IONSKIN_FAULT_{name.upper()}": str(value) for name, value in point.items()}}

    def end_at_file(self, number, *arguments, below, how=signal.SIGKILL, expect=-signal.SIGKILL):
        """Sends the program a signal before the file of this number below a folder gets its name; returns what it said."""
        point = self.observed(call="rename", folder=self.folder / below, number=number, signal=int(how))
        return self.run_program(*arguments, expect=expect, env=point).stderr

    @contextlib.contextmanager
    def stopped_at_file(self, number, *arguments, below):
        """A context in which the program stands before the file of this number below a folder gets its name; then kills it."""
        point = self.observed(call="rename", folder=self.folder / below, number=number, signal=int(signal.SIGSTOP))
        with subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=self.folder, env=point) as process:
            try:
                ended = os.waitid(os.P_PID, process.pid, os.WSTOPPED | os.WEXITED | os.WNOWAIT)
                self.assertEqual(ended.si_code, os.CLD_STOPPED)
                yield
            finally:
                process.kill()

    def end_at_progress(self, activity, *arguments, how=signal.SIGINT, expect=130):
        """Sends the program a signal before it first tells of an activity; returns what it said."""
        point = self.observed(text=f'"activity":"{activity}"', signal=int(how))
        return self.run_program(*arguments, "--progress", "json", expect=expect, env=point).stderr

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
