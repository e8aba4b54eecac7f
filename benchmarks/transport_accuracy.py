#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Error that time tolerance and grid leave in the currents of a strain history: the tables of docs/electrochemistry.md.

    build/ionskin run cases/paper.toml -o out/history --set motion.cycles=1 --only mechanics --no-report
    benchmarks/transport_accuracy.py build/ionskin out/history/results.h5 [PRESET ...]
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py
import numpy

CASE = Path(__file__).resolve().parent.parent / "cases" / "paper.toml"
TOLERANCES = {"coarse": 3e-4, "standard": 5e-5, "fine": 1.5e-6}
HALVES = '[{name="left", lower=["0 mm", "0 mm"], upper=["7.5 mm", "2 mm"]}, ' \
         '{name="right", lower=["7.5 mm", "0 mm"], upper=["15 mm", "2 mm"]}]'
LAWS = ("fixed-charge", "volume-neutral", "column-neutral", "pair-generation")
QUIET_AFTER = 0.05  # [s] behind an event, as in tail_current_difference


class Transport:
    """Runs Study 2 on one history."""

    def __init__(self, program, history):
        self.program, self.history = program, Path(history).resolve()
        with h5py.File(history) as file:
            self.events = file["strain/event_time"][...]

    def run(self, **keys):
        """Summary, number of steps, sampled difference current, which of its intervals are quiet; keeps the fields."""
        edits = {"strain.source": "file", "strain.file": json.dumps(str(self.history)), "motion.cycles": 1, **keys}
        with tempfile.TemporaryDirectory() as folder:
            command = [self.program, "run", CASE, "-o", f"{folder}/out", "--no-report", "--quiet"]
            for key, value in edits.items():
                command += ["--set", f"{key}={value}"]
            subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
            out = Path(folder) / "out"
            with h5py.File(out / "results.h5") as file:
                end, current = file["sampled/time"][...], file["sampled/current_difference"][...]
                self.fields = {instant: {name: group[name][...] for name in ("concentration", "potential")}
                               for instant, group in file["ions"].items() if "potential" in group}
            summary = json.loads((out / "summary.json").read_text())
            steps = json.loads((out / "manifest.json").read_text())["counters"]["time_steps"]
        begin = numpy.concatenate([[0.0], end[:-1]])
        near = (self.events > begin[:, None] - QUIET_AFTER) & (self.events < end[:, None])
        return summary, int(steps), current, ~near.any(axis=1)


def rms(values):
    return float(numpy.sqrt(numpy.mean(values**2)))


def tolerance_table(transport):
    print("time tolerance, on the coarse grid, against 1e-7:")
    print(f"{'preset':10}{'tolerance':>10}{'steps':>7}{'tail, rms':>11}{'largest':>10}")
    _, _, reference, tail = transport.run(**{"numerics.preset": "coarse", "numerics.time_tolerance": 1e-7})
    for preset, tolerance in TOLERANCES.items():
        _, steps, current, _ = transport.run(**{"numerics.preset": "coarse", "numerics.time_tolerance": tolerance})
        error = (current - reference)[tail]
        print(f"{preset:10}{tolerance:10.1e}{steps:7}"
              f"{rms(error) / rms(reference[tail]):11.1e}{numpy.abs(error).max() / rms(reference[tail]):10.1e}", flush=True)


def column_table(transport):
    print("standard: whole electrodes against a run with taxels, which resolves single columns; against 1e-6:")
    print(f"{'':9}{'steps':>6}{'tail, rms':>11}   rms error of kept fields (concentration, potential) over their rms deviation")
    _, _, reference, tail = transport.run(**{"numerics.time_tolerance": 1e-6, "readout.taxels": HALVES})
    exact = transport.fields
    for name, keys in {"whole": {}, "taxels": {"readout.taxels": HALVES}}.items():
        _, steps, current, _ = transport.run(**keys)
        errors = [f"{instant} s " + ", ".join(f"{numpy.std(transport.fields[instant][field] - values) / numpy.std(values):.1e}"
                                             for field, values in fields.items()) for instant, fields in exact.items()]
        print(f"{name:9}{steps:6}{rms((current - reference)[tail]) / rms(reference[tail]):11.1e}   {'; '.join(errors)}", flush=True)


def estimate_table(transport, presets):
    print("error of tail_current_difference, true (4/3 of the change on half the mesh and steps) and estimated:")
    print(f"{'law':17}{'preset':10}{'true':>9}{'estimated':>11}{'ratio':>7}")
    for law in LAWS:
        for preset in presets:
            keys = {"numerics.preset": preset, "coupling.law": law}
            summary, _, current, tail = transport.run(**keys)
            refined = {**keys, "numerics.mesh_refinement": 2, "numerics.time_refinement": 2}
            _, _, better, _ = transport.run(**refined)
            true = 4 / 3 * rms((current - better)[tail]) / rms(better[tail])
            estimated = summary["error_estimate"]["tail_current_difference"]
            print(f"{law:17}{preset:10}{true:9.2%}{estimated:11.2%}{estimated / true:7.1f}", flush=True)


def main(program, history, *presets):
    transport = Transport(program, history)
    tolerance_table(transport)
    column_table(transport)
    estimate_table(transport, presets or ("coarse", "standard"))


if __name__ == "__main__":
    main(*sys.argv[1:])
