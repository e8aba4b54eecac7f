# SPDX-License-Identifier: Apache-2.0
"""Draws what `stroke` printed, and the scene above it: plot.py stroke.csv stroke.png [scene.ppm]"""

import csv
import sys

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402


def trailing_means(values, count):
    """Means of each value and the `count` - 1 before it [µA]."""
    means = []
    for i in range(len(values)):
        last = values[max(0, i + 1 - count):i + 1]
        means.append(1e6 * sum(last) / len(last))
    return means


def main(table, picture, scene=None):
    with open(table, encoding="utf-8") as file:
        rows = list(csv.reader(file))
    columns = {name: [float(row[i]) for row in rows[1:]] for i, name in enumerate(rows[0])}
    time = columns["time [s]"]
    # Narrow, so that the letters can be read where a telephone shows it at 330 pixels.
    pyplot.rcParams.update({"font.size": 9, "legend.fontsize": 9})
    whole = pyplot.figure(figsize=(4, 6.0 if scene is None else 7.6), layout="constrained")
    figure = whole
    if scene is not None:
        above, figure = whole.subfigures(2, height_ratios=[2, 7])
        axes = above.subplots()
        axes.imshow(pyplot.imread(scene))
        axes.axis("off")
    force, share, current = figure.subplots(3, sharex=True, height_ratios=[2, 1, 2.4])
    force.plot(time, columns["contact_force [N]"], label="normal, MuJoCo", color="0.6", linewidth=3)
    force.plot(time, columns["normal_force [N]"], label="normal, skin", color="C0", linestyle="--")
    force.plot(time, columns["tangential_force_x [N]"], label="tangential, skin", color="C1")
    force.set_ylabel("force [N]")
    place = force.twinx()
    place.plot(time, [1e3 * x for x in columns["x [m]"]], color="C2", linestyle=":")
    place.set_ylabel("finger at x [mm]", color="C2")
    share.plot(time, columns["stick_share"], color="C3")
    share.set_ylabel("stick share")
    # Where the finger begins to slide, a peak of some milliseconds stands far above all that follows.
    for name, values in columns.items():
        if name.startswith("current_"):
            current.plot(time, trailing_means(values, 50), label=name.removesuffix(" [A]").removeprefix("current_").replace("_", " "))
    current.set_yscale("symlog", linthresh=10)
    current.set_ylabel("current [µA], mean of 50 ms")
    current.set_xlabel("time [s]")
    for axes, ncols in ((force, 2), (current, 4)):
        axes.legend(loc="lower right", bbox_to_anchor=(1, 1), frameon=False, ncols=ncols, handlelength=1.2, columnspacing=0.8,
                    borderaxespad=0)
    whole.savefig(picture, dpi=200)


if __name__ == "__main__":
    main(*sys.argv[1:])
