# SPDX-License-Identifier: Apache-2.0
"""Are there two regimes? One power law against two that meet, judged on the data alone."""

from typing import NamedTuple

import numpy

FEWEST = 5  # points that two slopes and a break can be found from


class Fit(NamedTuple):
    """A power law, or two that meet at a break.

    two        whether two describe the data better than one (Bayesian information criterion, by more than 6)
    low, high  exponents with standard errors; equal for one law
    gain       by how much the criterion of one law exceeds that of two
    """

    two: bool
    break_at: float
    low: float
    low_error: float
    high: float
    high_error: float
    gain: float
    values: numpy.ndarray
    coefficients: numpy.ndarray

    def __call__(self, x):
        return numpy.exp(design(numpy.log(x), numpy.log(self.break_at) if self.two else None) @ self.coefficients)


def design(x, kink):
    """Columns of a line, or of two lines that meet at the kink."""
    columns = [numpy.ones_like(x), x]
    if kink is not None:
        columns.append(numpy.maximum(0.0, x - kink))
    return numpy.stack(columns, axis=1)


def least_squares(x, y, kink):
    """Coefficients, their covariance and the sum of squares."""
    matrix = design(x, kink)
    coefficients, *_ = numpy.linalg.lstsq(matrix, y, rcond=None)
    squares = float(((y - matrix @ coefficients) ** 2).sum())
    freedom = max(1, len(x) - matrix.shape[1] - (kink is not None))
    return coefficients, numpy.linalg.inv(matrix.T @ matrix) * squares / freedom, squares


def criterion(squares, count, parameters):
    """Bayesian information criterion of a least-squares fit (Schwarz 1978, doi 10.1214/aos/1176344136)."""
    return count * numpy.log(max(squares, 1e-300) / count) + parameters * numpy.log(count)


def fit(values, data):
    """The better of one and two power laws, or None for too few positive points.

    values, data  sequences of equal length; entries that are not positive are left out
    The break is searched between the second and the last but one value.
    """
    values, data = numpy.asarray(values, float), numpy.asarray(data, float)
    kept = (values > 0) & (data > 0)
    values, data = values[kept], data[kept]
    if len(values) < FEWEST:
        return None
    x, y = numpy.log(values), numpy.log(data)
    line, line_covariance, line_squares = least_squares(x, y, None)
    kinks = numpy.linspace(x[1], x[-2], 400)
    best = min(kinks, key=lambda kink: least_squares(x, y, kink)[2])
    two, covariance, squares = least_squares(x, y, best)
    gain = criterion(line_squares, len(x), 2) - criterion(squares, len(x), 4)
    if gain <= 6:
        error = float(numpy.sqrt(line_covariance[1, 1]))
        return Fit(False, float("nan"), line[1], error, line[1], error, gain, values, line)
    high_error = numpy.sqrt(covariance[1, 1] + covariance[2, 2] + 2 * covariance[1, 2])
    return Fit(True, float(numpy.exp(best)), two[1], float(numpy.sqrt(covariance[1, 1])), two[1] + two[2],
               float(high_error), gain, values, two)
