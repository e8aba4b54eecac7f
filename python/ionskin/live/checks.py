# SPDX-License-Identifier: Apache-2.0
"""Checks of the arguments of steps of live skins."""

import numpy

HEIGHT, FORCE = 0, 1
_MOST_TURNED = 1e6  # yaw [rad]


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
        first = numpy.unravel_index(numpy.argmin(numpy.isfinite(array)), shape)
        place = f" (first at index {', '.join(map(str, first))})" if shape else ""
        remedy = {"forces": "\n  = of a path of ionskin.motion take path.normal_force",
                  "heights": "\n  = a path of ionskin.motion has no height where a force presses: give forces=path.normal_force"}.get(name, "")
        raise ValueError(f"{name}: holds NaN or infinity{place}{remedy}")
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


def require_ascending_times(times: numpy.ndarray, last: float | None) -> None:
    """Checks the times of steps.

    times  array [step] [s]
    last   time of the step before them [s]; None if there was none

    Raises ValueError where a time lies before the one that precedes it.
    """
    if (numpy.diff(times) < 0).any():
        later = int(numpy.argmax(numpy.diff(times) < 0)) + 1
        raise ValueError(f"times: {times[later]} s (index {later}) comes after {times[later - 1]} s")
    if last is not None and len(times) and times[0] < last:
        raise ValueError(f"time: {times[0]} s comes before the last step at {last} s; restore a state, or reset")


def require_turns(name: str, yaw: float) -> None:
    """Raises ValueError for a yaw [rad] whose magnitude is larger than a step takes."""
    if abs(yaw) > _MOST_TURNED:
        raise ValueError(f"{name}: {yaw:g} rad is outside +-{_MOST_TURNED:g} rad")
