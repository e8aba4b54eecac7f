# SPDX-License-Identifier: Apache-2.0
"""Charts: contents of figures as plain data in SI units, which the script of a page or `drawing.draw_chart` draws."""

from typing import NamedTuple

import numpy

from .colours import BLUE, INK, QUIET, SEQUENCE
from .spans import CONTACT_PHASES, contact_spans, peak_of, windows

WHOLE = 2.3  # width of the whole run over that of a window


class Axis(NamedTuple):
    """Axis of a cell.

    name       name of the quantity in words; "" where the cell below or to the left shows it
    unit       SI unit; "1" for pure numbers
    low, high  ends of the axis, in the unit; None for the ends of the data
    origin     value that is shown as 0
    signed     largest magnitude of a symmetric logarithmic axis; 0 for any other axis
    log        True for a logarithmic axis of positive values
    """

    name: str = ""
    unit: str = "1"
    low: float | None = None
    high: float | None = None
    origin: float = 0.0
    signed: float = 0.0
    log: bool = False


class Curve(NamedTuple):
    """Curve of y over x, arrays of one length in the units of the cell's axes.

    label   name in the legend; "" for none
    step    "": straight lines between values; "over": y is the mean over the step that ends at its x; "held": y is read at
            its x, and shown until the next value
    width   width of the line [pt]
    look    "": solid; "dashed", "dotted"; "none": marks only
    marks   True to mark each value; a page leaves out marks that would touch
    band    arrays of the lower and upper end of y's error band; None without one
    """

    x: numpy.ndarray
    y: numpy.ndarray
    label: str = ""
    colour: str = BLUE
    step: str = ""
    width: float = 1.2
    look: str = ""
    marks: bool = False
    band: tuple | None = None


class Span(NamedTuple):
    """Coloured band behind the curves of a cell, between two values on the axis `along`, "x"
    or "y"; `label` is its name in the legend."""

    low: float
    high: float
    colour: str
    along: str = "x"
    label: str = ""


class Mark(NamedTuple):
    """Line across a cell at a value on the axis `along`, "x" or "y".

    look   as for a Curve
    label  name in the legend; "" for none
    words  text beside the line
    """

    at: float
    look: str = "dashed"
    along: str = "x"
    label: str = ""
    words: str = ""


class Map(NamedTuple):
    """Colour map of values [y][x] in the cells between the edges x and y; NaN for cells without a value.

    low, high   values of the first and the last colour of the palette
    name, unit  name and SI unit of the values, for the colour bar
    beyond      True if values above `high` exist
    smooth      True if x and y are nodes, not edges, and values between them are interpolated
    classes     dict of colour to name, for values that are indices into it; a legend replaces the colour bar then
    lines       arrays [point, (x, y)] of white lines over the map
    ticks       pairs of value and words, in place of the usual ticks of the colour bar
    """

    x: numpy.ndarray
    y: numpy.ndarray
    values: numpy.ndarray
    low: float = 0.0
    high: float = 1.0
    name: str = ""
    unit: str = "1"
    palette: str = SEQUENCE
    beyond: bool = False
    smooth: bool = False
    classes: dict = {}
    lines: tuple = ()
    ticks: tuple = ()


class Shape(NamedTuple):
    """Part of a drawing: outlines, a list of arrays [point, (x, y)], with the colours of
    filling and edge; None for no filling or edge."""

    outlines: list
    fill: str | None = None
    edge: str | None = INK
    width: float = 0.4
    look: str = ""
    label: str = ""


class Note(NamedTuple):
    """Text at a point (x, y) of a cell.

    anchor  part of the text that lies at x: "start", "middle" or "end"; lines of the text are centred about y
    size    size of the letters [pt]
    boxed   True for a box about the text
    room    width and height, in the units of the axes, within which a page keeps the text by leaving out its first lines;
            (0, 0) for no bound
    """

    x: float
    y: float
    words: str
    anchor: str = "start"
    colour: str = INK
    size: float = 7.5
    boxed: bool = False
    room: tuple[float, float] = (0.0, 0.0)


class Cell(NamedTuple):
    """Cell of a chart: one pair of axes with its curves, bands, lines, map, shapes and notes.

    phases  notes along the upper edge; only their x is used
    height  height relative to the usual one
    legend  True to name the curves above the cell
    equal   True for one scale of x and y
    bare    True for neither axes nor grid
    """

    title: str
    x: Axis
    y: Axis
    curves: tuple = ()
    spans: tuple = ()
    marks: tuple = ()
    map: Map | None = None
    shapes: tuple = ()
    notes: tuple = ()
    phases: tuple = ()
    height: float = 1.0
    legend: bool = True
    equal: bool = False
    bare: bool = False


class Chart(NamedTuple):
    """Chart: the cells of one figure, in rows.

    rows    list of rows, each a list of Cell
    widths  relative widths of the columns
    narrow  number of columns on a narrow screen
    note    sentence below the figure; "" for none
    """

    rows: list
    widths: tuple = (1.0,)
    narrow: int = 1
    note: str = ""


def phase_spans(results, offset=0.0, cycle=None, named=False):
    """Bands that mark the phases of contact, darker while the slider slides, as a tuple of Span.

    offset  time that is subtracted from the instants [s]
    cycle   number of the cycle; None for all
    named   True to explain the bands in the legend
    """
    names = {"touchdown": "touching", "slide": "sliding"} if named else {}
    return tuple(Span(span.start - offset, span.end - offset, CONTACT_PHASES[span.phase], "x", names.pop(span.phase, ""))
                 for span in contact_spans(results) if span.phase in CONTACT_PHASES and (cycle is None or span.cycle == cycle))


def limits(curves, signed=0.0):
    """Lower and upper end of an axis that several cells share, with room about the curves;
    (None, None) for a symmetric logarithmic axis."""
    values = [part for curve in curves for part in (curve.y, *(curve.band or ()))]
    if signed or not values:
        return None, None
    found = numpy.concatenate(values)
    found = found[numpy.isfinite(found)]
    low, high = (float(found.min()), float(found.max())) if len(found) else (0.0, 0.0)
    room = 0.06 * (high - low) or 0.06 * abs(high) or 1.0
    return low - room, high + room


def over_time(results, panels):
    """Chart of signals over the whole run, with one row for each panel (title, y axis, curves, height), from the top."""
    time, spans = results.signals["time"], phase_spans(results)
    return Chart([[Cell(title, Axis("time" if place == len(panels) - 1 else "", "s", time[0], time[-1]), y, tuple(curves), spans,
                        height=height)] for place, (title, y, curves, height) in enumerate(panels)])


def with_events(results, panels, span=None):
    """Chart of signals over the whole run, with the milliseconds about begin and end of the first contact enlarged
    beside it.

    panels  list of (title, y axis, curves, height), from the top
    span    begin and end of the first column [s]; None for the whole run
    """
    time, spans, found = span or results.signals["time"], phase_spans(results), windows(results)
    rows = []
    for place, (title, y, curves, height) in enumerate(panels):
        low, high = limits(curves, y.signed) if y.low is None else (y.low, y.high)
        y, last = y._replace(low=low, high=high), place == len(panels) - 1
        whole = Cell(title, Axis("time" if last else "", "s", time[0], time[-1]), y, tuple(curves), spans, height=height)
        rows.append([whole, *(Cell(words if place == 0 else "",
                                   Axis(f"time from {instant:.5g} s" if last else "", "s", begin, end, instant),
                                   y._replace(name=""), tuple(curves), spans, height=height, legend=False)
                              for begin, end, instant, words in found)])
    return Chart(rows, (WHOLE, *[1.0] * len(found)))


def current_axis(*columns):
    """Symmetric logarithmic axis for the given columns of currents [A]."""
    return Axis("current", "A", signed=peak_of(*columns) or 1.0)


COINCIDE = 0.006  # of the height of a cell: about the width of a line


def heights(axis, values):
    """Heights, on a linear scale of any unit, at which an axis shows values."""
    with numpy.errstate(divide="ignore", invalid="ignore"):
        if axis.log:
            return numpy.log10(values)
        if axis.signed:
            return numpy.sign(values) * numpy.log10(1 + numpy.abs(values) / (1e-5 * axis.signed))
        return numpy.asarray(values, float)


def coinciding(cell):
    """Groups of curves of a cell that coincide within the width of a line, as lists of their labels."""
    named = [curve for curve in cell.curves if curve.label]
    places = [heights(cell.y, curve.y) for curve in named]
    finite = [part[numpy.isfinite(part)] for part in places]
    if sum(map(len, finite)) == 0:
        return []
    every = numpy.concatenate(finite)
    room = COINCIDE * (every.max() - every.min())
    groups = []
    for curve, place in zip(named, places):
        for group in groups:
            other, there = group[0]
            if len(curve.x) == len(other.x) and len(place) > 1 and numpy.array_equal(curve.x, other.x):
                gap = numpy.abs(place - there)
                if numpy.isfinite(gap).any() and not (gap > room).any() and numpy.array_equal(numpy.isfinite(place), numpy.isfinite(there)):
                    group.append((curve, place))
                    break
        else:
            groups.append([(curve, place)])
    return [[curve.label for curve, _ in group] for group in groups if len(group) > 1]


def joined(words):
    """Joins at least two words: "a, b and c"."""
    return f"{', '.join(words[:-1])} and {words[-1]}"


def with_coincidence_noted(chart):
    """Adds a note on curves that coincide to a chart."""
    groups = dict.fromkeys(f"{joined(group)}" for row in chart.rows for cell in row for group in coinciding(cell))
    return chart._replace(note=" ".join([chart.note, f"These curves coincide: {'; '.join(groups)}."]).strip()) if groups else chart


def quiet_note(words):
    """Note in the middle of a cell that has nothing else to show."""
    return Note(0.5, 0.5, words, "middle", QUIET)
