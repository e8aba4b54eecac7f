# SPDX-License-Identifier: Apache-2.0
"""The potential along electrodes whose metal has a sheet resistance."""

import numpy

from .chart import Axis, Cell, Chart, Curve, Map, limits
from .colours import SEQUENCE, mixed
from .fields import fields_of
from .ions import FADE


def has_metal(results):
    """True where the potential varies along an electrode."""
    return "peak_metal_drop" in results.metrics


def walls(results):
    """Edges x and y [m], instants [s], potential of the bottom and of the top metal [instant][y][x]; None without fields."""
    file = fields_of(results)
    if file is None:
        return None
    with file:
        instants = sorted((name for name in file.get("ions", {}) if name != "grid"), key=float)
        if not instants:
            return None
        x, y = (file["ions/grid"][axis][...] for axis in ("x", "y"))
        bottom, top = (numpy.array([file["ions"][name]["potential"][0, wall] for name in instants]) for wall in (0, -1))
    return x, y, [float(name) for name in instants], bottom, top


def potential(results):
    """Along both metals at mid-width at the instants of output.fields, and from above where the top one differs most."""
    if not has_metal(results):
        return None
    found = walls(results)
    if found is None:
        return "the case asks for no fields: set output.fields"
    x, y, instants, *metals = found
    rows_y, centres = len(y) - 1, 0.5 * (x[1:] + x[:-1])
    rows = []
    for words, metal in zip(("bottom metal", "top metal"), metals):
        along = 0.5 * (metal[:, rows_y // 2] + metal[:, (rows_y - 1) // 2])  # mid-width lies in a column or between two
        curves = tuple(Curve(centres, values, f"{instant:g} s", mixed(SEQUENCE, FADE * place / max(1, len(instants) - 1)), width=1.2)
                       for place, (instant, values) in enumerate(zip(instants, along)))
        low, high = limits(curves)
        rows.insert(0, [Cell(f"{words}, at mid-width", Axis("along the skin" if words == "bottom metal" else "", "m", x[0], x[-1]),
                             Axis("potential", "V", low, high), curves, height=0.9, legend=words == "top metal")])
    top = metals[1]
    place = int(numpy.ptp(top.reshape(len(instants), -1), axis=1).argmax())
    if rows_y > 1:
        seen = Map(x, y, top[place], float(top[place].min()), float(top[place].max()), "potential", "V")
        rows.append([Cell(f"top metal from above at {instants[place]:g} s", Axis("along the skin", "m", x[0], x[-1]),
                          Axis("across", "m", y[0], y[-1]), map=seen, height=0.5)])
    return Chart(rows)
