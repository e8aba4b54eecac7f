#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Random physical cases: whether each runs to an end in time, and whether what it says can be.

    benchmarks/random_cases.py build/ionskin [--cases 200] [--first 0] [--jobs 2] [--keep DIR] [--table FILE]

Every key of `ionskin keys` is drawn in a physical range (physical_cases.py), each case from its own number. A case is refused by
`check`, or runs within six times the processor time that `check --explain` promises (and no less than --least) and ends with 0, or
with 3 and a remedy. Where it ends with 0 and all its audits passed, work, friction, areas and charges are judged again from its
files. Fails when a case crashes, hangs, is refused by `run` alone, or says what cannot be.
"""

import argparse
import collections
import concurrent.futures
import csv
import json
import math
import os
import pathlib
import resource
import shutil
import subprocess
import sys
import tempfile

import h5py
import numpy
import physical_cases

FACTOR = 6  # times the promise, until a run is a hang
WALL_FACTOR = 20  # wall time over processor time on a machine that others use
FARADAY = 96485.0  # C/mol
LEAST_SHARE = 1e-6  # of the largest value, below which a number counts as 0


def run(command, seconds, wall):
    """Exit code, processor time and what a program said; a negative code is a signal's, None stands for no end."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    limit = int(seconds) + 1
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, start_new_session=True,
                               preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 5)))
    try:
        said, _ = process.communicate(timeout=wall)
        code = process.returncode
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, 9)
        said, _ = process.communicate()
        code = None
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return code, used, said


def table(path):
    """Columns of a CSV by name without unit, but for phases and for what the case does not have."""
    with open(path, encoding="utf-8") as file:
        rows = list(csv.reader(file))
    columns = {name.split(" [")[0]: [row[i] for row in rows[1:]] for i, name in enumerate(rows[0])}
    return {name: numpy.array([float(cell) if cell else numpy.nan for cell in cells])
            for name, cells in columns.items() if name != "phase" and any(cells)}


def largest(values):
    """Largest magnitude; 0 of nothing."""
    return float(numpy.nanmax(numpy.abs(values))) if len(values) else 0.0


def impossible_energy(signals, metrics):
    """Work that a touch gives: the skin stores nothing before and nothing behind it."""
    work = metrics.get("external_work", {}).get("value")
    if work is None or "normal_force" not in signals:
        return
    way = numpy.hypot(*(numpy.diff(signals[name]) for name in ("slider_x", "slider_y"))) if "slider_y" in signals else numpy.diff(
        signals["slider_x"])
    done = numpy.sum(numpy.abs(signals["tangential_force"][1:] * way)) + numpy.sum(
        numpy.abs(signals["normal_force"][1:] * numpy.diff(signals["slider_z"])))
    if work < -1e-4 * done:
        yield f"work of {work:.3g} J, of {done:.3g} J in all"
    if metrics["friction_work"]["value"] < -1e-4 * done:
        yield f"friction takes {metrics['friction_work']['value']:.3g} J"


def impossible_contact(case, signals, results):
    """Areas and shares out of range, and tractions above the limit of friction or without pressure."""
    if "contact" not in case:
        return
    contact = case["contact"]
    force, drag = signals["normal_force"], signals["tangential_force"]
    if numpy.nanmin(signals["contact_area"]) < 0:
        yield f"contact area {numpy.nanmin(signals['contact_area']):.3g} m2"
    if numpy.nanmin(signals["stick_share"]) < 0 or numpy.nanmax(signals["stick_share"]) > 1:
        yield "stick share out of 0 to 1"
    adheres = contact["law"] == "adhesive"
    if not adheres and numpy.nanmin(force) < -LEAST_SHARE * largest(force):
        yield f"normal force {numpy.nanmin(force):.3g} N"
    # A viscous one grows to 2 with the speed, beyond which a motion is refused.
    most = 2 if contact["law"] == "viscous" else max(contact["friction"], contact.get("transverse_friction", 0))
    over = numpy.abs(drag) - most * force
    if not adheres and numpy.nanmax(over) > LEAST_SHARE * largest(force):
        yield f"friction {numpy.nanmax(over):.3g} N above its limit"
    for name, state in results.get("contact", {}).items():
        if "pressure" not in state:  # lines of the cells
            continue
        pressure = state["pressure"][...]
        tangential = numpy.hypot(state["shear_x"][...], state["shear_y"][...])
        if numpy.max(tangential - most * numpy.maximum(pressure, 0)) > 10 * LEAST_SHARE * largest(pressure.ravel()):
            yield f"traction above its limit at {name}"


def rounding_charge(case):
    """Largest error that rounding may leave in the charge of all ions of a core [C]."""
    core = next(layer for layer in case["skin"]["layers"] if layer["role"] == "core")
    volume = 1e-12 * math.prod(float(text.split()[0]) for text in (case["skin"]["length"], case["skin"]["width"], core["thickness"]))
    held = {**case.get("materials", {}).get("polymer", {}), **case["electrochemistry"]}
    return 1e-13 * FARADAY * float(held["fixed_charge_concentration"].split()[0]) * volume


def impossible_currents(case, signals):
    """Numbers that are none, and charge that moves before the first touch, through an open circuit, or to ground under neutral laws."""
    for name, values in signals.items():
        if name.startswith(("current", "charge", "mean_shear", "time")) and not numpy.all(numpy.isfinite(values)):
            yield f"{name} is not a number"
    top, bottom = signals["charge_top"], signals["charge_bottom"]
    least = max(LEAST_SHARE * max(largest(top), largest(bottom)), rounding_charge(case))
    if case["readout"]["circuit"] == "open" and "taxel_circuit" not in case["readout"] and largest(top - bottom) > least:
        yield f"{largest(top - bottom):.3g} C through an open circuit"
    if case["coupling"]["law"] != "fixed-charge" and largest(top + bottom) > least:
        yield f"{largest(top + bottom):.3g} C to ground under a neutral law"
    pressed_outside = any(key.endswith("_pressure") for key in case.get("water", {}))  # which moves water from the beginning
    if "contact" in case and not pressed_outside:
        touched = numpy.flatnonzero(signals["normal_force"] != 0)
        before = max(0, touched[0] - 1) if len(touched) else len(top)
        if max(largest(top[:before]), largest(bottom[:before])) > least:
            yield "charge before the first touch"


def judged(case, folder):
    """Results of a finished run that cannot be right, though its audits passed."""
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    if any(audit["verdict"] == "failed" for audit in summary["audits"].values()):
        return ["ended with 0 though an audit failed"]
    if any(audit["verdict"] == "warned" for audit in summary["audits"].values()):
        return []
    signals = table(folder / "signals.csv")
    with h5py.File(folder / "results.h5") as results:
        return [*impossible_energy(signals, summary["metrics"]), *impossible_contact(case, signals, results),
                *impossible_currents(case, signals)]


def trial(program, number, least):
    """Verdict, its reason, processor times promised and taken, and the case's folder."""
    draw = physical_cases.Draw(number)
    folder = pathlib.Path(tempfile.mkdtemp(prefix=f"ionskin-case-{number}-"))
    path = folder / "case.toml"
    path.write_text(physical_cases.toml(draw.case), encoding="utf-8")
    for name, text in draw.files.items():
        (folder / name).write_text(text, encoding="utf-8")
    result = {"number": number, "name": draw.name(), "folder": folder, "promised": 0.0, "taken": 0.0}
    code, used, said = run([program, "check", path, "--explain", "--json"], 60, 60 * WALL_FACTOR)
    first = (said.strip().splitlines() or [""])[0][:150]
    if code != 0:
        return result | {"verdict": "refused" if code == 2 else "CRASH" if code else "HANG", "why": f"check: {first}", "taken": used}
    try:
        result["promised"] = json.loads(said)["cost"]["seconds"]
    except ValueError:
        return result | {"verdict": "CRASH", "why": f"check says no JSON: {first}"}
    allowed = max(least, FACTOR * result["promised"])
    code, result["taken"], said = run([program, "run", path, "-o", folder / "out", "--threads", "1", "--progress", "none",
                                       "--no-report"], allowed, WALL_FACTOR * allowed)
    errors = [line for line in said.splitlines() if "error" in line] or said.strip().splitlines() or [""]
    if code is None or code in (-24, -9):  # SIGXCPU, SIGKILL
        return result | {"verdict": "HANG", "why": f"{allowed:.0f} s allowed"}
    if code == 2:
        return result | {"verdict": "LATE", "why": f"valid, then refused: {errors[0][:150]}"}
    if code == 3:
        named = "remedy" in said
        return result | {"verdict": "gave up" if named else "NO REMEDY", "why": errors[0][:150]}
    if code != 0:
        return result | {"verdict": "CRASH", "why": f"exit {code}: {errors[0][:150]}"}
    wrong = judged(draw.case, folder / "out")
    return result | {"verdict": "WRONG" if wrong else "sound", "why": "; ".join(wrong)}


def main():
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--cases", type=int, default=200)
    parser.add_argument("--first", type=int, default=0, help="number of the first case")
    parser.add_argument("--jobs", type=int, choices=(1, 2), default=2, help="cases side by side")
    parser.add_argument("--least", type=float, default=20, help="processor time that every run may take [s]")
    parser.add_argument("--keep", type=pathlib.Path, help="a folder for the cases that are not sound")
    parser.add_argument("--table", type=pathlib.Path, help="every verdict as a JSON line")
    options = parser.parse_args()
    program = options.program.resolve()
    schema = json.loads(subprocess.run([program, "keys", "--json"], capture_output=True, text=True, check=True).stdout)
    if missing := physical_cases.undrawn_keys(schema):
        sys.exit(f"no case has {', '.join(missing)}: say in physical_cases.py how they are drawn, or why not")
    verdicts = collections.Counter()
    with concurrent.futures.ProcessPoolExecutor(options.jobs) as pool:
        numbers = range(options.first, options.first + options.cases)
        for done in concurrent.futures.as_completed([pool.submit(trial, program, number, options.least) for number in numbers]):
            if done.exception():
                pool.shutdown(cancel_futures=True)
            result = done.result()
            verdicts[result["verdict"]] += 1
            print(f"{result['number']:4} {result['verdict']:8} {result['promised']:6.1f} s promised {result['taken']:7.1f} s taken  "
                  f"{result['name']}{': ' if result['why'] else ''}{result['why']}", flush=True)
            folder = result.pop("folder")
            if options.keep and result["verdict"] not in ("sound", "refused"):
                shutil.copytree(folder, options.keep / str(result["number"]), dirs_exist_ok=True)
            shutil.rmtree(folder, ignore_errors=True)
            if options.table:
                with open(options.table, "a", encoding="utf-8") as lines:
                    lines.write(json.dumps(result) + "\n")
    print(", ".join(f"{count} {verdict}" for verdict, count in sorted(verdicts.items())))
    return 1 if any(verdict.isupper() for verdict in verdicts) else 0


if __name__ == "__main__":
    sys.exit(main())
