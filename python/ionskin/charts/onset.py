# SPDX-License-Identifier: Apache-2.0
"""Figure of the onset of the slide of one run: where and when the contact slips, the stuck share, and the currents."""

import numpy

from ..analysis import slip
from . import readout
from .chart import Axis, Cell, Chart, Curve, Map, Mark, Span, quiet_note
from .colours import GREEN, PALE, PURPLE
from .fields import fields_of, mirrored
from .spans import peak_of

COLOURS = {"difference": GREEN, "common": PURPLE}
BEHIND = 0.35  # of the time to full slip that is shown after it
FRONTS = (0.2, 0.4, 0.6, 0.8)  # of the last time, at which the front is drawn


def onset(results):
    """Two maps above three panels over time; None where nothing sticks when the slide begins, or nothing slides."""
    found = slip.onset(results)
    if found is None or fields_of(results) is None or not results.signals.has("stick_share"):
        return None
    with fields_of(results) as file:
        if "contact" not in file or not slip.onset_states(file):
            return None
        maps = draw_maps(file, found)
    end = found.full if found.full is not None else float(results.phases()[-1].end)
    span = (end - found.begin) * (1 + BEHIND)
    marks = [Mark(found.micro - found.begin, "dotted", label="first micro-slip")]
    if found.full is not None:
        marks.append(Mark(found.full - found.begin, label="full slip"))
    time = Axis("", "s", -0.04 * span, span)
    stuck = Curve(results.signals["time"] - found.begin, results.signals["stick_share"], marks=True)
    cells = [Cell("Part of the contact that sticks", time, Axis("stuck share", "1", -0.03, 1.05), (stuck,), marks=tuple(marks), height=0.7)]
    nothing = readout.carries_nothing(results)
    shown = () if nothing else slip.CURRENTS[readout.passes_nothing(results):]  # without the difference between open electrodes
    cells += [current_cell(results, found, current, time, marks) for current in shown]
    cells[-1] = cells[-1]._replace(x=time._replace(name="time since the slide began"))
    return Chart([maps, *([cell] for cell in cells)], (1.0, 1.0), note=f"Currents are not drawn: {readout.OPEN}." if nothing else "")


def draw_maps(file, found):
    """When each cell slips for good, with the front at four instants, and how far it has slipped at full slip."""
    x = file["contact/grid/x"][...]
    y, times = mirrored(file, slip.release_times(file, found.begin))
    end = found.full if found.full is not None else found.begin + numpy.nanmax(times)
    way = mirrored(file, slip.slip_at(file, end))[1]
    cells = []
    for values, name, unit, words, lines in ((times, "time", "s", "When it slips", fronts(x, y, times)),
                                             (way, "slip", "m", "Slipped by full slip", ())):
        cells.append(Cell(words, Axis("x from the slider's centre", "m", x[0], x[-1]), Axis("y", "m", y[0], y[-1]),
                          map=Map(x, y, values, high=peak_of(values) or 1.0, name=name, unit=unit, lines=lines), equal=True))
    return cells


def fronts(x, y, times):
    """Front between stuck and slipping cells, at parts of the last time."""
    if min(times.shape) < 2 or not peak_of(times):
        return ()
    from contourpy import contour_generator  # of matplotlib, but without it

    lines = contour_generator((x[1:] + x[:-1]) / 2, (y[1:] + y[:-1]) / 2, numpy.nan_to_num(times))
    return tuple(line for part in FRONTS for line in lines.lines(part * peak_of(times)))


def current_cell(results, found, current, time, marks):
    """A current, with three times the noise floor about its value at the first micro-slip."""
    signals, column = results.signals, f"current_{current}"
    marks = tuple(mark._replace(label="") for mark in marks)
    precursor = slip.precursor(results, current)
    r = slip.value(results, f"precursor_correlation_{current}")
    if r is None:
        return Cell(f"{current.capitalize()} current", time, Axis("current", "A", 0.0, 1.0), marks=marks, height=0.7,
                    notes=(quiet_note("no current above rounding"),))
    since = signals["time"] - found.begin
    shown = (since > 0) & (numpy.roll(since, 1) <= time.high)  # with the step that goes on beyond the end
    value = float(numpy.interp(found.micro, signals["time"], signals[column]))
    floor = slip.SEEN * precursor.noise
    spans = (Span(value - floor, value + floor, PALE, "y"),) if numpy.isfinite(precursor.noise) else ()
    seen = "" if precursor.departure > precursor.noise else "; no reading before full slip shows it"
    curve = Curve(since[shown], signals[column][shown], "", COLOURS[current], "over", 1.0)
    return Cell(f"{current.capitalize()} current, correlation with the stuck share {r:.2f}{seen}", time, Axis("current", "A"), (curve,),
                spans, marks, height=0.7)
