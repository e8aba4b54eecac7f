# SPDX-License-Identifier: Apache-2.0
"""Engine that runs trials of a study on the workers of a cluster, each in a process of one thread."""

import pathlib
import tempfile
import threading
import uuid

from .. import solver
from ..errors import CaseError
from ..evaluation.local import TrialProcess, task_of
from ..evaluation.trial import Outcome
from .client import Job, connected, work_off
from .security import read_scheduler

OUTCOME = "outcome.npz"
_own = threading.local()  # the process of each of the worker's threads


def do_trial(task: dict) -> dict:
    """Runs one trial on a worker and returns {"outcome": bytes of its file, "mistake": what is wrong with the case}."""
    from distributed import get_worker  # pylint: disable=import-outside-toplevel
    if not hasattr(_own, "process"):
        _own.process = TrialProcess()
    with tempfile.TemporaryDirectory(dir=get_worker().local_directory) as place:
        path = pathlib.Path(place, OUTCOME)
        try:
            _own.process.run(task, path)
        except CaseError as error:
            return {"outcome": b"", "mistake": str(error)}
        return {"outcome": path.read_bytes(), "mistake": ""}


class ClusterEngine:
    """Engine that runs trials on the workers of a cluster; their outcomes come back through its scheduler.

    on       file of the cluster's scheduler
    workers  number of workers, as last reported
    """

    def __init__(self, on) -> None:
        """Reads the file of the scheduler. Raises CaseError when it is none, or may not be connected to."""
        read_scheduler(on)
        self.on, self.workers = on, 0

    def evaluate(self, case, trials, folder, on_result) -> None:
        """Runs every trial and writes its outcome, as `LocalEngine.evaluate` does. Raises CaseError and SchedulerLost."""
        del case  # every trial holds its own
        if not trials:
            return
        study, by_number = uuid.uuid4().hex, {trial.number: trial for trial in trials}
        jobs = [Job(f"run {trial.number}", f"ionskin-{study}-{trial.number}", (do_trial, task_of(trial)), 1,
                    solver.load().memory(trial.case)) for trial in trials]

        def took(job, result, problem):
            trial = by_number[int(job.key.rsplit("-", maxsplit=1)[1])]
            path = folder / f"{trial.number:06}.npz"
            if problem:
                Outcome({}, {}, reason=problem).write(path)
            elif result["mistake"]:
                raise CaseError(result["mistake"])
            else:
                Outcome.keep(result["outcome"], path)
            on_result(trial, Outcome.read_back(path))

        def show(running, workers):
            del running
            self.workers = workers

        with connected(self.on) as client:
            work_off(client, jobs, took, show)
