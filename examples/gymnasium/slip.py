#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A slider strokes a live skin, and slip is announced before it comes: an environment with the interface of Gymnasium.

    PYTHONPATH=build/python examples/gymnasium/slip.py skin.live

Definitions:

- Slip. The share of the pressed area that slides is 1 - stick_share. Slip is the first step, 0.12 s or more after the
  landing began, in which it is 1: nothing sticks. The full model tells the same share in its signals.csv.
- Seen are the currents of the top electrode and of the taxels alone, with white noise. Its standard deviation is 2.4 uA
  unless --noise gives another: one step of a converter of 12 bits over 10 V behind 1 kohm. This suits the block of the
  paper, which presses with 13 to 36 N. The currents of a soft finger are below this noise: choose a finer instrument,
  and give its noise (sample_noise in the summary.json of a full run with readout.instrument).
- Signal. The median over touches of the largest current, mean over 5 ms, from 0.12 s on. Below the noise of one reading
  the example warns.
- Touches. The finger presses, rests, and is then pulled so slowly that it would slip 80 to 400 ms later. Half of the
  touches go on, a quarter stop after 5 to 30 % of that way, a quarter press harder instead.
- Detector. A linear discriminant of the logarithms of mean currents over the last 5, 20, 60 and 200 ms, learnt from steps
  that are less than 20 ms before slip, or up to 10 ms behind it, against those before. What comes later is left out.
- Judged by touches that it has not seen. The score of a touch is the largest up to 10 ms behind slip, of one without slip
  the largest of all. The ROC curve is over the scores of touches. The threshold is that which one in twenty touches
  without slip passes in the training; the lead time is from the first step above it to slip, negative when late.

Slip, touches, noise, score, threshold and lead time were fixed before any result. So was a first detector, which took no
mean over 200 ms and counted all steps behind slip as slip: it was worse than chance (area 0.18 on the touches of seed 2), for
behind slip the charges rest and the currents with them. This one was chosen on halves of the training touches, and is judged
on touches of a seed not used before. No touch stops between 30 % and all of its way, so a call there is never wrong.
"""

import argparse
import types

import numpy

from ionskin.live import Skin

try:
    import gymnasium
except ModuleNotFoundError:  # the interface alone
    gymnasium = None

STEP = 1e-3  # [s]
LANDED, STEPS = 120, 750  # steps: from when on a touch is judged, and its length
LATE = 10  # steps behind slip in which a call still counts
NOISE = 2.4e-6  # of the currents, unless given [A]
SMALLEST = 1e-15  # [A]; of a current in a logarithm
WINDOWS = (5, 20, 60, 200)  # steps
HORIZON = 20  # steps before slip that are learnt as slip


def channels(skin: Skin) -> list[str]:
    """Names of the currents that are seen."""
    return [name for name in skin.names if name.startswith("current_top")]


def slip_step(stick_share) -> int | None:
    """The step of slip, or none."""
    slides = numpy.flatnonzero(numpy.asarray(stick_share)[LANDED:] == 0)
    return LANDED + int(slides[0]) if len(slides) else None


def way_to_slip(skin: Skin) -> float:
    """Way of the finger until nothing sticks, over the force [m/N], found in the middle of the trained range."""
    tried = skin.copy()
    tried.reset()
    force, way = 0.4 * tried.range.force, 1e-9
    x, y = numpy.mean([tried.range.lowest, tried.range.highest], axis=0)
    for step in range(400):
        if tried.step(STEP * step, (x + way, y), force=force)["stick_share"] == 0:
            return way / force
        way *= 1.05
    raise SystemExit("error: this skin does not slip")


class Touches:
    """Random touches of a skin, as arguments of `Skin.run`."""

    def __init__(self, skin: Skin) -> None:
        self.skin, self.compliance = skin, way_to_slip(skin)
        self.low, self.high = numpy.array(skin.range.lowest), numpy.array(skin.range.highest)

    def draw(self, random: numpy.random.Generator) -> dict:
        """One touch: times [s], positions [m], forces [N]."""
        times = STEP * numpy.arange(STEPS)
        force = random.uniform(0.2, 0.55) * self.skin.range.force
        begin = random.uniform(0.15, 0.25)
        way = self.compliance * force
        pulled = way / random.uniform(0.08, 0.4) * numpy.clip(times - begin, 0, None)
        forces = force * _ramp(times, 0, random.uniform(0.05, 0.1))
        kind = random.choice(["slips", "stops", "presses"], p=[0.5, 0.25, 0.25])
        if kind == "stops":
            pulled = numpy.minimum(pulled, random.uniform(0.05, 0.3) * way)
        elif kind == "presses":
            pulled = 0 * times
            forces = forces * (1 + random.uniform(0.1, 0.5) * _ramp(times, begin, begin + random.uniform(0.1, 0.3)))
        room = pulled[-1]
        if self.high[0] - self.low[0] < 2 * room:
            raise SystemExit("error: the trained range is too short for a pull: widen the motion of the case")
        x = random.uniform(self.low[0] + room, self.high[0] - room) + random.choice([-1, 1]) * pulled
        y = random.uniform(self.low[1], self.high[1])
        return {"times": times, "positions": numpy.column_stack([x, numpy.full(STEPS, y)]), "forces": forces}


def _ramp(times, begin: float, end: float):
    share = numpy.clip((times - begin) / (end - begin), 0, 1)
    return share**2 * (3 - 2 * share)


class SlipEnv(gymnasium.Env if gymnasium is not None else object):
    """One touch an episode. The action is 0 to go on and 1 to call slip, which ends the episode: with the reward 1 where the
    finger, going on as it does, slips within the next 100 steps or did within the last 10, with -1 where not. Slip that
    is not called within 10 steps ends it with -1, and a touch without slip or call with 1. The observation are the currents
    of the last 200 steps [mA], the latest one last. `info` has the share of the contact that slides, which the full model
    tells, too, and the flags of the skin."""

    metadata = {"render_modes": []}
    ahead = 100

    def __init__(self, skin: Skin | str, noise: float = NOISE) -> None:
        self.skin = skin.copy() if isinstance(skin, Skin) else Skin(skin)
        self.touches, self.noise, self.names = Touches(self.skin), noise, channels(self.skin)
        shape = (WINDOWS[-1], len(self.names))
        if gymnasium is not None:
            self.action_space = gymnasium.spaces.Discrete(2)
            self.observation_space = gymnasium.spaces.Box(-numpy.inf, numpy.inf, shape, dtype=numpy.float32)
        else:
            self.action_space = types.SimpleNamespace(n=2, shape=(), dtype=numpy.dtype(numpy.int64))
            self.observation_space = types.SimpleNamespace(shape=shape, dtype=numpy.dtype(numpy.float32))
        self.random = numpy.random.default_rng()

    def reset(self, *, seed: int | None = None, options: dict | None = None):
        """A new touch, up to where it is judged."""
        if seed is not None:
            self.random = numpy.random.default_rng(seed)
        self.touch = self.touches.draw(self.random)
        self.skin.reset()
        self.now, self.slipped = 0, None
        self.seen = numpy.zeros(self.observation_space.shape, dtype=numpy.float32)
        while self.now < LANDED:
            info = self._advance()
        return self.seen.copy(), info

    def step(self, action):
        """Observation, reward, terminated, truncated, info."""
        if int(action) == 1:
            return self.seen.copy(), 1.0 if self._slips_ahead() else -1.0, True, False, self.info
        info = self._advance()
        if self.slipped is None and info["slide_share"] == 1:
            self.slipped = self.now - 1
        late = self.slipped is not None and self.now - 1 - self.slipped >= LATE
        over = self.now == STEPS
        return self.seen.copy(), -1.0 if late else float(over and self.slipped is None), late, over, info

    def _advance(self) -> dict:
        at = self.now
        signals = self.skin.step(self.touch["times"][at], self.touch["positions"][at], force=self.touch["forces"][at])
        readings = [signals[name] + self.noise * self.random.standard_normal() for name in self.names]
        self.seen = numpy.vstack([self.seen[1:], 1e3 * numpy.array([readings])]).astype(numpy.float32)
        self.now += 1
        self.info = {"slide_share": 1 - signals["stick_share"], "flags": signals.flags}
        return self.info

    def _slips_ahead(self) -> bool:
        if self.slipped is not None:
            return True
        rest = slice(self.now, self.now + self.ahead)
        going_on = {name: values[rest] for name, values in self.touch.items()}
        return bool(len(going_on["times"])) and bool((self.skin.copy().run(**going_on)["stick_share"] == 0).any())


class Detector:
    """A linear discriminant (Fisher 1936, doi 10.1111/j.1469-1809.1936.tb02137.x)."""

    def __init__(self, currents: list, slips: list, noise: float = NOISE) -> None:
        self.noise = noise
        rows, about = [], []
        for own, slip in zip(currents, slips, strict=True):
            end = len(own) if slip is None else slip + LATE + 1
            rows.append(features(own, noise)[LANDED:end])
            about.append(numpy.arange(LANDED, end) > (end if slip is None else slip - HORIZON))
        rows, about = numpy.vstack(rows), numpy.concatenate(about)
        self.mean, self.scale = rows.mean(0), rows.std(0) + 1e-300
        rows = (rows - self.mean) / self.scale
        within = sum(numpy.cov(rows[about == kind].T) for kind in (False, True))
        self.weights = numpy.linalg.solve(within + 1e-3 * numpy.eye(len(within)),
                                          rows[about].mean(0) - rows[~about].mean(0))
        calm = [self.score(own, None) for own, slip in zip(currents, slips, strict=True) if slip is None]
        self.threshold = numpy.quantile(calm, 0.95)

    def __call__(self, currents) -> numpy.ndarray:
        """The score of every step."""
        return (features(currents, self.noise) - self.mean) / self.scale @ self.weights

    def score(self, currents, slip: int | None) -> float:
        """The score of a touch."""
        return float(self(currents)[LANDED:None if slip is None else slip + LATE + 1].max())

    def call(self, currents, slip: int | None) -> int | None:
        """The first step above the threshold up to 10 ms behind slip; none where there is none."""
        above = numpy.flatnonzero(self(currents)[LANDED:None if slip is None else slip + LATE + 1] > self.threshold)
        return LANDED + int(above[0]) if len(above) else None


def means(currents, window: int) -> numpy.ndarray:
    """[step, channel] of currents [step, channel]: their means over the last steps, as many as the window has."""
    sums = numpy.vstack([numpy.zeros(currents.shape[1]), numpy.cumsum(currents, axis=0)])
    end = numpy.arange(1, len(currents) + 1)
    return (sums[end] - sums[numpy.maximum(end - window, 0)]) / window


def features(currents, noise: float = NOISE) -> numpy.ndarray:
    """[step, feature] of currents [step, channel] with a noise [A]: logarithms of their means over windows."""
    return numpy.hstack([numpy.log(numpy.abs(means(currents, window)) + max(noise, SMALLEST)) for window in WINDOWS])


def signal_of(currents: list) -> float:
    """The signal [A] of touches, given as currents [step, channel] without noise."""
    return float(numpy.median([numpy.abs(means(own, WINDOWS[0])[LANDED:]).max() for own in currents]))


def comparison(signal: float, noise: float) -> list[str]:
    """Lines of text on signal and noise [A], with a warning where the noise is the larger one."""
    lines = [f"signal {signal:.2g} A, noise of one reading {noise:.2g} A" + (f": ratio {signal / noise:.2g}" if noise > 0 else "")]
    if noise > signal:
        lines.append("warning: the noise is larger than the signal, so that slip may not be recognised; give the noise of a finer "
                     "instrument by --noise")
    return lines


def measured(skin: Skin, count: int, seed: int, noise: float = NOISE):
    """Currents [step, channel] of random touches with noise, and their steps of slip."""
    currents, slips, random = touched(skin, count, seed)
    return [own + noise * random.standard_normal(own.shape) for own in currents], slips


def touched(skin: Skin, count: int, seed: int):
    """Currents [step, channel] of random touches without noise, their steps of slip, and the generator for the noise."""
    random = numpy.random.default_rng(seed)
    touches = Touches(skin)
    ran = skin.batch([touches.draw(random) for _ in range(count)], threads=2)
    currents = [numpy.column_stack([signals[name] for name in channels(skin)]) for signals in ran]
    return currents, [slip_step(signals["stick_share"]) for signals in ran], random


def judge(detector: Detector, currents: list, slips: list) -> dict:
    """Area under the ROC curve, shares of touches with slip that are called and of those without that are called wrongly, and
    lead times [ms]."""
    yes = [detector.score(own, slip) for own, slip in zip(currents, slips, strict=True) if slip is not None]
    no = [detector.score(own, slip) for own, slip in zip(currents, slips, strict=True) if slip is None]
    calls = [(detector.call(own, slip), slip) for own, slip in zip(currents, slips, strict=True)]
    above = numpy.subtract.outer(yes, no)
    return {"area": float(numpy.mean((above > 0) + 0.5 * (above == 0))), "touches": (len(yes), len(no)),
            "called": numpy.mean([call is not None for call, slip in calls if slip is not None]),
            "false": numpy.mean([call is not None for call, slip in calls if slip is None]),
            "leads": [1e3 * STEP * (slip - call) for call, slip in calls if slip is not None and call is not None]}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("file")
    parser.add_argument("--touches", type=int, default=100, help="of the training, and as many to judge by")
    parser.add_argument("--noise", type=float, default=NOISE,
                        help="standard deviation of the noise of a reading of your instrument [A]; 2.4e-6, unless given, is one "
                        "step of a converter of 12 bits over 10 V behind 1 kohm, for the block of the paper")
    arguments = parser.parse_args()
    skin = Skin(arguments.file)
    currents, slips, random = touched(skin, arguments.touches, 1)
    print("\n".join(comparison(signal_of(currents), arguments.noise)), flush=True)
    noisy = [own + arguments.noise * random.standard_normal(own.shape) for own in currents]
    detector = Detector(noisy, slips, arguments.noise)
    found = judge(detector, *measured(skin, arguments.touches, 3, arguments.noise))
    quartiles = numpy.quantile(found["leads"], [0.25, 0.5, 0.75]) if found["leads"] else [numpy.nan] * 3
    print("unseen touches: {} slip, {} do not".format(*found["touches"]))
    print(f"area under the ROC curve: {found['area']:.3f}")
    print(f"called: {100 * found['called']:.0f} % of those that slip, {100 * found['false']:.0f} % of the others")
    print("lead time: {1:.0f} ms in the median, quartiles {0:.0f} and {2:.0f} ms".format(*quartiles))


if __name__ == "__main__":
    main()
