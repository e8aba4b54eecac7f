# SPDX-License-Identifier: Apache-2.0
"""Runs of several codes beside one another: errors, ratios at equal accuracy, a table. A run is a dict with code,
setting, unknowns, processor_s, peak_MB and figures, a dict of numbers."""


def with_errors(run, reference, resolved=0.0):
    """The run with the relative error of each figure, and the largest of them, or `resolved`: what the reference tells."""
    errors = {name: abs(run["figures"][name] / value - 1) for name, value in reference.items()}
    return {**run, "errors": errors, "error": max(resolved, *errors.values())}


def equal_accuracy(runs, home="ionskin"):
    """The runs, each of another code with its ratios to the cheapest run of `home` that is no less accurate; to the most
    accurate one, marked as a bound, where none is: one as accurate would cost more."""
    ours = [run for run in runs if run["code"] == home]
    compared = []
    for run in runs:
        if run["code"] != home and ours:
            enough = [other for other in ours if other["error"] <= run["error"]]
            other = min(enough, key=lambda one: one["processor_s"]) if enough else min(ours, key=lambda one: one["error"])
            run = {**run, "beside": other["setting"], "bound": not enough,
                   "time_ratio": run["processor_s"] / other["processor_s"],
                   "memory_ratio": run["peak_MB"] / other["peak_MB"]}
        compared.append(run)
    return compared


def markdown(runs):
    """A row for each run."""
    head = ["code", "setting", "unknowns", "processor time", "peak memory", "largest error", "compared with",
            "time ratio", "memory ratio"]
    rows = [head, ["---"] * len(head)]
    for run in runs:
        worst = max(run["errors"], key=run["errors"].get)
        error = f"{run['error']:.2%}, {worst}" if run["errors"][worst] >= run["error"] else f"below {run['error']:.2%}"
        row = [run["code"], run["setting"], f"{run['unknowns']:,}", f"{run['processor_s']:.3g} s", f"{run['peak_MB']:.0f} MB",
               error, "", "", ""]
        if "beside" in run:
            below = "below " if run["bound"] else ""
            row[-3:] = [run["beside"], *(f"{below}{float(f'{run[ratio]:.2g}'):g}" for ratio in ("time_ratio", "memory_ratio"))]
        rows.append(row)
    return "\n".join("| " + " | ".join(row) + " |" for row in rows)
