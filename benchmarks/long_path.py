#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Cost of a path of many rows: rows a millisecond apart, over the skin and under the slider of cases/paper.toml.

    benchmarks/long_path.py build/ionskin [--rows 100000] [--preset coarse] [--threads 2]

The slider lands, strokes to and fro over 4 mm while it trembles by 0.1 mm and its depth changes, and leaves. Prints what
`check --explain` promises, wall time, largest memory and contact steps.
"""

import argparse
import json
import math
import pathlib
import subprocess
import tempfile
import time

import small_cases


def path_text(rows):
    """The table of a path; half a second each for landing and leaving."""
    lines = ["time [s],x [m],y [m],height [m]"]
    for row in range(rows):
        at = 1e-3 * row
        touch = min(1.0, at / 0.5, (1e-3 * (rows - 1) - at) / 0.5)
        x = 7.5e-3 + 2e-3 * math.sin(2 * math.pi * 0.11 * at) + 1e-4 * math.sin(2 * math.pi * 3 * at)
        depth = 1e-6 * (0.6 + 0.4 * math.sin(2 * math.pi * 0.7 * at))
        lines.append(f"{at:.3f},{x:.9g},0.001,{20e-6 * (1 - touch) - depth * touch:.9g}")
    return "\n".join(lines) + "\n"


def case_text(preset):
    """The TOML text of the case."""
    return small_cases.skin(length=15, width=2) + f"""
[slider]
shape = "flat"
size = ["3 mm", "1.5 mm"]
[motion]
kind = "waypoints"
file = "path.csv"
[contact]
friction = 0.3
[coupling]
law = "fixed-charge"
coefficient = 0.1
[numerics]
preset = "{preset}"
"""


def main():
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--rows", type=int, default=100_000)
    parser.add_argument("--preset", default="coarse")
    parser.add_argument("--threads", type=int, default=2)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="ionskin-path-") as scratch:
        folder, out = pathlib.Path(scratch), pathlib.Path(scratch) / "out"
        (folder / "path.csv").write_text(path_text(arguments.rows), encoding="utf-8")
        case = folder / "case.toml"
        case.write_text(case_text(arguments.preset), encoding="utf-8")
        explained = subprocess.run([arguments.program, "check", case, "--explain"], capture_output=True, text=True, check=True)
        print("\n".join(line for line in explained.stdout.splitlines() if line.startswith(("  memory ", "  wall time "))))
        begin = time.monotonic()
        subprocess.run([arguments.program, "run", case, "-o", out, "--no-report", "--quiet", "--threads",
                        str(arguments.threads)], check=True)
        manifest = json.loads((out / "manifest.json").read_text(encoding="utf-8"))
        memory = max(stage["peak_memory_bytes"] for stage in manifest["stages"].values())
        print(f"{arguments.rows} rows: {time.monotonic() - begin:.0f} s on {arguments.threads} threads, {memory * 1e-9:.2f} GB, "
              f"{manifest['counters']['contact_solves']:.0f} contact steps")


if __name__ == "__main__":
    main()
