# SPDX-License-Identifier: Apache-2.0
"""The verification page: table and plots of what `ionskin verify --csv` wrote."""

import csv
import math

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402  the backend must be chosen first

TITLES = {
    "M1": "Patch tests", "M2": "Hertz and Cattaneo-Mindlin", "M4": "Friction and equilibrium",
    "M5": "Complementarity", "M6": "Baseline contact", "M7": "Onset of sliding", "M8": "Repeating cycles",
    "M9": "Symmetry", "M10": "Reciprocating motion", "M11": "Force control", "E1": "Gauss identity",
    "E2": "Ramo identity", "E3": "Linear step of shear", "E4": "Impedance", "E5": "Nonlinear double layer",
    "E6": "Conservation of ions", "E7": "Manufactured solution", "E8": "Averages across the skin",
    "E9": "Ions of finite size", "M12": "Paths in rows", "M13": "Friction laws", "M14": "Slider on a drive",
    "P1": "Consolidation", "P2": "Water between sealed walls", "P3": "Voltage of a step of pressure",
    "P4": "Charge of a step of pressure", "P5": "Waves of pressure", "P6": "Symmetries", "P7": "Conservation of water",
    "P8": "Bench loads", "P9": "Saxen's relation", "P10": "Thin double layers", "P11": "Permeation cell", "P12": "Walls that conduct water", "P13": "Held compression", "P14": "Relaxing polymer",
    "M15": "Adhesion", "M16": "Free sides and ends", "M17": "Pose and wrench", "M18": "Several sliders", "M19": "Rolling",
    "E10": "Circuits of taxels", "E11": "Sheet resistance", "E12": "Interface capacitance", "E13": "Thermal noise",
    "E14": "Crossing lines", "C1": "No coupling, no current", "C3": "Smooth sliding", "C4": "Charge of the spikes",
    "C5": "Estimated errors",
}
HEAD = """# Verification results

Every row compares a figure with a closed form, an identity or an independent code; what each set holds the program to
is described in [Verification](verification.md). Made by `ionskin verify --csv FILE` on the machine that built these pages.

"""
NOTHING = HEAD + """The table was not there when these pages were built. `make docs` makes it; `ionskin verify` prints it
within minutes.
"""


def read(path):
    """Rows of the table, numbers as numbers."""
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        row.update({name: float(row[name]) for name in ("value", "reference", "tolerance")})
    return rows


def is_order(row):
    """An observed order of convergence, which must not be below its bound."""
    return "observed order" in row["quantity"]


def is_error(row):
    """A figure with a tolerance on its distance from the reference."""
    return row["tolerance"] > 0


def plot_orders(rows, path):
    """Observed orders of convergence beside the least that passes."""
    rows = [row for row in rows if is_order(row)]
    figure, axes = pyplot.subplots(figsize=(8, 0.8 + 0.45 * len(rows)), layout="constrained")
    places = range(len(rows))[::-1]
    axes.barh(places, [row["value"] for row in rows], color="#0072b2", height=0.55)
    for place, row in zip(places, rows):
        axes.plot([row["reference"]] * 2, [place - 0.36, place + 0.36], color="#d55e00", linewidth=2)
        axes.text(row["value"] + 0.03, place, f"{row['value']:.2f}", va="center")
    axes.set_yticks(places, [f"{row['id']}  {row['quantity']}" for row in rows])
    axes.set_xlim(0, 1.15 * max(row["value"] for row in rows))
    axes.set_xlabel("observed order (mark: least that passes)")
    figure.savefig(path)
    pyplot.close(figure)


def plot_margins(rows, path):
    """Plots the share of its tolerance that every figure uses, one dot a row."""
    names = list(dict.fromkeys(row["id"] for row in rows if is_error(row)))
    figure, axes = pyplot.subplots(figsize=(8, 0.9 + 0.3 * len(names)), layout="constrained")
    rows = list(filter(is_error, rows))
    shares = [max(abs(row["value"] - row["reference"]) / row["tolerance"], 1e-9) for row in rows]
    for row, share in zip(rows, shares):
        axes.plot(share, -names.index(row["id"]), "o", color="#0072b2" if row["verdict"] == "pass" else "#d55e00",
                  markersize=5, alpha=0.7)
    axes.axvline(1, color="#d55e00", linewidth=1.5)
    axes.set_xscale("log")
    axes.set_xlim(5e-10, 2 * max(10, *shares))
    axes.set_yticks([-i for i in range(len(names))], [f"{name}  {TITLES.get(name, '')}" for name in names])
    axes.grid(axis="x", alpha=0.3)
    axes.set_xlabel("distance from the reference over the tolerance")
    figure.savefig(path)
    pyplot.close(figure)


def number(value):
    """Seven digits, and no more zeros than needed."""
    return f"{value:.7g}" if math.isfinite(value) else "–"


def table(rows):
    """Markdown tables, one for every set."""
    parts = []
    for name in dict.fromkeys(row["id"] for row in rows):
        parts.append(f"\n## {name} {TITLES.get(name, '')}\n\n| quantity | value | reference | tolerance | verdict |\n"
                     "|---|--:|--:|--:|---|\n")
        for row in rows:
            if row["id"] == name:
                quantity = row["quantity"].replace("|", "\\|").replace("*", "\\*").replace("$", "\\$")
                parts.append(f"| {quantity} | {number(row['value'])} | {number(row['reference'])} "
                             f"| {number(row['tolerance'])} | {row['verdict']} |\n")
    return "".join(parts)


def verification(path, folder):
    """Writes the plots into the folder and returns the Markdown of the page."""
    if not path.exists():
        return NOTHING
    rows = read(path)
    plot_orders(rows, folder / "verification_orders.svg")
    plot_margins(rows, folder / "verification_margins.svg")
    passed = sum(row["verdict"] == "pass" for row in rows)
    return (HEAD + f"{passed} of {len(rows)} rows pass.\n\n"
            "![Observed orders of convergence](verification_orders.svg)\n\n"
            "Each dot is one figure; left of the line it is within its tolerance.\n\n"
            "![Distance from the reference over the tolerance](verification_margins.svg)\n" + table(rows))
