# SPDX-License-Identifier: Apache-2.0
"""Starts and stops a cluster that sweeps run on: python3 -I isolated.py ionskin.cluster start|worker|stop FOLDER ..."""

import argparse
import os
import pathlib
import subprocess
import sys
import time

from .. import isolated
from ..errors import CaseError, exit_on
from .security import CERTIFICATE, KEY, SCHEDULER, is_loopback, make_certificate, read_scheduler, require_distributed, require_listening
from .worker import default_memory, default_threads, work

START, STOP = 60, 30  # seconds to wait


def detached(folder, name, *arguments):
    """Starts a module of this package that outlives this process; its output goes into a log in the folder."""
    command = [sys.executable, "-I", "-B", isolated.__file__, *arguments]
    with open(folder / f"{name}.log", "wb") as log:
        return subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=log, stderr=log, start_new_session=True)


def require_idle(folder):
    """Requires that no cluster of this folder is running. Raises CaseError when one answers."""
    path = folder / SCHEDULER
    try:
        client = answering(path) if os.path.lexists(path) else None
    except CaseError as error:
        raise CaseError(f"{str(error).splitlines()[0]}\n  = move it away, or choose another folder") from error
    if client is not None:
        raise CaseError(f"{folder} has a running cluster\n  = stop it: ionskin cluster stop {folder}, or choose another folder")
    path.unlink(missing_ok=True)


def answering(path):
    """Dask client of the scheduler whose file is given; None when it does not answer."""
    from distributed import Client  # pylint: disable=import-outside-toplevel
    address, security = read_scheduler(path)
    try:
        require_listening(address, path)
        return Client(address, security=security, timeout=5, set_as_default=False)
    except (CaseError, OSError):
        return None


def wait_for_scheduler(folder, process):
    """Waits until the scheduler has written its file. Raises CaseError with its last words when it ends."""
    deadline = time.monotonic() + START
    while not (folder / SCHEDULER).exists():
        if process.poll() is not None or time.monotonic() > deadline:
            process.kill()
            said = (folder / "scheduler.log").read_text(errors="replace").strip().splitlines()
            raise CaseError(f"the scheduler does not start: {isolated.reason(said[-1] if said else 'it says nothing')}\n  = "
                            f"{folder / 'scheduler.log'} has more")
        time.sleep(0.05)


def start(arguments):
    """Starts a scheduler and workers on this machine. Raises CaseError."""
    folder = arguments.folder
    if not is_loopback(arguments.address) and not arguments.tls:
        raise CaseError(f"other machines could connect to {arguments.address}, and whoever connects can run code\n  = give "
                        "--tls, which lets in holders of the cluster's key only")
    require_distributed()
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    require_idle(folder)
    if arguments.tls:
        make_certificate(folder)
    scheduler = detached(folder, "scheduler", "ionskin.cluster.scheduler", str(folder), arguments.address,
                         "tls" if arguments.tls else "plain")
    wait_for_scheduler(folder, scheduler)
    each = arguments.threads or max(1, default_threads() // max(1, arguments.workers))
    memory = arguments.memory or default_memory() / max(1, arguments.workers)
    for number in range(arguments.workers):
        detached(folder, f"worker-{number + 1}", "ionskin.cluster", "worker", str(folder), "--threads", str(each), "--memory",
                 str(memory))
    print(f"scheduler: {read_scheduler(folder / SCHEDULER)[0]}\n"
          f"workers: {arguments.workers} here, {each} threads and {memory / 1e9:.2g} GB each\n"
          f"use it: ionskin sweep CASE.toml --over KEY=VALUES --on {folder}/{SCHEDULER} -o DIR\n"
          f"stop it: ionskin cluster stop {folder}")
    whole = folder.resolve()
    if arguments.tls:
        print(f"a worker over ssh:   ssh HOST ionskin cluster worker {whole}\n"
              f"workers by Slurm:    sbatch --array=1-4 --requeue --wrap \"ionskin cluster worker {whole} --death-timeout 60\"\n"
              f"where HOST does not share {whole}: copy {SCHEDULER}, {CERTIFICATE} and "
              f"{KEY} there first")
    else:
        print("workers on other machines need --tls and --address with an address of this one")


def stop(arguments):
    """Stops scheduler and workers of a cluster. A running batch is lost; its finished points stay."""
    path = arguments.folder / SCHEDULER
    require_distributed()
    if not os.path.lexists(path):
        raise CaseError(f"{arguments.folder} has no running cluster: {path} is missing")
    client = answering(path)
    if client is None:
        path.unlink(missing_ok=True)
        print("the scheduler was gone already")
        return
    client.shutdown()
    deadline = time.monotonic() + STOP
    while path.exists() and time.monotonic() < deadline:
        time.sleep(0.05)
    print("stopped")


def main():
    """Runs the command line of `ionskin cluster`."""
    parser = argparse.ArgumentParser(prog="ionskin.cluster", description=__doc__)
    parser.add_argument("action", choices=("start", "worker", "stop"))
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--address", default="127.0.0.1")
    parser.add_argument("--tls", action="store_true")
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--threads", type=int, default=0)
    parser.add_argument("--memory", type=float, default=0)
    parser.add_argument("--death-timeout", type=float, default=60)
    arguments = parser.parse_args()
    with exit_on(CaseError, OSError):
        if arguments.action == "start":
            start(arguments)
        elif arguments.action == "stop":
            stop(arguments)
        else:
            work(arguments.folder, arguments.threads, arguments.memory, arguments.death_timeout)
    sys.stdout.flush()
    os._exit(0)  # Dask's threads may linger


if __name__ == "__main__":
    main()
