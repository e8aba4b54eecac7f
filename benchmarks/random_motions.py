#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Random motions under every friction law: how many have a solution, and how well it fulfils contact and friction.

    benchmarks/random_motions.py build/ionskin [--rows 150] [--seeds 1] [--laws WORD ...] [--sliders WORD ...]
                                 [--drives WORD ...] [--refinement 0.5]

For each law, drive, slider and kind of load (height, force) a path of random rows, 1 um to the whole stroke each, with presses,
turns, rests, landings and lift-offs, is solved on a small skin, and its worst violation of the contact's and friction's
conditions printed, relative, and the number of contact steps. Fails when a path has no solution or a violation is above 1e-6.
A refinement above 1 brings many cells under a round
slider, which a step then lifts by more than each gives alone.
"""

import argparse
import itertools
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

import small_cases

CASE = small_cases.skin(length=5, width=2) + """
[slider]
{slider}
[motion]
kind = "waypoints"
file = "path.csv"
[contact]
friction = 0.3
{law}
[coupling]
coefficient = 0.1
[numerics]
preset = "coarse"
mesh_refinement = {refinement}
error_estimate = "off"
{drive}
"""

# Keys of the slider; greatest depth [um] and force [N].
SLIDERS = {
    "flat": ('size = ["1 mm", "0.8 mm"]', 1, 3),
    "rounded": ('size = ["1 mm", "0.8 mm"]\nedge_radius = "0.1 mm"', 1, 3),
    "sphere": ('shape = "sphere"\nradius = "8 mm"', 2, 1),
    "cylinder": ('shape = "cylinder"\nradius = "8 mm"\nsize = ["1 mm", "0.8 mm"]', 1, 2),
    "profile": ('shape = "profile"\nprofile = "ridges.csv"\nsize = ["1 mm", "0.8 mm"]', 2, 1),
    "height map": ('shape = "profile"\nprofile = "rough.csv"\nsize = ["1 mm", "0.8 mm"]', 2, 1),
}
# What the slider hangs on; "none" is a rail.
DRIVES = {
    "none": "",
    "stiff": 'stiffness = "50 kN/m"\ndamping = "5 N s/m"\nmass = "2 g"',
    "soft": 'stiffness = "2 kN/m"\ndamping = "1 N s/m"\nmass = "5 g"',
    "undamped": 'stiffness = "5 kN/m"\nmass = "1 g"',
    "massless": 'stiffness = "2 kN/m"\ndamping = "2 N s/m"',
}


def heights_file(rough):
    """Text of the file of an underside: three ridges along y, or a rounded one with random roughness."""
    rng = random.Random("rough")

    def height(x, y):
        return (x * x + y * y) / 16 + (2e-4 * rng.random() if rough else 1e-3 * (1 - math.cos(2 * math.pi * x / 0.33)) / 2)

    return small_cases.height_map([-0.5 + i / 40 for i in range(41)], [-0.4 + i / 40 for i in range(33)], height)


def path_rows(rng, rows, depth, force, oblique):
    """Waypoints [s, mm, mm, um, N]; a stroke is 2 mm long, and a row takes 10 ms or as long as 0.1 m/s needs."""
    time, x, y, rests = 0.0, 2.5, 1.0, False
    path = [(time, x, y, "1", "")]
    for _ in range(rows):
        size = 2 * 10 ** (-3.3 * rng.random())
        before = (x, y)
        rests = not rests and rng.random() < 0.1
        if not rests:
            x = min(3.5, max(1.5, x + rng.choice((-size, size))))
            if oblique:
                y = min(1.02, max(0.98, y + rng.choice((-size, size)) / 50))
        time += max(0.01, (abs(x - before[0]) + abs(y - before[1])) / 100)
        if rng.random() < 0.05:
            path.append((time, x, y, f"{rng.random():.6f}", ""))
        elif force:
            path.append((time, x, y, "", f"{force * (0.1 + 0.9 * rng.random()):.6f}"))
        else:
            path.append((time, x, y, f"{-depth * (0.1 + 0.9 * rng.random()):.6f}", ""))
    path.append((time + 0.1, x, y, "1", ""))
    return path


def trial(program, folder, slider, law, drive, by_force, rows, seed, refinement):
    """Worst violation and steps of one path, or what went wrong."""
    keys, depth, force = SLIDERS[slider]
    rng = random.Random(f"{slider} {by_force} {seed}")
    rows = path_rows(rng, rows, depth, force if by_force else 0, law == "anisotropic")
    text = "time [s], x [mm], y [mm], height [um], force [N]\n"
    text += "".join(f"{t:.6f},{x:.6f},{y:.6f},{h},{f}\n" for t, x, y, h, f in rows)
    (folder / "path.csv").write_text(text)
    (folder / "ridges.csv").write_text(heights_file(False))
    (folder / "rough.csv").write_text(heights_file(True))
    hangs = f"[motion.drive]\n{DRIVES[drive]}\n" if DRIVES[drive] else ""
    (folder / "case.toml").write_text(CASE.format(slider=keys, law=small_cases.friction(law), drive=hangs,
                                                      refinement=refinement))
    command = [program, "run", folder / "case.toml", "-o", folder / "out", "--overwrite", "--only", "mechanics", "--quiet",
               "--no-report", "--threads", "1"]
    process = subprocess.run(command, capture_output=True, text=True, check=False)
    if process.returncode != 0:
        return None, 0, f"exit {process.returncode}: {process.stderr.strip().splitlines()[0][:100]}"
    summary = json.loads((folder / "out" / "summary.json").read_text())
    manifest = json.loads((folder / "out" / "manifest.json").read_text())
    return summary["metrics"]["complementarity_residual"]["value"], manifest["counters"]["contact_solves"], ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--rows", type=int, default=150)
    parser.add_argument("--seeds", type=int, default=1)
    parser.add_argument("--laws", nargs="+", default=list(small_cases.FRICTION_LAWS))
    parser.add_argument("--sliders", nargs="+", default=list(SLIDERS))
    parser.add_argument("--drives", nargs="+", default=list(DRIVES))
    parser.add_argument("--refinement", type=float, default=0.5, help="of the mesh of the preset coarse")
    options = parser.parse_args()
    failures = paths = all_steps = 0
    for law, drive in itertools.product(options.laws, options.drives):
        if law == "adhesive" and drive != "none":
            continue  # refused
        worst, law_steps = 0.0, 0
        for slider, by_force, seed in itertools.product(options.sliders, (False, True), range(options.seeds)):
            with tempfile.TemporaryDirectory() as folder:
                residual, steps, problem = trial(options.program.resolve(), pathlib.Path(folder), slider, law, drive, by_force,
                                                 options.rows, seed, options.refinement)
            paths += 1
            law_steps += int(steps)
            if residual is None or not residual <= 1e-6:
                failures += 1
                load = "force" if by_force else "height"
                print(f"{law}, drive {drive}, {slider} by {load}, seed {seed}: {problem or residual}", flush=True)
            if residual is not None:
                worst = max(worst, residual)
        all_steps += law_steps
        print(f"{law:20} drive {drive:9} {law_steps:6} steps, worst violation {worst:.1e}", flush=True)
    print(f"{paths} paths of {options.rows} rows, {all_steps} steps, {failures} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
