# SPDX-License-Identifier: Apache-2.0
"""Hands the batches of a planned sweep to the workers of a cluster: python3 -I isolated.py ionskin.cluster.sweep DIR ...

Ends with 0 when every batch came back, whatever its points did, with 2 before any work, with 5 when the scheduler is lost.
"""

import argparse
import asyncio
import contextlib
import json
import logging
import os
import pathlib
import signal
import sys
import uuid

from ..errors import CaseError, exit_on
from .progress import BatchProgress
from .security import read_scheduler
from .task import do_batch, unpack

LOST = 5
CONNECT, FIRST_WORKER = 30, 60  # seconds to wait
WINDOW = 2  # batches per slot that the scheduler knows of: it never queues tasks with resources
DONE = (0, 3)  # exit codes of a batch whose points are rows


class SchedulerLost(Exception):
    """The connection to the scheduler ended."""


def numbers(text):
    """The numbers of "0-3,7"."""
    ranges = [part.split("-") for part in text.split(",") if part]
    return [number for ends in ranges for number in range(int(ends[0]), int(ends[-1]) + 1)]


def slots(workers, batch):
    """How many batches of this kind the workers can do at once."""
    return sum(min(worker["resources"].get("THREADS", 0) // batch["threads"],
                   worker["resources"].get("MEMORY", 0) // max(1, batch["memory_bytes"])) for worker in workers.values())


def require_room(workers, batches):
    """Raises CaseError for a batch that no worker can ever take."""
    for batch in batches:
        if slots(workers, batch) < 1:
            threads, memory = (max(worker["resources"].get(name, 0) for worker in workers.values())
                               for name in ("THREADS", "MEMORY"))
            raise CaseError(f"batch {batch['number']} needs {batch['threads']} threads and {batch['memory_bytes'] / 1e9:.2g} GB, "
                            f"and no worker has both: the largest have {threads:.0f} threads and {memory / 1e9:.2g} GB\n  = "
                            "give fewer --threads, start larger workers (ionskin cluster worker --memory), or choose a coarser "
                            "numerics.preset")


class Driver:
    """Submits batches, longest first, and takes their results."""

    def __init__(self, client, folder, plan, cache, progress):
        self.client, self.folder, self.cache, self.progress = client, folder, cache, progress
        self.plan, self.digest = plan, json.loads(plan)["digest"]
        self.token = f".ionskin-cluster-{uuid.uuid4().hex}"
        self.running = {}

    def workers(self):
        """The workers there are. Raises SchedulerLost."""
        if self.client.status != "running":
            raise SchedulerLost
        try:
            return self.client.scheduler_info()["workers"]
        except OSError as error:
            raise SchedulerLost from error

    def submit(self, batch):
        """The key is the batch's own: a client that comes back finds what is under way."""
        future = self.client.submit(
            do_batch, batch["number"], str(self.folder), self.token, self.plan, batch["threads"], self.cache,
            key=f"ionskin-{self.digest}-{batch['number']}", pure=False, retries=0,
            resources={"THREADS": batch["threads"], "MEMORY": batch["memory_bytes"]})
        self.running[future] = batch

    def take(self, future):
        """One batch that ended."""
        batch = self.running.pop(future)["number"]
        if future.status == "finished":
            result = future.result()
            if result["archive"] is not None:
                unpack(result["archive"], self.folder / "staging" / f"received-{batch:04}")
            problem = "" if result["code"] in DONE else result["message"] or f"the program ended with {result['code']}"
        elif self.client.status != "running":
            raise SchedulerLost
        else:
            problem = f"{type(future.exception()).__name__}: it ended the workers that did it, or could not be started"
        if problem:
            self.progress.failed.add(batch)
            self.progress.say(f"warning: batch {batch} failed: {problem}")
        else:
            self.progress.done.add(batch)
        future.release()

    def run(self, batches):
        """Raises CaseError before any work, and SchedulerLost."""
        from distributed import wait  # pylint: disable=import-outside-toplevel
        require_room(self.workers(), batches)
        pending = sorted(batches, key=lambda batch: batch["seconds"])
        (self.folder / self.token).touch()
        try:
            while pending or self.running:
                workers = self.workers()
                while pending and len(self.running) < WINDOW * max(1, slots(workers, pending[-1])):
                    self.submit(pending.pop())
                busy = sum(len(tasks) for tasks in self.client.processing().values())
                self.progress.show(min(busy, len(self.running)), len(workers))
                with contextlib.suppress(TimeoutError):
                    wait(list(self.running), timeout=1, return_when="FIRST_COMPLETED")
                for future in [future for future in self.running if future.done()]:
                    self.take(future)
        except (Exception, asyncio.CancelledError) as error:
            if self.client.status != "running":
                raise SchedulerLost from error
            raise
        finally:
            (self.folder / self.token).unlink(missing_ok=True)


def drive(folder, scheduler, chosen, cache, mode):
    """Does the chosen batches on a cluster. Raises CaseError and SchedulerLost."""
    address, security = read_scheduler(scheduler)
    from distributed import Client  # pylint: disable=import-outside-toplevel
    logging.getLogger("distributed").setLevel(logging.CRITICAL)  # what is lost is told here
    plan = (folder / "plan.json").read_bytes()
    batches = [batch for batch in json.loads(plan)["batches"] if batch["number"] in set(chosen)]
    progress = BatchProgress(mode, {batch["number"]: batch["seconds"] or 1 for batch in batches})
    try:
        client = Client(address, security=security, timeout=CONNECT, name="ionskin")
    except OSError as error:
        raise CaseError(f"the scheduler at {address}, which {scheduler} names, does not answer: {error}\n  = start the cluster "
                        "again: ionskin cluster start FOLDER") from error
    try:
        try:
            client.wait_for_workers(1, timeout=FIRST_WORKER)
        except TimeoutError as late:
            raise CaseError(f"no worker came to {address} within {FIRST_WORKER} s\n  = start one: ionskin cluster worker "
                            "FOLDER") from late
        Driver(client, folder.resolve(), plan, cache, progress).run(batches)
    finally:
        progress.close()
        if client.status == "running":
            client.close(timeout=5)


def main():
    """Command line."""
    parser = argparse.ArgumentParser(prog="ionskin.cluster.sweep", description=__doc__)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--on", required=True)
    parser.add_argument("--batches", type=numbers, required=True)
    parser.add_argument("--no-cache", action="store_true")
    parser.add_argument("--progress", default="lines")
    arguments = parser.parse_args()
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        with exit_on(CaseError):
            drive(arguments.folder, arguments.on, arguments.batches, not arguments.no_cache, arguments.progress)
    except SchedulerLost:
        print(f"error: the scheduler of {arguments.on} is lost; what was finished is kept\n  = start the cluster again, and "
              "finish the sweep with --resume", file=sys.stderr, flush=True)
        os._exit(LOST)  # Dask would go on trying to connect
    except KeyboardInterrupt:
        sys.exit(130)


if __name__ == "__main__":
    main()
