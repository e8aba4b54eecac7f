#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Random steps of a live skin, from any state to any other: how many miss what was asked, or have a flag without a cause.

    benchmarks/live_steps.py build skin.live [--steps 100000]

A step takes 1 ms, no time at all, or 0.1 ms to 1 s. The slider rests, moves within the trained speed or jumps anywhere within the
trained range, to any force or height and any tilt: detached, a little, the largest, or any between. Some loads are held for a few
steps; friction changes, with and without a reset. Before every tenth step, steps beyond the trained range are tried and compared
with steps to the nearest trained inputs. The exit code is 1 if any count of faults is not 0.
"""

import argparse
import collections
import dataclasses
import pathlib
import sys
import tomllib

import numpy

FLAGS = {1: "place", 2: "load", 4: "speed", 8: "unconverged", 16: "refused", 32: "pulled", 64: "pose"}
EXACT = 1e-3  # error of a force over the force asked for, and of other signals over their largest values
ROUNDING = 1e-6  # error over the largest value
MARGIN = 0.02  # excess over the range that need not have a flag
COMPARED = ["normal_force", "tangential_force_x", "tangential_force_y", "slider_x", "slider_y", "slider_z", "charge_top"]
KIND_STEPS = 20  # by force or by height
HELD_STEPS = 4
BEYOND_EVERY = 10  # steps


@dataclasses.dataclass
class Asked:
    """Inputs of a step of all environments."""

    by_force: bool
    interval: numpy.ndarray
    place: numpy.ndarray
    angles: numpy.ndarray
    load: numpy.ndarray  # force [N] or height [m]
    first: numpy.ndarray  # true after a reset
    held: numpy.ndarray  # true if the step before had the same place, angles and load

    def inputs(self) -> dict:
        return {"positions": self.place, "angles": self.angles, "forces" if self.by_force else "heights": self.load}


def directions(random, count: int) -> numpy.ndarray:
    angle = random.uniform(0, 2 * numpy.pi, count)
    return numpy.column_stack([numpy.cos(angle), numpy.sin(angle)])


class Walk:
    """Random inputs within the trained range, except for the speed of jumps."""

    def __init__(self, trained, count: int, random) -> None:
        self.trained, self.count, self.random, self.steps = trained, count, random, 0
        self.low, self.high = numpy.array(trained.lowest), numpy.array(trained.highest)
        self.place, self.angles = self.anywhere(), numpy.zeros((count, 3))
        self.held, self.still = numpy.zeros(count, dtype=int), numpy.zeros(count, dtype=bool)

    def chance(self, share: float) -> numpy.ndarray:
        return self.random.random(self.count) < share

    def anywhere(self) -> numpy.ndarray:
        return self.low + self.random.random((self.count, 2)) * (self.high - self.low)

    def loads(self) -> numpy.ndarray:
        kind, amount = self.random.random(self.count), self.random.random(self.count)
        detached = numpy.where(self.chance(0.5), -amount, 0)  # a pull or a gap, or nothing
        share = numpy.select([kind < 0.15, kind < 0.35, kind < 0.5], [detached, 10**(-6 * amount), 1], amount)
        return share * (self.trained.force if self.by_force else -self.trained.indentation)

    def next(self, first: numpy.ndarray, changed: numpy.ndarray) -> Asked:
        """Inputs of the next step; `first` and `changed` are masks of the environments that were reset and that begin anew."""
        draws = (self.held == 0) | changed
        if self.steps % KIND_STEPS == 0:
            self.by_force, self.load, draws = self.random.random() < 0.6, None, numpy.ones(self.count, dtype=bool)
            self.steady = self.chance(0.5)
        self.steps += 1
        drawn = self.loads()
        self.load = drawn if self.load is None else numpy.where(draws, drawn, self.load)
        interval = numpy.select([self.steady, self.chance(0.05)], [1e-3, 0], 10**self.random.uniform(-4, 0, self.count))
        held = self.still & ~draws
        rests, jumps = held | self.chance(0.15), self.chance(0.2)
        way = (self.random.random(self.count) * self.trained.speed * interval)[:, None] * directions(self.random, self.count)
        moved = numpy.where(jumps[:, None], self.anywhere(), numpy.clip(self.place + way, self.low, self.high))
        tilt = (self.random.random(self.count) * self.trained.tilt)[:, None] * directions(self.random, self.count)
        fastest = numpy.where(jumps & (self.trained.turn > 0), 1, self.trained.turn * interval)
        turn = fastest * self.random.uniform(-1, 1, self.count)
        self.place = numpy.where(rests[:, None], self.place, moved)
        self.angles = numpy.where(rests[:, None], self.angles, numpy.column_stack([tilt, self.angles[:, 2] + turn]))
        begins = draws & self.chance(0.3)
        self.held = numpy.where(begins, HELD_STEPS, numpy.maximum(self.held - 1, 0))
        self.still = numpy.where(begins, self.chance(0.5), held & (self.held > 0))
        return Asked(self.by_force, interval, self.place, self.angles, self.load, first, held)


def causes(asked: Asked, before: Asked, trained, normal: numpy.ndarray, margin: float) -> numpy.ndarray:
    """Flags for which the inputs of a `Walk` give a cause.

    normal  normal force of the step [N]
    margin  excess over the range that is no cause
    """
    travel = numpy.linalg.norm(asked.place - before.place, axis=1)
    turn = numpy.abs(asked.angles[:, 2] - before.angles[:, 2])
    time, rounding = (1 + margin) * asked.interval, 2e-9 if margin > 0 else 0
    fast = (travel > trained.speed * time + rounding) | (turn > trained.turn * time + rounding)
    heavy = (normal > (1 + margin) * trained.force) & (not asked.by_force)
    pulls = (asked.load < 0) & asked.by_force
    return 4 * (fast & ~asked.first & (normal > 0)) + 2 * heavy + 32 * pulls


def faults(asked: Asked, before: Asked, trained, signals, last, earlier, limit, relaxes: bool) -> dict[str, numpy.ndarray]:
    """Masks [environment] of each fault in a step of a `Walk`.

    signals, last, earlier  signals of the step and of the two before
    limit                   largest ratio of tangential to normal force
    relaxes                 true if friction changes at rest, because it depends on the speed
    """
    def changes(name, scale):
        return [(new[name] - old[name]) / scale for new, old in ((signals, last), (last, earlier))]
    normal, height, flags = signals["normal_force"], signals["slider_z"], signals.flags
    tangential = numpy.hypot(signals["tangential_force_x"], signals["tangential_force_y"])
    presses = asked.load > 0 if asked.by_force else asked.load < 0
    wanted = asked.load if asked.by_force else normal
    result = {
        "not finite": ~numpy.isfinite(signals.array).all(axis=1),
        "force missed": presses & ~(numpy.abs(normal - wanted) <= EXACT * wanted),
        "height missed": (not asked.by_force) & ~(numpy.abs(height - asked.load) <= ROUNDING * trained.indentation),
        "not detached": ~presses & ((normal != 0) | (tangential != 0)),
        "pulls": ~(normal >= 0),
        "too much friction": ~(tangential <= limit * normal * (1 + EXACT) + ROUNDING * trained.force),
        "contact lost": asked.held & (last["normal_force"] > 0) & ~(normal > 0),
        "not at rest": numpy.zeros(len(normal), dtype=bool), "oscillates": numpy.zeros(len(normal), dtype=bool)}
    for now, then in (changes("normal_force", trained.force), changes("slider_z", trained.indentation)):
        result["not at rest"] |= asked.held & (not relaxes) & ~(numpy.abs(now) <= EXACT)
        result["oscillates"] |= asked.held & before.held & (now * then < 0) & (numpy.minimum(abs(now), abs(then)) > EXACT)
    may, must = (causes(asked, before, trained, normal, margin) for margin in (0, MARGIN))
    for bit, name in FLAGS.items():
        result[f"flag {name} without cause"] = flags & ~may & bit != 0
        result[f"flag {name} missing"] = must & ~flags & bit != 0
    return result


def beyond(trained, random, asked: Asked, turns: bool):
    """Inputs beyond the trained range: yields name, flag, inputs and the nearest trained inputs."""
    count, angles = len(asked.load), asked.angles
    factor = 1 + 10**random.uniform(-2, 2, count)
    still, force = {"positions": asked.place, "angles": angles}, {"forces": trained.force * random.random(count)}
    yield "force", 2, {**still, "forces": factor * trained.force}, {**still, "forces": trained.force}
    yield "height", 2, {**still, "heights": -factor * trained.indentation}, {**still, "heights": -trained.indentation}
    yield "negative force", 32, {**still, "forces": -factor * trained.force}, {**still, "forces": 0.0}
    low, high, along = numpy.array(trained.lowest), numpy.array(trained.highest), numpy.eye(2)[random.integers(0, 2, count)]
    upper = random.integers(0, 2, (count, 1))
    edge = numpy.where(along == 1, numpy.where(upper, high, low), asked.place)
    outside = edge + (2 * upper - 1) * along * 1e-2 * (factor - 1)[:, None]
    for load in (force, {"heights": -trained.indentation * random.random(count)}):
        yield "place", 1, {"positions": outside, "angles": angles, **load}, {"positions": edge, "angles": angles, **load}
    towards, steep = directions(random, count), numpy.minimum(1.5, numpy.maximum(trained.tilt, 1e-3) * factor)[:, None]
    tilts = [numpy.column_stack([tilt * towards, angles[:, 2]]) for tilt in (steep, trained.tilt)]
    yield "tilt", 64, {**still, "angles": tilts[0], **force}, {**still, "angles": tilts[1], **force}
    if not turns:
        yield "yaw", 64, {**still, "angles": angles + [0, 0, 0.1], **force}, {**still, **force}


def beyond_faults(bit: int, signals, nearest) -> numpy.ndarray:
    """Mask of the environments where a step beyond the range lacks the flag or differs from the step to the nearest trained inputs.
    A slider that does not touch may have any place and pose."""
    wrong = signals.flags != nearest.flags | numpy.where((nearest["normal_force"] > 0) | (bit == 32), bit, 0)
    for name in COMPARED:
        wrong |= ~(numpy.abs(signals[name] - nearest[name]) <= EXACT * numpy.abs(nearest[name]).max())
    return wrong


def friction_limit(contact: dict) -> float:
    """Lower bound on the largest ratio of tangential to normal force, whatever the coefficient of friction."""
    if contact.get("law") == "viscous":
        return numpy.inf
    return max(contact.get("kinetic_friction", 0), contact.get("transverse_friction", 0))


class Count:
    """Counts of flags and faults, and a line on each of the first faults."""

    def __init__(self) -> None:
        self.flags, self.faults, self.told = collections.Counter(), collections.Counter(), 0

    def add(self, step: int, asked: Asked, signals, last, found: dict[str, numpy.ndarray]) -> None:
        for bit, name in FLAGS.items():
            self.flags[name] += int(numpy.count_nonzero(signals.flags & bit))
        for name, mask in found.items():
            self.faults[name] += int(mask.sum())
            for i in numpy.flatnonzero(mask)[:max(0, 10 - self.told)]:
                self.told += 1
                print(f"step {step} of environment {i}: {name}; {asked.load[i]:.6g} {'N' if asked.by_force else 'm'} asked after "
                      f"{last['normal_force'][i]:.6g} N at {last['slider_z'][i]:.6g} m, in {asked.interval[i]:.3g} s; now "
                      f"{signals['normal_force'][i]:.6g} N at {signals['slider_z'][i]:.6g} m, tangential "
                      f"{signals['tangential_force_x'][i]:.6g} and {signals['tangential_force_y'][i]:.6g} N, residual "
                      f"{signals['residual'][i]:.2g}, flags {signals.flags[i]}", flush=True)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("file", type=pathlib.Path)
    parser.add_argument("--steps", type=int, default=100_000)
    parser.add_argument("--environments", type=int, default=100)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    sys.path.insert(0, str(arguments.build / "python"))
    from ionskin.live import Skin, Skins

    skin, count, random = Skin(arguments.file), arguments.environments, numpy.random.default_rng(arguments.seed)
    skins, trained, turns = Skins(skin, count, threads=arguments.threads), skin.range, skin.turns_into_itself
    contact, walk, found = tomllib.loads(skin.case).get("contact", {}), Walk(trained, count, random), Count()
    limit, relaxes = friction_limit(contact), contact.get("law") in ("stribeck", "viscous")
    times, before, last, earlier, tried, steps = numpy.zeros(count), None, None, None, 0, -(-arguments.steps // count)
    for step in range(steps):
        reset = walk.chance(0.01 if before else 1)
        skins.reset(reset)
        changed = reset | walk.chance(0.01)
        skins.set_friction(random.uniform(*trained.friction, int(changed.sum())), changed)
        if step % BEYOND_EVERY == BEYOND_EVERY - 1:
            states = skins.save()
            for name, bit, *inputs in beyond(trained, random, before, turns):
                results = []
                for one in inputs:
                    results.append(skins.step(times + 1e-3, **one))
                    skins.restore(states)
                found.faults[f"beyond the range, {name}"] += int(beyond_faults(bit, *results).sum())
                tried += count
        asked = walk.next(reset, changed)
        times += asked.interval
        signals = skins.step(times, **asked.inputs())
        before, last, earlier = before or asked, last or signals, earlier or signals
        masks = faults(asked, before, trained, signals, last, earlier, numpy.maximum(limit, skins.friction), relaxes)
        found.add(step, asked, signals, last, masks)
        before, last, earlier = asked, signals, last
    print(f"{arguments.file}: {steps * count} steps within the range, {tried} beyond")
    print("flags within the range: " + (", ".join(f"{name} {number}" for name, number in found.flags.items() if number) or "none"))
    print("faults: " + (", ".join(f"{name} {number}" for name, number in found.faults.items() if number) or "none"))
    return 1 if found.faults.total() else 0


if __name__ == "__main__":
    sys.exit(main())
