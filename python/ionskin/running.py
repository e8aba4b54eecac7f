# SPDX-License-Identifier: Apache-2.0
"""Runs and sweeps: `run` solves one case, `sweep` the cases of a parameter sweep."""

import os
import shutil
import tempfile
import threading
import weakref
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from . import solver
from .case import Case, toml_text, unit_of_number
from .cluster.running import sweep_on_cluster
from .errors import CaseError, SolverError
from .results import Results
from .sweep_results import Sweep

Progress = Callable[[str, float], None]
SAMPLINGS = ("sobol", "latin")
STUDIES = ("", "mechanics", "electrochemistry")


def run(case: Case, output: str | os.PathLike | None = None, *, threads: int = 0, progress: Progress | None = None,
        overwrite: bool = False, resume: bool = False, only: str = "", report: bool = False, cache: bool | str = True) -> Results:
    """Runs a case, contact mechanics (Study 1) and then ion transport (Study 2), and returns its Results.

    output     folder of the results; None: a temporary folder, removed with the returned object
    threads    largest number of threads; 0: one for each processor
    progress   called with (activity, finished fraction in [0, 1]), from any thread; an exception that it raises stops the run
    overwrite  True to replace earlier results in the folder
    resume     True to finish an interrupted run of the same case in its folder
    only       "": both studies; "mechanics": Study 1 only; "electrochemistry": Study 2 only, on the finished mechanics in the
               folder
    report     True to draw the figures and write report.html
    cache      ignored

    Other Python threads go on during a run. A second run waits for the first one.

    Raises CaseError before any work when the case or a setting is wrong, and when a run is started by `progress` or in a
    process that was forked during a run. Raises SolverError when a solver gives up, and KeyboardInterrupt; what was finished
    stays in the folder then.
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
    """Runs a case at many points, each with other values of some keys, and returns the Sweep.

    The mechanics (Study 1) is solved once for all points between which it does not differ.

    over      dict of key to its values: a list (numbers in SI units, or texts with a unit), or a text as for --over, such as
              "0.05:0.05:0.5" (first:step:last); several keys make a grid
    samples   0: the grid; else the number of sampled points, where each value of `over` is a pair (lowest, highest)
    sampling  "sobol" (Sobol' sequence) or "latin" (Latin hypercube)
    seed      seed of the sampling
    on        file of a cluster's scheduler (ionskin cluster start), whose workers then run the sweep, each with `threads`
              threads (0: 1 thread); None: this process

    `output`, `threads`, `progress`, `overwrite`, `resume`, `report` and `cache` are those of `run`; `only` is "" or
    "mechanics". A point that fails does not end the sweep: it is listed in the Sweep with the reason.

    Raises CaseError before any work, SolverError when every point failed, ClusterError when a cluster left points undone, and
    KeyboardInterrupt; finished points stay, and resume=True continues.
    """
    _require("sampling", sampling, SAMPLINGS)
    _require("only", only, STUDIES[:2])
    axes = [_axis(case, key, values, samples > 0) for key, values in over.items()]
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


def _axis(case: Case, key: str, values: str | Sequence[Any], interval: bool) -> str:
    if isinstance(values, str):
        return f"{key}={values}"
    texts = [toml_text(value, "" if isinstance(value, str) else unit_of_number(case, key)) for value in values]
    if interval and len(texts) != 2:
        raise CaseError(f"{key}: a sampled sweep takes a pair (lowest, highest), not {len(texts)} values")
    return f"{key}={(':' if interval else ',').join(texts)}"


class _TemporaryFolder:
    """Temporary folder, removed when the last object that holds it is deleted."""

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
