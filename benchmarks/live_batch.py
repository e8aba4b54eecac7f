#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Steps a second of many reduced skins in closed loop, against a Python loop over single ones in the same run.

    benchmarks/live_batch.py build skin.live

Each environment strokes to and fro at a speed of its own under a force that follows a random one, so that at any time some stick,
some begin to slip and some slide; a tenth is lifted. Rates are by the clock and by processor time, and the first is what a
machine without other load has.
"""

import argparse
import os
import pathlib
import sys
import time

import numpy

STEP = 1e-3  # [s]
SETTLE = 20  # steps before any is timed


class Strokes:
    """Positions and forces of all environments, step by step."""

    def __init__(self, skin, count: int, seed: int) -> None:
        self.random, self.range, self.step = numpy.random.default_rng(seed), skin.range, 0
        self.low, self.high = numpy.array(self.range.lowest), numpy.array(self.range.highest)
        self.place = self.low + self.random.random((count, 2)) * (self.high - self.low)
        self.speed = self.random.uniform(-1, 1, (count, 2)) * self.range.speed * (self.high > self.low)
        self.force = numpy.zeros(count)
        self.turn()

    def turn(self) -> None:
        count = len(self.force)
        self.speed *= numpy.where(self.random.random((count, 1)) < 0.5, -1, 1)
        self.wanted = numpy.where(self.random.random(count) < 0.1, 0, self.random.uniform(0.15, 1, count) * self.range.force)

    def next(self):
        """Time, positions and forces."""
        if self.step % 200 == 199:
            self.turn()
        beyond = (self.place <= self.low) | (self.place >= self.high)
        inwards = numpy.where(self.place <= self.low, 1, -1) * numpy.abs(self.speed)
        self.speed = numpy.where(beyond, inwards, self.speed)
        self.place = numpy.clip(self.place + STEP * self.speed, self.low, self.high)
        self.force += 0.05 * (self.wanted - self.force)
        self.step += 1
        return STEP * self.step, self.place, self.force


def timed(step, strokes: Strokes, seconds: float) -> tuple[numpy.ndarray, float]:
    """Seconds by the clock of each step, and processor seconds of all."""
    for _ in range(SETTLE):
        step(*strokes.next())
    clock, processor = [], 0.0
    begin = time.perf_counter()
    while len(clock) < 5 or time.perf_counter() - begin < seconds:
        arguments = strokes.next()
        before, busy = time.perf_counter(), time.process_time()
        step(*arguments)
        clock.append(time.perf_counter() - before)
        processor += time.process_time() - busy
    return numpy.array(clock), processor


def tell(name: str, count: int, clock: numpy.ndarray, processor: float) -> float:
    rate = count * len(clock) / processor
    print(f"{name:22} {count:5} environments: {count * len(clock) / clock.sum():9.0f} steps a second by the clock, {rate:9.0f} by "
          f"processor time of one core; a step of all: median {1e3 * numpy.median(clock):.3f} ms, 99 % below "
          f"{1e3 * numpy.quantile(clock, 0.99):.3f} ms", flush=True)
    return rate


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("file", type=pathlib.Path)
    parser.add_argument("--environments", type=int, nargs="+", default=[1, 256, 4096])
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--seconds", type=float, default=10, help="of each measurement")
    parser.add_argument("--loop", type=int, default=256, help="environments of the Python loop")
    arguments = parser.parse_args()
    sys.path.insert(0, str(arguments.build / "python"))
    from ionskin.live import Skin, Skins

    skin = Skin(arguments.file)
    print(f"load of the machine {os.getloadavg()[0]:.1f}, {arguments.threads} threads")
    singles = [skin.copy() for _ in range(arguments.loop)]

    def loop(at, places, forces):
        for single, place, force in zip(singles, places, forces, strict=True):
            single.step(at, place, force=force)

    before = tell("Python loop", len(singles), *timed(loop, Strokes(skin, len(singles), 1), arguments.seconds))
    for count in arguments.environments:
        skins = Skins(skin, count, threads=arguments.threads)
        rate = tell("Skins", count, *timed(lambda at, places, forces, skins=skins: skins.step(at, places, forces=forces),
                                           Strokes(skin, count, 1), arguments.seconds))
        print(f"{'':22} {rate / before:.1f} times the loop, by processor time")


if __name__ == "__main__":
    main()
