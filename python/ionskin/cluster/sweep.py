# SPDX-License-Identifier: Apache-2.0
"""Hands the batches of a planned sweep to the workers of a cluster: python3 -I isolated.py ionskin.cluster.sweep DIR ...

Ends with 0 when every batch came back, whatever its points did, with 2 before any work, with 5 when the scheduler is lost.
"""

import argparse
import json
import os
import pathlib
import signal
import sys
import uuid

from ..errors import CaseError, exit_on
from ..reading import files
from .client import LOST, Job, SchedulerLost, connected, require_room, work_off, workers_of
from .progress import BatchProgress
from .task import do_batch, unpack

LARGEST_PLAN = 128 << 20  # bytes
DONE = (0, 3)  # exit codes of a batch whose points are rows


def numbers(text):
    """Reads a list of numbers with ranges: "0-3,7" gives [0, 1, 2, 3, 7]."""
    ranges = [part.split("-") for part in text.split(",") if part]
    return [number for ends in ranges for number in range(int(ends[0]), int(ends[-1]) + 1)]


class Driver:
    """Runs the batches of a planned sweep on a cluster, the longest first, and takes their results into the sweep's folder."""

    def __init__(self, client, folder, plan, progress):
        self.client, self.folder, self.progress = client, folder, progress
        self.plan, self.digest = plan, json.loads(plan)["digest"]
        self.token = f".ionskin-cluster-{uuid.uuid4().hex}"

    def job(self, batch):
        """Makes the Job of a batch of the plan. Its key follows from plan and batch, so that
        a client that reconnects finds the task."""
        call = do_batch, batch["number"], str(self.folder), self.token, self.plan, batch["threads"]
        return Job(f"batch {batch['number']}", f"ionskin-{self.digest}-{batch['number']}", call, batch["threads"],
                   batch["memory_bytes"])

    def take(self, job, result, problem):
        """Takes the result of a batch that ended, or the text of its failure, and reports it."""
        batch = job.call[1]
        if not problem:
            if result["archive"] is not None:
                unpack(result["archive"], self.folder / "staging" / f"received-{batch:04}")
            problem = "" if result["code"] in DONE else result["message"] or f"the program ended with {result['code']}"
        if problem:
            self.progress.failed.add(batch)
            self.progress.say(f"warning: batch {batch} failed: {problem}")
        else:
            self.progress.done.add(batch)

    def run(self, batches):
        """Runs batches, given as entries of the plan. Raises CaseError before any work, and SchedulerLost."""
        jobs = [self.job(batch) for batch in sorted(batches, key=lambda batch: -batch["seconds"])]
        require_room(workers_of(self.client), jobs)
        (self.folder / self.token).touch()
        try:
            work_off(self.client, jobs, self.take, self.progress.show)
        finally:
            (self.folder / self.token).unlink(missing_ok=True)


def drive(folder, scheduler, chosen, mode):
    """Runs batches of the sweep that is planned in a folder on a cluster.

    scheduler  file of the cluster's scheduler
    chosen     numbers of the batches
    mode       form of the progress, as for BatchProgress

    Raises CaseError and SchedulerLost.
    """
    with files.open_ordinary(folder / "plan.json", LARGEST_PLAN) as file:
        plan = file.read()
    batches = [batch for batch in json.loads(plan)["batches"] if batch["number"] in set(chosen)]
    progress = BatchProgress(mode, {batch["number"]: batch["seconds"] or 1 for batch in batches})
    with connected(scheduler) as client:
        try:
            Driver(client, folder.resolve(), plan, progress).run(batches)
        finally:
            progress.close()


def main():
    """Runs batches of a planned sweep on a cluster, by its command line."""
    parser = argparse.ArgumentParser(prog="ionskin.cluster.sweep", description=__doc__)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--on", required=True)
    parser.add_argument("--batches", type=numbers, required=True)
    parser.add_argument("--progress", default="lines")
    arguments = parser.parse_args()
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        with exit_on(CaseError):
            drive(arguments.folder, arguments.on, arguments.batches, arguments.progress)
    except SchedulerLost:
        print(f"error: the scheduler of {arguments.on} is lost; what was finished is kept\n  = start the cluster again, and "
              "finish the sweep with --resume", file=sys.stderr, flush=True)
        os._exit(LOST)  # Dask would go on trying to connect
    except KeyboardInterrupt:
        sys.exit(130)


if __name__ == "__main__":
    main()
