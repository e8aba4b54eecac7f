# SPDX-License-Identifier: Apache-2.0
"""Runs of cases/evidence for the page "Model against measurement", each variant once."""

import csv
import json
import subprocess

import numpy

from pathlib import Path

CASES = Path(__file__).resolve().parent.parent / "cases" / "evidence"


class Run:
    """One finished run: columns of its tables by their names, figures of its summary with their stated errors."""

    def __init__(self, folder):
        self.folder = folder
        summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
        self.values = {name: metric["value"] for name, metric in summary["metrics"].items()}
        self.errors = summary["error_estimate"]  # relative

    def table(self, name):
        """Columns of NAME.csv as arrays, without their units."""
        with open(self.folder / f"{name}.csv", newline="", encoding="utf-8") as file:
            titles, *rows = csv.reader(file)
        columns = numpy.array([[float(cell or "nan") for cell in row] for row in rows]).T
        return {title.split(" [")[0]: column for title, column in zip(titles, columns)}

    def voltage(self):
        """Voltage of the open terminals over time, [s] and [V]."""
        table = self.table("circuit")
        return table["time"], table["voltage"]


class Runs:
    """Runs cases with edits, and keeps what it has run."""

    def __init__(self, program, work):
        self.program, self.work, self.known = program, work, {}
        self.largest_error = 0.0  # that a run states of a peak used here, relative

    def __call__(self, case, **edits):
        """The run of cases/evidence/CASE.toml with `section__key="value"` set."""
        words = tuple(f"{name.replace('__', '.')}={value}" for name, value in edits.items())
        if (case, words) not in self.known:
            folder = self.work / f"run{len(self.known):03}"
            options = [option for word in words for option in ("--set", word)]
            subprocess.run([self.program, "run", CASES / f"{case}.toml", "-o", folder, "--no-report", "--quiet", *options],
                           check=True)
            run = self.known[case, words] = Run(folder)
            errors = [run.errors[name] for name in ("peak_voltage", "peak_streaming_voltage", "peak_sampled_current_difference")
                      if name in run.errors and abs(run.values[name]) > 0]
            self.largest_error = max(self.largest_error, *errors, 0.0)
        return self.known[case, words]


def amplitude(time, values, frequency):
    """Amplitude of the part at a frequency over the last whole periods of the second half."""
    periods = max(1, int((time[-1] - time[0]) * frequency / 2))
    begin = time[-1] - periods / frequency
    instants = numpy.linspace(begin, time[-1], 64 * periods, endpoint=False)
    wave = numpy.exp(-2j * numpy.pi * frequency * instants)
    return 2 * abs(numpy.mean(numpy.interp(instants, time, values) * wave))
