# SPDX-License-Identifier: Apache-2.0
"""Figures of the water of the law poroelastic: voltage and its parts, pressure through the core and between its
walls."""

import numpy

from ..words import quantity
from .chart import Axis, Cell, Chart, Curve, Map, with_events
from .colours import BLUE, DIVERGING, GREEN, ORANGE, PURPLE
from .fields import fields_of
from .spans import peak_of

MOST = 5  # instants that a figure shows


def voltage(results):
    """Open-circuit voltage over time with its parts, and the pressure at the walls behind it."""
    water = results.water
    if water is None:
        return None
    time = water["time"]
    held = [("Pressure that holds the compression", Axis("pressure", "Pa"), [Curve(time, water[name], "", PURPLE)], 0.9)
            for name in ("holding_pressure",) if water.has(name)]
    return with_events(results, [
        ("Open-circuit voltage", Axis("voltage", "V"),
         [Curve(time, water["streaming_voltage"], "streaming", BLUE, width=0.9),
          Curve(time, water["dilution_voltage"], "dilution", ORANGE, width=0.9),
          Curve(time, water["open_circuit_voltage"], "both", GREEN, band=results.band("water", "open_circuit_voltage"))], 1.1),
        ("Water pressure at the walls, mean over the area", Axis("pressure", "Pa"),
         [Curve(time, water["pore_pressure_top"], "top wall"),
          Curve(time, water["pore_pressure_bottom"], "bottom wall", ORANGE, width=0.8)], 0.9),
        ("Top minus bottom: what the whole electrode sees", Axis("difference", "Pa"),
         [Curve(time, water["pressure_difference"], "", PURPLE)], 0.9),
        *held])


def water_fields(results):
    """Edges x, y and nodes z [m], instants [s], pressure and swelling [instant][z][y][x]; None without fields of water."""
    file = fields_of(results)
    if file is None:
        return None
    with file:
        instants = sorted((name for name in file.get("ions", {}) if name != "grid"), key=float)
        instants = [name for name in instants if "pore_pressure" in file["ions"][name]]
        if not instants:
            return None
        kept = [instants[i] for i in numpy.unique(numpy.linspace(0, len(instants) - 1, min(MOST, len(instants))).round())
                .astype(int)]
        fields = [[file["ions"][name][field][0] for name in kept] for field in ("pore_pressure", "swelling")]
        grid = [file["ions/grid"][axis][...] for axis in ("x", "y", "z")]
    return *grid, [float(name) for name in kept], *map(numpy.array, fields)


def about_zero(x, y, values, unit):
    """A map in colours of both signs."""
    largest = peak_of(values) or 1.0
    return Map(x, y, values, -largest, largest, "", unit, DIVERGING)


def section(results):
    """Water pressure and swelling on a section along the skin at mid-width, at the instants of output.fields."""
    fields = water_fields(results)
    if fields is None or len(fields[0]) <= 2:
        return None
    x, _, z, instants, pressure, swelling = fields
    middle, rows = pressure.shape[2] // 2, []
    for place, instant in enumerate(instants):
        along, height = Axis("along the skin" if place == len(instants) - 1 else "", "m", x[0], x[-1]), Axis("height", "m", z[0], z[-1])
        cells = []
        for field, words, unit in ((pressure, "water pressure P", "Pa"), (swelling, "swelling (P − p_u)/M", "1")):
            values = field[place, :, middle]
            cells.append(Cell(f"{words} at {instant:g} s", along, height if not cells else height._replace(name=""),
                              map=about_zero(x, z, 0.5 * (values[1:] + values[:-1]), unit), height=0.45))
        rows.append(cells)
    return Chart(rows, (1.0, 1.0))


def wall_difference(results):
    """Water pressure at the top wall minus that at the bottom one, seen from above."""
    fields = water_fields(results)
    if fields is None or len(fields[0]) <= 2 or len(fields[1]) <= 2:
        return None
    x, y, _, instants, pressure, _ = fields
    rows = []
    for place, (instant, field) in enumerate(zip(instants, pressure)):
        difference = field[-1] - field[0]
        rows.append([Cell(f"{instant:g} s; mean {quantity(difference.mean(), 'Pa', 3)}",
                          Axis("along the skin" if place == len(instants) - 1 else "", "m", x[0], x[-1]),
                          Axis("across", "m", y[0], y[-1]), map=about_zero(x, y, difference, "Pa"), height=0.45)])
    return Chart(rows)
