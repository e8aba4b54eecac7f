# SPDX-License-Identifier: Apache-2.0
"""Transformation from the frame of a recording to that of the skin: origin, axes, quaternions."""

import numpy

from ... import solver
from ...errors import CaseError


def quantity(text, unit, name, default=None):
    """Reads a quantity from a text such as "32 mm" and returns it in the unit `unit`.

    name     name of the option in messages
    default  unit of a number without one; None where a unit is required

    Raises CaseError when it is not such a quantity.
    """
    parts = str(text).strip().split(None, 1)
    try:
        value = float(parts[0]) if parts and _splits(parts[0]) else None
    except ValueError:
        value = None
    if value is None:  # "100Hz"
        stripped = str(text).strip()
        end = len(stripped.rstrip("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZµ"))
        parts = [stripped[:end], stripped[end:]]
        value = float(parts[0]) if _splits(parts[0]) else None
    written = parts[1] if len(parts) > 1 and parts[1] else default
    converted = None if value is None or written is None else solver.load().convert_unit(value, written, unit)
    if converted is None or not numpy.isfinite(converted):
        raise CaseError(f"{name} = {text!r} is not a quantity in {unit}\n  = write a number and a unit, such as \"20 {unit}\"")
    return converted


def _splits(text):
    try:
        float(text)
    except ValueError:
        return False
    return True


def point(text, name):
    """Reads a point, as an array [3] [m], from a text "0.4 m, -0.1 m, 32 mm" or three numbers [m]. Raises CaseError."""
    parts = text.split(",") if isinstance(text, str) else list(text)
    if len(parts) != 3:
        raise CaseError(f"{name} = {text!r}: three lengths are wanted\n  = such as \"0.4 m, -0.1 m, 32 mm\"")
    return numpy.array([quantity(part, "m", name, "m") for part in parts])


def axes(x_axis, y_axis):
    """Rotation matrix [3, 3] from the frame of the recording to the skin: its rows are the skin's x, y and normal, unit
    vectors.

    Raises CaseError when the axes are not perpendicular.
    """
    rows = []
    for text, name in ((x_axis, "--x-axis"), (y_axis, "--y-axis")):
        parts = text.split(",") if isinstance(text, str) else list(text)
        if len(parts) != 3 or not all(_splits(part) for part in parts):
            raise CaseError(f"{name} = {text!r}: three numbers are wanted\n  = such as 0,1,0")
        rows.append(numpy.array([float(part) for part in parts]))
        if not 0 < numpy.linalg.norm(rows[-1]) < numpy.inf:
            raise CaseError(f"{name} {_shown(rows[-1])} is not a direction\n  = give one, such as 0,1,0")
    lengths = [numpy.linalg.norm(row) for row in rows]
    cosine = rows[0] @ rows[1] / (lengths[0] * lengths[1])
    if abs(cosine) > 1e-3:
        right = numpy.cross((0, 0, 1), rows[0])
        remedy = f"such as --y-axis={_shown(right)}" if right.any() else "such as --y-axis 0,1,0"
        raise CaseError(f"--x-axis {_shown(rows[0])} and --y-axis {_shown(rows[1])} are not perpendicular, but at "
                        f"{numpy.degrees(numpy.arccos(numpy.clip(cosine, -1, 1))):.4g} degrees; without --x-axis the skin's x is "
                        f"1,0,0, and without --y-axis its y is 0,1,0\n  = give both, perpendicular to each other, {remedy}")
    x = rows[0] / lengths[0]
    y = rows[1] - (rows[1] @ x) * x
    y /= numpy.linalg.norm(y)
    return numpy.array([x, y, numpy.cross(x, y)])


def _shown(axis):
    """A direction as the user writes it: "0,-1,0"."""
    return ",".join(f"{part + 0.0:.6g}" for part in axis)


def turned(quaternions, vectors):
    """Rotates vectors by quaternions, as an array [rows, 3].

    quaternions  array [rows, 4]: x, y, z, w of any length but 0
    vectors      array [3] or [rows, 3]
    """
    q = quaternions / numpy.linalg.norm(quaternions, axis=1, keepdims=True)
    vectors = numpy.broadcast_to(vectors, (len(q), 3))
    cross = 2 * numpy.cross(q[:, :3], vectors)
    return vectors + q[:, 3:] * cross + numpy.cross(q[:, :3], cross)
