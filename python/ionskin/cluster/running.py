# SPDX-License-Identifier: Apache-2.0
"""Sweep from Python on a cluster: runs the program ionskin, which plans it, hands out its batches and collects results."""

import json
import os
import pathlib
import shutil
import signal
import subprocess
import tempfile

from .. import solver
from ..errors import CaseError, SolverError

UNFINISHED, LOST, INTERRUPTED = 4, 5, 130  # exit codes


class ClusterError(RuntimeError):
    """Error of a cluster that did not finish a sweep; finished points stay in the folder, and resume=True continues."""


def program():
    """Path of the program ionskin that belongs to this package. Raises CaseError when it is not found."""
    beside = pathlib.Path(solver.load().__file__).resolve().parent.parent / "ionskin"
    found = str(beside) if beside.is_file() else shutil.which("ionskin")
    if found is None:
        raise CaseError("the program ionskin, which sweeps on a cluster go by, is not found\n  = put its folder on PATH")
    return found


def sweep_on_cluster(case, axes, folder, on, settings, progress):
    """Runs a sweep on the workers of a cluster.

    case      the Case
    axes      list of texts "KEY=values", as for --over
    folder    output folder of the sweep
    on        file of the cluster's scheduler
    settings  dict of `running.solve_settings`, with samples, sampling and seed
    progress  called with (activity, finished fraction in [0, 1]); None for no calls

    Raises CaseError before any work, SolverError when every point failed, ClusterError when points are left, and
    KeyboardInterrupt.
    """
    arguments = ["--on", os.fspath(on), "-o", os.fspath(folder), "--threads", str(settings["threads"] or 1),
                 "--progress", "json"]
    for axis in axes:
        arguments += ["--over", axis]
    if settings["samples"]:
        arguments += ["--samples", str(settings["samples"]), "--sampling", settings["sampling"], "--seed", str(settings["seed"])]
    if settings["only"]:
        arguments += ["--only", settings["only"]]
    for given, option in ((settings["overwrite"], "--overwrite"), (settings["resume"], "--resume"),
                          (not settings["report"], "--no-report")):
        arguments += [option] * bool(given)
    with tempfile.TemporaryDirectory(prefix="ionskin-") as place:
        path = pathlib.Path(place, "case.toml")
        path.write_text(solver.load().case_text(case), encoding="utf-8")
        code, said = _run([program(), "sweep", str(path), *arguments], progress)
    if code == INTERRUPTED:
        raise KeyboardInterrupt("what was finished is kept; the same call with resume=True continues")
    if code == 3:
        raise SolverError(f"every point of the sweep failed\n{said}")
    if code in (UNFINISHED, LOST):
        raise ClusterError(said)
    if code != 0:
        raise CaseError(said.removeprefix("error: "))


def _run(command, progress):
    """Runs the program, reports its progress, and returns its exit code and the other lines of its standard error."""
    said = []
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, errors="replace") as process:
        try:
            for line in process.stderr:
                if not line.startswith("{"):
                    said.append(line)
                elif progress is not None:
                    report = json.loads(line)
                    progress(report["activity"], report["fraction"])
        except BaseException:
            process.send_signal(signal.SIGINT)
            raise
    return process.returncode, "".join(said).strip()
