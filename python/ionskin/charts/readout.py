# SPDX-License-Identifier: Apache-2.0
"""Figures of the readout of a run: voltage or reading of its circuit, map and signals of its taxels."""

import re

import numpy

from ..analysis import derived
from ..quantity import si
from ..words import quantity, short, si_scale
from ..reading.sliders import suffix
from .chart import Axis, Cell, Chart, Curve, Map, Note, Shape, current_axis, limits, phase_spans, with_events
from .colours import BLUE, GREEN, ORANGE, PURPLE, SEQUENCE, mixed
from .spans import peak_of

TAXEL = "current_top_"
VOLTAGE = "voltage_"  # of a taxel with a circuit of its own
NO_TAXELS = "the run has no taxels"
OPEN = "no current passes between open electrodes"
ROUNDING = "rounding alone makes it"  # the program's reason of a metric without an error
COLUMNS = 4  # of taxel panels side by side
MOST_TAXELS = 36  # panels that a page can hold
VALUE = re.compile(r"([-+.0-9e]+) (ohm|F|Hz)\b")
UNITS = {"ohm": "Ω"}


def circuit_words(results):
    """Readout circuit of a run in words; only its name in folders of earlier versions."""
    name = results.case.get("readout", {}).get("circuit", "short")
    words = results.circuit_words.get("words", f"{short(name, 20)} circuit")
    words = VALUE.sub(lambda match: quantity(float(match[1]), UNITS.get(match[2], match[2])), words)
    return words[:1].upper() + words[1:]


def is_open(results):
    """True for an open circuit, or a load so large that rounding alone flows through it, as through an open one."""
    rounding = results.summary.get("not_estimated", {}).get("rms_current_difference") == ROUNDING
    if rounding and results.circuit is not None and results.circuit.has("voltage"):
        return True
    return results.circuit_words.get("name", results.case.get("readout", {}).get("circuit")) == "open"


def passes_nothing(results):
    """True if all terminals are open, so that only rounding errors pass between top and bottom."""
    if not has_own_circuits(results):
        return is_open(results)
    return "current_top_rest" not in results.taxels and all(
        peak_of(results.taxels[name]) == 0 for name in results.taxels if name.startswith("current_circuit_"))


def carries_nothing(results):
    """True if neither electrode has a current above rounding: with open terminals, under a law that makes no net charge."""
    return passes_nothing(results) and results.sampled.has("current_common") and derived.common_is_noise(results)


def circuit_panel(results):
    """Title, vertical axis, curves and height of the cell's voltage, or of the amplifier's reading, over time."""
    table = results.circuit
    if table.has("voltage"):
        return circuit_words(results), Axis("voltage", "V"), [Curve(table["time"], table["voltage"], "", GREEN)], 1.0
    return circuit_words(results), current_axis(table["current"]), [Curve(table["time"], table["current"], "", PURPLE, width=0.8)], 1.0


def circuit(results):
    """Voltage over a load or of an open circuit, with the current that flows; the reading of an amplifier."""
    table = results.circuit
    if table is None:
        return None
    panels = [circuit_panel(results)]
    if table.has("voltage", "current") and peak_of(table["current"]) > 0 and not is_open(results):
        panels.append(("Current through it", Axis("current", "A"), [Curve(table["time"], table["current"], "", BLUE, "over", 0.9)], 1.0))
    return with_events(results, panels)


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


def is_crossbar(results):
    """True where the taxels are crossings of lines that are conductors, columns above and rows below."""
    grid = results.case.get("readout", {}).get("taxels", {})
    return isinstance(grid, dict) and grid.get("wiring") == "crossbar"


def has_own_circuits(results):
    """True where taxels are conductors with circuits of their own."""
    return results.taxels is not None and any(name.startswith("current_circuit_") for name in results.taxels)


def has_voltages(results):
    """True where taxels have voltages: circuits of their own that do not ground them all."""
    return results.taxels is not None and any(name.startswith(VOLTAGE) and peak_of(results.taxels[name]) > 0 for name in results.taxels)


def has_charges(results):
    """True where a charge passes into a taxel: not where all of them are open."""
    return any(peak_of(results.taxels[f"charge_top_{name}"]) > 0 for name in taxel_names(results) if name != "rest")


def taxel_map(results):
    """Map of the taxels on the skin; coloured by the charge that each moved during the run."""
    if results.taxels is None:
        return None
    if not has_charges(results):
        return "no charge passes into a taxel"
    return map_of(results, "charge_top_", "Largest charge of each taxel", "charge", "C")


def taxel_voltage_map(results):
    """Map of the taxels on the skin; coloured by the largest voltage of each."""
    return map_of(results, VOLTAGE, "Largest voltage of each taxel", "voltage", "V") if has_voltages(results) else None


def map_of(results, column, title, quantity_name, unit):
    """The skin from above, every taxel coloured by the largest magnitude of one of its columns."""
    places, names = rectangles(results), taxel_names(results)
    drawn = [name for name in names if name in places and results.taxels.has(column + name)]
    if not drawn:
        return "the case does not list the taxels' corners in a unit that this figure knows"
    moved = {name: peak_of(results.taxels[column + name]) for name in drawn}
    top = max(moved.values()) or 1.0
    divisor = si_scale(top)[0]
    corners = [places[name] for name in drawn]
    extent = [skin_size(results, "length", max(high[0] for _, high in corners)),
              skin_size(results, "width", max(high[1] for _, high in corners))]
    shapes, notes = [], []
    for name, (low, high) in zip(drawn, corners):
        outline = numpy.array([low, (high[0], low[1]), high, (low[0], high[1])])
        shapes.append(Shape([outline], mixed(SEQUENCE, moved[name] / top), "#ffffff", 1.0))
        if len(drawn) <= MOST_TAXELS:
            notes.append(Note(*(low + high) / 2, f"{short(name, 12)}\n{moved[name] / divisor:.3g}", "middle",
                              "#ffffff" if moved[name] < 0.6 * top else "#000000", 6.5, room=tuple((high - low).tolist())))
    bar = Map(numpy.empty(0), numpy.empty(0), numpy.empty((0, 0)), 0.0, top, quantity_name, unit)
    return Chart([[Cell(title, Axis("x", "m", 0.0, extent[0]), Axis("y", "m", 0.0, extent[1]), map=bar,
                        shapes=(*shapes, *slider_path(results)), notes=tuple(notes), equal=True)]])


def skin_size(results, name, otherwise):
    """A length of the skin [m]."""
    try:
        return si(results.case["skin"][name])
    except (KeyError, ValueError):
        return otherwise


def slider_path(results):
    """Dashed shapes of the paths of the sliders' centres, where they are known."""
    ways = []
    for number, case in enumerate(results.sliders):
        name = f"slider_x{suffix(number)}"
        try:
            y = si(case["slider"]["start"])[1]
        except (KeyError, ValueError, IndexError):
            return []
        direction = case.get("motion", {}).get("direction", [1, 0])
        if not results.signals.has(name) or (not direction[1:] == [0] and direction[1]):
            return []
        x = results.signals[name]
        ways.append(numpy.array([[numpy.nanmin(x), y], [numpy.nanmax(x), y]]))
    return [Shape(ways, None, ORANGE, 1.4, "dashed", "way of the slider's centre")]


def taxel_charges(results):
    """The charge of every taxel over time, one panel each, laid out and scaled alike."""
    if results.taxels is None:
        return None
    return panels_of(results, "charge_top_", "charge", "C") if has_charges(results) else "no charge passes into a taxel"


def taxel_voltages(results):
    """The voltage of every taxel over time, one panel each, laid out and scaled alike."""
    return panels_of(results, VOLTAGE, "voltage", "V") if has_voltages(results) else None


def panels_of(results, column, quantity_name, unit):
    """One column of every taxel over time, one panel each, laid out and scaled alike."""
    names = taxel_names(results)[:MOST_TAXELS]
    columns = taxel_columns(results, names)
    places = rectangles(results)
    if all(name in places for name in names):  # as on the map, y upwards
        names.sort(key=lambda name: (-round(float(places[name][0][1]), 9), float(places[name][0][0])))
    time, spans = results.signals["time"], phase_spans(results)
    curves = [Curve(results.taxels["time"], results.taxels[column + name], width=0.9) for name in names]
    low, high = limits(curves)
    cells = [Cell(short(name, 20), Axis("time" if place + columns >= len(names) else "", "s", time[0], time[-1]),
                  Axis("" if place % columns else quantity_name, unit, low, high), (curve,), spans, height=0.45)
             for place, (name, curve) in enumerate(zip(names, curves))]
    return Chart([cells[begin:begin + columns] for begin in range(0, len(cells), columns)], (1.0,) * columns, min(2, columns))


def taxel_columns(results, names):
    """Number of panels in a row: as many as taxels lie side by side, where that is known and fits."""
    places = rectangles(results)
    lefts = {round(float(places[name][0][0]), 9) for name in names if name in places}
    if 1 < len(lefts) <= 8 and len(names) % len(lefts) == 0:
        return len(lefts)
    return min(COLUMNS, len(names))
