# SPDX-License-Identifier: Apache-2.0
"""Axes of matplotlib that are logarithmic on both sides of 0."""

import numpy
from matplotlib.ticker import EngFormatter, FixedLocator, NullLocator

from ..charts.spans import DECADES


def signed_log_axis(panel, unit, peak):
    """Symmetric logarithmic axis over the decades below a peak, with few and readable ticks."""
    top = int(numpy.ceil(numpy.log10(peak))) if peak > 0 else 0
    threshold = 10.0 ** (top - DECADES)
    panel.set_yscale("symlog", linthresh=threshold, linscale=0.6)
    powers = [10.0 ** (top - n) for n in range(0, DECADES + 1, 2)]
    panel.yaxis.set_major_locator(FixedLocator([-p for p in powers] + [0.0] + powers[::-1]))
    panel.yaxis.set_minor_locator(NullLocator())
    panel.yaxis.set_major_formatter(EngFormatter(unit=unit))
    panel.set_ylim(-1.3 * 10.0**top, 1.3 * 10.0**top)
