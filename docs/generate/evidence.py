# SPDX-License-Identifier: Apache-2.0
"""The page "Model against measurement": table and plot of what benchmarks/evidence.py wrote."""

import json
import re

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402  the backend must be chosen first

COLOURS = {"agrees": "#0072b2", "disagrees": "#d55e00", "cannot be had": "#777777"}
HEAD = """# Model against measurement

What laboratories have measured on wet ionic polymers, beside what the law [`poroelastic`](model.md) says of it. No constant is
chosen by the signal: each has a source that is not the signal, or is varied over its range. Of most papers only the abstract
could be read, so that many rows compare a statement and not a curve; a number that was not read in its source is marked "from memory".
Nothing here tests the law `fixed-charge`, whose one coefficient has no measured value.

The cases are in `cases/evidence`; `benchmarks/evidence.py build/ionskin` runs them at `coarse` within a minute.

"""
NOTHING = HEAD + """The table was not there when these pages were built. `make docs` makes it.
"""
AFTER = """
## What the disagreements say

- **A steady voltage of the wrong sign.** Streaming and dilution have one sign in bending, whatever the constants, and a polymer that relaxes changes their
  size alone. Something drives the ions back that the law has not got, such as a potential of the electrodes' reactions.
- **No rise before the fall at 50 % humidity.** With the constants of drier Nafion dilution exceeds streaming, and the voltage falls from 0.1 Hz on. Drag and
  mobility of the water are each unsure by a factor of two or more there; or the resistance of the cell stands before the instrument, of which an impedance of the same strip would tell.
- **No effect of thickness.** The law says that voltage goes with thickness, and water's time with its square; relaxation of the polymer
  has a time without thickness. One strip in two thicknesses, bent and held, decides.
- **Pressed sensors give more than the law.** By a factor of PRESSED at least, if the pad is small and the cation lithium. Bending on a soft support comes first
  among what may be missing.
- **Thin gels answer faster than the square.** An indenter's pressure spreads with thickness; a contact of `cases/finger.toml`'s kind with a soft core would say how much of it that is.

## What would decide

Voltage per curvature of one strip in four cations and two thicknesses, kept wet, with the drag number by electro-osmosis, the modulus by bending, the
permeability by pressing water through and the double layers by impedance, all of the same strip. Before water moves the law has no
constant left: the voltage is $n_d V_w E h \\kappa/(3 v F)$ of a narrow strip. Changing the cation changes one number by a factor of six, and
the voltage with it; doubling the thickness doubles the voltage and quarters the rate of its decay. The numbers that it would be held against stand in
[a prediction before the measurement](prediction.md).

A polymer that relaxes makes the voltage decay, too, but with times of its own: two thicknesses tell the two apart. Here half of the shear modulus goes with 10 s,
a time that was not measured ([the law](model.md#a-polymer-that-relaxes)):

![Voltage over its peak as it decays](evidence_decays.svg)

Cha and Porfiri (2013, Phys. Rev. E 88) have a theory without a fitted coefficient, too: bending thins and crowds the ions, and the voltage is linear in
curvature with a coefficient of thickness and temperature alone, $R T h \\kappa/F$ in its limit (from memory), whatever the cation and
at any rate. The two laws part at once with the cation:

![Voltage over curvature of two laws](evidence_laws.svg)
"""


def escaped(text):
    return text.replace("|", "\\|").replace("$", "\\$").replace("~", "\\~")


def linked(source):
    """A source with its DOIs as links."""
    return re.sub(r"doi (10\.\d+/[^\s;,]+)", r"[doi \1](https://doi.org/\1)", escaped(source))


def summary(rows):
    """A Markdown table of the verdicts."""
    lines = ["| experiment | verdict |", "|---|---|"]
    return "\n".join(lines + [f"| {escaped(row['name'])} | {row['verdict']} |" for row in rows]) + "\n"


def sections(rows):
    """For each source what was measured, and what is computed."""
    parts = []
    for source in dict.fromkeys(row["source"] for row in rows):
        parts.append(f"\n**{linked(source)}**\n\n")
        for row in rows:
            if row["source"] == source:
                computed = f" Computed: {escaped(row['computed'])} (`{row['case']}`)." if row["computed"] else ""
                parts.append(f"- {escaped(row['name'])}: *{row['verdict']}*. Measured: {escaped(row['measured'])}.{computed} "
                             f"{escaped(row['remark'])}\n")
    return "".join(parts)


def plot(rows, path):
    """Computed over measured with the ranges of both, for rows with numbers."""
    rows = [row for row in rows if row["value"] is not None and row["measured_low"] is not None]
    figure, axes = pyplot.subplots(figsize=(8, 1.2 + 0.5 * len(rows)), layout="constrained")
    for place, row in zip(range(len(rows))[::-1], rows):
        low = row["measured_low"]
        high = row["measured_high"] or low
        middle = (low * high) ** 0.5
        computed = [one / middle for one in (row["low"] or row["value"], row["value"], row["high"] or row["value"])]
        axes.plot([low / middle, high / middle], [place] * 2, color="#bbbbbb", linewidth=10, solid_capstyle="butt")
        axes.plot([low / middle], [place], "|", color="#777777", markersize=14)
        axes.plot([computed[0], computed[2]], [place] * 2, color=COLOURS[row["verdict"]], linewidth=2.5)
        axes.plot(computed[1], place, "o", color=COLOURS[row["verdict"]], markersize=7)
    axes.set_yticks(range(len(rows))[::-1], [row["name"] for row in rows])
    axes.set_xscale("log")
    axes.set_ylim(-0.6, len(rows) - 0.4)
    axes.grid(axis="x", alpha=0.3)
    axes.set_xlabel("computed over measured (grey: measured)")
    figure.savefig(path)
    pyplot.close(figure)


def plot_laws(points, path):
    """Peak voltage over curvature by cation and thickness: streaming beside dilution alone."""
    ions = list(dict.fromkeys(point["ion"] for point in points))
    figure, axes = pyplot.subplots(figsize=(7, 3.6), layout="constrained")
    for thickness, marker in ((100e-6, "o"), (200e-6, "s")):
        some = [point for point in points if abs(point["thickness"] - thickness) < 1e-9]
        label = f"{1e6 * thickness:.0f} um"
        axes.plot([ions.index(point["ion"]) for point in some], [1e5 * point["streamed"] for point in some], marker + "-",
                  color="#0072b2", label=f"streaming and dilution (poroelastic), {label}")
        axes.plot([ions.index(point["ion"]) for point in some], [1e5 * point["diluted"] for point in some], marker + "--",
                  color="#d55e00", label=f"dilution alone, {label}")
    axes.set_xticks(range(len(ions)), ions)
    axes.set_ylim(0)
    axes.set_ylabel("peak voltage over curvature [uV m]")
    axes.legend(fontsize=8)
    figure.savefig(path)
    pyplot.close(figure)


def plot_decays(decays, path):
    """Voltage over its peak as it decays: by the water alone, and with a polymer that relaxes."""
    figure, axes = pyplot.subplots(figsize=(7, 3.6), layout="constrained")
    for decay in decays:
        axes.semilogx(decay["time"], decay["share"], "--" if decay["relaxes"] else "-",
                      color="#0072b2" if decay["thickness"] < 150e-6 else "#d55e00",
                      label=f"{1e6 * decay['thickness']:.0f} um, {'the polymer relaxes too' if decay['relaxes'] else 'water alone'}")
    axes.set_ylim(0)
    axes.set_xlabel("time since the bend [s]")
    axes.set_ylabel("voltage over its peak")
    axes.legend(fontsize=8)
    figure.savefig(path)
    pyplot.close(figure)


def evidence(path, folder):
    """Writes the plot into the folder and returns the Markdown of the page."""
    if not path.exists():
        return NOTHING
    found = json.loads(path.read_text(encoding="utf-8"))
    rows = found["rows"]
    plot(rows, folder / "evidence.svg")
    plot_laws(found["two_laws"], folder / "evidence_laws.svg")
    plot_decays(found["two_decays"], folder / "evidence_decays.svg")
    counts = {verdict: sum(row["verdict"] == verdict for row in rows) for verdict in COLOURS}
    count = (f"Of {len(rows)} rows {counts['agrees']} agree, {counts['disagrees']} disagree, and {counts['cannot be had']} cannot be had. "
             f"Runs state an error of {100 * found['largest_error']:.2g} % at most of the peaks that are compared.\n\n")
    picture = "\n## Row by row\n\n![Computed over measured values](evidence.svg)\n"
    pressed = next(row for row in rows if row["case"] == "pressed_pad")
    after = AFTER.replace("PRESSED", f"{pressed['measured_low'] / pressed['high']:.1f}")
    return HEAD + count + summary(rows) + picture + sections(rows) + after
