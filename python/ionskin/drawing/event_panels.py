# SPDX-License-Identifier: Apache-2.0
"""Rows of panels over the whole run and, beside it, enlarged where contact begins and ends: events that last
milliseconds would be lines on an axis of seconds."""

import numpy
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, MaxNLocator

from ..charts.spans import windows
from . import style
from .panels import shade_phases

WHOLE = 2.3  # width of the whole run over that of a window


class Row:
    """Panels of one quantity; takes what a panel takes. The first shows the whole run and has title and label, the last
    has the legend."""

    def __init__(self, panels) -> None:
        self.panels = list(panels)

    def plot(self, *values, **look):
        """The same curve in every panel."""
        for panel in self.panels:
            panel.plot(*values, **look)

    def fill_between(self, *values, **look):
        """The same band in every panel."""
        for panel in self.panels:
            panel.fill_between(*values, **look)

    def twin(self):
        """A row with an axis of its own on the right, shown at the last panel."""
        twins = [panel.twinx() for panel in self.panels]
        for twin in twins:
            twin.sharey(twins[0]) if twin is not twins[0] else None
            twin.grid(False)
            twin.tick_params(labelright=twin is twins[-1], right=twin is twins[-1])
        twins[-1].spines["right"].set_visible(True)
        return Row(twins)

    def set_ylabel(self, *words, **look):
        self.panels[0].set_ylabel(*words, **look)

    def set_ylim(self, *limits, **more):
        self.panels[0].set_ylim(*limits, **more)

    def set_title(self, *words, **look):
        self.panels[0].set_title(*words, **look)

    def legend(self, *handles, **look):
        self.panels[-1].legend(*handles or self.panels[0].get_legend_handles_labels(), **look)


def rows(results, heights, *, left=0.105, right=0.98) -> tuple[Figure, list[Row]]:
    """A full-width figure and its rows, of heights in units of style.ROW."""
    style.apply()
    found = windows(results)
    height = style.ROW * sum(heights) + 0.44 + 0.22 * len(heights)
    figure = style.canvas(height=height, left=left, right=right, top=1 - 0.22 / height, bottom=0.56 / height, hspace=0.22,
                          wspace=0.07)
    panels = figure.subplots(len(heights), 1 + len(found), sharex="col", sharey="row", squeeze=False,
                             gridspec_kw={"height_ratios": heights, "width_ratios": [WHOLE] + [1.0] * len(found)})
    return figure, [Row(row) for row in panels]


def finish(results, all_rows, span=None):
    """Limits, labels and bands once everything is drawn; `span` is that of the first column, by default the run."""
    time = results.signals["time"]
    first, *enlarged = all_rows[-1].panels
    first.set_xlim(*(span or (time[0], time[-1])))
    first.set_xlabel("time [s]")
    for panel, window in zip(enlarged, windows(results)):
        enlarge(panel, window)
    for row in all_rows:
        for panel in row.panels:
            shade_phases(results, panel)


def enlarge(panel, window):
    """Limits, ticks and label of a panel that shows one window."""
    begin, end, instant, words = window
    panel.set_xlim(begin, end)
    panel.xaxis.set_major_locator(Offsets(instant))
    panel.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{(value - instant) * 1e3:.4g}"))
    panel.set_xlabel(f"{words},\nms from {instant:.5g} s", fontsize=7.5)


class Offsets(MaxNLocator):
    """Round ticks as counted from an instant."""

    def __init__(self, instant) -> None:
        super().__init__(nbins=4, prune="both")
        self.instant = instant

    def tick_values(self, vmin, vmax):
        return numpy.asarray(super().tick_values(vmin - self.instant, vmax - self.instant)) + self.instant
