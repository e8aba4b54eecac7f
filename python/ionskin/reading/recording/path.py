# SPDX-License-Identifier: Apache-2.0
"""Path of the slider over the skin, and its CSV file."""

import contextlib
import os
import pathlib
import tempfile

import numpy

from ...errors import CaseError


def require_writable(path, overwrite: bool) -> None:
    """Checks that a path may be written to a file: its folder exists, and nothing of its name, unless it may be replaced.

    Raises CaseError.
    """
    path = pathlib.Path(path)
    if not path.parent.is_dir():
        raise CaseError(f"{path}: there is no folder {path.parent}\n  = make it (mkdir -p {path.parent}), or name another")
    if path.is_dir():
        raise CaseError(f"{path} is a folder\n  = name a file in it, such as {path / 'path.csv'}")
    if path.exists() and not (overwrite and path.is_file()):
        raise CaseError(f"{path} is there already\n  = choose another name, or replace it with --overwrite")


class Path:
    """Path of the slider over the skin as a list of waypoints, made by `ionskin.motion`; each prescribes a height or a
    force.

    time      array [rows]: instants from 0 [s]
    position  array [rows, 2]: x and y of the slider on the skin [m]
    height    array [rows]: height of the underside above the undeformed top face [m]; NaN where the force is prescribed
    force     array [rows]: normal force, compression positive [N]; NaN where the height is prescribed, where the property
              normal_force has 0
    notes     list of sentences that say how the recording was converted
    angles    array [rows, 3]: roll, pitch and yaw of the slider [rad]; None for an upright one
    """

    def __init__(self, time, position, height, force, notes, angles=None):
        self.time, self.position, self.height, self.force, self.notes = time, position, height, force, notes
        self.angles = angles

    @property
    def normal_force(self):
        """Normal force in every row [rows], 0 off the skin [N], as a live skin takes it: `skin.run(path.time, path.position,
        forces=path.normal_force)`.

        Raises CaseError for a path of heights alone.
        """
        if numpy.isnan(self.force).all():
            raise CaseError("the path prescribes heights alone, and no force\n  = give a live skin heights=path.height")
        return numpy.nan_to_num(self.force, nan=0.0)

    def write(self, path, overwrite: bool = False) -> None:
        """Writes the path as the CSV file that the key motion.file of a case takes.

        Raises CaseError when the file exists and `overwrite` is False, or its folder is missing.
        """
        path = pathlib.Path(path)
        require_writable(path, overwrite)
        lines, poses = ["time [s],x [mm],y [mm],height [mm],force [N]"], [""] * len(self.time)
        if self.angles is not None:
            lines[0] += ",roll [deg],pitch [deg],yaw [deg]"
            angles = numpy.round(numpy.degrees(self.angles), 6) + 0.0  # no -0
            poses = ["".join(f",{angle:.6f}" for angle in row) for row in angles.tolist()]
        for time, (x, y), height, force, pose in zip(self.time, self.position, self.height, self.force, poses):
            level = f",{force:.6g}" if numpy.isnan(height) else f"{1e3 * height:.6f},"
            lines.append(f"{time:.9f},{1e3 * x:.6f},{1e3 * y:.6f},{level}{pose}")
        try:
            handle, pending = tempfile.mkstemp(prefix=f"{path.name}.", suffix=".ionskin-pending", dir=path.parent)
        except OSError as error:  # names the file of the user, not the pending one
            raise OSError(error.errno, error.strerror, str(path)) from None
        try:
            with os.fdopen(handle, "w", encoding="ascii") as file:
                file.write("\n".join(lines) + "\n")
            os.chmod(pending, 0o644)
            os.replace(pending, path)
        except BaseException:
            with contextlib.suppress(OSError):
                os.unlink(pending)
            raise
