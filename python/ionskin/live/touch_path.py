# SPDX-License-Identifier: Apache-2.0
"""Motion of a touch of a live skin as a path for a full run."""

from collections.abc import Mapping

import numpy

CLEARANCE = 1e-4  # height off the skin while a force of 0 means no contact [m]
PAUSE, LANDING = 0.5, 0.5  # s
USUAL_SPEED = 3e-3  # of a skin that was trained without strokes [m/s]


def touch_path(touch: Mapping, skin=None):
    """Makes the `ionskin.reading.recording.Path` of a touch, whose `write` writes the CSV file for the key motion.file of a case.

    touch  mapping with the arguments of `Skin.run`, such as `Skin.random_touch` returns it
    skin   Skin; None to leave out what follows. Behind the touch, the slider goes through the trained range under the largest
           trained load. Under a round slider, a full run of the path then has the contact cells of the live skin.

    The instants of the path are the times of the touch; it begins at 0 s, and off the skin. Angles that are all 0 are left out.
    Raises ValueError for times below 0.
    """
    from ..reading.recording.path import Path  # a controller reads no recordings

    times, positions = (numpy.asarray(touch[name], dtype=float) for name in ("times", "positions"))
    if times[0] < 0:
        raise ValueError(f"times: {times[0]:g} s is the first, and a path begins at 0 s; add {-times[0]:g} s to all times")
    by_force = touch.get("forces") is not None
    loads = numpy.asarray(touch["forces" if by_force else "heights"], dtype=float)
    angles = touch.get("angles")
    angles = numpy.asarray(angles, dtype=float) if numpy.any(angles) else None
    off = 0.0 if by_force else CLEARANCE
    if times[0] > 0:  # as that of Skin.random_touch, which has no step at 0 s
        before = loads[0] if (loads[0] <= 0 if by_force else loads[0] >= 0) else off
        times, loads, positions = numpy.append(0, times), numpy.append(before, loads), numpy.vstack([positions[:1], positions])
        angles = None if angles is None else numpy.vstack([angles[:1], angles])
    if skin is not None:
        low, high, load = skin.range.lowest, skin.range.highest, skin.range.force if by_force else -skin.range.indentation
        stroke = max(LANDING, numpy.hypot(high[0] - low[0], high[1] - low[1]) / (skin.range.speed or USUAL_SPEED))
        times = numpy.concatenate([times, times[-1] + numpy.cumsum([PAUSE, LANDING, stroke, LANDING])])
        positions = numpy.vstack([positions, low, low, high, high])
        loads = numpy.concatenate([loads, [off, load, load, off]])
        angles = None if angles is None else numpy.vstack([angles, numpy.zeros((4, 3))])
    if by_force:
        pressed = loads > 0
        heights, forces = numpy.where(pressed, numpy.nan, CLEARANCE), numpy.where(pressed, loads, numpy.nan)
    else:
        heights, forces = loads, numpy.full(len(times), numpy.nan)
    return Path(times, positions, heights, forces, [], angles)
