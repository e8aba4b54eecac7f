# SPDX-License-Identifier: Apache-2.0
"""Checks of the arguments of `Skin.step` and `Skins.step`."""

import numpy

HEIGHT, FORCE = 0, 1


def finite(name: str, values, shape: tuple) -> numpy.ndarray:
    """Converts values to an array of doubles of a shape.

    name  name of the argument in messages

    Raises ValueError for anything but numbers, for another shape, NaN and infinity.
    """
    try:
        array = numpy.asarray(values, dtype=float, order="C")
    except (TypeError, ValueError) as wrong:
        raise ValueError(f"{name}: numbers are wanted, not {values!r}") from wrong
    if array.shape != shape:
        raise ValueError(f"{name}: the shape is {array.shape}, and must be {shape}")
    if not numpy.isfinite(array).all():
        raise ValueError(f"{name}: holds NaN or infinity")
    return array


def one_load(height, force, plural: str) -> tuple[int, object]:
    """Load of a step: (HEIGHT, height) or (FORCE, force), whichever is not None.

    plural  ending of the arguments' names in messages, "" or "s"

    Raises TypeError when both or neither are given.
    """
    if (height is None) == (force is None):
        raise TypeError(f"give either height{plural} or force{plural}, " +
                        ("not both" if height is not None else "one of both is missing"))
    return (HEIGHT, height) if force is None else (FORCE, force)
