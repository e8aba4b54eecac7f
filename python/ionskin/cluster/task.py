# SPDX-License-Identifier: Apache-2.0
"""Task of a worker of a cluster: one batch of a sweep, by the program as a process of its own."""

import io
import os
import pathlib
import subprocess
import tempfile
import zipfile

LONGEST_MESSAGE = 2000


def do_batch(batch, folder, token, plan, threads):
    """Does a batch and returns {"code", "message", "archive"}; never raises for what the program says.

    folder, token  of the sweep, and a file in it: where this worker sees it, the results are written there
    plan           bytes of plan.json, for a worker that does not
    archive        the points as a zip file, None where they are in the folder
    """
    if os.path.exists(os.path.join(folder, token)):
        code, message = _program(batch, folder, threads)
        return {"code": code, "message": message, "archive": None}
    with tempfile.TemporaryDirectory(dir=_local_folder()) as place:
        pathlib.Path(place, "plan.json").write_bytes(plan)
        code, message = _program(batch, place, threads)
        return {"code": code, "message": message, "archive": pack(pathlib.Path(place, "points"))}


def pack(folder):
    """A zip file of a folder's files as bytes."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as archive:
        for path in sorted(folder.rglob("*")) if folder.is_dir() else ():
            if path.is_file():
                archive.write(path, path.relative_to(folder))
    return buffer.getvalue()


def unpack(data, folder):
    """The files of `pack` into a folder; names cannot lead out of it."""
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        archive.extractall(folder)


def _local_folder():
    from distributed import get_worker  # pylint: disable=import-outside-toplevel
    return get_worker().local_directory


def _program(batch, folder, threads):
    """The program dies with the worker: else it would go on beside the one that repeats the batch."""
    command = ["setpriv", "--pdeathsig", "KILL", os.environ["IONSKIN_FRONT"], "sweep", "--do-batch", str(batch), "-o", folder,
               "--threads", str(threads), "--quiet"]
    process = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, errors="replace", check=False)
    return process.returncode, process.stderr.strip()[-LONGEST_MESSAGE:]
