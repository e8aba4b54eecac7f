# SPDX-License-Identifier: Apache-2.0
"""Checks of the arguments of steps of live skins."""

import numpy

HEIGHT, FORCE = 0, 1
_MOST_TURNED = 1e6  # yaw [rad]
_NO_NUMBERS = {  # what there is in place of numbers, by numpy's kind of type, and a remedy
    "c": ("complex ones", "take their real part, such as values.real"),
    "M": ("dates", "give seconds, such as (values - values[0]) / numpy.timedelta64(1, 's')"),
    "m": ("time spans", "give seconds, such as values / numpy.timedelta64(1, 's')"),
    "U": ("text", "convert it, such as by numpy.asarray(values, dtype=float)"),
    "S": ("text", "convert it, such as by numpy.asarray(values, dtype=float)")}


def numbers(name: str, values, dtype=float) -> numpy.ndarray:
    """Converts values to a contiguous array of real numbers of a type, without a copy where it is one already.

    name  name of the argument in messages

    Raises ValueError for anything else: complex numbers, dates, text, None, and masked values.
    """
    if isinstance(values, numpy.ma.MaskedArray) and numpy.ma.is_masked(values):
        raise ValueError(f"{name}: {numpy.ma.count_masked(values)} of {values.size} values are masked\n"
                         "  = leave out their steps, or fill them, such as by values.filled(0)")
    try:
        given = numpy.asarray(values)
        kind = given.dtype.kind
        array = given if kind in _NO_NUMBERS else numpy.asarray(given, dtype=dtype, order="C")
    except (TypeError, ValueError) as wrong:
        raise ValueError(f"{name}: numbers are wanted, not {values!r}") from wrong
    if kind in _NO_NUMBERS:
        what, remedy = _NO_NUMBERS[kind]
        first = f": {given.flat[0]}" if given.size else ""
        raise ValueError(f"{name}: numbers are wanted, not {what}{first}\n  = {remedy}")
    if kind == "O" and any(one is None or isinstance(one, (str, bytes)) for one in given.flat):  # which float() takes
        raise ValueError(f"{name}: numbers are wanted, not {values!r}")
    return array


def whole(name: str, value, least: int, most: int | None = None) -> int:
    """Returns a whole number from `least` to `most`, None for no upper limit. Raises ValueError for anything else."""
    if (isinstance(value, bool) or not isinstance(value, (int, numpy.integer)) or value < least
            or (most is not None and value > most)):
        raise ValueError(f"{name}: a whole number from {least}{'' if most is None else f' to {most}'} is wanted, not {value!r}")
    return int(value)


def finite(name: str, values, shape: tuple) -> numpy.ndarray:
    """Converts values to an array of doubles of a shape.

    name  name of the argument in messages

    Raises ValueError for anything but numbers, for another shape, NaN and infinity.
    """
    array = numbers(name, values)
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
