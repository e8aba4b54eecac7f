# SPDX-License-Identifier: Apache-2.0
"""Design optimization: the search for the best values of keys of a case under constraints, by ask and tell."""

import math
import re
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy

from ..case import Case
from ..errors import CaseError
from ..evaluation import Outcome, Trial
from ..uncertainty import designs
from ..uncertainty.distributions import parse
from . import surrogate

CONSTRAINT = re.compile(r"\s*(\w+)\s*(<=|>=|==|<|>|=)\s*([-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?)\s*([^\s\d]\S*)?\s*")
SMALLEST = 1e-4  # of the ranges: a trust region below it ends the search
FIRST_RADIUS, SHRINK, GROW, LARGEST = 0.3, 0.5, 1.6, 0.6
TOLERANCE = 1e-4  # of a constraint's bound


class Constraint(NamedTuple):
    """Constraint `metric sign bound` of a search, such as "normal_force_slide < 3 N"; unit is "" where none was written."""

    metric: str
    sign: str
    bound: float
    unit: str

    @property
    def equal(self) -> bool:
        """True if the constraint is an equality: the metric must have the value of the bound."""
        return self.sign.startswith("=")

    def margin(self, metrics: dict) -> float:
        """Margin of the constraint, as a share of the bound [1]: at least 0 where an
        inequality holds, 0 where an equality holds."""
        gap = (metrics[self.metric] - self.bound) / (abs(self.bound) or 1.0)
        return gap if self.equal or self.sign.startswith(">") else -gap


class Design:
    """Design search: values of free keys of a case at which a metric is least, or largest, under constraints.

    The search asks for trials, the caller runs them and hands the results back.

    case        an ionskin.Case; None for a function of one's own, whose keys are any names
    free        dict of key to its range (lowest, highest), as texts: {"skin.layers[1].thickness": ("50 um", "500 um")}
    objective   name of the metric
    maximise    True to search the largest value of the metric instead of the least
    subject_to  constraints on metrics, such as "normal_force_slide < 3 N", in the SI unit of the metric; == for equalities
    budget      largest number of evaluations
    seed        seed of the search

        while trials := study.ask():
            for trial in trials:
                study.tell(trial, ionskin.run(trial.case))
        study.best()

    The first trials fill the ranges evenly; each further one is the optimum of interpolants of all results so far, within
    a region that shrinks where they mislead. Raises CaseError before any work.
    """

    def __init__(self, case: Case | None, free: dict, objective: str, *, maximise: bool = False,
                 subject_to: Sequence[str] = (), budget: int = 60, seed: int = 1) -> None:
        if not free:
            raise CaseError("no key is free\n  = give at least one with its range")
        self.parameters = [parse(key, f"uniform({low}, {high})", case) for key, (low, high) in free.items()]
        self.case, self.objective, self.sign, self.budget = case, objective, -1.0 if maximise else 1.0, budget
        self.constraints = [self._constraint(text) for text in subject_to]
        self._generator = numpy.random.default_rng(seed)
        first = 2 * len(free) + 4
        if budget < first + 2:
            raise CaseError(f"a budget of {budget} evaluations is too small\n  = give at least {first + 2} for {len(free)} keys")
        self.places = list(designs.points("sobol", first, len(free), seed))
        self.trials = [self._trial(number, place) for number, place in enumerate(self.places)]
        self.outcomes: dict[int, Outcome] = {}
        self.radius = FIRST_RADIUS

    @staticmethod
    def _constraint(text: str) -> Constraint:
        match = CONSTRAINT.fullmatch(text)
        if not match or not math.isfinite(float(match[3])):
            raise CaseError(f'"{text}" is not a constraint\n  = write \"METRIC < NUMBER UNIT\"; > and == too')
        return Constraint(match[1], match[2], float(match[3]), match[4] or "")

    def _trial(self, number, place) -> Trial:
        values = {one.key: float(one.values(2 * at - 1)) for one, at in zip(self.parameters, place)}
        if self.case is None:
            return Trial(number, values)
        case = self.case.copy()
        for one in self.parameters:
            case._edits.pop(one.key, None)
            case._edits[one.key] = one.text(values[one.key])
        return Trial(number, values, case.check())

    def ask(self) -> list[Trial]:
        """Returns the trials to evaluate next; [] when the search has ended. Raises CaseError
        when too few evaluations gave a result."""
        open_ = [trial for trial in self.trials if trial.number not in self.outcomes]
        if open_ or len(self.trials) >= self.budget or self.radius < SMALLEST:
            return open_
        rows = [number for number, outcome in sorted(self.outcomes.items()) if not outcome.reason]
        if len(rows) < len(self.parameters) + 2:
            raise CaseError(f"{len(rows)} of {len(self.trials)} evaluations gave a result, too few to go on\n"
                            "  = narrow the ranges of the free keys")
        metrics = [self.outcomes[number].metrics for number in rows]
        objective = numpy.array([self.sign * one[self.objective] for one in metrics])
        margins = numpy.array([[one.margin(row) for one in self.constraints] for row in metrics]).reshape(len(rows), -1)
        place = surrogate.next_place(numpy.array([self.places[number] for number in rows]), objective, margins,
                                     [one.equal for one in self.constraints], self.places[self._leader(rows)], self.radius,
                                     self._generator)
        if min(numpy.abs(place - self.places[number]).max() for number in rows) < 0.05 * SMALLEST:
            self.radius = 0.0  # the optimum has been evaluated
            return []
        try:
            trial = self._trial(len(self.trials), place)
        except CaseError:  # values that do not go together
            self.radius *= SHRINK
            return self.ask()
        self.places.append(place)
        self.trials.append(trial)
        return [trial]

    def _missed(self, number) -> float:
        metrics = self.outcomes[number].metrics
        return sum(abs(one.margin(metrics)) if one.equal else max(0.0, -one.margin(metrics)) for one in self.constraints)

    def _merit(self, number, scale) -> tuple[bool, float]:
        """Merit by the rule of Deb (2000, doi 10.1016/S0045-7825(99)00389-8): points that meet every constraint
        come first, then those that miss the least. Hardly any point meets an equality before the search is near
        its end; until one does, the objective counts beside what is missed."""
        missed = max(0.0, self._missed(number) - TOLERANCE)
        objective = self.sign * self.outcomes[number].metrics[self.objective] / scale
        if missed == 0:
            return False, objective
        return True, objective + 10 * missed if any(one.equal for one in self.constraints) else missed

    def _leader(self, rows) -> int:
        scale = numpy.std([self.outcomes[number].metrics[self.objective] for number in rows]) or 1.0
        return min(rows, key=lambda number: self._merit(number, scale))

    def tell(self, trial: Trial, result: Any) -> None:
        """Takes the result of a trial.

        trial   a trial that `ask` returned
        result  Results of its run, a dict of metric name to number, or the exception with which its run ended

        Raises CaseError when the result lacks the objective or a constrained metric, or has it in another unit than the bound.
        """
        outcome = Outcome.of(result)
        outcome.require([self.objective, *(one.metric for one in self.constraints)])
        for one in self.constraints if outcome.units else ():
            own = outcome.units[one.metric]
            if (one.unit or "1") != own and not outcome.reason:
                raise CaseError(f"{one.metric} {one.sign} {one.bound:g} {one.unit}: the metric is in {own}\n"
                                f"  = write the bound in {own}")
        rows = [number for number, known in sorted(self.outcomes.items()) if not known.reason]
        former = self._leader(rows) if rows else None
        self.outcomes[trial.number] = outcome
        if trial.number < 2 * len(self.parameters) + 4:
            return
        better = not outcome.reason and self._leader([*rows, trial.number]) == trial.number != former
        moved = numpy.abs(self.places[trial.number] - self.places[former]).max()
        if not better:
            self.radius *= SHRINK
        elif moved > 0.9 * self.radius:
            self.radius = min(LARGEST, self.radius * GROW)

    def best(self) -> tuple[Trial, dict] | None:
        """Best trial so far that meets every constraint, with a dict of its metrics in SI units; None where no trial does."""
        rows = [number for number, outcome in self.outcomes.items() if not outcome.reason and self._missed(number) <= TOLERANCE]
        if not rows:
            return None
        number = min(rows, key=lambda row: self.sign * self.outcomes[row].metrics[self.objective])
        return self.trials[number], self.outcomes[number].metrics
