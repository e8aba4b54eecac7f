# SPDX-License-Identifier: Apache-2.0
"""Task of a cluster's worker: one batch of a sweep, run by the program ionskin as a separate process."""

import io
import os
import pathlib
import subprocess
import tempfile
import zipfile

LONGEST_MESSAGE = 2000


def do_batch(batch, folder, token, plan, threads):
    """Runs one batch of a planned sweep on a worker. It does not raise when the program fails.

    batch    number of the batch
    folder   output folder of the sweep
    token    name of a file in the folder: a worker that sees the file shares the folder and writes its results there
    plan     bytes of plan.json, for a worker that does not share the folder
    threads  number of threads

    Returns {"code": exit code, "message": standard error, "archive": zip file of the points as bytes, or None where they are
    in the folder}.
    """
    if os.path.exists(os.path.join(folder, token)):
        code, message = _program(batch, folder, threads)
        return {"code": code, "message": message, "archive": None}
    with tempfile.TemporaryDirectory(dir=_local_folder()) as place:
        pathlib.Path(place, "plan.json").write_bytes(plan)
        code, message = _program(batch, place, threads)
        return {"code": code, "message": message, "archive": pack(pathlib.Path(place, "points"))}


def pack(folder):
    """Packs all files of a folder into a zip file and returns its bytes."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as archive:
        for path in sorted(folder.rglob("*")) if folder.is_dir() else ():
            if path.is_file():
                archive.write(path, path.relative_to(folder))
    return buffer.getvalue()


def unpack(data, folder):
    """Unpacks the bytes of `pack` into a folder; no name can lead out of the folder."""
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        archive.extractall(folder)


def _local_folder():
    from distributed import get_worker  # pylint: disable=import-outside-toplevel
    return get_worker().local_directory


def _program(batch, folder, threads):
    """Runs the program on a batch; returns exit code and standard error. It ends with the
    worker, since the batch is repeated then."""
    command = ["setpriv", "--pdeathsig", "KILL", os.environ["IONSKIN_FRONT"], "sweep", "--do-batch", str(batch), "-o", folder,
               "--threads", str(threads), "--quiet"]
    process = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, errors="replace", check=False)
    return process.returncode, process.stderr.strip()[-LONGEST_MESSAGE:]
