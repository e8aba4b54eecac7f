#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Solve one small sweep in every way that must not matter; print whether the results are the same bits.

    verification/same_bits.py build/ionskin [--case cases/paper/coarse.toml] [--set KEY=VALUE ...] [--seed N]

The reference is a sweep on one thread. Against it: more threads, kills at random instants, a lost
point, other points beside a point, and each point as a run by itself. Compared are all
datasets of results.h5, the two tables, and the figures and errors of summary.json. Exits 0 only if all are the same.
"""

import argparse
import csv
import json
import random
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import h5py

ROOT = Path(__file__).resolve().parent.parent
FRICTIONS = ("0.1", "0.3", "0.6")
SHAPES = {
    "flat": (),
    "sphere": ("--set", 'slider.shape="sphere"', "--set", "slider.radius=8 mm", "--set", "motion.preload=0.5 N"),
}


def results(folder):
    """All numbers of a run's folder as bytes, by name."""
    found = {}
    with h5py.File(folder / "results.h5") as file:
        def keep(name, item):
            if isinstance(item, h5py.Dataset) and name != "manifest":  # which holds times
                found[f"results.h5/{name}"] = str(item[()].tolist()) if item.dtype.hasobject else item[()].tobytes()
        file.visititems(keep)
    for table in ("signals.csv", "sampled.csv"):
        with open(folder / table, newline="", encoding="utf-8") as file:
            for column in zip(*csv.reader(file)):
                found[f"{table}/{column[0]}"] = column
    summary = json.loads((folder / "summary.json").read_text())
    for part in ("metrics", "error_estimate"):
        found.update({f"summary.json/{part}/{name}": str(value) for name, value in summary[part].items()})
    return found


def difference(folder, reference):
    """The name of the first result that differs, or an empty text."""
    one, other = results(folder), results(reference)
    return next((name for name in {**one, **other} if one.get(name) != other.get(name)), "")


class Ways:
    """Solves one sweep in several ways, each in a folder of its own."""

    def __init__(self, program, case, settings, folder, seed):
        self.program, self.case, self.folder = str(Path(program).resolve()), case, folder
        self.settings, self.random = settings, random.Random(seed)
        self.reference = self.sweep("reference", "--threads", "1")

    def command(self, name, *arguments, frictions=FRICTIONS):
        return [self.program, "sweep", str(self.case), "-o", str(self.folder / name), "--no-report", "--quiet",
                *self.settings, "--over", "contact.friction=" + ",".join(frictions), *arguments]

    def sweep(self, name, *arguments, frictions=FRICTIONS):
        self.call(self.command(name, *arguments, frictions=frictions))
        return self.folder / name / "points"

    def call(self, command):
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            sys.exit(f"{' '.join(command)}\n{done.stderr}")

    def killed(self, name):
        """Kills the sweep at random instants of ever longer attempts, then resumes it."""
        kills, allowed = 0, 1.0
        while True:
            resume = ["--resume"] if (self.folder / name).exists() else []
            process = subprocess.Popen(self.command(name, *resume), stderr=subprocess.DEVNULL)
            try:
                process.wait(self.random.uniform(0, allowed))
                return kills, self.folder / name / "points"
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
                kills, allowed = kills + 1, 1.3 * allowed

    def lost(self, name):
        """A finished sweep loses a point, which is solved again."""
        points = self.sweep(name)
        shutil.rmtree(sorted(points.iterdir())[1])
        self.sweep(name, "--resume")
        return points

    def alone(self, name):
        """Each point as a run of its own case."""
        for point in sorted(self.reference.iterdir()):
            self.call([self.program, "run", str(point / "case.toml"), "-o", str(self.folder / name / point.name),
                       "--no-report", "--quiet"])
        return self.folder / name

    def rows(self):
        for threads in "234":
            yield f"{threads} threads", self.sweep(f"threads{threads}", "--threads", threads)
        kills, points = self.killed("killed")
        yield f"killed {kills} times, resumed", points
        yield "a point lost, resumed", self.lost("lost")
        yield "two points together", self.sweep("two", frictions=FRICTIONS[:2])
        yield "each point alone", self.alone("alone")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--case", default=ROOT / "cases" / "paper" / "coarse.toml", type=Path)
    parser.add_argument("--set", dest="edits", action="append", default=[])
    parser.add_argument("--shape", choices=SHAPES, action="append")
    parser.add_argument("--seed", type=int, default=int(time.time()))
    options = parser.parse_args()
    print(f"seed {options.seed}")
    differing = 0
    for shape in options.shape or SHAPES:
        settings = [*SHAPES[shape], *(word for edit in options.edits for word in ("--set", edit))]
        with tempfile.TemporaryDirectory(prefix="ionskin-same-bits-") as folder:
            ways = Ways(options.program, options.case, settings, Path(folder), options.seed)
            for way, points in ways.rows():
                worst = [f"{point.name}: {first}" for point in sorted(points.iterdir())
                         if (first := difference(point, ways.reference / point.name))]
                differing += bool(worst)
                print(f"{shape:8} {way:34} {worst[0] if worst else 'the same bits'}", flush=True)
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
