# SPDX-License-Identifier: Apache-2.0
"""Test for two regimes: fits one power law and two that meet, and chooses by an information criterion."""

from typing import NamedTuple

import numpy

FEWEST = 5  # points that two slopes and a break can be found from


class Fit(NamedTuple):
    """Fit of one power law, or of two power laws that meet at a break. Calling it with values x gives fitted values.

    two        True if two laws describe the data better than one (Bayesian information criterion, by more than 6)
    break_at   value at which the two laws meet; NaN for one law
    low, high  exponents below and above the break; equal for one law
    low_error, high_error  standard errors of the exponents
    gain       criterion of one law minus that of two
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
    """Design matrix of a line, or of two lines that meet at the kink; None for one line."""
    columns = [numpy.ones_like(x), x]
    if kink is not None:
        columns.append(numpy.maximum(0.0, x - kink))
    return numpy.stack(columns, axis=1)


def least_squares(x, y, kink):
    """Least-squares fit of one or two lines: coefficients, their covariance, and the sum of squared residuals."""
    matrix = design(x, kink)
    coefficients, *_ = numpy.linalg.lstsq(matrix, y, rcond=None)
    squares = float(((y - matrix @ coefficients) ** 2).sum())
    freedom = max(1, len(x) - matrix.shape[1] - (kink is not None))
    return coefficients, numpy.linalg.inv(matrix.T @ matrix) * squares / freedom, squares


def criterion(squares, count, parameters):
    """Bayesian information criterion of a least-squares fit (Schwarz 1978, doi 10.1214/aos/1176344136)."""
    return count * numpy.log(max(squares, 1e-300) / count) + parameters * numpy.log(count)


def fit(values, data):
    """Fits one and two power laws and returns the better Fit; None for too few positive points.

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
