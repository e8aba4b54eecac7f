#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What the mesh leaves in the averages of Study 1 of cases/paper.toml, and what the program estimates: the table of
docs/verification.md.

    benchmarks/mechanics_accuracy.py build/ionskin [REFINEMENT]

The limit is that of the standard preset by its value and that at `numerics.mesh_refinement` REFINEMENT (default 1.7,
which takes 13 GB), with errors in proportion to the mesh size. The fine preset, another family of meshes, stands beside.
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


def main(program, refinement="1.7"):
    standard, estimate = solve(program, "standard", 1)
    refined, _ = solve(program, "standard", refinement)
    fine, fine_estimate = solve(program, "fine", 1)
    print(f"{'average':30}{'standard':>12}{'limit':>12}{'true':>8}{'estimate':>10}{'ratio':>7}"
          f"{'fine':>12}{'off limit':>11}{'estimate':>10}")
    for name in AVERAGES:
        limit = refined[name] + (refined[name] - standard[name]) / (float(refinement) - 1)
        true = abs(standard[name] / limit - 1)
        print(f"{name:30}{standard[name]:12.5g}{limit:12.5g}{true:8.2%}{estimate[name]:10.2%}"
              f"{estimate[name] / true:7.1f}{fine[name]:12.5g}{abs(fine[name] / limit - 1):11.2%}"
              f"{fine_estimate[name]:10.2%}")


if __name__ == "__main__":
    main(*sys.argv[1:])
