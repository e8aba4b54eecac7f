# SPDX-License-Identifier: Apache-2.0
"""Tilt and turn of a recorded tool while it touches the skin."""

import numpy

from ...errors import CaseError
from . import frame

OBLIQUE = numpy.radians(20)  # between the tool's nearest axis and the normal, where the finger is not along that axis
LEAST = numpy.radians(1)
STEEPEST = numpy.radians(5)  # roll and pitch together of a case


class Tilt:
    """Tilt of a tool on the skin.

    angles  array [rows, 3]: roll, pitch and yaw of the slider [rad]; between touches linear in time, yaw 0 when the first
            touch begins
    steep   array [rows]: roll and pitch together [rad]
    what    what tilts, and the direction from which its tilt counts, in words
    """

    def __init__(self, time, turn, axes, touches):
        """Finds the tilt.

        time     array [rows] [s]
        turn     array [rows, 4]: quaternions x, y, z, w
        axes     array [3, 3]: rotation from the frame of the recording to the skin
        touches  array [rows]: True in contact, at least once
        """
        parts = [frame.turned(turn, axis) @ axes.T for axis in numpy.eye(3)]
        rotations = numpy.stack(parts, axis=2)  # [row, axis of the skin, axis of the tool]
        first = rotations[numpy.argmax(touches)]
        nearest = int(numpy.argmax(numpy.abs(first[2])))
        finger = numpy.sign(first[2, nearest]) * numpy.eye(3)[nearest]
        self.what = f"the tool's {'xyz'[nearest]} axis", "the skin's normal"
        if abs(first[2, nearest]) < numpy.cos(OBLIQUE):
            finger, self.what = first[2], ("the tool", "its direction at the first touch")
        side = first[0] - (first[0] @ finger) * finger
        x, z = rotations @ (side / numpy.linalg.norm(side)), rotations @ finger
        y = numpy.cross(z, x)
        roll, pitch = numpy.arctan2(y[:, 2], z[:, 2]), -numpy.arcsin(numpy.clip(x[:, 2], -1, 1))
        yaw = numpy.arctan2(x[:, 1], x[:, 0])
        known = numpy.column_stack((roll, pitch, numpy.unwrap(yaw)))[touches]
        known[:, 2] -= known[0, 2]
        self.angles = numpy.column_stack([numpy.interp(time, time[touches], one) for one in known.T])
        self.steep = numpy.hypot(self.angles[:, 0], self.angles[:, 1])
        self._time = time

    def sentence(self):
        """Largest tilt and turn, in words; None for those that do not matter."""
        row, turned = int(numpy.argmax(self.steep)), float(numpy.abs(self.angles[:, 2]).max())
        if self.steep[row] < LEAST and turned < LEAST:
            return None
        roll, pitch = numpy.round(numpy.degrees(self.angles[row, :2]), 2) + 0.0
        turns = f", and turns about the normal by up to {numpy.degrees(turned):.3g}" if turned >= LEAST else ""
        return (f"in contact {self.what[0]} tilts by up to {numpy.degrees(self.steep[row]):.3g} degrees from {self.what[1]} "
                f"(roll {roll:.3g}, pitch {pitch:.3g} degrees, at {self._time[row]:.4g} s){turns}")

    def remedy(self):
        """Remedy for a path that leaves the tilt out."""
        if self.steep.max() <= STEEPEST:
            return "--angles takes it into the path"
        return "a case takes tilts up to 5 degrees; for a steeper one give the underside as a height map (docs/shapes.md)"

    def require_flat(self):
        """Raises CaseError where the tilt is steeper than a case takes."""
        if self.steep.max() > STEEPEST:
            raise CaseError(f"{self.sentence()}\n  = leave out --angles; {self.remedy()}")
