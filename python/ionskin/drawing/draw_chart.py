# SPDX-License-Identifier: Apache-2.0
"""Drawing of a Chart with matplotlib, for figure files."""

import textwrap
from typing import NamedTuple

import numpy
from matplotlib.colors import ListedColormap, Normalize
from matplotlib.cm import ScalarMappable
from matplotlib.patches import Patch, Polygon
from matplotlib.ticker import EngFormatter, FuncFormatter, MaxNLocator, NullFormatter

from ..charts.chart import limits
from ..charts.spans import peak_of, scaled_label
from . import style
from .panels import signed_log_axis

LEFT, RIGHT, BAR, BETWEEN = 0.80, 0.14, 0.55, 0.16  # widths [inch]: of labels, of what is free, of a bar of colours
LINE, ENTRY, ROOM, PHASES, TICKS, NAME, NOTE = 0.15, 0.17, 0.09, 0.12, 0.20, 0.18, 0.20  # heights [inch]
BOLD, LETTER, HANDLE = 0.066, 0.056, 0.40  # widths of a letter of a title and of a name, and of what stands before a name [inch]
TALLEST = 3.0  # of a cell with equal scales [inch]
LOOKS = {"": "-", "dashed": (0, (5, 2)), "dotted": (0, (1.5, 1.5)), "none": ""}
STEPS = {"": "default", "over": "steps-pre", "held": "steps-post"}
FILLS = {"": None, "over": "pre", "held": "post"}
FULL = 0.75  # of the width of a figure, from which a cell has none beside it
TICK = 0.42  # width of a tick's number [inch]
MOST_MARKS = 400  # of a curve; more would touch
ANCHORS = {"start": "left", "middle": "center", "end": "right"}


def draw(chart):
    """Draws a Chart as a matplotlib figure in the common style."""
    rows = [(row, places(chart, row)) for row in chart.rows]
    heights = [max(height_of(cell, width) for cell, (_, width) in zip(row, across)) for row, across in rows]
    lows = [0.06 if row[0].bare else TICKS + NAME * any(cell.x.name for cell in row) for row, _ in rows]
    highs = [max(heading(cell, width).height for cell, (_, width) in zip(row, across)) for row, across in rows]
    notes = textwrap.wrap(chart.note, int(style.WIDTH / 0.052))
    height = sum(heights) + sum(lows) + sum(highs) + NOTE * bool(notes) + LINE * max(0, len(notes) - 1)
    figure = style.canvas(height=height)
    top = height
    for (row, across), tall, low, high in zip(rows, heights, lows, highs):
        top -= high
        for cell, (left, width) in zip(row, across):
            own = height_of(cell, width)
            panel = figure.add_axes((left / style.WIDTH, (top - own) / height, width / style.WIDTH, own / height))
            draw_cell(figure, panel, cell)
            name_curves(panel, cell, heading(cell, width))
        top -= tall + low
    if notes:
        figure.text(0.01, 0.05 / height, "\n".join(notes), fontsize=7, color=style.QUIET, va="bottom")
    return figure


class Heading(NamedTuple):
    """The heading above a cell. title: lines; columns: of the legend; rows: of it, 0 where it stands beside the title"""

    title: list
    columns: int
    rows: int
    height: float


def heading(cell, width):
    """Heading of a cell of the given width [inch]."""
    title = textwrap.wrap(cell.title, max(8, int(width / BOLD)))
    names = [each.label for each in (*cell.spans, *cell.curves, *cell.marks, *cell.shapes) if each.label] if cell.legend else []
    widths = [HANDLE + LETTER * len(name) for name in names]
    columns, rows = 1, 0
    if names:
        beside = len(title) == 1 and sum(widths) + BOLD * len(title[0]) + 0.1 <= width
        columns = len(names) if beside else max(1, min(len(names), int(width / max(widths))))
        rows = 0 if beside else -(-len(names) // columns)
    return Heading(title, columns, rows, ROOM + LINE * len(title) + ENTRY * rows + PHASES * bool(cell.phases))


def places(chart, row):
    """Left edge and width of each cell of a row [inch]."""
    widths = chart.widths if len(row) == len(chart.widths) else (1.0,)
    lefts = [0.1 if cell.bare else LEFT if place == 0 or cell.y.name or cell.map else BETWEEN for place, cell in enumerate(row)]
    rights = [RIGHT + BAR * (cell.map is not None) if place == len(row) - 1 or cell.map else 0.0 for place, cell in enumerate(row)]
    free = style.WIDTH - sum(lefts) - sum(rights)
    found, at = [], 0.0
    for left, right, part in zip(lefts, rights, widths):
        width = free * part / sum(widths[:len(row)])
        found.append((at + left, width))
        at += left + width + right
    return found


def height_of(cell, width):
    """Height of the axes of a cell [inch]."""
    if not cell.equal:
        return style.ROW * cell.height
    return min(TALLEST, width * (cell.y.high - cell.y.low) / (cell.x.high - cell.x.low))


def draw_cell(figure, panel, cell):
    """Draws a cell into a panel (matplotlib axes)."""
    xs = [end for end in (cell.x.low, cell.x.high) if end is not None] or [curve.x for curve in cell.curves]
    reach = peak_of(*(numpy.asarray(end) - cell.x.origin for end in xs))
    values = [part for curve in cell.curves for part in (curve.y, *(curve.band or ()))]
    ends = [end for end in (cell.y.low, cell.y.high) if end is not None]
    height = peak_of(*values, ends)
    both = max(reach, height) if cell.equal else 0.0  # one unit where both have one scale
    x_divisor, x_label = scaled_label(cell.x.name, cell.x.unit, both or reach)
    y_divisor, y_label = (1.0, cell.y.name) if cell.y.signed or cell.y.log else scaled_label(cell.y.name, cell.y.unit, both or height)

    def along(place):
        return (place - cell.x.origin) / x_divisor

    for span in cell.spans:
        if span.along == "x":
            panel.axvspan(along(span.low), along(span.high), color=span.colour, lw=0, zorder=0, label=span.label or None)
        else:
            panel.axhspan(span.low / y_divisor, span.high / y_divisor, color=span.colour, alpha=0.5, lw=0)
    for curve in cell.curves:
        draw_curve(panel, curve, along, y_divisor)
    for mark in cell.marks:
        look = {"color": style.QUIET, "lw": 0.8, "ls": LOOKS[mark.look], "label": mark.label or None}
        panel.axvline(along(mark.at), **look) if mark.along == "x" else panel.axhline(mark.at / y_divisor, **look)
        if mark.words:
            panel.annotate(mark.words, (along(mark.at), 0.97), xycoords=panel.get_xaxis_transform(), xytext=(4, 0),
                           textcoords="offset points", va="top", fontsize=7.5, color=style.QUIET)
    for note in cell.phases:
        panel.text(along(note.x), 1.0, note.words, transform=panel.get_xaxis_transform(), ha="center", va="bottom", fontsize=7,
                   color=style.QUIET)
    if cell.map is not None:
        draw_map(figure, panel, cell.map, along, y_divisor)
    draw_shapes(panel, cell, along, y_divisor)
    set_axes(panel, cell, along, y_divisor)
    panel.set_xlabel(x_label if cell.x.name else "")
    panel.set_ylabel(y_label if cell.y.name else "")


def draw_curve(panel, curve, along, divisor):
    """Draws a curve with its error band into a panel."""
    x = along(curve.x)
    if curve.band is not None and curve.look == "none":
        low, high = (end / divisor for end in curve.band)
        panel.vlines(x, low, high, color=curve.colour, lw=0.8)
    elif curve.band is not None:
        panel.fill_between(x, *(end / divisor for end in curve.band), step=FILLS[curve.step], color=curve.colour, alpha=0.25,
                           lw=0, zorder=1.5)
    panel.plot(x, curve.y / divisor, color=curve.colour, lw=curve.width, ls=LOOKS[curve.look], label=curve.label or None,
               **({"marker": "o", "markersize": 3.5 if curve.look == "none" else 1.8} if curve.marks and len(x) < MOST_MARKS else {}), drawstyle=STEPS[curve.step])


def set_axes(panel, cell, along, divisor):
    """Sets the limits and the ticks of both axes of a panel."""
    if cell.x.low is not None:
        panel.set_xlim(along(cell.x.low), along(cell.x.high))
    if cell.y.signed:
        signed_log_axis(panel, cell.y.unit, cell.y.signed)
    elif cell.y.log:
        panel.set_yscale("log")
        panel.yaxis.set_major_formatter(EngFormatter(cell.y.unit))
        panel.yaxis.set_minor_formatter(NullFormatter())
    else:
        low, high = (cell.y.low, cell.y.high) if cell.y.low is not None else limits(cell.curves)
        if low is not None:
            panel.set_ylim(low / divisor, high / divisor)
    if cell.bare:
        panel.set_axis_off()
    if cell.map is not None:
        panel.grid(False)
    if not cell.y.name and not cell.map:
        panel.tick_params(labelleft=False)
    share = panel.get_position().width
    if share < FULL:  # ticks at the ends would touch those of the cell beside
        panel.xaxis.set_major_locator(MaxNLocator(max(2, min(8, int(share * style.WIDTH / TICK))), prune="both"))
    if cell.x.origin:
        panel.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:.4g}"))
        panel.xaxis.label.set_fontsize(7)


def draw_map(figure, panel, drawn, along, divisor):
    """Draws a map into a panel, with its colour bar or a legend of its classes."""
    classes = drawn.classes
    palette = ListedColormap(list(classes.values())) if classes else drawn.palette
    scale, label = scaled_label(drawn.name, drawn.unit, max(abs(drawn.low), abs(drawn.high)))
    norm = Normalize(drawn.low / scale, drawn.high / scale)
    image = ScalarMappable(norm, palette)
    if drawn.values.size:
        image = panel.pcolormesh(along(drawn.x), drawn.y / divisor, drawn.values / scale, cmap=palette, norm=norm, rasterized=True,
                                 shading="gouraud" if drawn.smooth else "flat")
    for line in drawn.lines:
        panel.plot(along(line[:, 0]), line[:, 1] / divisor, color="white", lw=0.7)
    if classes:
        panel.legend(handles=[Patch(color=colour, label=name) for name, colour in classes.items()], loc="center left",
                     bbox_to_anchor=(1.01, 0.5), fontsize=6.5, handlelength=0.9)
        return
    bar = figure.colorbar(image, cax=panel.inset_axes((1.03, 0, 0.035, 1)), extend="max" if drawn.beyond else "neither")
    if drawn.ticks:
        bar.set_ticks([place for place, _ in drawn.ticks], labels=[words for _, words in drawn.ticks])
        bar.ax.minorticks_off()
    else:
        bar.ax.yaxis.set_major_locator(MaxNLocator(4))
    bar.ax.tick_params(labelsize=7)
    if label.strip():
        bar.set_label(label.strip(), fontsize=7)


def draw_shapes(panel, cell, along, divisor):
    """Draws the shapes and notes of a cell into a panel."""
    scale = numpy.array([along(cell.x.origin + 1.0), 1 / divisor])
    for shape in cell.shapes:
        for outline in shape.outlines:
            points = (outline - (cell.x.origin, 0)) * scale
            if shape.fill:
                panel.add_patch(Polygon(points, closed=True, facecolor=shape.fill, edgecolor=shape.edge, lw=shape.width, clip_on=False))
            else:
                panel.plot(*points.T, color=shape.edge, lw=shape.width, ls=LOOKS[shape.look], clip_on=False)
    for note in cell.notes:
        place = {"transform": panel.transAxes} if not cell.shapes else {}
        x, y = (note.x, note.y) if not cell.shapes else (along(note.x), note.y / divisor)
        panel.text(x, y, note.words, ha=ANCHORS[note.anchor], va="center", fontsize=note.size, color=note.colour,
                   bbox=style.BEHIND_TEXT if note.boxed else None, **place)


def name_curves(panel, cell, above):
    """Writes title and legend above a cell."""
    base = PHASES * bool(cell.phases)  # [inch] above the axes
    if above.title:
        panel.set_title("\n".join(above.title), loc="left", pad=72 * (base + ENTRY * above.rows) + 4, color=style.INK, fontweight="bold")
    handles, names = panel.get_legend_handles_labels()
    for shape in reversed(cell.shapes):  # the upper parts of a drawing come last
        if shape.label:
            handles.append(Patch(facecolor=shape.fill, edgecolor=shape.edge, lw=0.4) if shape.fill else panel.plot(
                [], [], color=shape.edge, lw=shape.width, ls=LOOKS[shape.look])[0])
            names.append(shape.label)
    if not handles or not cell.legend or panel.get_legend() is not None:
        return
    tall = panel.get_position().height * panel.figure.get_figheight()
    panel.legend(handles, names, loc="lower left" if above.rows else "lower right",
                 bbox_to_anchor=(0.0 if above.rows else 1.0, 1 + (base + 0.03) / tall), ncol=above.columns, borderaxespad=0.0,
                 handlelength=1.6, columnspacing=1.2, borderpad=0.0, labelspacing=0.35)
