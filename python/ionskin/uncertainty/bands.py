# SPDX-License-Identifier: Apache-2.0
"""Quantile bands of signals over time, taken over the samples of a study."""

import numpy

SIGNALS = ("sampled/current_difference", "sampled/current_top", "signals/mean_shear", "signals/normal_force")
LEVELS = (0.05, 0.25, 0.5, 0.75, 0.95)
ROWS = 400


def bands(outcomes):
    """Quantiles of signals over outcomes: dict of signal to (instants [s], array [level,
    instant]), over the time that all runs cover."""
    result = {}
    for name in SIGNALS:
        runs = [outcome.columns for outcome in outcomes if name in outcome.columns]
        if not runs:
            continue
        clock = name.split("/")[0] + "/time"
        time = numpy.linspace(max(run[clock][0] for run in runs), min(run[clock][-1] for run in runs), ROWS)
        curves = [numpy.interp(time, run[clock], run[name]) for run in runs]
        result[name] = time, numpy.quantile(curves, LEVELS, axis=0)
    return result
