# SPDX-License-Identifier: Apache-2.0
"""Figures 5, 6, 9 and 10: shear and currents over time of all runs of a sweep."""

import numpy

from ..words import quantity
from .chart import Axis, Cell, Chart, Curve, Map, with_events
from .colours import BLUE, DIVERGING, SEQUENCE, mixed
from .spans import peak_of, sampled_label, windows

NO_CURRENT = "the runs have no currents"
NO_SHEAR = "the runs have no shear"
NEEDS_SEVERAL = "it needs several runs of a sweep"
SEVERAL_KEYS = "several keys vary at once: fig21_scatter shows the points"
MAP_COLUMNS = 600
MOST_MEMBERS = 24  # of a family in one figure
MOST_NAMED = 10  # of them in its legend
FADE = 0.9  # of the palette: without its palest colours
LINEAR = 1e-3  # part of the peak within which the colours of a map of currents are linear


def spread(family, label):
    """Looks of a family of curves: triples of entry, colour from dark to light, and label, "" for some where there are many.

    family  list of entries; of very many, some are left out
    label   function of an entry that returns its label
    """
    shown = family[::-(-len(family) // MOST_MEMBERS)]
    named = set(numpy.linspace(0, len(shown) - 1, min(MOST_NAMED, len(shown))).round().astype(int))
    return [(entry, mixed(SEQUENCE, FADE * place / max(1, len(shown) - 1)), label(entry)[:36] if place in named else "")
            for place, entry in enumerate(shown)]


def looks(study):
    """Looks of a Study's members as of `spread`; a single member is blue, without a label."""
    return [(study.members[0], BLUE, "")] if study.single else spread(study.members, study.panel_label)


def shear(study):
    """Figure 5: mean shear over time of every member."""
    results = study.typical.results
    if not results.signals.has("mean_shear"):
        return NO_SHEAR
    curves = [Curve(member.results.signals["time"], member.results.signals["mean_shear"], label, colour)
              for member, colour, label in looks(study) if member.results.signals.has("mean_shear")]
    return with_events(results, [("Mean shear of the core", Axis("mean shear γ"), curves, 1.4)])


def currents(study):
    """Figure 9: sampled currents over time of every member."""
    results = study.typical.results
    if not results.sampled.has("current_top"):
        return NO_CURRENT
    panels = []
    for name, title in (("top", "Top electrode"), ("bottom", "Bottom electrode"), ("difference", "Difference (top − bottom)/2")):
        column = f"current_{name}"
        shown = [(member, colour, label) for member, colour, label in looks(study) if member.results.sampled.has(column)]
        curves = [Curve(member.results.sampled["time"], member.results.sampled[column], label if not panels else "", colour, "held", 1.0)
                  for member, colour, label in shown]
        peak = peak_of(*(member.results.signals[column] for member, *_ in shown if member.results.signals.has(column)))
        panels.append((f"{title}: peaks of {quantity(peak_of(*(curve.y for curve in curves)), 'A', 3)} sampled, {quantity(peak, 'A', 3)} resolved",
                       Axis("current", "A"), curves, 1.0))
    chart = with_events(results, panels)
    return chart._replace(note=f"{sampled_label(results).capitalize()}.")


def value_edges(values):
    """Edges of cells about ascending values, halfway between them."""
    values = numpy.asarray(values, float)
    middle = (values[1:] + values[:-1]) / 2
    return numpy.concatenate([[values[0] - (middle[0] - values[0])], middle, [values[-1] + (values[-1] - middle[-1])]])


def no_map(study):
    """Reason why a Study has no map over time and its key; "" when it has one."""
    return NEEDS_SEVERAL if study.single else SEVERAL_KEYS if study.scattered else ""


def with_first_contact(study, cells_of):
    """Chart of a map over the whole run and, beside it, about the begin of the first contact.

    cells_of  function of the time axis and a title that returns the cells of one column
    """
    time = study.typical.results.signals["time"]
    whole = cells_of(Axis("time", "s", float(time[0]), float(time[-1])), "")
    enlarged = [cells_of(Axis(f"time from {instant:.5g} s", "s", begin, end, instant), words)
                for begin, end, instant, words in windows(study.typical.results)[:1]]
    rows = [list(cells) for cells in zip(whole, *enlarged)]
    return Chart(rows, (1.6, 1.0) if enlarged else (1.0,))


def shear_map(study):
    """Figure 6: mean shear over time and the swept key."""
    if no_map(study):
        return no_map(study)
    if not study.typical.results.signals.has("mean_shear"):
        return NO_SHEAR
    values = value_edges([member.value for member in study.members])
    top = max(peak_of(member.results.signals["mean_shear"]) for member in study.members) or 1.0

    def cells(part, words):
        edges = numpy.linspace(part.low, part.high, MAP_COLUMNS + 1)
        rows = numpy.array([member.results.signals.at("mean_shear", (edges[1:] + edges[:-1]) / 2) for member in study.members])
        return [Cell(words or "Mean shear γ of the core", part, key_axis(study, values),
                     map=Map(edges, values, rows, high=top, name="mean shear γ"), height=1.2)]

    return with_first_contact(study, cells)


def key_axis(study, edges):
    """Vertical axis along the members of a Study, between the edges of a map."""
    return Axis(study.name, study.unit, float(edges[0]), float(edges[-1]))


def compressed(values, peak):
    """Values scaled to lie between -1 and 1: logarithmic beyond a thousandth of the peak, linear within."""
    share = numpy.abs(values) / peak
    with numpy.errstate(divide="ignore"):
        size = numpy.where(share < LINEAR, share / LINEAR, 1 + numpy.log10(numpy.maximum(share, LINEAR) / LINEAR))
    return numpy.sign(values) * size / (1 - numpy.log10(LINEAR))


def current_map(study):
    """Figure 10: sampled currents over time and the swept key, on a symmetric logarithmic scale."""
    if no_map(study):
        return no_map(study)
    typical = study.typical.results
    if not typical.sampled.has("current_top"):
        return NO_CURRENT
    values = value_edges([member.value for member in study.members])
    time = typical.sampled["time"]
    # A reading is shown from its instant to that of the next.
    edges = numpy.concatenate([time, [time[-1] + (time[-1] - time[-2] if len(time) > 1 else 1.0)]])

    def cells(part, words):
        found = []
        for name, title in (("top", "Top electrode"), ("bottom", "Bottom electrode"), ("difference", "Difference (top − bottom)/2")):
            rows = numpy.array([member.results.sampled[f"current_{name}"][:len(time)] for member in study.members])
            peak = peak_of(rows) or 1e-12  # a scale for runs without any current
            ticks = tuple((float(compressed(tick, peak)), quantity(tick, "A", 2)) for tick in (-peak, -peak / 30, 0.0, peak / 30, peak))
            columns = slice(max(0, int(numpy.searchsorted(edges, part.low)) - 1), int(numpy.searchsorted(edges, part.high)) + 1)
            shown = edges[columns]
            found.append(Cell(title if not words else words, part if name == "difference" else part._replace(name=""),
                              key_axis(study, values), map=Map(shown, values, compressed(rows, peak)[:, columns][:, :len(shown) - 1], -1.0, 1.0,
                                                               palette=DIVERGING, ticks=ticks), height=0.9))
        return found

    return with_first_contact(study, cells)._replace(note=f"{sampled_label(typical).capitalize()}.")


