# SPDX-License-Identifier: Apache-2.0
"""What the readout of a run shows: voltage or reading of its circuit, map and signals of its taxels."""

import re

import numpy
from matplotlib.patches import Rectangle

from ..quantity import si
from ..words import quantity, short
from . import event_panels, style
from .panels import STEP, peak_of, scaled, signed_log_axis, time_axis

TAXEL = "current_top_"
NO_TAXELS = "the run has no taxels"
COLUMNS = 4  # of taxel panels side by side
MOST_TAXELS = 36  # panels that a page can hold
VALUE = re.compile(r"([-+.0-9e]+) (ohm|F|Hz)\b")
UNITS = {"ohm": "Ω"}


def circuit_words(results):
    """The readout circuit in words, as the run says it; its name in folders of earlier versions."""
    name = results.case.get("readout", {}).get("circuit", "short")
    words = results.circuit_words.get("words", f"{short(name, 20)} circuit")
    words = VALUE.sub(lambda match: quantity(float(match[1]), UNITS.get(match[2], match[2])), words)
    return words[:1].upper() + words[1:]


def circuit_panel(panel, results):
    """The voltage of the cell, or the reading of the amplifier, over time."""
    table = results.circuit
    if table.has("voltage"):
        divisor = scaled(panel, "voltage", "V", peak_of(table["voltage"]))
        panel.plot(table["time"], table["voltage"] / divisor, color=style.GREEN)
    else:
        panel.plot(table["time"], table["current"], color=style.PURPLE, lw=0.8)
        signed_log_axis(panel, "A", peak_of(table["current"]))
        panel.set_ylabel("current")
    style.title(panel, circuit_words(results))


def circuit(results):
    """Voltage over a load or of an open circuit, with the current that flows; the reading of an amplifier."""
    table = results.circuit
    if table is None:
        return None
    loaded = table.has("voltage", "current") and peak_of(table["current"]) > 0
    figure, axes = event_panels.rows(results, [1.0] * (2 if loaded else 1), left=0.125)
    circuit_panel(axes[0], results)
    if loaded:
        unit = scaled(axes[1], "current", "A", peak_of(table["current"]))
        axes[1].plot(table["time"], table["current"] / unit, color=style.BLUE, lw=0.9, **STEP)
        style.title(axes[1], "Current through it")
    event_panels.finish(results, axes)
    return figure


def taxel_names(results):
    """Names of the taxels in the order of the file."""
    return [name.removeprefix(TAXEL) for name in results.taxels if name.startswith(TAXEL)]


def grid_rectangles(grid, skin):
    """Corners of a grid of equal taxels over the whole skin by name, as ionskin lays them [m]."""
    count = numpy.array([int(grid["columns"]), int(grid["rows"])])
    gap = si(grid.get("gap", "0 m"))
    size = (numpy.array([si(skin["length"]), si(skin["width"])]) - (count - 1) * gap) / count
    corner = {(row, column): numpy.array([column, row]) * (size + gap) for row in range(count[1]) for column in range(count[0])}
    return {f"r{row + 1}c{column + 1}": numpy.array([low, low + size]) for (row, column), low in corner.items()}


def rectangles(results):
    """Lower and upper corner of each named taxel [m]; without those whose unit is not known here."""
    found = {}
    taxels = results.case.get("readout", {}).get("taxels", [])
    if isinstance(taxels, dict):
        try:
            return grid_rectangles(taxels, results.case["skin"])
        except (KeyError, ValueError, TypeError):
            return found
    for taxel in taxels:
        try:
            found[taxel["name"]] = numpy.array([si(taxel["lower"]), si(taxel["upper"])])
        except (KeyError, ValueError):
            continue
    return found


def taxel_map(results):
    """Where the taxels lie on the skin; coloured by the charge that each moved during the run."""
    if results.taxels is None:
        return None
    places, names = rectangles(results), taxel_names(results)
    drawn = [name for name in names if name in places]
    if not drawn:
        return "the case does not list the taxels' corners in a unit that this figure knows"
    moved = {name: peak_of(results.taxels[f"charge_top_{name}"]) for name in drawn}
    divisor, prefix = style.si_scale(max(moved.values()))
    corners = numpy.array([places[name] for name in drawn]) * 1e3
    extent = numpy.array([skin_size(results, "length", corners[:, 1, 0].max()),
                          skin_size(results, "width", corners[:, 1, 1].max())])
    height = float(numpy.clip(5.6 * extent[1] / extent[0], 1.0, 4.5)) + 0.75
    figure = style.canvas(height=height, left=0.085, right=0.91, top=1 - 0.30 / height, bottom=0.42 / height)
    axes = figure.add_subplot()
    top = max(moved.values()) / divisor or 1.0
    colours = style.matplotlib.cm.ScalarMappable(style.matplotlib.colors.Normalize(0, top), style.SEQUENCE)
    for name, (low, high) in zip(drawn, corners):
        value = moved[name] / divisor
        axes.add_patch(Rectangle(low, *(high - low), facecolor=colours.to_rgba(value), edgecolor="white", lw=1.0))
        if len(drawn) <= MOST_TAXELS:
            axes.text(*(low + high) / 2, f"{short(name, 12)}\n{value:.3g}", ha="center", va="center", fontsize=6.5,
                      color="white" if value < 0.6 * top else "black")
    slider_path(axes, results)
    axes.set(xlim=(0, extent[0]), ylim=(0, extent[1]), xlabel="x [mm]", ylabel="y [mm]", aspect="equal")
    axes.grid(False)
    style.title(axes, "Largest charge of each taxel")
    figure.colorbar(colours, ax=axes, pad=0.02, fraction=0.03).set_label(f"charge [{prefix}C]")
    return figure


def skin_size(results, name, otherwise):
    """A length of the skin [mm]."""
    try:
        return 1e3 * si(results.case["skin"][name])
    except (KeyError, ValueError):
        return otherwise


def slider_path(axes, results):
    """The way of the slider's centre, dashed, where it is known."""
    try:
        y = 1e3 * si(results.case["slider"]["start"])[1]
    except (KeyError, ValueError, IndexError):
        return
    direction = results.case.get("motion", {}).get("direction", [1, 0])
    if results.signals.has("slider_x") and not direction[1:] == [0] and direction[1]:
        return
    if results.signals.has("slider_x"):
        x = results.signals["slider_x"] * 1e3
        axes.plot([numpy.nanmin(x), numpy.nanmax(x)], [y, y], color=style.ORANGE, lw=1.4, ls=(0, (4, 2)),
                  label="way of the slider's centre")
        axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), borderaxespad=0.1, handlelength=2.4)


def taxel_charges(results):
    """The charge of every taxel over time, one panel each, laid out and scaled alike."""
    if results.taxels is None:
        return None
    names = taxel_names(results)[:MOST_TAXELS]
    columns = taxel_columns(results, names)
    places = rectangles(results)
    if all(name in places for name in names):  # as on the map, y upwards
        names.sort(key=lambda name: (-round(float(places[name][0][1]), 9), float(places[name][0][0])))
    rows = -(-len(names) // columns)
    height = 0.78 * rows + 0.85
    figure = style.canvas(height=height, left=0.095, right=0.985, top=1 - 0.26 / height, bottom=0.42 / height,
                          hspace=0.42, wspace=0.12)
    panels = figure.subplots(rows, columns, sharex=True, sharey=True, squeeze=False)
    values = [results.taxels[f"charge_top_{name}"] for name in names]
    divisor, prefix = style.si_scale(peak_of(*values))
    for panel, name, charge in zip(panels.ravel(), names, values):
        panel.plot(results.taxels["time"], charge / divisor, color=style.BLUE, lw=0.9)
        panel.set_title(short(name, 20), loc="left", fontsize=7, pad=2)
    for panel in panels.ravel()[len(names):]:
        panel.set_visible(False)
    time_axis(results, list(panels.ravel()))
    panels.ravel()[-1].set_xlabel("")
    figure.supxlabel("time [s]", fontsize=8, y=0.02 / height)
    figure.supylabel(f"charge [{prefix}C]", fontsize=8, x=0.005)
    return figure


def taxel_columns(results, names):
    """As many panels in a row as taxels lie side by side, where that is known and fits."""
    places = rectangles(results)
    lefts = {round(float(places[name][0][0]), 9) for name in names if name in places}
    if 1 < len(lefts) <= 8 and len(names) % len(lefts) == 0:
        return len(lefts)
    return min(COLUMNS, len(names))
