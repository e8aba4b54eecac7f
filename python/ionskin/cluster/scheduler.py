# SPDX-License-Identifier: Apache-2.0
"""The process of a cluster's scheduler: python3 -I isolated.py ionskin.cluster.scheduler FOLDER ADDRESS tls|plain"""

import asyncio
import json
import os
import pathlib
import sys

import dask
from distributed import Scheduler

from .security import SCHEDULER, tls

ALLOWED_FAILURES = 3  # workers that a batch may end before it is given up
WORKER_PATIENCE = "60s"  # until a silent worker counts as lost


async def serve(folder, address, security):
    """Runs until a client or a signal stops it."""
    path = folder / SCHEDULER
    # What /info and /metrics tell needs no login: this machine only.
    scheduler = Scheduler(host=address, port=0, protocol="tls" if security else "tcp", security=security,
                          dashboard_address="127.0.0.1:0", allowed_failures=ALLOWED_FAILURES, worker_ttl=WORKER_PATIENCE)
    async with scheduler:
        pending = path.with_suffix(".new")
        pending.write_text(json.dumps(scheduler.identity() | {"pid": os.getpid()}, indent=1), encoding="utf-8")
        pending.rename(path)
        await scheduler.finished()
    path.unlink(missing_ok=True)


def main():
    """Runs the scheduler of a cluster, by its command line: folder, address, "tls" or "plain"."""
    folder = pathlib.Path(sys.argv[1])
    security = tls(folder) if sys.argv[3] == "tls" else None
    dask.config.set({"distributed.comm.require-encryption": security is not None})
    asyncio.run(serve(folder, sys.argv[2], security))


if __name__ == "__main__":
    main()
