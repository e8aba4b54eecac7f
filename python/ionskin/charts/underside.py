# SPDX-License-Identifier: Apache-2.0
"""Underside of a slider, as figures draw it."""

import numpy

from ..quantity import si

CAP = 0.7e-3  # height of the drawn part of a round slider [m]
BLOCK = 1.0e-3  # of any other [m]; a slider's height is not part of the model
CLOSED_FORMS = ("flat", "cylinder", "sphere")  # any other shape is drawn by the heights that its run states


class Underside:
    """Height of a slider's underside above its lowest point, as a function of x and y from the slider's centre [m]."""

    def __init__(self, slider, heights=None):
        """`slider` is the case's table, `heights` those that the run states (read_heights).

        Raises ValueError and KeyError where it holds what a figure cannot draw.
        """
        self.shape = slider.get("shape", "flat")
        self.radius = si(slider["radius"]) if self.shape in ("cylinder", "sphere") else None
        self.edge_radius = si(slider.get("edge_radius", "0 m")) if self.shape == "flat" else 0.0
        self.size = numpy.array([2 * self.radius] * 2 if "size" not in slider and self.radius else si(slider["size"]))
        self.map = heights if self.shape not in CLOSED_FORMS else None

    @property
    def sharp(self):
        """True for a slider that figures draw as a box."""
        return self.unknown or self.shape == "flat" and self.edge_radius == 0

    @property
    def unknown(self):
        """True if the heights are not known, neither from the case nor from the run."""
        return self.shape not in CLOSED_FORMS and self.map is None

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
        """Height of the underside above its lowest point [m], at most that of the drawn part."""
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
        """Points along x at each y, and their heights [m], as arrays [y, points]."""
        # Denser towards the ends, where a rounded edge is steep.
        share = numpy.sin(numpy.linspace(-numpy.pi / 2, numpy.pi / 2, points))
        y = numpy.atleast_1d(y)
        x = self.reach(y)[:, None] * share
        return x, self.height(x, numpy.broadcast_to(y[:, None], x.shape))


def arc(radius, distance):
    """Height of a circle above its lowest point at a distance from its centre line [m]; the radius beyond it."""
    return radius - numpy.sqrt(numpy.maximum(0.0, radius**2 - numpy.square(distance)))


def read_heights(results, end=""):
    """Height map of a slider from the results of a run, as a function of x and y [m]; None where the run has none.

    end  suffix of the names of the slider's signals
    """
    if not (results.folder / "results.h5").exists():
        return None
    with results.open_fields() as file:
        if f"slider{end}" not in file:
            return None
        x, y, heights = (file[f"slider{end}"][name][...] for name in ("x", "y", "height"))
    return interpolated(x, y, heights)


def interpolated(x, y, heights):
    """Function of x and y that interpolates heights [y, x] bilinearly, constant beyond their border."""
    def at(places_x, places_y):
        places_x, places_y = numpy.clip(places_x, x[0], x[-1]), numpy.clip(places_y, y[0], y[-1])
        column = numpy.clip(numpy.searchsorted(x, places_x) - 1, 0, len(x) - 2)
        row = numpy.clip(numpy.searchsorted(y, places_y) - 1, 0, len(y) - 2)
        across = (places_x - x[column]) / (x[column + 1] - x[column])
        along = (places_y - y[row]) / (y[row + 1] - y[row])
        near = heights[row, column] * (1 - across) + heights[row, column + 1] * across
        far = heights[row + 1, column] * (1 - across) + heights[row + 1, column + 1] * across
        return near * (1 - along) + far * along

    return at
