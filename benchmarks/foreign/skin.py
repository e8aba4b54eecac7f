# SPDX-License-Identifier: Apache-2.0
"""The skin that every code is given: layers and materials of cases/paper.toml on a smaller piece, a rigid sphere, and the
structured mesh of its half y <= WIDTH / 2. Lengths in mm, forces in N, stresses in MPa, as CalculiX is used."""

import math

import numpy

LENGTH, WIDTH = 4.0, 2.0
ELECTRODE, CORE = 0.01, 0.18
HEIGHT = CORE + 2 * ELECTRODE
PLATINUM, NAFION = (168e3, 0.38), (249.0, 0.49)  # Young's modulus and Poisson's ratio
RADIUS, FRICTION = 8.0, 0.3
START, INDENTATION = 1.9, 2e-3
STEPS, STEP = 10, 0.02  # of the slide
TOUCH_STEPS = 4
REACH = 0.16  # half the length that is meshed finely: the contact ends within it
SLIDE = STEPS * STEP


def graded(length, first, growth=1.5, largest=0.4):
    """Sizes that grow from `first` and fill `length`."""
    sizes = [first]
    while sum(sizes) < length:
        sizes.append(min(sizes[-1] * growth, largest))
    return numpy.array(sizes) * (length / sum(sizes))


def mesh_lines(size, core_elements):
    """Lines of a tensor mesh along x, y and z with elements of `size` wherever the sphere touches."""
    low, high = START - REACH, START + SLIDE + REACH
    inner = numpy.linspace(low, high, math.ceil((high - low) / size) + 1)
    left, right = low - numpy.cumsum(graded(low, size)), high + numpy.cumsum(graded(LENGTH - high, size))
    x = numpy.concatenate([left[::-1], inner, right])
    under = numpy.linspace(WIDTH / 2 - REACH, WIDTH / 2, math.ceil(REACH / size) + 1)
    y = numpy.concatenate([(under[0] - numpy.cumsum(graded(under[0], size)))[::-1], under])
    x[0], y[0] = 0, 0
    z = numpy.concatenate([[0], numpy.linspace(ELECTRODE, ELECTRODE + CORE, core_elements + 1), [HEIGHT]])
    return x, y, z


def schedule():
    """Indentation and travel after every step."""
    touch = [(INDENTATION * (step + 1) / TOUCH_STEPS, 0.0) for step in range(TOUCH_STEPS)]
    return touch + [(INDENTATION, STEP * (step + 1)) for step in range(STEPS)]
