# SPDX-License-Identifier: Apache-2.0
"""Dependence of a metric on the swept keys, from the points of a sampled sweep."""

from typing import NamedTuple

import numpy

FEWEST = 6  # points below which neither figure means anything
DEGREE = 2


def ranks(values):
    """Ranks of values in ascending order, from 0; equal values share their mean rank."""
    values = numpy.asarray(values, float)
    _, place, counts = numpy.unique(values, return_inverse=True, return_counts=True)
    ends = numpy.cumsum(counts)
    return (ends - (counts + 1) / 2)[place]


def rank_correlation(values, data):
    """Spearman's rank correlation coefficient (1904, doi 10.2307/1412159); NaN when one array is constant."""
    first, second = ranks(values), ranks(data)
    first, second = first - first.mean(), second - second.mean()
    scale = numpy.sqrt((first**2).sum() * (second**2).sum())
    return float((first * second).sum() / scale) if scale > 0 else float("nan")


def first_order(values, data):
    """Share of the variance of the data that a parabola in one key's values explains (adjusted R2), in [0, 1].

    An estimate of the first-order index of Sobol (2001, doi 10.1016/S0378-4754(00)00270-6); NaN for constant data.
    """
    values, data = numpy.asarray(values, float), numpy.asarray(data, float)
    width = values.max() - values.min()
    total = ((data - data.mean()) ** 2).sum()
    freedom = len(data) - DEGREE - 1
    if total <= (1e-12 * numpy.abs(data).max()) ** 2 * len(data) or width == 0 or freedom < 1:
        return float("nan")
    fit = numpy.polynomial.Polynomial.fit(values, data, DEGREE)
    left = ((data - fit(values)) ** 2).sum() / total
    return float(numpy.clip(1 - left * (len(data) - 1) / freedom, 0.0, 1.0))


class Sensitivity(NamedTuple):
    """Sensitivities of metrics to swept keys, as arrays [metric, key]: `rank` holds rank
    correlations, `share` first-order shares."""

    metrics: list
    keys: list
    rank: numpy.ndarray
    share: numpy.ndarray


def of_study(study, metrics):
    """Sensitivity of a Study: of those `metrics` that every member has, to every swept key that is a number; None for
    too few points."""
    keys = study.numeric_keys
    present = [name for name in metrics if numpy.isfinite(study.metric(name)).all()]
    if not keys or not present or len(study.members) < FEWEST:
        return None
    values = {key: [member.values[key] for member in study.members] for key in keys}

    def matrix(measure):
        return numpy.array([[measure(values[key], study.metric(name)) for key in keys] for name in present])

    return Sensitivity(present, keys, matrix(rank_correlation), matrix(first_order))
