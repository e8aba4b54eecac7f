# SPDX-License-Identifier: Apache-2.0
"""Run a case, or many at once."""

import os
import shutil
import tempfile
import threading
import weakref
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from . import solver
from .case import Case, toml_text
from .cluster.running import sweep_on_cluster
from .errors import CaseError, SolverError
from .results import Results
from .sweep_results import Sweep

Progress = Callable[[str, float], None]
SAMPLINGS = ("sobol", "latin")
STUDIES = ("", "mechanics", "electrochemistry")


def run(case: Case, output: str | os.PathLike | None = None, *, threads: int = 0, progress: Progress | None = None,
        overwrite: bool = False, resume: bool = False, only: str = "", report: bool = False, cache: bool | str = True) -> Results:
    """Runs a case and returns what it wrote.

    output     folder of the results; None: a temporary one that goes with the returned object
    threads    at most so many; 0: all processors
    progress   called with (activity, finished fraction in [0, 1]), from whichever thread works; what it raises stops
               the run
    overwrite  replace the results in the folder
    resume     finish an interrupted run of the same case in its folder
    only       "mechanics", or "electrochemistry" on the finished mechanics in the folder
    report     draw the figures and write report.html
    cache      has no effect any more: nothing is kept in the home folder

    Raises CaseError before any work, SolverError, and KeyboardInterrupt; what was finished then stays in the folder.
    Other Python threads go on meanwhile; a second run waits for the first, but `progress` cannot begin one. A process
    that was forked during a run cannot run either: both are a CaseError.
    """
    _require("only", only, STUDIES)
    with_folder, keep = _folder(output)
    settings = solve_settings(with_folder, threads, overwrite, resume, only, report, "run")
    solver.load().run(case, settings, progress)
    return Results(with_folder, keep)


def sweep(case: Case, over: Mapping[str, str | Sequence[Any]], output: str | os.PathLike | None = None, *,
          samples: int = 0, sampling: str = "sobol", seed: int = 1, threads: int = 0, progress: Progress | None = None,
          overwrite: bool = False, resume: bool = False, only: str = "", report: bool = False,
          cache: bool = True, on: str | os.PathLike | None = None) -> Sweep:
    """Runs a case at many values of its keys; the mechanics is shared wherever it can be.

    over      values by key: a list of them (SI numbers, or texts with a unit), or a text as for --over, such as
              "0.05:0.05:0.5"; several keys make a grid
    samples   so many points instead of the grid; every value of `over` is then a pair (lowest, highest)
    sampling  "sobol" or "latin", with its seed
    on        file of a cluster's scheduler (ionskin cluster start), whose workers then do the batches of the sweep, each
              with `threads` threads, 1 by default; ClusterError when points are left

    The others are those of `run`. A point that fails is a point with its reason. Raises CaseError before any work,
    SolverError when every point failed, and KeyboardInterrupt; finished points stay, and resume=True continues.
    """
    _require("sampling", sampling, SAMPLINGS)
    _require("only", only, STUDIES[:2])
    axes = [_axis(key, values, samples > 0) for key, values in over.items()]
    if not axes:
        raise CaseError("the sweep varies nothing\n  = give `over` at least one key with its values")
    with_folder, keep = _folder(output)
    settings = solve_settings(with_folder, threads, overwrite, resume, only, report, "sweep")
    settings |= {"samples": samples, "sampling": sampling, "seed": seed}
    if on is not None:
        sweep_on_cluster(case, axes, with_folder, on, settings, progress)
        return Sweep(with_folder, keep)
    failures = solver.load().sweep(case, axes, settings, progress)
    result = Sweep(with_folder, keep)
    if failures and len(failures) == len(result.points):
        raise SolverError(f"every point of the sweep failed; the first: {next(iter(failures.values()))}")
    return result


def _axis(key: str, values: str | Sequence[Any], interval: bool) -> str:
    if isinstance(values, str):
        return f"{key}={values}"
    unit = solver.load().key_unit(key) or ""
    texts = [toml_text(value, unit) for value in values]
    if interval and len(texts) != 2:
        raise CaseError(f"{key}: a sampled sweep takes a pair (lowest, highest), not {len(texts)} values")
    return f"{key}={(':' if interval else ',').join(texts)}"


class _TemporaryFolder:
    """Removed with the last result that holds it."""

    def __init__(self) -> None:
        self.name = tempfile.mkdtemp(prefix="ionskin-")
        weakref.finalize(self, shutil.rmtree, self.name, ignore_errors=True)


def _folder(output: str | os.PathLike | None) -> tuple[str, _TemporaryFolder | None]:
    if output is not None:
        return os.fspath(output), None
    keep = _TemporaryFolder()
    return keep.name, keep


def solve_settings(folder: str, threads: int, overwrite: bool, resume: bool, only: str, report: bool,
              verb: str) -> dict[str, Any]:
    if overwrite and resume:
        raise CaseError("overwrite and resume exclude each other")
    # As bytes: names of folders need not be UTF-8.
    return {"output": os.fsencode(folder), "threads": threads, "overwrite": overwrite, "resume": resume, "only": only, "report": report,
            "command": f"ionskin.{verb} (Python)",
            "main_thread": threading.current_thread() is threading.main_thread()}


def _require(name: str, value: Any, known: Sequence[Any]) -> None:
    if value not in known:
        raise CaseError(f"{name} = {value!r} is unknown\n  = choose one of {', '.join(map(repr, known))}")
