#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Use of the workers of a cluster: the table of docs/clusters.md.

    benchmarks/cluster_efficiency.py build/ionskin [--sweep] [--sleep] [--turns 3] [--batches 8] [--workers 2]

--sweep: a sweep of equal batches on one worker and on --workers, in turns; the efficiency is T_1/(P T_P). It needs a
machine with nothing else to do: beside each time stand the load average before it and what the batches took of the
processors. Processor time over wall time and places tells the share of the places that worked, whatever else ran; the
growth of processor time a batch tells what the batches took from each other.

--sleep: tasks that sleep on 64 places, 4 workers of 16, handed out as batches are; no processor is needed.
"""

import argparse
import contextlib
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

CASE = pathlib.Path(__file__).parent.parent / "cases" / "paper.toml"
SLEEPING_WORKERS, SLEEPING_THREADS, SLEEP, NAPS = 4, 16, 5.0, 6  # seconds a nap, about a coarse batch, and naps a place


@contextlib.contextmanager
def cluster(program, folder, workers, threads=1):
    """Path of the scheduler's file."""
    subprocess.run([program, "cluster", "start", folder, "--workers", str(workers), "--threads", str(threads), "--memory", "4 GB"],
                   check=True, stdout=subprocess.DEVNULL)
    try:
        yield pathlib.Path(folder, "scheduler.json")
    finally:
        subprocess.run([program, "cluster", "stop", folder], check=True, stdout=subprocess.DEVNULL)


def processor_time(scheduler):
    """Processor time of the workers of a cluster and of what they started [s]: Dask's worker process waits for the
    programs."""
    import distributed  # pylint: disable=import-outside-toplevel
    with distributed.Client(scheduler_file=str(scheduler), set_as_default=False) as client:
        return sum(client.run(lambda: sum(os.times()[:4])).values())


def sweep(program, place, scheduler, batches):
    """Wall time and processor time of the workers [s]."""
    preloads = ",".join(f"{1 + 0.01 * i:.2f} um" for i in range(batches))
    before = processor_time(scheduler)
    begin = time.monotonic()
    subprocess.run([program, "sweep", CASE, "--set", "numerics.preset=coarse", "--over", f"motion.preload={preloads}", "--on",
                    scheduler, "-o", place, "--no-report", "--quiet", "--overwrite"], check=True)
    seconds = time.monotonic() - begin
    return seconds, processor_time(scheduler) - before


def compare(program, place, turns, batches, workers):
    """One worker and several, in turns."""
    print(f"{batches} equal batches of one thread; {os.cpu_count()} processors")
    print("turn  workers  load   wall s  processor s  places at work")
    taken = {1: [], workers: []}
    for turn in range(turns):
        for count in taken:
            with cluster(program, place / f"cluster-{turn}-{count}", count) as scheduler:
                load = os.getloadavg()[0]
                wall, processor = sweep(program, place / "out", scheduler, batches)
            taken[count].append((wall, processor))
            print(f"{turn + 1:4}  {count:7}  {load:4.1f}  {wall:7.1f}  {processor:11.1f}  {100 * processor / wall / count:12.0f} %",
                  flush=True)
    one, several = ([statistics.median(column) for column in zip(*taken[count])] for count in taken)
    ratios = [a[0] / b[0] / workers for a, b in zip(*taken.values())]
    print(f"efficiency T_1/({workers} T_{workers}): median {100 * statistics.median(ratios):.1f} %, by turn "
          + ", ".join(f"{100 * ratio:.1f} %" for ratio in ratios))
    print(f"processor time a batch: {one[1] / batches:.2f} s on one worker, {several[1] / batches:.2f} s on {workers}, ratio "
          f"{several[1] / one[1]:.3f}")


def sleep(program, place):
    """Tasks that sleep, by the loop that hands out batches."""
    sys.path.insert(0, str(pathlib.Path(program).resolve().parent / "python"))
    from ionskin.cluster.client import Job, connected, work_off  # pylint: disable=import-outside-toplevel
    places = SLEEPING_WORKERS * SLEEPING_THREADS
    with cluster(program, place / "sleeping", SLEEPING_WORKERS, SLEEPING_THREADS) as scheduler, connected(scheduler) as client:
        client.wait_for_workers(SLEEPING_WORKERS)
        ended = []
        jobs = [Job(f"nap {i}", f"nap-{i}", (time.sleep, SLEEP), 1, 0) for i in range(places * NAPS)]
        begin = time.monotonic()
        work_off(client, jobs, lambda job, result, problem: ended.append(problem), lambda running, workers: None)
        wall = time.monotonic() - begin
    if ended != [""] * len(jobs):
        sys.exit(f"{len(ended)} of {len(jobs)} naps ended: {set(ended)}")
    print(f"{len(jobs)} tasks of {SLEEP:g} s on {places} places: {wall:.2f} s, efficiency "
          f"{100 * SLEEP * NAPS / wall:.1f} %; load {os.getloadavg()[0]:.1f}")


def main():
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=lambda path: str(pathlib.Path(path).resolve()))
    parser.add_argument("--sweep", action="store_true")
    parser.add_argument("--sleep", action="store_true")
    parser.add_argument("--turns", type=int, default=3)
    parser.add_argument("--batches", type=int, default=8)
    parser.add_argument("--workers", type=int, default=2)
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="ionskin-efficiency-") as place:
        if arguments.sleep or not arguments.sweep:
            sleep(arguments.program, pathlib.Path(place))
        if arguments.sweep or not arguments.sleep:
            compare(arguments.program, pathlib.Path(place), arguments.turns, arguments.batches, arguments.workers)


if __name__ == "__main__":
    main()
