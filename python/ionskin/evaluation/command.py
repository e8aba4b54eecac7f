# SPDX-License-Identifier: Apache-2.0
"""Parts that the commands that run many trials share: options, the base case, progress, exit codes."""

import contextlib
import json
import os
import pathlib
import signal
import sys
import tempfile
import time
import types

from .. import solver
from ..case import Case
from ..cluster.client import LOST, SchedulerLost
from ..cluster.trials import ClusterEngine
from ..errors import CaseError, in_words
from .local import LocalEngine

SOLVER_GAVE_UP, INTERRUPTED = 3, 130
EVERY = 60  # seconds
REPRESENTATIVE = 16  # trials


def given_options() -> types.SimpleNamespace:
    """Options of the command line, which the program ionskin passes as one JSON object, named as in its options.hpp."""
    return types.SimpleNamespace(**json.loads(sys.argv[1]))


def base_case(arguments) -> Case:
    """Case of a command, with the edits of --set, checked. Raises CaseError."""
    case = Case.from_file(arguments.case_path)
    for edit in arguments.set_edits:
        key, _, text = edit.partition("=")
        case._edits[key.strip()] = text
    return case.check()


def engine(arguments) -> LocalEngine | ClusterEngine:
    """Engine that runs the trials: on this machine, or on the cluster that --on names. Raises CaseError."""
    if arguments.on:
        if arguments.threads > 1:
            raise CaseError(f"a run of a study takes one thread, not --threads {arguments.threads}\n  = leave out --threads: "
                            "the cluster's workers say how many runs they do at once")
        return ClusterEngine(arguments.on)
    return LocalEngine(arguments.threads)


def require_disk(trials, count: int, folder, runner) -> None:
    """Requires room on the disk for the outcomes of `count` trials, and for the files that trials write while they run.

    trials  trials of the study; the first of them stand for all
    folder  output folder of the study
    runner  the engine

    Raises CaseError, before any work, when there is not enough room.
    """
    kept = pathlib.Path(folder, "points")
    there = sum(1 for _ in kept.iterdir()) if kept.is_dir() else 0
    sizes = [solver.load().output(trial.case) for trial in trials[:REPRESENTATIVE]]
    if sizes:
        tables = sum(of_tables for _, of_tables in sizes) / len(sizes)
        solver.load().require_disk(tables * max(0, count - there), os.fsencode(folder))
        if isinstance(runner, LocalEngine):  # the cluster's workers have disks of their own
            at_once = min(runner.workers, count)
            solver.load().require_disk(at_once * max(whole for whole, _ in sizes), tempfile.gettempdir())


class Progress:
    """Progress of a study, as lines on standard error: each failure, and the number of
    runs after each tenth and each minute."""

    def __init__(self, total: int, quiet: bool, runner) -> None:
        """Begins the count of `total` runs; `runner` is the engine, whose number of
        workers is printed. `quiet`: prints nothing."""
        self._total, self._quiet, self._runner = total, quiet, runner
        self._done = self._failed = 0
        self._begin = self._printed = time.monotonic()

    def __call__(self, outcome) -> None:
        self._done += 1
        self._failed += bool(outcome.reason)
        if self._quiet:
            return
        if outcome.reason:
            print(f"failed: {outcome.reason}", file=sys.stderr, flush=True)
        now = time.monotonic()
        if self._done * 10 // self._total != (self._done - 1) * 10 // self._total or now - self._printed > EVERY:
            self._printed = now
            left = (now - self._begin) / self._done * (self._total - self._done)
            workers = self._runner.workers
            print(f"{self._done} of {self._total} runs ended, {self._failed} failed; {workers} worker{'s' * (workers != 1)}"
                  + (f"; about {left:.0f} s left" if self._done < self._total else ""), file=sys.stderr, flush=True)


@contextlib.contextmanager
def guarded():
    """Context of a command: ends the program with code 2 at the user's mistake, 5 at a lost scheduler, 130 at an interrupt, a
    request to end or a lost terminal."""
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    if signal.getsignal(signal.SIGHUP) != signal.SIG_IGN:  # as under nohup
        signal.signal(signal.SIGHUP, signal.default_int_handler)
    try:
        yield
    except SchedulerLost:
        print("error: the scheduler is lost; what was finished is kept\n  = start the cluster again, and finish with --resume",
              file=sys.stderr, flush=True)
        sys.stdout.flush()
        os._exit(LOST)  # Dask would go on trying to connect
    except (CaseError, OSError) as error:
        print(f"error: {in_words(error)}", file=sys.stderr)
        sys.exit(2)
    except KeyboardInterrupt:
        print("interrupted: finish with --resume", file=sys.stderr)
        sys.exit(INTERRUPTED)
