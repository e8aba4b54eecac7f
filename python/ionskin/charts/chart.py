# SPDX-License-Identifier: Apache-2.0
"""Contents of one figure of a run, as plain data in SI units: the page draws it by its script, files by
draw_chart.py."""

from typing import NamedTuple

import numpy

from .colours import BLUE, INK, QUIET, SEQUENCE
from .spans import CONTACT_PHASES, contact_spans, peak_of, windows

WHOLE = 2.3  # width of the whole run over that of a window


class Axis(NamedTuple):
    """An axis of a cell.

    name       in words; "" where the cell below or to the left has it too
    unit       SI, "1" for pure numbers
    low, high  ends; None for those of the data
    origin     what is shown as 0
    signed     largest magnitude of a symmetric logarithmic axis; 0 for a linear one
    log        logarithmic, for positive values
    """

    name: str = ""
    unit: str = "1"
    low: float | None = None
    high: float | None = None
    origin: float = 0.0
    signed: float = 0.0
    log: bool = False


class Curve(NamedTuple):
    """y over x.

    step   "over": y is the mean over the step that ends at its x; "held": y is read at its x, and shown until the next
    look   "", "dashed", "dotted", or "none" for marks alone
    marks  one per value; where they would touch, the page leaves them out
    band   lower and upper end of y within its stated error, or None
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
    """A band behind the curves between two places of "x" or "y". label: of the legend."""

    low: float
    high: float
    colour: str
    along: str = "x"
    label: str = ""


class Mark(NamedTuple):
    """A line across a cell at a place of "x" or "y"; look as of a Curve. label: of the legend. words: beside it."""

    at: float
    look: str = "dashed"
    along: str = "x"
    label: str = ""
    words: str = ""


class Map(NamedTuple):
    """values [y][x] in colours of a palette from low to high, between edges x and y; NaN where there is nothing.

    name, unit  of the values, for the bar of colours
    beyond      values above high exist
    smooth      values at nodes, and what lies between is interpolated
    classes     names by colour: the values are places in it, and a legend stands for the bar
    lines       arrays [point, (x, y)] in white
    ticks       pairs of value and words beside the bar of colours, where they are not its own
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
    """A drawing's part: outlines, arrays [point, (x, y)], filled in a colour, or a line where it has none. edge: its colour."""

    outlines: list
    fill: str | None = None
    edge: str | None = INK
    width: float = 0.4
    look: str = ""
    label: str = ""


class Note(NamedTuple):
    """Words at a place. anchor: "start", "middle" or "end" of the text lies there; lines are centred about it. room: width and height,
    as on the axes, that a page keeps the words within: of lines that do not fit the first ones go; (0, 0) for any."""

    x: float
    y: float
    words: str
    anchor: str = "start"
    colour: str = INK
    size: float = 7.5
    boxed: bool = False
    room: tuple[float, float] = (0.0, 0.0)


class Cell(NamedTuple):
    """One pair of axes. phases: notes along the upper edge, of which x alone counts. height: 1 is the usual one. legend:
    names of curves stand above. equal: x and y have one scale. bare: neither axes nor grid."""

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
    """Rows of cells. widths: of the columns, in proportion. narrow: columns on a narrow screen. note: a sentence below."""

    rows: list
    widths: tuple = (1.0,)
    narrow: int = 1
    note: str = ""


def phase_spans(results, offset=0.0, cycle=None, named=False):
    """Bands behind the contact, darker while it slides; `named` says in the legend what they mean."""
    names = {"touchdown": "touching", "slide": "sliding"} if named else {}
    return tuple(Span(span.start - offset, span.end - offset, CONTACT_PHASES[span.phase], "x", names.pop(span.phase, ""))
                 for span in contact_spans(results) if span.phase in CONTACT_PHASES and (cycle is None or span.cycle == cycle))


def limits(curves, signed=0.0):
    """Ends of an axis that several cells share."""
    values = [part for curve in curves for part in (curve.y, *(curve.band or ()))]
    if signed or not values:
        return None, None
    found = numpy.concatenate(values)
    found = found[numpy.isfinite(found)]
    low, high = (float(found.min()), float(found.max())) if len(found) else (0.0, 0.0)
    room = 0.06 * (high - low) or 0.06 * abs(high) or 1.0
    return low - room, high + room


def over_time(results, panels):
    """A chart over the whole run. panels: (title, y, curves, height) each, top first."""
    time, spans = results.signals["time"], phase_spans(results)
    return Chart([[Cell(title, Axis("time" if place == len(panels) - 1 else "", "s", time[0], time[-1]), y, tuple(curves), spans,
                        height=height)] for place, (title, y, curves, height) in enumerate(panels)])


def with_events(results, panels, span=None):
    """A chart over the whole run, with the begin and the end of the first contact enlarged beside it: events of milliseconds.

    span  of the first column [s]; None for the whole run
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
    """A symmetric logarithmic axis of currents."""
    return Axis("current", "A", signed=peak_of(*columns) or 1.0)


COINCIDE = 0.006  # of the height of a cell: about the width of a line


def heights(axis, values):
    """Values as an axis places them, between any two numbers."""
    with numpy.errstate(divide="ignore", invalid="ignore"):
        if axis.log:
            return numpy.log10(values)
        if axis.signed:
            return numpy.sign(values) * numpy.log10(1 + numpy.abs(values) / (1e-5 * axis.signed))
        return numpy.asarray(values, float)


def coinciding(cell):
    """Groups of labels of curves of a cell that lie over one another."""
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
    """"a, b and c"."""
    return f"{', '.join(words[:-1])} and {words[-1]}"


def with_coincidence_noted(chart):
    """The chart with a note on curves that coincide in it."""
    groups = dict.fromkeys(f"{joined(group)}" for row in chart.rows for cell in row for group in coinciding(cell))
    return chart._replace(note=" ".join([chart.note, f"These curves coincide: {'; '.join(groups)}."]).strip()) if groups else chart


def quiet_note(words):
    """Words in the middle of a cell that has nothing to show."""
    return Note(0.5, 0.5, words, "middle", QUIET)
