# SPDX-License-Identifier: Apache-2.0
"""Parts that many figures share: phase bands, axes with prefixed units, signed logarithmic axes."""

import numpy
from matplotlib.collections import BrokenBarHCollection
from matplotlib.ticker import EngFormatter, FixedLocator, NullLocator

from ..charts.spans import CONTACT_PHASES, DECADES, contact_spans, scaled_label
from . import style

STEP = {"drawstyle": "steps-pre"}  # a current is the mean over the step that ends at its row


def shade_phases(results, axes, offset=0.0, cycle=None):
    """Bands behind the contact; darker while it slides."""
    for colour in (style.BAND, style.BAND_STRONG):
        bands = [(span.start - offset, span.end - span.start) for span in contact_spans(results)
                 if CONTACT_PHASES.get(span.phase) == colour and (cycle is None or span.cycle == cycle)]
        if bands:
            axes.add_collection(BrokenBarHCollection(bands, (0, 1), color=colour, lw=0, zorder=0,
                                                     transform=axes.get_xaxis_transform()), autolim=False)


def name_phases(results, axes, offset, cycle):
    """Phase names along the upper edge of a panel that shows one cycle."""
    for span in results.phases():
        if span.cycle == cycle:
            axes.text((span.start + span.end) / 2 - offset, 1.0, span.phase, transform=axes.get_xaxis_transform(),
                      ha="center", va="bottom", fontsize=7, color=style.QUIET)


def error_band(panel, results, table, name, divisor, colour):
    """Shades the stated error of a signal; nothing where none is stated."""
    band = results.band(table, name)
    if band is not None:
        panel.fill_between(getattr(results, table)["time"], *(end / divisor for end in band), step="pre" if
                           name.startswith("current") else None, color=colour, alpha=0.25, lw=0, zorder=1.5)


def scaled(panel, name, unit, peak):
    """Labels a linear axis with a prefixed unit and returns the divisor of its values."""
    divisor, label = scaled_label(name, unit, peak)
    panel.set_ylabel(label)
    return divisor


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
