# SPDX-License-Identifier: Apache-2.0
"""Motion of a touch of a live skin as a path for a full run."""

from collections.abc import Mapping

import numpy

CLEARANCE = 1e-4  # height off the skin while a force of 0 means no contact [m]


def touch_path(touch: Mapping):
    """Makes the `ionskin.reading.recording.Path` of a touch, whose `write` writes the CSV file for the key motion.file of a case.

    touch  mapping with the arguments of `Skin.run`, such as `Skin.random_touch` returns it

    Time begins at 0 s with the first step. Angles that are all 0 are left out.
    """
    from ..reading.recording.path import Path  # a controller reads no recordings

    times, positions = (numpy.asarray(touch[name], dtype=float) for name in ("times", "positions"))
    if touch.get("forces") is not None:
        forces = numpy.asarray(touch["forces"], dtype=float)
        heights, forces = numpy.where(forces > 0, numpy.nan, CLEARANCE), numpy.where(forces > 0, forces, numpy.nan)
    else:
        heights = numpy.asarray(touch["heights"], dtype=float)
        forces = numpy.full(len(times), numpy.nan)
    angles = touch.get("angles")
    return Path(times - times[0], positions, heights, forces, [], angles if numpy.any(angles) else None)
