# SPDX-License-Identifier: Apache-2.0
"""The underside of a slider, as far as figures draw it."""

import csv

import numpy

from ..quantity import UNITS, si

CAP = 0.7e-3  # height of the drawn part of a round slider [m]
BLOCK = 1.0e-3  # of any other [m]; a slider's height is no part of the model
DRAWN = ("flat", "cylinder", "sphere", "profile")  # any other shape is drawn as a box


class Underside:
    """Heights above the lowest point over the plan of a slider. Lengths in metres, from the slider's centre."""

    def __init__(self, slider):
        """`slider` is the case's table. Raises ValueError and KeyError where it holds what a figure cannot draw."""
        self.shape = slider.get("shape", "flat")
        self.radius = si(slider["radius"]) if self.shape in ("cylinder", "sphere") else None
        self.edge_radius = si(slider.get("edge_radius", "0 m")) if self.shape == "flat" else 0.0
        self.size = numpy.array([2 * self.radius] * 2 if "size" not in slider and self.radius else si(slider["size"]))
        self.map = read_heights(slider["profile"]) if self.shape == "profile" else None

    @property
    def sharp(self):
        """True for a slider that figures draw as a box."""
        return (self.shape not in DRAWN or self.shape == "flat" and self.edge_radius == 0
                or self.shape == "profile" and self.map is None)

    @property
    def depth(self):
        """Height of the drawn part of the body [m]."""
        if self.radius is not None:
            return min(CAP, self.radius)
        return max(BLOCK, 2 * self.edge_radius)

    @property
    def half_size(self):
        """Half the plan of the drawn part along x and y [m]."""
        half = self.size / 2
        if self.radius is None:
            return half
        reach = numpy.sqrt(2 * self.radius * self.depth - self.depth**2)
        return numpy.minimum(half, [reach, reach if self.shape == "sphere" else numpy.inf])

    def reach(self, y):
        """Half the extent of the drawn part along x at places y [m]."""
        half = self.half_size[0]
        return numpy.sqrt(numpy.maximum(0.0, half**2 - y**2)) if self.shape == "sphere" else numpy.full_like(y, half)

    def height(self, x, y):
        """Of the underside above its lowest point [m], at most that of the drawn part."""
        if self.shape == "sphere":
            rise = arc(self.radius, numpy.hypot(x, y))
        elif self.shape == "cylinder":
            rise = arc(self.radius, numpy.abs(x))
        elif self.map is not None:
            rise = self.map(x, y)
        else:
            flat = self.size / 2 - self.edge_radius
            rise = arc(self.edge_radius, numpy.hypot(numpy.maximum(0, numpy.abs(x) - flat[0]),
                                                     numpy.maximum(0, numpy.abs(y) - flat[1])))
        return numpy.minimum(rise, self.depth)

    def lines(self, y, points=121):
        """Places along x at each y, and the heights there [m]: arrays [y, points]."""
        # Denser towards the ends, where a rounded edge is steep.
        share = numpy.sin(numpy.linspace(-numpy.pi / 2, numpy.pi / 2, points))
        y = numpy.atleast_1d(y)
        x = self.reach(y)[:, None] * share
        return x, self.height(x, numpy.broadcast_to(y[:, None], x.shape))


def arc(radius, distance):
    """Height of a circle above its lowest point; that of its top beyond its reach."""
    return radius - numpy.sqrt(numpy.maximum(0.0, radius**2 - numpy.square(distance)))


def read_heights(path):
    """A height map as a function of x and y above its lowest point [m], or None where the file is not at hand."""
    try:
        with open(path, newline="", encoding="utf-8") as file:
            rows = [row for row in csv.reader(file) if row]
        unit = UNITS[rows[0][0].strip()]
        x = unit * numpy.array(rows[0][1:], dtype=float)
        body = unit * numpy.array(rows[1:], dtype=float)
    except (OSError, KeyError, ValueError, IndexError):
        return None
    y, heights = body[:, 0], body[:, 1:] - body[:, 1:].min()

    def at(places_x, places_y):
        column = numpy.clip(numpy.searchsorted(x, places_x) - 1, 0, len(x) - 2)
        row = numpy.clip(numpy.searchsorted(y, places_y) - 1, 0, len(y) - 2)
        across = numpy.clip((places_x - x[column]) / (x[column + 1] - x[column]), 0, 1)
        along = numpy.clip((places_y - y[row]) / (y[row + 1] - y[row]), 0, 1)
        near = heights[row, column] * (1 - across) + heights[row, column + 1] * across
        far = heights[row + 1, column] * (1 - across) + heights[row + 1, column + 1] * across
        return near * (1 - along) + far * along

    return at
