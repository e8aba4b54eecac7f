# SPDX-License-Identifier: Apache-2.0
"""Common style of all figures: publication sizes, and colours that colour-blind readers can tell apart."""

import matplotlib
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from ..charts.colours import BAND, BAND_STRONG, BLUE, DIVERGING, GREEN, GRID, INK, ORANGE, PALE, PURPLE, QUIET, SEQUENCE
from ..words import si_scale  # figures take it and the colours from here

BEHIND_TEXT = {"facecolor": "white", "alpha": 0.8, "edgecolor": "none", "pad": 1.0}

WIDTH = 170 / 25.4  # full text width of most journals [inch]
TELEPHONE_WIDTH = 88 / 25.4  # whose letters can be read on a telephone [inch]
ROW = 44 / 25.4  # height of one panel [inch]

SETTINGS = {
    "font.family": ["DejaVu Sans", "sans-serif"],
    "font.size": 8,
    "axes.titlesize": 8,
    "axes.titley": 1.0,  # a fixed place saves laying out every panel twice
    "axes.labelsize": 8,
    "axes.edgecolor": QUIET,
    "axes.labelcolor": INK,
    "axes.linewidth": 0.6,
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.facecolor": "none",
    "grid.color": GRID,
    "grid.linewidth": 0.5,
    "lines.linewidth": 1.2,
    "lines.markersize": 2.5,
    "legend.frameon": False,
    "legend.fontsize": 7.5,
    "text.color": INK,
    "text.parse_math": False,  # a name such as $\frac{1}$ stays what it is
    "xtick.color": INK,
    "ytick.color": INK,
    "xtick.labelsize": 7.5,
    "ytick.labelsize": 7.5,
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "figure.facecolor": "white",
    "svg.fonttype": "none",
    "svg.hashsalt": "ionskin",
    "path.simplify_threshold": 0.2,
}


def apply():
    """Makes the style the default of every figure drawn afterwards."""
    matplotlib.rcParams.update(SETTINGS)


def stacked(rows, *, share_x=True, heights=None, width=WIDTH):
    """Makes a figure with stacked panels; returns it and the list of its axes. `width` in inch; `heights`: relative heights."""
    apply()
    heights = heights or [1] * rows
    height = ROW * sum(heights) + 0.30 + 0.22 * rows
    figure = Figure(figsize=(width, height))
    FigureCanvasAgg(figure)
    axes = figure.subplots(rows, 1, sharex=share_x, squeeze=False, gridspec_kw={"height_ratios": heights})[:, 0]
    figure.subplots_adjust(left=0.105 * WIDTH / width, right=0.98, top=1 - 0.22 / height, bottom=0.42 / height,
                           hspace=0.22 if share_x else 0.42)
    return figure, list(axes)


def legend(axes, *, columns=4):
    """Adds a legend above a panel, where no curve can run through it."""
    axes.legend(loc="lower right", bbox_to_anchor=(1.0, 0.98), ncol=columns, borderaxespad=0.1,
                handlelength=1.6, columnspacing=1.4)


def title(axes, text):
    """Writes the name of a panel above it on the left."""
    axes.set_title(text, loc="left", pad=4, color=INK, fontweight="bold")


def canvas(width=WIDTH, height=3.0, **margins):
    """Makes an empty figure in the common style; width and height in inch."""
    apply()
    figure = Figure(figsize=(width, height))
    FigureCanvasAgg(figure)
    if margins:
        figure.subplots_adjust(**margins)
    return figure
