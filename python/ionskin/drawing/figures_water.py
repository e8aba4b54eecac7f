# SPDX-License-Identifier: Apache-2.0
"""What the water of the law poroelastic does: voltage and its parts, pressure through the core and between its walls."""

import numpy

from ..words import quantity
from . import event_panels, style
from .figures_fields import fields_of
from .panels import error_band, peak_of, scaled, scaled_label

MOST = 5  # instants that a figure shows


def voltage(results):
    """Open-circuit voltage over time with its parts, and the pressure at the walls behind it."""
    water = results.water
    if water is None:
        return None
    time = water["time"]
    figure, axes = event_panels.rows(results, [1.1, 0.9, 0.9], left=0.125)
    total = water["open_circuit_voltage"]
    volt = scaled(axes[0], "voltage", "V", peak_of(total, water["streaming_voltage"], water["dilution_voltage"]))
    error_band(axes[0], results, "water", "open_circuit_voltage", volt, style.GREEN)
    axes[0].plot(time, water["streaming_voltage"] / volt, color=style.BLUE, lw=0.9, label="streaming")
    axes[0].plot(time, water["dilution_voltage"] / volt, color=style.ORANGE, lw=0.9, label="dilution")
    axes[0].plot(time, total / volt, color=style.GREEN, label="both")
    style.title(axes[0], "Open-circuit voltage")
    style.legend(axes[0])
    pascal = scaled(axes[1], "pressure", "Pa", peak_of(water["pore_pressure_top"], water["pore_pressure_bottom"]))
    axes[1].plot(time, water["pore_pressure_top"] / pascal, color=style.BLUE, label="top wall")
    axes[1].plot(time, water["pore_pressure_bottom"] / pascal, color=style.ORANGE, lw=0.8, label="bottom wall")
    style.title(axes[1], "Water pressure at the walls, mean over the area")
    style.legend(axes[1])
    difference = scaled(axes[2], "difference", "Pa", peak_of(water["pressure_difference"]))
    axes[2].plot(time, water["pressure_difference"] / difference, color=style.PURPLE)
    style.title(axes[2], "Top minus bottom: what the whole electrode sees")
    event_panels.finish(results, axes)
    return figure


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


def colour_bar(figure, panel, image, unit, largest):
    """A bar with its ends and its middle; returns their unit in brackets."""
    divisor, label = scaled_label("", unit, largest)
    bar = figure.colorbar(image, ax=panel, pad=0.02)
    bar.set_ticks([-largest, 0, largest], labels=[f"{tick / divisor:.3g}" for tick in (-largest, 0, largest)])
    return label.strip()


def section(results):
    """Water pressure and swelling on a section along the skin at mid-width, at the instants of output.fields."""
    fields = water_fields(results)
    if fields is None or len(fields[0]) <= 2:
        return None
    x, _, z, instants, pressure, swelling = fields
    middle = pressure.shape[2] // 2
    figure = style.canvas(height=0.45 + 0.85 * len(instants), left=0.09, right=0.99, top=0.93 if len(instants) > 1 else 0.8,
                          bottom=0.42 / (0.45 + 0.85 * len(instants)), hspace=0.35, wspace=0.12)
    panels = figure.subplots(len(instants), 2, sharex=True, sharey=True, squeeze=False)
    for column, (field, words, unit) in enumerate(((pressure, "water pressure P", "Pa"), (swelling, "swelling (P − p_u)/M", "1"))):
        for row, instant in enumerate(instants):
            panel = panels[row, column]
            values = field[row, :, middle]
            middles = 0.5 * (values[1:] + values[:-1])
            largest = peak_of(values) or 1.0
            image = panel.pcolormesh(x * 1e3, z * 1e6, middles, cmap=style.DIVERGING, vmin=-largest, vmax=largest,
                                     rasterized=True)
            panel.grid(False)
            style.title(panel, f"{words} {colour_bar(figure, panel, image, unit, largest)} at {instant:g} s")
    for panel in panels[-1]:
        panel.set_xlabel("along the skin [mm]")
    for panel in panels[:, 0]:
        panel.set_ylabel("height [µm]")
    return figure


def wall_difference(results):
    """Water pressure at the top wall minus that at the bottom one, seen from above."""
    fields = water_fields(results)
    if fields is None or len(fields[0]) <= 2 or len(fields[1]) <= 2:
        return None
    x, y, _, instants, pressure, _ = fields
    height = 0.45 + 0.85 * len(instants)
    figure = style.canvas(height=height, left=0.09, right=0.99, top=0.93 if len(instants) > 1 else 0.8, bottom=0.42 / height,
                          hspace=0.4)
    panels = figure.subplots(len(instants), 1, sharex=True, squeeze=False)[:, 0]
    for panel, instant, field in zip(panels, instants, pressure):
        difference = field[-1] - field[0]
        largest = peak_of(difference) or 1.0
        image = panel.pcolormesh(x * 1e3, y * 1e3, difference, cmap=style.DIVERGING, vmin=-largest, vmax=largest,
                                 rasterized=True)
        panel.grid(False)
        unit = colour_bar(figure, panel, image, "Pa", largest)
        style.title(panel, f"{instant:g} s {unit}; mean {quantity(difference.mean(), 'Pa', 3)}")
        panel.set_ylabel("across [mm]")
    panels[-1].set_xlabel("along the skin [mm]")
    return figure
