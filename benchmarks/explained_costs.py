#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Time and memory that `ionskin check --explain` promises, beside what a run takes, over random cases.

    benchmarks/explained_costs.py build/ionskin [--cases 40] [--first 0] [--refinements 0.5 0.6 0.7] [--table FILE]

Skin, slider, motion, control, friction, drive, coupling, circuit and errors are drawn at the preset coarse, each case from its
own number. A run has one thread and its report; its time is processor time, so that other work on the machine
tells little. Fails when a run takes more than twice the memory that was promised and did not say so first.
"""

import argparse
import json
import math
import os
import pathlib
import random
import statistics
import subprocess
import sys
import tempfile

import small_cases

SLIDERS = ("flat", "rounded", "sphere", "cylinder", "profile")
COUPLINGS = ("fixed-charge", "column-neutral", "pair-generation", "volume-neutral")


def ridges(size):
    """Text of the file of three ridges along y over a plan [mm]."""
    return small_cases.height_map([size[0] * (i / 40 - 0.5) for i in range(41)], [size[1] * (i / 16 - 0.5) for i in range(17)],
                                  lambda x, y: 0.001 * (1 - math.cos(2 * math.pi * x / (size[0] / 3))) / 2)


def draw_slider(rng, shape, length, width):
    """Keys of a slider, and its plan [mm]."""
    size = [round(rng.uniform(0.8, min(3, length / 4)), 3), round(rng.uniform(0.6, min(1.5, width / 2)), 3)]
    plan = f'size = ["{size[0]:.3f} mm", "{size[1]:.3f} mm"]'
    radius = f'radius = "{rng.uniform(2, 8):.2f} mm"'
    return {
        "flat": plan,
        "rounded": plan + f'\nedge_radius = "{rng.uniform(0.05, 0.2):.3f} mm"',
        "sphere": f'shape = "sphere"\n{radius}',
        "cylinder": f'shape = "cylinder"\n{radius}\n{plan}',
        "profile": f'shape = "profile"\nprofile = "profile.csv"\n{plan}',
    }[shape], size


def draw_motion(rng, kind, load, by_force, start, stroke):
    """Text of a motion and, for waypoints, of its file."""
    if kind == "waypoints":
        key = "force" if by_force else "height"
        rows, time, place = [(0, start[0], 100, "")], 0.5, start[0]
        for _ in range(rng.randint(3, 40)):
            level = load * rng.uniform(0.3, 1)
            rows.append((time, place, "" if by_force else -level, level if by_force else ""))
            place = start[0] + stroke * rng.random()
            time += rng.uniform(0.02, 0.3)
        rows.append((time, place, 100, ""))
        text = "time [s], x [mm], y [mm], height [um], force [N]\n"
        text += "".join(f"{t:.4f},{x:.4f},{start[1]:.4f},{height},{force}\n" for t, x, height, force in rows)
        return 'kind = "waypoints"\nfile = "path.csv"\n', text, f"{len(rows)} rows by {key}"
    preload = f"{load:.3f} N" if by_force else f"{load:.3f} um"
    motion = (f'gap = "0.1 mm"\npreload = "{preload}"\nstroke = "{stroke:.3f} mm"\ntouchdown = "0.5 s"\n'
              f'slide = "{rng.uniform(0.3, 2):.2f} s"\nlift = "0.5 s"\nreturn = "0.5 s"\ncycles = {rng.choice((1, 1, 2))}\n')
    if kind == "reciprocating":
        motion += f'kind = "reciprocating"\nstrokes = {rng.randint(2, 4)}\ndwell = "0.1 s"\n'
    return motion, "", f"{kind} by {'force' if by_force else 'height'}"


def draw(number, refinements):
    """Text, files and short name of one case."""
    rng = random.Random(f"explained {number}")
    length, width = rng.uniform(5, 15), rng.uniform(1.6, 4)
    core = rng.uniform(80, 220)
    text = small_cases.skin(length, width, rng.uniform(5, 15), core)
    shape = SLIDERS[number % len(SLIDERS)]
    keys, size = draw_slider(rng, shape, length, width)
    by_force = rng.random() < 0.5
    round_below = shape in ("sphere", "cylinder", "profile")
    load = rng.uniform(0.2, 1.5) if by_force else rng.uniform(0.3, 3 if round_below else 1)
    stroke = rng.uniform(0.05, 1) * (length / 2 - size[0] / 2)
    start = [length / 4 + size[0] / 4, width / 2]
    kind = rng.choice(("touch-slide-lift", "reciprocating", "waypoints"))
    motion, path, said = draw_motion(rng, kind, load, by_force, start, stroke)
    law = rng.choice(["coulomb"] * 4 + list(small_cases.FRICTION_LAWS))
    drive = law != "adhesive" and rng.random() < 0.25
    text += f"[slider]\n{keys}\n"
    if kind != "waypoints":
        text += f'start = ["{start[0]:.4f} mm", "{start[1]:.4f} mm"]\n'
    text += f"[motion]\n{motion}"
    if drive:
        text += (f'[motion.drive]\nstiffness = "{10 ** rng.uniform(3.3, 4.7):.0f} N/m"\ndamping = "{rng.uniform(1, 5):.2f} N s/m"\n'
                 f'mass = "{rng.uniform(1, 5):.2f} g"\n')
    text += f'[contact]\nfriction = {rng.uniform(0.1, 0.6):.2f}\n{small_cases.friction(law)}'
    coupling, circuit = rng.choice(COUPLINGS), rng.choice(("short", "open"))
    text += f'[coupling]\nlaw = "{coupling}"\ncoefficient = 0.1\n[readout]\ncircuit = "{circuit}"\n'
    errors, refinement = rng.choice(("on", "on", "off")), rng.choice(refinements)
    text += f'[numerics]\npreset = "coarse"\nmesh_refinement = {refinement}\nerror_estimate = "{errors}"\n'
    files = {"case.toml": text, "profile.csv": ridges(size), "path.csv": path or "time [s]\n"}
    return files, f"{shape}, {said}, {law}{', drive' if drive else ''}, errors {errors}"


def promised(program, case):
    """Cost that `check --explain` tells of a run on one thread; None and the message of a case that is refused."""
    core = min(os.sched_getaffinity(0))
    process = subprocess.run(["taskset", "-c", str(core), program, "check", case, "--explain", "--json"], capture_output=True,
                             text=True, check=False)
    if process.returncode != 0:
        return None, first_line(process.stderr)
    return json.loads(process.stdout)["cost"], ""


def first_line(text):
    """First line that a program printed."""
    return (text.strip().splitlines() or [""])[0][:140]


def taken(program, case, folder, limit):
    """Processor time [s], peak memory [bytes] and what a run said."""
    output = folder / "said.txt"
    with open(output, "w", encoding="utf-8") as said:
        process = subprocess.Popen(["timeout", str(limit), program, "run", case, "-o", folder / "out", "--threads", "1", "--progress",
                                    "none"], stdout=said, stderr=said)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024, process.returncode, output.read_text(encoding="utf-8")


def ratios(name, promised_values, taken_values):
    """One line on how far promises are off."""
    values = sorted(promise / real for promise, real in zip(promised_values, taken_values))
    within = sum(0.5 <= value <= 2 for value in values)
    return (f"{name}: promised over taken {values[0]:.2f} to {values[-1]:.2f}, median {statistics.median(values):.2f}; "
            f"{within} of {len(values)} within a factor of 2")


def main():
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--cases", type=int, default=40)
    parser.add_argument("--first", type=int, default=0, help="number of the first case")
    parser.add_argument("--refinements", type=float, nargs="+", default=[0.5, 0.6, 0.7])
    parser.add_argument("--limit", type=int, default=900, help="wall time after which a run is ended [s]")
    parser.add_argument("--table", type=pathlib.Path, help="the figures of every case as JSON lines")
    options = parser.parse_args()
    program = options.program.resolve()
    costs, runs, silent = [], [], 0
    for number in range(options.first, options.first + options.cases):
        files, name = draw(number, options.refinements)
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            for path, text in files.items():
                (folder / path).write_text(text, encoding="utf-8")
            cost, problem = promised(program, folder / "case.toml")
            if cost is None:
                print(f"{number:3} {name}: refused, {problem}", flush=True)
                continue
            seconds, memory, code, said = taken(program, folder / "case.toml", folder, options.limit)
            manifest = folder / "out" / "manifest.json"
            counters = json.loads(manifest.read_text())["counters"] if manifest.exists() else {}
        if code not in (0, 3) or not counters:
            print(f"{number:3} {name}: exit {code} after {seconds:.1f} s, {first_line(said)}", flush=True)
            continue
        costs.append(cost)
        runs.append((seconds, memory))
        too_much = memory > 2 * cost["memory_bytes"] and "memory" not in said
        silent += too_much
        print(f"{number:3} {name}: {cost['seconds']:.1f} s promised, {seconds:.1f} s taken, {cost['seconds'] / seconds:.2f}; "
              f"{cost['memory_bytes'] / 1e9:.2f} GB, {memory / 1e9:.2f} GB, {cost['memory_bytes'] / memory:.2f}"
              f"{'  MORE THAN TWICE' if too_much else ''}", flush=True)
        if options.table:
            with open(options.table, "a", encoding="utf-8") as table:
                table.write(json.dumps({"number": number, "name": name, "cost": cost, "seconds": seconds, "memory": memory,
                                        "counters": counters}) + "\n")
    if runs:
        print(ratios("time", [cost["seconds"] for cost in costs], [run[0] for run in runs]))
        print(ratios("memory", [cost["memory_bytes"] for cost in costs], [run[1] for run in runs]))
    print(f"{len(runs)} runs, {silent} took more than twice the memory that they promised without a word")
    return 1 if silent else 0


if __name__ == "__main__":
    sys.exit(main())
