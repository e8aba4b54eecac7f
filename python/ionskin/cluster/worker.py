# SPDX-License-Identifier: Apache-2.0
"""Worker of a cluster, which runs until its scheduler ends: a Dask nanny, whose worker starts the program for each batch."""

import asyncio
import os
import pathlib
import tempfile

from ..errors import CaseError
from .security import SCHEDULER, read_scheduler, require_listening

MEMORY_SHARE = 0.9  # of what is free, by default


def default_threads():
    """Number of processors that Slurm gave the job, or else those of this process."""
    return int(os.environ.get("SLURM_CPUS_PER_TASK") or len(os.sched_getaffinity(0)))


def default_memory():
    """Memory of a worker [bytes]: that which Slurm gave the job on this node, or else a share of the free memory."""
    if os.environ.get("SLURM_MEM_PER_NODE"):
        return float(os.environ["SLURM_MEM_PER_NODE"]) * 2**20
    with open("/proc/meminfo", encoding="ascii") as file:
        kilobytes = next(int(line.split()[1]) for line in file if line.startswith("MemAvailable"))
    return MEMORY_SHARE * 1024 * kilobytes


def local_folder():
    """Folder of this user on a local disk of this machine, in which batches run."""
    path = pathlib.Path(tempfile.gettempdir(), f"ionskin-worker-{os.getuid()}")
    path.mkdir(mode=0o700, exist_ok=True)
    state = path.lstat()
    if state.st_uid != os.getuid() or not path.is_dir() or path.is_symlink():
        raise CaseError(f"{path} belongs to somebody else\n  = let TMPDIR name a folder of yours on this machine")
    return path


async def _work(address, security, host, threads, memory, death_timeout):
    from distributed import Nanny  # pylint: disable=import-outside-toplevel
    nanny = Nanny(address, nthreads=threads, memory_limit=0, security=security, host=host, death_timeout=death_timeout,
                  local_directory=str(local_folder()), resources={"THREADS": threads, "MEMORY": memory},
                  dashboard_address="127.0.0.1:0")
    async with nanny:
        await nanny.finished()


def work(folder, threads, memory, death_timeout):
    """Runs a worker for the cluster of a folder until its scheduler ends.

    threads, memory  number of threads and memory [bytes]; 0 for the defaults
    death_timeout    time for which it waits for the scheduler [s]

    Raises CaseError.
    """
    address, security = read_scheduler(pathlib.Path(folder) / SCHEDULER)
    require_listening(address, pathlib.Path(folder) / SCHEDULER)
    try:
        asyncio.run(_work(address, security, None if security else "127.0.0.1", threads or default_threads(),
                          memory or default_memory(), death_timeout))
    except (OSError, asyncio.TimeoutError) as error:
        raise CaseError(f"the scheduler at {address} does not answer: {error}\n  = is the cluster running? ionskin cluster "
                        "start FOLDER") from error
