# SPDX-License-Identifier: Apache-2.0
"""The strain history that every code is given: a patch of shear that is switched on, moves in ten steps and is switched
off, linear in time between the instants and through the thickness, constant over each cell. In SI."""

import numpy

LENGTH, WIDTH, CORE = 4e-3, 2e-3, 180e-6
CELLS = (16, 8)
PATCH = (1.5e-3, 1e-3)  # its size
PLACES = 1.5e-3 + 1e-4 * numpy.arange(11)  # of its centre along x
ON, OFF, RAMP, END = 0.1, 1.1, 5e-4, 2.0  # [s] a millimetre in a second between them
SHEAR = 0.02  # at the upper wall; 0.4 times that at the lower
TIMES = numpy.concatenate([[0, ON - RAMP], numpy.linspace(ON, OFF, 11), [OFF + RAMP, END]])
DIFFUSIVITY, PERMITTIVITY, CONCENTRATION, COUPLING, TEMPERATURE = 7e-11, 2e-3, 1200.0, 0.1, 293.15
CURRENT_FROM = OFF - 0.1  # to OFF: the interval of the mean current


def share(edges, low, high):
    """Share of each cell that lies between `low` and `high`."""
    return numpy.clip(numpy.minimum(edges[1:], high) - numpy.maximum(edges[:-1], low), 0, None) / numpy.diff(edges)


def cells():
    """Edges along x and y, and at each of TIMES the shear at the upper wall [time, y, x]."""
    x, y = (numpy.linspace(0, size, count + 1) for size, count in zip((LENGTH, WIDTH), CELLS))
    across = share(y, (WIDTH - PATCH[1]) / 2, (WIDTH + PATCH[1]) / 2)
    shear = numpy.zeros((len(TIMES), CELLS[1], CELLS[0]))
    for step, place in enumerate(PLACES):
        shear[2 + step] = SHEAR * numpy.outer(across, share(x, place - PATCH[0] / 2, place + PATCH[0] / 2))
    return x, y, shear


def through(height):
    """Shear at a share `height` of the thickness, over that at the upper wall."""
    return 0.4 + 0.6 * height


def figures(times, charges):
    """The two figures that are compared: the difference charge when the patch is switched off, and the mean difference
    current before."""
    last, before = (float(numpy.interp(time, times, charges)) for time in (OFF, CURRENT_FROM))
    return {"charge": last, "current": (last - before) / (OFF - CURRENT_FROM)}
