# SPDX-License-Identifier: Apache-2.0
"""Uncertainty study: statistics and Sobol' indices of a case's results under uncertain keys, by ask and tell."""

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy

from ..case import Case
from ..errors import CaseError
from ..evaluation import Outcome, Trial
from . import chaos, designs, distributions

LEAST_Q2 = 0.95
FEWEST = 16
METRICS = ("peak_sampled_current_difference", "rms_current_difference", "peak_mean_shear", "normal_force_slide")
QUANTILES = (0.025, 0.05, 0.25, 0.5, 0.75, 0.95, 0.975)
SURROGATE_SAMPLES = 20000


class Analysis(NamedTuple):
    """Statistics of one metric over the samples of an uncertainty study.

    mean, deviation   mean and standard deviation of the samples, in the metric's SI unit
    quantiles         dict of probability to quantile: of the surrogate where it is valid, else of the samples, in this unit
    q2                predictive coefficient Q2 of the surrogate, 1 minus the share of the variance that it misses at points that
                      it has not seen; None for a metric that does not vary
    leave_one_out     corrected leave-one-out error of the surrogate, as a share of the variance; None as for q2
    degree, terms     polynomial degree of the surrogate, and its number of terms without the constant
    first, total      dict of key to first-order and total Sobol' index as (index, lower, upper), with the ends of the 95 %
                      interval; {} where the surrogate is refused
    refusal           reason why there are no indices, and the remedy; "" where there are indices
    samples_needed    estimated number of samples, in all, for a valid surrogate; 0 where it is valid or more do not help
    """

    mean: float
    deviation: float
    quantiles: dict
    q2: float | None
    leave_one_out: float | None
    degree: int
    terms: int
    first: dict
    total: dict
    refusal: str
    samples_needed: int


class Uncertainty:
    """Uncertainty study: how much results vary with uncertain keys of a case, and which key matters most.

    The study makes the trials, the caller runs them and hands the results back, in any order.

    case      an ionskin.Case; None for a function of one's own, whose keys are any names
    vary      dict of key to its distribution, as text: {"contact.friction": "uniform(0.1, 0.4)"}; or a list of texts
              "KEY=DISTRIBUTION"
    samples   number of trials, at least 16; with the design "sobol" it may be raised later
    design    "sobol" (Sobol' sequence) or "lhs" (Latin hypercube)
    seed      seed of the design
    metrics   names of metrics to analyse; empty for the usual ones, or all where a result has none of these
    least_q2  least Q2 at which the surrogate of a metric is used

        study = ionskin.Uncertainty(case, {"contact.friction": "uniform(0.1, 0.4)"}, samples=64)
        for trial in study.ask():
            study.tell(trial, ionskin.run(trial.case))
        study.analyse()["peak_mean_shear"].first

    Raises CaseError before any work when an argument is wrong or a distribution reaches values that its key cannot have.
    """

    def __init__(self, case: Case | None, vary: dict | Sequence[str], *, samples: int = 64, design: str = "sobol",
                 seed: int = 1, metrics: Sequence[str] = (), least_q2: float = LEAST_Q2) -> None:
        if samples < FEWEST:
            raise CaseError(f"{samples} samples are too few\n  = give at least {FEWEST}")
        if not 0 < least_q2 < 1:
            raise CaseError(f"least Q2 = {least_q2} is outside 0 to 1\n  = {LEAST_Q2} is the default")
        self.case, self.metrics, self.seed, self.least_q2 = case, list(metrics), seed, least_q2
        self.parameters = distributions.parse_all(vary, case)
        unit_cube = designs.points(design, samples, len(self.parameters), seed)
        self.germs = numpy.column_stack([one.germs(unit_cube[:, k]) for k, one in enumerate(self.parameters)])
        values = numpy.column_stack([one.values(self.germs[:, k]) for k, one in enumerate(self.parameters)])
        self.trials = [self._trial(number, row) for number, row in enumerate(values)]
        self.outcomes: dict[int, Outcome] = {}

    @property
    def keys(self) -> list[str]:
        """Names of the keys that vary, in the order of `vary`."""
        return [one.key for one in self.parameters]

    def _trial(self, number, row) -> Trial:
        values = {one.key: float(value) for one, value in zip(self.parameters, row)}
        if self.case is None:
            return Trial(number, values)
        case = self.case.copy()
        for one in self.parameters:
            case._edits.pop(one.key, None)
            case._edits[one.key] = one.text(values[one.key])
        try:
            return Trial(number, values, case.check())
        except CaseError as error:
            at = ", ".join(f"{one.key} = {values[one.key]:.6g}" for one in self.parameters)
            raise CaseError(f"sample {number} is not a valid case ({at})\n  = narrow the distributions so that all values go "
                            f"together\n{error}") from error

    def ask(self, count: int | None = None) -> list[Trial]:
        """Returns the trials that have no result yet, in order; the first `count` of them, or all for None."""
        return [trial for trial in self.trials if trial.number not in self.outcomes][:count]

    def tell(self, trial: Trial, result: Any) -> None:
        """Takes the result of a trial.

        trial   a trial that `ask` returned
        result  Results of its run, a dict of metric name to number, or the exception with which its run ended

        Raises CaseError when the trial is of another study, or the first result lacks a metric that was asked for.
        """
        if not 0 <= trial.number < len(self.trials):
            raise CaseError(f"trial {trial.number} does not belong to this study\n  = pass a trial that ask() returned")
        outcome = Outcome.of(result)
        if not self.finished():  # the first result tells a misspelt metric, not the last
            outcome.require(self.metrics)
        self.outcomes[trial.number] = outcome

    def finished(self) -> list[int]:
        """Numbers of the trials that have a result and did not fail, ascending."""
        return [number for number in sorted(self.outcomes) if not self.outcomes[number].reason]

    def chosen_metrics(self) -> list[str]:
        """Names of the metrics to analyse: those asked for, else the usual ones, else all that the first result has.

        Raises CaseError when no trial has a result yet.
        """
        rows = self.finished()
        if not rows:
            raise CaseError("no sample has a result yet\n  = call tell() with the result of each trial that ask() returned")
        known = list(self.outcomes[rows[0]].metrics)
        return self.metrics or [name for name in METRICS if name in known] or known

    def data(self, name: str):
        """Samples of a metric: list of the numbers of the trials that have it, and array of its values in SI units."""
        rows = [number for number in self.finished() if name in self.outcomes[number].metrics]
        return rows, numpy.array([self.outcomes[number].metrics[name] for number in rows])

    def analyse(self) -> dict[str, Analysis]:
        """Analyses the results given so far and returns a dict of metric name to Analysis.
        Raises CaseError for less than 16 results."""
        return {name: self._analysis(*self.data(name)) for name in self.chosen_metrics()}

    def _analysis(self, rows, data) -> Analysis:
        if len(rows) < FEWEST:
            raise CaseError(f"{len(rows)} finished samples are too few\n  = at least {FEWEST} are needed")
        quantiles = {level: float(numpy.quantile(data, level)) for level in QUANTILES}
        moments = float(data.mean()), float(data.std(ddof=1))
        if moments[1] <= 1e-9 * numpy.abs(data).max():
            return Analysis(*moments, quantiles, None, None, 0, 0, {}, {}, "it does not vary with these keys", 0)
        germs, laws = self.germs[rows], [one.germ for one in self.parameters]
        centred = (data - data.mean()) / data.std()
        surrogate = chaos.fit(germs, centred, laws)
        about = (float(surrogate.q2), float(surrogate.leave_one_out), surrogate.degree, len(surrogate.terms) - 1)
        if not surrogate.q2 >= self.least_q2:
            needed = self._samples_needed(germs, centred, laws, 1 - surrogate.q2)
            remedy = (f"about {needed} samples in all may do ({needed - len(data)} more): --resume --samples {needed}" if needed
                      else "more samples hardly help: the polynomials do not hold this function; narrow the distributions, or "
                      "choose a smoother metric")
            refusal = (f"the surrogate explains {max(surrogate.q2, 0):.3f} of the variance at points that it has not seen, less "
                       f"than {self.least_q2:g}; {remedy}")
            return Analysis(*moments, quantiles, *about, {}, {}, refusal, needed)
        at = numpy.column_stack([one.germs(column) for one, column in zip(self.parameters, designs.points(
            "sobol", SURROGATE_SAMPLES if len(self.parameters) < 3 else SURROGATE_SAMPLES // 2, len(laws), self.seed).T)])
        drawn = surrogate.evaluate(at) * data.std() + data.mean()
        quantiles = {level: float(numpy.quantile(drawn, level)) for level in QUANTILES}
        estimates = chaos.indices(surrogate.terms, surrogate.coefficients)
        ranges = chaos.intervals(surrogate, centred, self.seed)
        first, total = ({key: (float(index[k]), float(ends[0][k]), float(ends[1][k])) for k, key in enumerate(self.keys)}
                        for index, ends in zip(estimates, ranges))
        return Analysis(*moments, quantiles, *about, first, total, "", 0)

    def _samples_needed(self, germs, data, laws, error) -> int:
        """Number of samples needed, by how the error fell from half of the samples to all; 0 where it hardly did. Too
        few samples to tell a quadratic function of the keys say nothing of more."""
        half, keys = len(data) // 2, len(laws)
        if half < max(FEWEST // 2, (keys + 1) * (keys + 2) // 2):
            return 4 * len(data)
        former = 1 - chaos.fit(germs[:half], data[:half], laws).q2
        rate = numpy.log2(former / error) if error > 0 and former > error else 0.0
        if rate < 0.3 or error > 0.9:
            return 0
        factor = (error / (1 - self.least_q2)) ** (1 / rate)
        return int(numpy.ceil(len(data) * min(max(factor, 1.25), 32.0) / 8) * 8)
