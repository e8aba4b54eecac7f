# SPDX-License-Identifier: Apache-2.0
"""Draws what ParaView shows of a run: python3 picture.py RUN/fields/fields.pvd picture.png [--time SECONDS]"""

import argparse

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.collections import PolyCollection
from vtu import read_collection, read_vtu


def middle_slice(grid, places, y):
    """Cells of hexahedra that hold y, as quadrilaterals along x and z [m]."""
    corners = places[grid["connectivity"]]
    low, high = corners[:, 0, 1], corners[:, 3, 1]
    chosen = (low <= y) & (y < high)
    return corners[chosen][:, [0, 1, 5, 4]][:, :, [0, 2]], chosen


def draw_section(axes, quadrilaterals, values, name, colours, limit):
    drawn = PolyCollection(quadrilaterals * [1e3, 1e6], array=values, cmap=colours, edgecolors="none")
    drawn.set_clim(-limit, limit)
    axes.add_collection(drawn)
    axes.set_ylabel("height [um]")
    axes.figure.colorbar(drawn, ax=axes, label=name)


def draw_layers(axes, files, y, scale):
    layers, slider = read_vtu(files["layers"]), read_vtu(files["slider"])
    section, chosen = middle_slice(layers, layers["Points"] + scale * layers["displacement"], y)
    stress = layers["stress"][chosen, 5] / 1e6
    draw_section(axes, section, stress, "shear stress xz [MPa]", "RdBu_r", np.percentile(np.abs(stress), 97))
    places = slider["Points"]
    row = places[np.isclose(places[:, 1], places[np.abs(places[:, 1] - y).argmin(), 1])]
    top = layers["Points"][:, 2].max()
    axes.plot(row[:, 0] * 1e3, (top + scale * (row[:, 2] - top)) * 1e6, color="black", label="slider")
    axes.set_title(f"Layers and slider, displacements {scale:.0f} times")
    axes.legend(loc="upper right")
    return section


def draw_core(axes, files, y):
    core = read_vtu(files["core"])
    section, chosen = middle_slice(core, core["Points"], y)
    potential = core["potential"][core["connectivity"][chosen]].mean(axis=1) * 1e3
    draw_section(axes, section, potential, "potential [mV]", "PuOr", np.percentile(np.abs(potential), 98))
    axes.set_title("Ions in the core")
    axes.set_xlabel("along the skin [mm]")


def draw_contact(axes, files):
    contact = read_vtu(files["contact"])
    quadrilaterals = contact["Points"][contact["connectivity"]][:, :, :2] * 1e3
    pressure = contact["pressure"] / 1e6
    drawn = PolyCollection(quadrilaterals, array=pressure, cmap="viridis", edgecolors="none")
    drawn.set_clim(0, np.percentile(pressure, 98))
    axes.add_collection(drawn)
    axes.set_aspect("equal")
    axes.autoscale_view()
    axes.set_ylabel("across [mm]")
    axes.figure.colorbar(drawn, ax=axes, label="pressure [MPa]")
    axes.set_title("Contact from above")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("collection", help="fields.pvd of a run")
    parser.add_argument("picture", help="file to draw")
    parser.add_argument("--time", type=float, default=None, help="instant of the run; the last with contact [s]")
    options = parser.parse_args()
    instants = [(time, files) for time, files in read_collection(options.collection) if {"core", "layers"} <= set(files)]
    if not instants:
        parser.error("no fields of core and layers: set output.fields, and run both studies")
    pressed = [entry for entry in instants if read_vtu(entry[1]["contact"])["pressure"].max() > 0] or instants
    time, files = pressed[-1] if options.time is None else min(instants, key=lambda entry: abs(entry[0] - options.time))
    contact = read_vtu(files["contact"])
    layers = read_vtu(files["layers"])
    y = layers["Points"][:, 1].max() / 2 - 1e-9
    largest = np.abs(layers["displacement"]).max()
    scale = 10 ** np.floor(np.log10(0.5 * layers["Points"][:, 2].max() / largest)) if largest > 0 else 1
    figure, axes = plt.subplots(3, 1, figsize=(8, 7.5), layout="constrained")
    draw_contact(axes[0], files)
    draw_layers(axes[1], files, y, scale)
    draw_core(axes[2], files, y)
    low, high = contact["Points"][:, 0].min() * 1e3, contact["Points"][:, 0].max() * 1e3
    margin, height = 0.4 * (high - low), layers["Points"][:, 2].max() * 1e6
    for panel in axes:
        panel.set_xlim(low - margin, high + margin)
    for panel in axes[1:]:
        panel.set_ylim(-0.05 * height, 1.3 * height)
    figure.suptitle(f"{time:g} s")
    figure.savefig(options.picture, dpi=100)


if __name__ == "__main__":
    main()
