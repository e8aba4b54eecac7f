# SPDX-License-Identifier: Apache-2.0
"""A path over the skin, and its file."""

import contextlib
import os
import pathlib
import tempfile

import numpy

from ...errors import CaseError


class Path:
    """A path over the skin, row by row, in SI.

    time      [rows], from 0
    position  [rows, 2] of the slider on the skin
    height    [rows] of its underside above the undeformed top face; not a number where the force leads
    force     [rows], normal, compression positive; not a number where the height leads
    notes     what was done with the recording, a sentence each
    """

    def __init__(self, time, position, height, force, notes):
        self.time, self.position, self.height, self.force, self.notes = time, position, height, force, notes

    def write(self, path, overwrite: bool = False) -> None:
        """Writes the path as motion.file takes it. Raises CaseError where the file is there and `overwrite` is not
        set."""
        path = pathlib.Path(path)
        if path.exists() and not (overwrite and path.is_file()):
            raise CaseError(f"{path} is there already\n  = choose another name, or replace it with --overwrite")
        lines = ["time [s],x [mm],y [mm],height [mm],force [N]"]
        for time, (x, y), height, force in zip(self.time, self.position, self.height, self.force):
            level = f",{force:.6g}" if numpy.isnan(height) else f"{1e3 * height:.6f},"
            lines.append(f"{time:.9f},{1e3 * x:.6f},{1e3 * y:.6f},{level}")
        handle, pending = tempfile.mkstemp(prefix=f"{path.name}.", suffix=".ionskin-pending", dir=path.parent)
        try:
            with os.fdopen(handle, "w", encoding="ascii") as file:
                file.write("\n".join(lines) + "\n")
            os.chmod(pending, 0o644)
            os.replace(pending, path)
        except BaseException:
            with contextlib.suppress(OSError):
                os.unlink(pending)
            raise
