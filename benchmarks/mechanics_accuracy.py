#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Error that the mesh leaves in the averages of Study 1 of cases/paper.toml, and the program's estimate of it: the
table of docs/verification.md.

    benchmarks/mechanics_accuracy.py build/ionskin [REFINEMENT]

The limit is the value of the fine preset at `numerics.mesh_refinement` REFINEMENT (default 1.3, which takes 0.5 GB): what
is left there has no common order, as the edges' share comes from below and that of the mesh around them from above.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

CASE = Path(__file__).resolve().parent.parent / "cases" / "paper.toml"
AVERAGES = ("normal_force_touchdown", "normal_force_slide", "tangential_force_slide", "mean_shear_touchdown",
            "mean_shear_slide", "peak_mean_shear", "time_mean_shear", "rms_mean_shear", "shear_first_moment_touchdown",
            "shear_first_moment_slide", "external_work", "friction_work")


def solve(program, preset, refinement):
    """Figures of one cycle, and the estimates of their relative errors."""
    edits = {"numerics.preset": preset, "numerics.mesh_refinement": refinement, "motion.cycles": 1}
    with tempfile.TemporaryDirectory() as folder:
        command = [program, "run", CASE, "-o", f"{folder}/out", "--only", "mechanics", "--no-report", "--quiet"]
        for key, value in edits.items():
            command += ["--set", f"{key}={value}"]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        summary = json.loads((Path(folder) / "out" / "summary.json").read_text())
    return {name: entry["value"] for name, entry in summary["metrics"].items()}, summary["error_estimate"]


def main(program, refinement="1.3"):
    presets = {preset: solve(program, preset, 1) for preset in ("standard", "fine")}
    limits, _ = solve(program, "fine", refinement)
    print(f"{'average':30}{'limit':>12}" + "".join(
        f"{preset:>12}{'off limit':>11}{'estimate':>10}{'ratio':>7}" for preset in presets))
    for name in AVERAGES:
        row = f"{name:30}{limits[name]:12.5g}"
        for values, estimates in presets.values():
            off = abs(values[name] / limits[name] - 1)
            row += f"{values[name]:12.5g}{off:11.2%}{estimates[name]:10.2%}{estimates[name] / off:7.1f}"
        print(row)


if __name__ == "__main__":
    main(*sys.argv[1:])
