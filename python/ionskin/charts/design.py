# SPDX-License-Identifier: Apache-2.0
"""Figures 21 and 22: the metrics of a sampled sweep against its keys, and how much each key matters."""

import numpy

from ..analysis import sensitivity as measures
from ..page.quantities import words
from ..sweep_results import symbol
from .chart import Axis, Cell, Chart, Curve, Note, Shape, limits
from .colours import BLUE, DIVERGING, SEQUENCE, mixed, parts
from .spans import peak_of

NO_DESIGN = "it needs a sweep whose keys vary at once (--samples)"
METRICS = ("peak_mean_shear", "time_mean_shear", "normal_force_slide", "peak_sampled_current_top", "peak_sampled_current_difference",
           "rms_current_difference")
SHOWN, MOST_KEYS = 4, 5  # metrics and keys in the scatter
ROW = 0.3  # height of a row of a table


def scatter(study):
    """Figure 21: one panel per metric and key, one mark per point."""
    if not study.scattered or not study.numeric_keys:
        return NO_DESIGN
    keys = study.numeric_keys[:MOST_KEYS]
    names = [name for name in METRICS if numpy.isfinite(study.metric(name)).any()][:SHOWN]
    rows = []
    for name in names:
        values = numpy.array(study.metric(name), float)
        height = Axis("value", study.typical.results.metrics[name].unit, min(0.0, 1.08 * float(numpy.nanmin(values))), 1.08 * peak_of(values) or 1.0)
        row = []
        for key in keys:
            places = numpy.array([member.values[key] for member in study.members], float)
            ends = limits([Curve(places, places)])
            title = f"{words(name)}, over {study.axis_label(key).split(' [')[0]}"
            row.append(Cell(title, Axis(symbol(key), study.sweep.keys[key], *ends), height if not row else height._replace(name=""),
                            (Curve(places, values, "", BLUE, look="none", marks=True, width=1.5),), height=0.9))
        rows.append(row)
    return Chart(rows, (1.0,) * len(keys), min(2, len(keys)))


def sensitivity(study):
    """Figure 22: rank correlations and first-order shares as tables of colour."""
    found = measures.of_study(study, METRICS) if study.scattered else None
    if found is None:
        return NO_DESIGN if not study.scattered else f"it needs {measures.FEWEST} finished points or more"
    cells = [table(f"Rank correlation, {len(study.members)} points", found, found.rank, -1.0, DIVERGING),
             table("Share of the variance", found, found.share, 0.0, SEQUENCE)]
    return Chart([cells], (1.0, 1.0))


def table(title, found, values, low, palette):
    """Coloured boxes with numbers: one row for each metric below its name, one column for each key below its symbol."""
    shapes, notes = [], [Note(column + 0.5, 0.25, symbol(key), "middle") for column, key in enumerate(found.keys)]
    for row, name in enumerate(found.metrics):
        notes.append(Note(0.03, -row - 0.25, words(name), "start"))
        for column, value in enumerate(values[row]):
            colour = "#ffffff" if numpy.isnan(value) else mixed(palette, (value - low) / (1 - low))
            box = numpy.array([(column + 0.02, -row - 0.95), (column + 0.98, -row - 0.95), (column + 0.98, -row - 0.5), (column + 0.02, -row - 0.5)])
            shapes.append(Shape([box], colour, None))
            dark = numpy.dot(parts(colour), (0.3, 0.59, 0.11)) < 128
            notes.append(Note(column + 0.5, -row - 0.725, "–" if numpy.isnan(value) else f"{value:.2f}", "middle", "#ffffff" if dark else "#000000"))
    rows = len(found.metrics)
    return Cell(title, Axis("", "1", 0.0, float(len(found.keys))), Axis("", "1", -float(rows), 0.5), shapes=tuple(shapes), notes=tuple(notes),
                height=ROW * (rows + 0.5), bare=True)
