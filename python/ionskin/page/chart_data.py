# SPDX-License-Identifier: Apache-2.0
"""Conversion of charts to the JSON data that the script of a page, chart_cells.js, draws."""

import base64
import struct
import zlib

import numpy

from ..charts.colours import PALETTES, THEMED_COLOURS, mixed, parts

MOST_POINTS = 6000  # of a curve; of longer ones the extremes of equal numbers of rows are kept
MOST_PIXELS = 480  # of a map along x or y
SHADES = 254  # of a palette; the first entry of a picture's own is transparent
DIGITS = 5  # of what is drawn
DIGITS_ALONG = 9  # of where: events last a millionth of a run


def colour(name):
    """CSS value of a colour, which follows the page's light or dark theme."""
    return f"var(--{THEMED_COLOURS[name]})" if name in THEMED_COLOURS else name


def rounded(values, digits=DIGITS):
    """Rounds values to some significant digits, as a list for JSON; None for NaN and infinity."""
    values = numpy.asarray(values, float)
    with numpy.errstate(divide="ignore", invalid="ignore"):
        power = 10.0 ** numpy.clip(digits - 1 - numpy.floor(numpy.log10(numpy.abs(values))), -300, 300)
        short = numpy.where(values == 0, 0.0, numpy.round(values * power) / power)
    return short.tolist() if numpy.isfinite(short).all() else [value if numpy.isfinite(value) else None for value in short]


def kept_rows(curve):
    """Indices of the rows of a curve that a page draws: all, or for long curves the extremes of y within groups of rows."""
    count = len(curve.y)
    if count <= MOST_POINTS:
        return numpy.arange(count)
    group = -(-2 * count // MOST_POINTS)
    whole = numpy.nan_to_num(curve.y[:count - count % group].reshape(-1, group))
    begins = numpy.arange(len(whole)) * group
    return numpy.unique(numpy.concatenate([[0], begins + whole.argmin(axis=1), begins + whole.argmax(axis=1), [count - 1]]))


class Arrays:
    """Arrays of numbers of a page, each stored once; charts refer to them by index."""

    def __init__(self):
        self.series, self.places = [], {}

    def place(self, values, rows, digits=DIGITS):
        """Index of the chosen rows of an array, which is added if it is new."""
        chosen = values[rows]
        key = (chosen.tobytes(), digits)
        if key not in self.places:
            self.places[key] = len(self.series)
            self.series.append(rounded(chosen, digits))
        return self.places[key]


def curve_data(curve, arrays):
    """Data of a Curve, with the indices of its numbers in `arrays`."""
    rows = kept_rows(curve)
    data = {"x": arrays.place(curve.x, rows, DIGITS_ALONG), "y": arrays.place(curve.y, rows), "colour": colour(curve.colour),
            "label": curve.label, "step": curve.step, "width": curve.width, "look": curve.look, "marks": curve.marks}
    if curve.band is not None:
        data["band"] = [arrays.place(end, rows) for end in curve.band]
    return data


def palette_of(drawn):
    """Colours of a Map in the order of its values."""
    return list(drawn.classes.values()) if drawn.classes else [mixed(drawn.palette, place / (SHADES - 1)) for place in range(SHADES)]


def pixels(drawn):
    """Resamples a Map on equal pixels, as an array with the upper row first."""
    if drawn.smooth:
        x, y = (numpy.linspace(ends[0], ends[-1], count) for ends, count in ((drawn.x, MOST_PIXELS), (drawn.y, MOST_PIXELS // 4)))
        rows = numpy.array([numpy.interp(x, drawn.x, row) for row in drawn.values])
        return numpy.array([numpy.interp(y, drawn.y, column) for column in rows.T]).T[::-1]
    picked = []
    for edges in (drawn.x, drawn.y):
        count = int(numpy.clip(numpy.ceil((edges[-1] - edges[0]) / numpy.diff(edges).min()), len(edges) - 1, MOST_PIXELS))
        centres = edges[0] + (edges[-1] - edges[0]) * (numpy.arange(count) + 0.5) / count
        picked.append(numpy.clip(numpy.searchsorted(edges, centres) - 1, 0, len(edges) - 2))
    return drawn.values[numpy.ix_(picked[1], picked[0])][::-1]


def picture(drawn):
    """Data URL of a Map as a PNG picture with a palette; transparent where there is no value."""
    values, colours = pixels(drawn), palette_of(drawn)
    with numpy.errstate(invalid="ignore"):
        places = numpy.clip(numpy.rint((values - drawn.low) / (drawn.high - drawn.low) * (len(colours) - 1)), 0, len(colours) - 1)
    image = numpy.where(numpy.isfinite(values), places + 1, 0).astype(numpy.uint8)

    def chunk(kind, content):
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

    rows = numpy.hstack([numpy.zeros((len(image), 1), numpy.uint8), image])  # a filter of none before each
    entries = bytes([0, 0, 0, *(part for each in colours for part in parts(each))])
    content = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", image.shape[1], image.shape[0], 8, 3, 0, 0, 0))
    content += chunk(b"PLTE", entries) + chunk(b"tRNS", b"\0") + chunk(b"IDAT", zlib.compress(rows.tobytes(), 6)) + chunk(b"IEND", b"")
    return "data:image/png;base64," + base64.b64encode(content).decode("ascii")


def map_data(drawn):
    """Data of a Map with its colour bar or legend."""
    data = {"low": drawn.low, "high": drawn.high, "name": drawn.name, "unit": drawn.unit, "beyond": drawn.beyond, "smooth": drawn.smooth,
            "bar": PALETTES[drawn.palette][::-1], "classes": drawn.classes, "ticks": drawn.ticks,
            "lines": [rounded(line.ravel()) for line in drawn.lines]}
    if drawn.values.size:
        ends = [float(end) for along in (drawn.x, drawn.y) for end in (along[0], along[-1])]
        data.update(image=picture(drawn), ends=ends)
    return data


def cell_data(cell, arrays):
    """Data of a Cell."""
    data = {"title": cell.title, "x": axis_data(cell.x), "y": axis_data(cell.y), "height": cell.height, "legend": cell.legend,
            "equal": cell.equal, "bare": cell.bare, "curves": [curve_data(curve, arrays) for curve in cell.curves],
            "spans": [{**span._asdict(), "colour": colour(span.colour)} for span in cell.spans],
            "marks": [mark._asdict() for mark in cell.marks],
            "shapes": [{"outlines": [rounded(outline.ravel()) for outline in shape.outlines], "fill": shape.fill,
                        "edge": shape.edge and colour(shape.edge), "width": shape.width, "look": shape.look, "label": shape.label}
                       for shape in cell.shapes],
            "notes": [{**note._asdict(), "colour": colour(note.colour)} for note in cell.notes],
            "phases": [{"x": note.x, "words": note.words} for note in cell.phases]}
    return {**data, "map": map_data(cell.map)} if cell.map else data


def axis_data(axis):
    """Data of an Axis."""
    return {name: float(value) if isinstance(value, (float, numpy.number)) else value for name, value in axis._asdict().items()}


def chart_data(charts):
    """Data of all charts of a page, {"arrays": [...], "charts": {name: ...}}; `charts` is a dict of name to Chart."""
    arrays = Arrays()
    found = {name: {"widths": chart.widths, "narrow": chart.narrow,
                    "rows": [[cell_data(cell, arrays) for cell in row] for row in chart.rows]} for name, chart in charts.items()}
    return {"arrays": arrays.series, "charts": found}
