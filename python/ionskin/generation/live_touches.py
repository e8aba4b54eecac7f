# SPDX-License-Identifier: Apache-2.0
"""Random touches of a live skin, and the engine that steps them."""

import concurrent.futures
import os
import threading
from typing import NamedTuple

import numpy

from ..evaluation import Outcome, Trial
from ..live import Skin
from ..live.signals import UNCONVERGED
from .store import ANGLES

REPRESENTATIVE = 16  # touches
MAGIC = b"ionskin live skin"
FRICTION = "contact.friction"
TAXELS = ("current_top_", "current_bottom_", "charge_top_", "charge_bottom_")
ELECTRODES = ("current_top", "current_bottom", "current_difference", "current_common", "charge_top", "charge_bottom")


def is_live_skin(path: str | os.PathLike) -> bool:
    """True if a file begins as one of a live skin does, or has the ending of such a file."""
    if os.fspath(path).endswith(".live"):
        return True
    try:
        with open(path, "rb") as file:
            return file.read(len(MAGIC)) == MAGIC
    except OSError:
        return False


class Drawn(NamedTuple):
    """Key that varies from touch to touch, as `store.write` names it: its SI unit and the text of its distribution."""

    key: str
    unit: str
    written: str


class LiveTouches:
    """Random touches of a live skin, as trials to run: motions of `Skin.random_touch`, and a coefficient of friction in the
    trained range.

    skin        Skin
    count       number of touches
    seed        seed of the random values; touch i depends only on the seed and i
    interval    time between two steps [s]
    trials      list of Trial without a case
    parameters  list of Drawn
    errors      list of (event, signal, SignalError) that the file of the skin states; "" for whole touches
    """

    def __init__(self, skin: Skin, count: int, *, seed: int, interval: float) -> None:
        self.skin, self.seed, self.interval = skin, seed, interval
        low, high = skin.range.friction
        self.parameters = [Drawn(FRICTION, "1", f"uniform({low:g}, {high:g})" if high > low else f"{low:g}")]
        self.errors = [("", name, error) for name, error in skin.errors.items()]
        self.errors += [(event, name, error) for event, own in skin.event_errors.items() for name, error in own.items()]
        self.trials = [Trial(number, {FRICTION: self._friction(number, low, high)}) for number in range(count)]

    @property
    def identity(self) -> dict:
        """Text of the case and digest of the skin's file, as a dict; equal touches have an equal one."""
        return {"case": self.skin.case, "skin": self.skin.digest}

    def _friction(self, number: int, low: float, high: float) -> float:
        share = numpy.random.default_rng([self.seed, number, 1]).random()
        return float(numpy.clip(low + (high - low) * share, low, high))

    def size(self) -> float:
        """Rough size of the outcomes of all touches on the disk [bytes], from the first of them."""
        first = self.trials[:REPRESENTATIVE]
        rows = sum(len(self.skin.random_touch(self.seed, one.number, self.interval)["times"]) for one in first) / len(first)
        return len(self.trials) * rows * len(self.skin.names) * 8.0  # numbers of eight bytes

    def outcome(self, trial: Trial) -> Outcome:
        """Steps a copy of the skin, at rest, along the touch of a trial, and returns its signals as those of a run."""
        skin = self.skin.copy()
        skin.reset()
        skin.friction = trial.values[FRICTION]
        motion = skin.random_touch(self.seed, trial.number, self.interval)
        signals = skin.run(**motion)
        unsolved = int(numpy.count_nonzero(signals.flags & UNCONVERGED))
        if unsolved:
            return Outcome({}, {}, reason=f"touch {trial.number}: the contact was not solved in {unsolved} of {len(signals.flags)} steps")
        columns = {f"{table}/time": motion["times"] for table in ("signals", "sampled", "sampled_taxels")}
        for name in skin.names:
            if name in ELECTRODES:
                columns[f"sampled/{name}"] = signals[name]
            elif name.startswith(TAXELS):
                columns[f"sampled_taxels/{name}"] = signals[name]
            else:
                columns[f"signals/{name}"] = signals[name]
        if self.skin.range.tilt or self.skin.range.turn:
            columns |= {f"signals/{name}": values for name, values in zip(ANGLES, motion["angles"].T)}
        return Outcome({}, {}, columns)


class LiveEngine:
    """Engine that steps touches of a live skin on this machine.

    touches  LiveTouches
    workers  number of threads; 0: one for each processor
    """

    def __init__(self, touches: LiveTouches, workers: int = 0) -> None:
        self.touches, self.workers = touches, workers or len(os.sched_getaffinity(0))

    def evaluate(self, case, trials, folder, on_result) -> None:
        """Steps every trial and writes its outcome to FOLDER/NUMBER.npz, as `LocalEngine.evaluate` does.

        case       not used
        trials     list of Trial of the touches
        folder     folder of the outcomes
        on_result  called in this thread with (trial, Outcome) as each trial ends; an exception that it raises stops the others
        """
        del case
        stopped = threading.Event()

        def work(trial):
            if stopped.is_set():
                return None
            outcome = self.touches.outcome(trial)
            outcome.write(folder / f"{trial.number:06}.npz")
            return outcome

        pool = concurrent.futures.ThreadPoolExecutor(self.workers)
        try:
            tasks = {pool.submit(work, trial): trial for trial in trials}
            for done in concurrent.futures.as_completed(tasks):
                on_result(tasks.pop(done), done.result())
        finally:
            stopped.set()
            pool.shutdown(wait=True, cancel_futures=True)
