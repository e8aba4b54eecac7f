# SPDX-License-Identifier: Apache-2.0
"""Results of a run that has not ended: its mechanics, which is in results.h5 once Study 1 is finished."""

import contextlib

from .hdf5 import open_hdf5

# Columns by their places in results.h5.
PLACES = {"time": "path/time", "slider_x": "strain/slider_x", "slider_z": "path/slider_z",
          "normal_force": "path/normal_force", "tangential_force": "path/tangential_force",
          "tangential_force_x": "path/tangential_force_x", "tangential_force_y": "path/tangential_force_y",
          "moment_x": "path/moment_x", "moment_y": "path/moment_y", "moment_z": "path/moment_z",
          "contact_area": "path/contact_area", "stick_share": "path/stick_share", "slip": "path/slip",
          "drive_force_x": "path/drive_force_x", "drive_force_y": "path/drive_force_y"}


def mechanics(path):
    """Reads the mechanics (Study 1): dicts of name to array [rows] and to SI unit, and a list of metrics (name, value,
    unit).

    None when the file does not hold Study 1.
    """
    with contextlib.suppress(OSError, KeyError, TypeError, ValueError, AttributeError), open_hdf5(path) as file:
        # A run of an earlier version lacks the later columns.
        places = {name: place for name, place in PLACES.items() if place in file or name == "time"}
        columns = {name: file[place][:] for name, place in places.items()}
        units = {name: str(file[place].attrs["unit"]) for name, place in places.items()}
        names, texts = (file[f"path/metrics/{part}"].asstr()[:] for part in ("name", "unit"))
        return columns, units, list(zip(names, file["path/metrics/value"][:].tolist(), texts))
    return None


def reason(folder, manifest):
    """Message that says why a folder without signals.csv cannot be read, by its manifest (a dict)."""
    state = manifest.get("state")
    if not folder.exists():
        return f"there is no folder {folder}: name the folder of a finished run"
    if state is None:
        return f"{folder} holds no signals.csv: name the folder of a finished run"
    stages = [name for name, stage in manifest.get("stages", {}).items() if stage.get("state") == state]
    where = f" in its stage {stages[-1]}" if stages else ""
    if state == "running":
        return f"{folder} holds a run that has not ended{where}: read it when it has; if it was killed, --resume ends it"
    why = f"; {manifest['reason']}" if isinstance(manifest.get("reason"), str) else ""
    return f"{folder} holds a run that did not end ({state}{where}{why}): --resume ends it"
