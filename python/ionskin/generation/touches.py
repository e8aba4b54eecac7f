# SPDX-License-Identifier: Apache-2.0
"""Random touches of a case: the keys that vary, and their values in each touch."""

import numpy

from ..case import Case
from ..errors import CaseError
from ..evaluation import Trial
from ..uncertainty.distributions import Parameter, parse, parse_all

ATTEMPTS = 100
RATE = 1000.0  # rows a second
TAIL = 1e-9
USUAL = {  # share of the case's own value, lowest and highest; where the case has the key
    "motion.preload": (0.5, 1.5),
    "motion.stroke": (0.5, 1.0),
    "slider.radius": (0.8, 1.2),
    "slider.start[0]": (0.95, 1.05),
    "slider.start[1]": (0.96, 1.04),
}
FRICTION = "contact.friction", "uniform(0.1, 0.6)"


def usual(case: Case) -> dict[str, str]:
    """Usual distributions of the keys of a finger and its motion about the case's own values, as a dict of key to text."""
    found = {}
    for key, (low, high) in USUAL.items():
        if key in case and isinstance(case[key], float) and case[key] > 0:
            value = case.value(key)
            unit = "" if value.unit == "1" else f" {value.unit}"
            found[key] = f"uniform({low * value.value:.6g}{unit}, {high * value.value:.6g}{unit})"
    if FRICTION[0] in case:
        found[FRICTION[0]] = FRICTION[1]
    return found


class Touches:
    """Random touches of a case, as trials to run.

    case     the case; its readout is set to 1000 samples a second
    count    number of touches
    seed     seed of the random values
    vary     distributions, as for Uncertainty; keys that it does not name vary as `usual` says
    trials   list of Trial; the values of touch i depend only on the seed and i
    redrawn  number of draws that made no valid case and were repeated
    errors   (), as the engine states none

    Raises CaseError when an argument is wrong or a touch finds no valid case.
    """

    errors = ()

    def __init__(self, case: Case, count: int, *, seed: int = 1, vary=()) -> None:
        if count < 1:
            raise CaseError(f"{count} touches\n  = give at least one")
        if "slider[0].start" in case:
            raise CaseError("slider: the touches of a store are of one slider, and this case has a list of them\n  = write one section [slider]")
        self.case, self.seed, self.redrawn = case.copy(), seed, 0
        self.case["readout.sample_interval"] = 1 / RATE
        self.case["output.fields"] = []  # which the store does not hold
        self.case.check()
        own = parse_all(vary, self.case) if vary else []
        named = {one.key for one in own}
        self.parameters: list[Parameter] = [parse(key, written, self.case) for key, written in usual(self.case).items()
                                            if key not in named] + own
        if not self.parameters:
            raise CaseError('nothing varies in this case\n  = give --vary "KEY=DISTRIBUTION"')
        self.parameters.sort(key=lambda one: one.key)
        self.trials = [self._touch(number) for number in range(count)]

    @property
    def identity(self) -> dict:
        """Text of the case, as a dict; equal touches have an equal one."""
        return {"case": self.case.text}

    def _touch(self, number: int) -> Trial:
        last = None
        for attempt in range(ATTEMPTS):
            generator = numpy.random.default_rng([self.seed, number, attempt])
            uniform = numpy.clip(generator.random(len(self.parameters)), TAIL, 1 - TAIL)
            values = {one.key: float(one.values(one.germs(u))[0]) for one, u in zip(self.parameters, uniform)}
            case = self.case.copy()
            for one in self.parameters:
                case._edits.pop(one.key, None)
                case._edits[one.key] = one.text(values[one.key])
            try:
                return Trial(number, values, case.check())
            except CaseError as error:
                last, self.redrawn = error, self.redrawn + 1
        raise CaseError(f"touch {number} found no valid case in {ATTEMPTS} draws\n  = narrow the ranges; the last one:\n{last}")
