# SPDX-License-Identifier: Apache-2.0
"""Client of a cluster: connects, checks the room on its workers, and runs jobs, of which the
scheduler gets only as many as its workers can soon take."""

import asyncio
import contextlib
import logging
import sys
import threading
from collections.abc import Callable
from typing import Any, NamedTuple

from ..errors import CaseError
from .security import read_scheduler, require_listening

LOST = 5  # exit code
AT_ONCE, CONNECT, FIRST_WORKER = 1, 30, 60  # seconds to wait
WINDOW = 2  # jobs per place that the scheduler knows of: it never queues tasks with resources


class SchedulerLost(Exception):
    """Exception raised when the connection to the scheduler has ended."""


class Job(NamedTuple):
    """Job for a worker of a cluster: a function call, and the room that it needs.

    name     name in messages, such as "batch 3"
    key      key of the task at the scheduler: a client that reconnects and submits the same key finds the task under way
    call     function and its arguments
    threads  number of threads that it needs
    memory   memory that it needs [bytes]
    """

    name: str
    key: str
    call: tuple
    threads: int
    memory: float


@contextlib.contextmanager
def patience(what, most):
    """Context of a wait: after a second, prints what is waited for.

    what  name of the awaited thing
    most  longest time of the wait, for the message [s]
    """
    def tell():
        print(f"waiting for {what}, {most} s at most", file=sys.stderr, flush=True)

    timer = threading.Timer(AT_ONCE, tell)
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()


@contextlib.contextmanager
def connected(scheduler):
    """Context that yields a Dask client of the scheduler whose file is given, once it has a
    worker. Raises CaseError when none comes."""
    address, security = read_scheduler(scheduler)
    require_listening(address, scheduler)
    from distributed import Client  # pylint: disable=import-outside-toplevel
    logging.getLogger("distributed").setLevel(logging.CRITICAL)  # what is lost is reported here
    try:
        with patience(f"the scheduler at {address}", CONNECT):
            client = Client(address, security=security, timeout=CONNECT, name="ionskin")
    except OSError as error:
        raise CaseError(f"the scheduler at {address}, which {scheduler} names, does not answer: {error}\n  = start the cluster "
                        "again: ionskin cluster start FOLDER") from error
    try:
        try:
            with patience(f"a worker at {address}", FIRST_WORKER):
                client.wait_for_workers(1, timeout=FIRST_WORKER)
        except TimeoutError as late:
            raise CaseError(f"no worker came to {address} within {FIRST_WORKER} s\n  = start one: ionskin cluster worker "
                            "FOLDER") from late
        yield client
    finally:
        if client.status == "running":
            client.close(timeout=5)


def workers_of(client):
    """Workers of a cluster, as the scheduler describes them: dict by address. Raises SchedulerLost."""
    if client.status != "running":
        raise SchedulerLost
    try:
        return client.scheduler_info()["workers"]
    except OSError as error:
        raise SchedulerLost from error


def places(workers, job):
    """Number of jobs with the needs of `job` that the workers can run at once."""
    return sum(min(worker["resources"].get("THREADS", 0) // job.threads,
                   worker["resources"].get("MEMORY", 0) // max(1, job.memory)) for worker in workers.values())


def require_room(workers, jobs):
    """Requires that each job fits into some worker. Raises CaseError for a job that
    needs more threads or memory than any has."""
    for job in jobs:
        if places(workers, job) < 1:
            threads, memory = (max(worker["resources"].get(name, 0) for worker in workers.values())
                               for name in ("THREADS", "MEMORY"))
            raise CaseError(f"{job.name} needs {job.threads} threads and {job.memory / 1e9:.2g} GB, "
                            f"and no worker has both: the largest have {threads:.0f} threads and {memory / 1e9:.2g} GB\n  = "
                            "give fewer --threads, start larger workers (ionskin cluster worker --memory), or choose a coarser "
                            "numerics.preset")


def work_off(client, jobs, took: Callable[[Job, Any, str], None], show: Callable[[int, int], None]):
    """Runs all jobs on a cluster, in the order of the list, and returns when all have ended.

    client  Dask client
    jobs    list of Job
    took    called with (job, result, problem) as each job ends: the return value and "", or None and a text on the failure
    show    called with the numbers of running jobs and of workers, about once a second

    Raises CaseError before any work when a job fits into no worker, and SchedulerLost.
    """
    from distributed import wait  # pylint: disable=import-outside-toplevel
    require_room(workers_of(client), jobs)
    pending, running = list(reversed(jobs)), {}
    try:
        while pending or running:
            workers = workers_of(client)
            while pending and len(running) < WINDOW * max(1, places(workers, pending[-1])):
                job = pending.pop()
                running[client.submit(*job.call, key=job.key, pure=False, retries=0,
                                      resources={"THREADS": job.threads, "MEMORY": job.memory})] = job
            busy = sum(len(tasks) for tasks in client.processing().values())
            show(min(busy, len(running)), len(workers))
            with contextlib.suppress(TimeoutError):
                wait(list(running), timeout=1, return_when="FIRST_COMPLETED")
            for future in [future for future in running if future.done()]:
                job = running.pop(future)
                if future.status == "finished":
                    took(job, future.result(), "")
                elif client.status != "running":
                    raise SchedulerLost
                else:
                    took(job, None, f"{type(future.exception()).__name__}: it ended the workers that did it, or could not be "
                                    "started")
                future.release()
    except (Exception, asyncio.CancelledError) as error:
        if client.status != "running":
            raise SchedulerLost from error
        raise
