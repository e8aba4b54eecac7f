# SPDX-License-Identifier: Apache-2.0
"""Engine that runs trials on this machine, several at once, each in a process."""

import concurrent.futures
import contextlib
import json
import os
import pathlib
import queue
import subprocess
import sys
import tempfile
import threading

from .. import solver
from ..errors import CaseError
from .trial import Outcome

NO_ERRORS = {"numerics.error_estimate": "off"}  # which an outcome does not keep; its numbers are the same bits
LAUNCHER = pathlib.Path(__file__).parent.parent / "isolated.py"


class LocalEngine:
    """Engine that runs trials on this machine, in processes of one thread each, so that results do not depend on their
    number.

    workers  number of processes; 0: one for each processor
    """

    def __init__(self, workers: int = 0) -> None:
        self.workers = workers or len(os.sched_getaffinity(0))

    def evaluate(self, case, trials, folder, on_result) -> None:
        """Runs every trial and writes its outcome to FOLDER/NUMBER.npz, also where its solver gives up.

        case       not used: every trial has its own case
        trials     list of Trial
        folder     folder of the outcomes
        on_result  called in this thread with (trial, Outcome) as each trial ends; an exception that it raises stops the others

        Raises CaseError for a case with mistakes.
        """
        del case  # every trial holds its own
        free: queue.SimpleQueue = queue.SimpleQueue()
        workers = [TrialProcess() for _ in range(min(self.workers, len(trials)))]
        for worker in workers:
            free.put(worker)
        stopped = threading.Event()

        def work(trial):
            worker = free.get()
            try:
                return None if stopped.is_set() else worker.run(task_of(trial), folder / f"{trial.number:06}.npz")
            finally:
                free.put(worker)

        pool = concurrent.futures.ThreadPoolExecutor(max(1, len(workers)))
        try:
            tasks = {pool.submit(work, trial): trial for trial in trials}
            for done in concurrent.futures.as_completed(tasks):
                on_result(tasks[done], done.result())
        finally:
            stopped.set()
            for worker in workers:
                worker.stop()
            pool.shutdown(wait=True, cancel_futures=True)


def task_of(trial) -> dict:
    """Task of a TrialProcess for a trial: a dict with the text, path and edits of its case, and the build of ionskin."""
    return {"text": trial.case._original, "path": os.path.abspath(trial.case._path), "edits": trial.case._edits | NO_ERRORS,
            "build": solver.load().build()}


class TrialProcess:
    """Process that runs one trial after another. It is started with the first trial, and again when it was killed."""

    def __init__(self) -> None:
        self._process, self._stopped = None, False

    def run(self, task: dict, path) -> Outcome:
        """Runs a task, writes its outcome to `path` and returns it. Raises CaseError for a case with mistakes."""
        with tempfile.TemporaryDirectory(prefix="ionskin-trial-", ignore_cleanup_errors=True) as scratch:
            line = json.dumps(task | {"scratch": scratch, "file": os.fspath(path)})
            for _ in range(2):  # a killed process is not a fault of the trial
                answer = self._ask(line)
                if answer == "done":
                    return Outcome.read_back(path)
                if answer:
                    raise CaseError(answer)
        lost = Outcome({}, {}, reason="the process that ran it ended twice without an answer")
        if not self._stopped:
            lost.write(path)
        return lost

    def _ask(self, line: str) -> str:
        """Sends a line to the process and returns its answer; "" when it ended without one."""
        if self._stopped:
            return ""
        if self._process is None or self._process.poll() is not None:
            environment = os.environ | {"OPENBLAS_NUM_THREADS": "1"}
            # Of a session of its own: an interrupt at the terminal is this process's to handle.
            self._process = subprocess.Popen([sys.executable, "-I", "-B", os.fspath(LAUNCHER), "ionskin.evaluation.worker",
                                              str(os.getpid())], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                             text=True, env=environment, start_new_session=True)
        try:
            self._process.stdin.write(line + "\n")
            self._process.stdin.flush()
            return json.loads(self._process.stdout.readline() or '""')
        except (OSError, ValueError):
            return ""

    def stop(self) -> None:
        self._stopped = True
        if self._process is not None:
            self._process.kill()
            with contextlib.suppress(OSError), self._process:  # closes its pipes and waits
                pass
