# SPDX-License-Identifier: Apache-2.0
"""Random touches: what varies, and the values of each."""

import itertools
import math

import numpy

from .. import solver
from ..case import Case
from ..errors import CaseError, SolverError
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
    "slider.start[1]": (0.96, 1.04),  # two lines of positions hold the strain across so much of cases/finger.toml
}
FRICTION = "contact.friction", "uniform(0.1, 0.6)"
HEAVIEST = ("motion.preload", "slider.radius", FRICTION[0])  # the more of them, the larger the contact
OWN_SKIN = ("skin.", "materials.", "numerics.")  # keys that give every touch positions of its own


def usual(case: Case) -> dict[str, str]:
    """Distributions for the keys of the finger and its motion, about the case's own values."""
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
    """The touches of a case.

    vary   distribution by key, as for Uncertainty; what it does not name varies as `usual` says
    trials with the case of each: the numbers of touch i follow from the seed and i alone
    shares_positions  whether the skin is solved once for all touches
    redrawn  how many draws made no valid case, and were drawn again

    Raises CaseError where a touch finds no valid case.
    """

    def __init__(self, case: Case, count: int, *, seed: int = 1, vary=()) -> None:
        if count < 1:
            raise CaseError(f"{count} touches\n  = give at least one")
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
        self.shares_positions = self._share_positions()
        self.trials = [self._touch(number) for number in range(count)]

    def _share_positions(self) -> bool:
        """Gives all touches one rectangle of positions and one area of contact, from the ends of the distributions, so
        that the skin is solved once for all of them. Whether it did."""
        case = self.case
        if (case["strain.source"] != "contact" or case["motion.kind"] == "waypoints"
                or "numerics.shared_positions.to" in case
                or any(one.key.startswith(OWN_SKIN) for one in self.parameters)):
            return False
        ends = {one.key: [float(value) for value in one.values(one.germs([TAIL, 1 - TAIL]))] for one in self.parameters}

        def values(key):
            return [float(case[key]), *ends.get(key, [])]

        starts = [values(f"slider.start[{axis}]") for axis in (0, 1)]
        ways = itertools.product(values("motion.stroke"), values("motion.direction[0]"), values("motion.direction[1]"))
        travel = [(stroke * x / (math.hypot(x, y) or 1), stroke * y / (math.hypot(x, y) or 1)) for stroke, x, y in ways]
        low = [min(starts[axis]) + min(0, *(way[axis] for way in travel)) for axis in (0, 1)]
        high = [max(starts[axis]) + max(0, *(way[axis] for way in travel)) for axis in (0, 1)]
        widest = case.copy()
        for one in self.parameters:
            if one.key in HEAVIEST:
                widest._edits.pop(one.key, None)
                widest._edits[one.key] = one.text(max(ends[one.key]))
        shared = case.copy()
        try:
            half_size, sharp = solver.load().footprint(widest, 0)
            for key, pair in (("from", low), ("to", high), *(() if sharp else [("footprint", half_size)])):
                shared._edits[f"numerics.shared_positions.{key}"] = "[" + ", ".join(f'"{one!r} m"' for one in pair) + "]"
            solver.load().footprint(shared, 0)
        except (CaseError, SolverError):  # the rectangle leaves the skin, which no touch need do
            return False
        self.case = shared
        return True

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
