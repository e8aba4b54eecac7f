# SPDX-License-Identifier: Apache-2.0
"""Figure 19: ions through the thickness."""

import numpy

from .chart import Axis, Cell, Chart, Curve, limits
from .colours import SEQUENCE, mixed
from .fields import fields_of

PART = 0.03  # of the thickness beside a wall that is enlarged
FADE = 0.9  # of a palette: without its palest colours


def ions(results):
    """Concentration and potential through the thickness at the instants of the case's output.fields."""
    if not results.signals.has("current_top") or fields_of(results) is None:
        return None
    with fields_of(results) as file:
        instants = sorted((name for name in file.get("ions", {}) if name != "grid"), key=float)
        if not instants:
            return "the case asks for no fields: set output.fields"
        grid = file["ions/grid"]
        z = grid["z"][...]
        column = loaded_column(file, instants)
        initial = file["ions"][instants[0]]["concentration"][0].mean()
        concentrations, potentials = [], []
        for place, name in enumerate(instants):
            label, colour = f"{float(name):g} s", mixed(SEQUENCE, FADE * place / max(1, len(instants) - 1))
            state = file["ions"][name]
            concentrations.append(Curve(z, state["concentration"][0][:, column[0], column[1]] / initial, label, colour, width=1.0))
            potentials.append(Curve(z, state["potential"][0][:, column[0], column[1]], label, colour, width=1.0))
        centre = [(edges[i] + edges[i + 1]) / 2 * 1e3
                  for edges, i in ((grid["x"][...], column[1]), (grid["y"][...], column[0]))]
    rows = []
    for name, unit, curves in (("concentration c / mean", "1", concentrations), ("potential φ", "V", potentials)):
        low, high = limits(curves)
        rows.append([Cell(words if not rows else "", Axis("height in the core" if rows else "", "m", *ends),
                          Axis(name if words == "bottom wall" else "", unit, low, high), tuple(curves), height=1.0, legend=False)
                     for words, ends in (("bottom wall", (0.0, PART * z[-1])), ("whole core", (0.0, z[-1])),
                                         ("top wall", ((1 - PART) * z[-1], z[-1])))])
    rows[0][1] = rows[0][1]._replace(legend=True)
    return Chart(rows, (1.0, 1.4, 1.0), note=f"Column at x = {centre[0]:.3g} mm, y = {centre[1]:.3g} mm, where the potential deviates "
                                             "most.")


def loaded_column(file, instants):
    """Index (y, x) of the column whose potential deviates most over the chosen instants."""
    largest = None
    for name in instants:
        amplitude = numpy.abs(file["ions"][name]["potential"][0]).max(axis=0)
        largest = amplitude if largest is None else numpy.maximum(largest, amplitude)
    return numpy.unravel_index(int(largest.argmax()), largest.shape)
