# SPDX-License-Identifier: Apache-2.0
"""Spans and labels that figures share: phases and contacts of a run, what is enlarged,
sizes and labels of axes. Draws nothing."""

import numpy

from ..words import SUPERSCRIPTS, quantity, si_scale
from .colours import BAND, BAND_STRONG

CONTACT_PHASES = {"touchdown": BAND, "slide": BAND_STRONG, "lift": BAND}
PLAIN = 0.1  # pure numbers up to here need no power of ten
DECADES = 5  # between the largest current and the linear part of a symmetric logarithmic axis
BEFORE, AFTER = 3, 9  # readout intervals that a window shows around its event
INTERVAL = 10e-3  # [s]; where nothing is sampled
MOST_OF_A_CONTACT = 0.25  # a window is no longer than this part of the contact


def contact_spans(results):
    """Parts of the phases in which slider and skin touch, as a list of PhaseSpan; whole phases where no force is known."""
    signals = results.signals
    spans = [span for span in results.phases() if span.phase != "return"]
    if not signals.has("normal_force"):
        return spans
    time, touching = signals["time"], signals["normal_force"] > 0
    found = []
    for span in spans:
        rows = numpy.flatnonzero(rows_within(signals, span) & touching)
        if len(rows):
            # A row belongs to the step that ends there; the force of the last contact falls to 0 within the next one.
            end = min(rows[-1] + 1, len(time) - 1)
            found.append(span._replace(start=max(span.start, time[rows[0] - 1]), end=min(span.end, time[end])))
    return found


def windows(results):
    """Enlarged events, begin and end of the first contact, as rows of begin and end of the window [s], instant [s] and name."""
    spans = contact_spans(results)
    if not spans:
        return []
    last = spans[0]
    for span in spans[1:]:
        if span.start <= last.end + 1e-9 * max(1.0, last.end):
            last = span
        else:
            break
    first, end = spans[0].start, last.end
    time = results.sampled["time"]
    interval = float(time[1] - time[0]) if len(time) > 1 else INTERVAL
    interval = min(interval, MOST_OF_A_CONTACT * (end - first) / (BEFORE + AFTER))
    if interval <= 0:
        return []
    return [(instant - BEFORE * interval, instant + AFTER * interval, instant, words)
            for instant, words in ((first, "contact begins"), (end, "contact ends"))]


def rows_within(signals, span):
    """True in rows of a table whose whole time step lies in a span."""
    return (signals["time"] > span.start) & (signals["time"] <= span.end)


def slide_start(results):
    """Start of the slide of the first cycle [s]; None without one."""
    return next((span.start for span in results.phases() if span.phase == "slide"), None)


def peak_of(*columns):
    """Largest magnitude over columns, NaN ignored; 0 without numbers."""
    values = numpy.concatenate([numpy.ravel(column) for column in columns]) if columns else numpy.empty(0)
    return float(numpy.max(numpy.abs(values[numpy.isfinite(values)]), initial=0.0))


def scaled_label(name, unit, peak):
    """Divisor of the values of an axis, and its label with the prefixed unit, by the largest magnitude `peak`."""
    divisor, prefix = si_scale(peak)
    if unit != "1":
        return divisor, f"{name} [{prefix}{unit}]"
    if PLAIN <= peak < 1e5:
        return 1.0, name
    power = f"{round(numpy.log10(divisor)):d}".translate(SUPERSCRIPTS)
    return divisor, f"{name} [10{power}]" if divisor != 1 else name


def sampling_interval(results):
    """Interval over which sampled currents are means [s]; 0 where nothing is sampled."""
    time = results.sampled["time"] if "time" in results.sampled else ()
    return float(time[1] - time[0]) if len(time) > 1 else 0.0


def sampled_label(results):
    """Label of a sampled current, with its interval."""
    interval = sampling_interval(results)
    return f"sampled, mean over the {quantity(round(interval, 9), 's')} before" if interval else "sampled"
