# SPDX-License-Identifier: Apache-2.0
"""Figures 21 and 22: the metrics of a sampled sweep against its keys, and how much each key matters."""

import textwrap

import numpy
from matplotlib.ticker import MaxNLocator

from ..analysis import sensitivity as measures
from ..charts.spans import peak_of
from ..words import si_scale
from . import style
from .panels import scaled

NO_DESIGN = "it needs a sweep whose keys vary at once (--samples)"
METRICS = {"peak_mean_shear": "peak mean shear", "time_mean_shear": "time mean of the shear",
           "normal_force_slide": "normal force, mid-slide", "peak_sampled_current_top": "peak current, top",
           "peak_sampled_current_difference": "peak difference current", "rms_current_difference": "rms difference current"}
SHOWN = 4  # metrics in the scatter
LABEL_WIDTH = 13  # letters in a line beside a panel of it


def scatter(study):
    """Figure 21: one panel per metric and key, one mark per point."""
    if not study.scattered or not study.numeric_keys:
        return NO_DESIGN
    keys = study.numeric_keys[:5]
    names = [name for name in METRICS if numpy.isfinite(study.metric(name)).any()][:SHOWN]
    height = 1.15 * len(names) + 0.6
    figure = style.canvas(height=height, left=0.105, right=0.98, top=1 - 0.28 / height, bottom=0.42 / height, hspace=0.28,
                          wspace=0.10)
    panels = figure.subplots(len(names), len(keys), sharex="col", sharey="row", squeeze=False)
    for row, name in zip(panels, names):
        values = numpy.array(study.metric(name))
        divisor = scaled(row[0], textwrap.fill(METRICS[name], LABEL_WIDTH), study.typical.results.metrics[name].unit, peak_of(values))
        for panel, key in zip(row, keys):
            unit = study.sweep.keys[key]
            places = numpy.array([member.values[key] for member in study.members])
            scale, prefix = si_scale(numpy.abs(places).max()) if unit != "1" else (1.0, "")
            panel.plot(places / scale, values / divisor, ls="", marker="o", markersize=3.2, color=style.BLUE)
            if name == names[-1]:
                # Ticks at the ends would touch those of the panel beside.
                panel.xaxis.set_major_locator(MaxNLocator(4, prune="both"))
                panel.set_xlabel(study.axis_label(key).split(" [")[0] + (f" [{prefix}{unit}]" if unit != "1" else ""))
        row[0].set_ylim(min(0, 1.08 * values.min() / divisor), 1.08 * max(0, values.max()) / divisor or 1)
        row[0].yaxis.label.set_fontsize(7)
    return figure


def sensitivity(study):
    """Figure 22: rank correlations and first-order shares as tables of colour."""
    found = measures.of_study(study, METRICS) if study.scattered else None
    if found is None:
        return NO_DESIGN if not study.scattered else f"it needs {measures.FEWEST} finished points or more"
    names = [study.axis_label(key).split(" [")[0] for key in found.keys]
    foot = 0.25 + 0.042 * max(map(len, names))  # of slanted names of keys [inch]
    height = 0.32 * len(found.metrics) + 0.4 + foot
    figure = style.canvas(height=height, left=0.21, right=0.97, top=1 - 0.30 / height, bottom=foot / height, wspace=0.12)
    panels = figure.subplots(1, 2, sharey=True)
    for panel, values, look, words in ((panels[0], found.rank, {"vmin": -1, "vmax": 1, "cmap": style.DIVERGING},
                                        "Rank correlation"),
                                       (panels[1], found.share, {"vmin": 0, "vmax": 1, "cmap": "Greens"},
                                        "Share of the variance")):
        panel.imshow(values, aspect="auto", **look)
        for (row, column), value in numpy.ndenumerate(values):
            panel.text(column, row, "–" if numpy.isnan(value) else f"{value:.2f}", ha="center", va="center", fontsize=7.5,
                       color="white" if abs(value) > 0.75 else "black")
        panel.set_xticks(range(len(names)), names, rotation=35, ha="right", rotation_mode="anchor")
        panel.set_yticks(range(len(found.metrics)), [METRICS[name] for name in found.metrics])
        panel.tick_params(length=0)
        panel.grid(False)
        style.title(panel, f"{words}, {len(study.members)} points" if panel is panels[0] else words)
    return figure
