#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Solve the contact of every slider shape and motion at twelve friction coefficients; print the worst residuals.

    verification/every_contact.py build/ionskin coarse [SHAPE or MOTION ...]

Exits 0 only if every contact solve converged and no state violates tension, penetration, friction cone or slip
by more than 1e-8, or equilibrium by more than the audit of a run allows (docs/limits.md).
"""

import csv
import json
import math
import re
import subprocess
import sys
import tempfile
from pathlib import Path

PAPER = Path(__file__).resolve().parent.parent / "cases" / "paper.toml"
FRICTION = "0.05:0.05:0.6"
COMPLEMENTARITY, EQUILIBRIUM = 1e-8, 1e-3
SHAPES = {
    "flat": 'shape = "flat"\nsize = ["3 mm", "1.5 mm"]\n',
    "rounded": 'shape = "flat"\nsize = ["1.5 mm", "1 mm"]\nedge_radius = "0.2 mm"\n',
    "cylinder": 'shape = "cylinder"\nradius = "8 mm"\nsize = ["3 mm", "1.5 mm"]\n',
    "sphere": 'shape = "sphere"\nradius = "8 mm"\n',
    "profile": 'shape = "profile"\nprofile = "bumps.csv"\nsize = ["1.6 mm", "1.2 mm"]\n',
}
STROKES = 'gap = "1 mm"\nstroke = "3 mm"\ntouchdown = "0.5 s"\nslide = "1 s"\nlift = "0.5 s"\nreturn = "1 s"\ncycles = 1\n'
MOTIONS = {
    "touch-slide-lift": 'kind = "touch-slide-lift"\n{load}' + STROKES,
    "reciprocating": 'kind = "reciprocating"\nstrokes = 3\ndwell = "0.1 s"\n{load}' + STROKES,
    "waypoints": 'kind = "waypoints"\nfile = "path.csv"\ncycles = 1\n',
}


def write_bumps(path):
    """A blunt paraboloid of 8 mm radius with ripples of 2 um."""
    millimetres = [-0.8 + 0.1 * i for i in range(17)]
    rows = [["um"] + [1e3 * x for x in millimetres]]
    for y in millimetres:
        rows.append([1e3 * y] + [1e3 * (x * x + y * y) / 16 + math.cos(12 * x) + math.cos(9 * y) for x in millimetres])
    with open(path, "w", newline="") as file:
        csv.writer(file).writerows(rows)


def write_path(path, sharp):
    """Down, along, obliquely back and up again."""
    press = "-1," if sharp else ",0.5"
    stops = [(0, 4.5, 1, "1000,"), (0.5, 4.5, 1, press), (1.5, 7, 1, press), (2.5, 5, 1.1, press), (3, 5, 1.1, "1000,")]
    lines = ["time [s], x [mm], y [mm], height [um], force [N]"]
    path.write_text("\n".join(lines + [f"{t}, {x}, {y}, {level}" for t, x, y, level in stops]) + "\n")


def case_text(shape, motion):
    """paper.toml with another slider and motion; flat sharp sliders press by 1 um, the others by a force."""
    load = 'preload = "1 um"\n' if shape == "flat" else 'preload = "0.5 N"\n'
    start = "" if motion == "waypoints" else 'start = ["4.5 mm", "1 mm"]\n'
    text = re.sub(r"(?s)\[slider\].*?(?=\[motion\])", "[slider]\n" + SHAPES[shape] + start + "\n", PAPER.read_text())
    text = re.sub(r"(?s)\[motion\].*?(?=\[contact\])", "[motion]\n" + MOTIONS[motion].format(load=load) + "\n", text)
    return re.sub(r"(?s)\[output\].*", "", text)


def solve(program, preset, shape, motion):
    """Number of points, failures, contact solves, worst complementarity and equilibrium residual."""
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        write_bumps(folder / "bumps.csv")
        write_path(folder / "path.csv", shape == "flat")
        (folder / "case.toml").write_text(case_text(shape, motion))
        result = subprocess.run(
            [program, "sweep", folder / "case.toml", "--over", f"contact.friction={FRICTION}", "--only", "mechanics",
             "--no-report", "--quiet", "--set", f"numerics.preset={preset}", "-o", folder / "out"],
            capture_output=True, text=True, check=False)
        summaries = [json.loads(path.read_text())["metrics"] for path in (folder / "out").glob("points/*/summary.json")]
        counters = [json.loads(path.read_text())["counters"] for path in (folder / "out").glob("points/*/manifest.json")]
        worst = {name: max((metrics[name]["value"] for metrics in summaries), default=math.nan)
                 for name in ("complementarity_residual", "equilibrium_residual")}
        solves = sum(counter.get("contact_solves", 0) for counter in counters)
        if result.returncode:
            print(result.stderr.strip(), file=sys.stderr)
        return len(summaries), 12 - len(summaries), solves, worst


def main(program, preset, *names):
    unknown = set(names) - set(SHAPES) - set(MOTIONS)
    if unknown:
        print(f"no shape or motion {', '.join(sorted(unknown))}; there are {', '.join([*SHAPES, *MOTIONS])}", file=sys.stderr)
        return 2
    shapes, motions = ([name for name in known if name in names] or known for known in (SHAPES, MOTIONS))
    print(f"{'preset':9}{'slider':10}{'motion':18}{'points':>7}{'failed':>7}{'solves':>8}{'complementarity':>17}{'equilibrium':>13}")
    passed = True
    for shape in shapes:
        for motion in motions:
            points, failed, solves, worst = solve(program, preset, shape, motion)
            passed &= failed == 0 and worst["complementarity_residual"] <= COMPLEMENTARITY \
                and worst["equilibrium_residual"] <= EQUILIBRIUM
            print(f"{preset:9}{shape:10}{motion:18}{points:7}{failed:7}{solves:8.0f}"
                  f"{worst['complementarity_residual']:17.2g}{worst['equilibrium_residual']:13.2g}", flush=True)
    print("all contact solves converged" if passed else "FAILED: see the rows above")
    return 0 if passed else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
