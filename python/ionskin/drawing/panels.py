# SPDX-License-Identifier: Apache-2.0
"""Parts that many figures share: phase bands, axes with prefixed units, signed logarithmic axes."""

import numpy
from matplotlib.ticker import EngFormatter, FixedLocator, NullLocator

from . import style

CONTACT_PHASES = {"touchdown": style.BAND, "slide": style.BAND_STRONG, "lift": style.BAND}
STEP = {"drawstyle": "steps-pre"}  # a current is the mean over the step that ends at its row
SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
DECADES = 5  # between the largest current and the linear part of a symmetric logarithmic axis


def contact_spans(results):
    """The parts of the phases in which slider and skin touch, as PhaseSpan; whole phases where no force is known."""
    signals = results.signals
    spans = [span for span in results.phases() if span.phase != "return"]
    if not signals.has("normal_force"):
        return spans
    time, touching = signals["time"], signals["normal_force"] > 0
    found = []
    for span in spans:
        rows = numpy.flatnonzero(rows_within(signals, span) & touching)
        if len(rows):
            # A row belongs to the step that ends there; the force of the last contact falls to 0 within the next one.
            end = min(rows[-1] + 1, len(time) - 1)
            found.append(span._replace(start=max(span.start, time[rows[0] - 1]), end=min(span.end, time[end])))
    return found


def shade_phases(results, axes, offset=0.0, cycle=None):
    """Bands behind the contact; darker while it slides."""
    for span in contact_spans(results):
        if span.phase in CONTACT_PHASES and (cycle is None or span.cycle == cycle):
            axes.axvspan(span.start - offset, span.end - offset, color=CONTACT_PHASES[span.phase], lw=0, zorder=0)


def name_phases(results, axes, offset, cycle):
    """Phase names along the upper edge of a panel that shows one cycle."""
    for span in results.phases():
        if span.cycle == cycle:
            axes.text((span.start + span.end) / 2 - offset, 1.0, span.phase, transform=axes.get_xaxis_transform(),
                      ha="center", va="bottom", fontsize=7, color=style.QUIET)


def time_axis(results, axes):
    """Limits of the run below the last panel and its label."""
    time = results.signals["time"]
    axes[-1].set_xlim(time[0], time[-1])
    axes[-1].set_xlabel("time [s]")
    for panel in axes:
        shade_phases(results, panel)


def error_band(panel, results, table, name, divisor, colour):
    """Shades the stated error of a signal; nothing where none is stated."""
    band = results.band(table, name)
    if band is not None:
        panel.fill_between(getattr(results, table)["time"], *(end / divisor for end in band), step="pre" if
                           name.startswith("current") else None, color=colour, alpha=0.25, lw=0, zorder=1.5)


def motion_panels(results, row, colours):
    """Position and height of the slider over time, one panel each; `row` is the height of a panel."""
    signals = results.signals
    figure, axes = style.stacked(2, heights=[row, row])
    for panel, colour, column, label in zip(axes, colours, ("slider_x", "slider_z"), ("position x [mm]", "height z [mm]")):
        panel.plot(signals["time"], signals[column] * 1e3, color=colour)
        panel.set_ylabel(label)
    axes[1].axhline(0, color=style.QUIET, lw=0.6)
    time_axis(results, axes)
    return figure, axes


def scaled_label(name, unit, peak):
    """Divisor of the values of an axis, and its label with the prefixed unit."""
    divisor, prefix = style.si_scale(peak)
    if unit != "1":
        return divisor, f"{name} [{prefix}{unit}]"
    power = f"{round(numpy.log10(divisor)):d}".translate(SUPERSCRIPTS)
    return divisor, f"{name} [10{power}]" if divisor != 1 else name


def scaled(panel, name, unit, peak):
    """Labels a linear axis with a prefixed unit and returns the divisor of its values."""
    divisor, label = scaled_label(name, unit, peak)
    panel.set_ylabel(label)
    return divisor


def peak_of(*columns):
    """Largest magnitude over columns with empty entries; 0 without any."""
    values = numpy.concatenate([numpy.ravel(column) for column in columns]) if columns else numpy.empty(0)
    return float(numpy.max(numpy.abs(values[numpy.isfinite(values)]), initial=0.0))


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


def first_cycle_names(results, panel):
    """Says once what the bands mean."""
    handles = [panel.fill_between([], [], color=colour, lw=0, label=label) for colour, label in
               ((style.BAND, "touching"), (style.BAND_STRONG, "sliding"))]
    panel.legend(handles=handles, loc="lower right", bbox_to_anchor=(1.0, 0.98), ncol=2, borderaxespad=0.1,
                 handlelength=1.4)


def rows_within(signals, span):
    """Rows whose whole step lies in a span."""
    return (signals["time"] > span.start) & (signals["time"] <= span.end)


def sampled_label(results):
    """Names the sampled current with its interval."""
    time = results.sampled["time"]
    if len(time) < 2:
        return "sampled"
    return f"sampled, mean over {EngFormatter(unit='s').format_eng(round(time[1] - time[0], 9))}s each"


def slide_start(results):
    """Start of the slide of the first cycle [s], or None."""
    return next((span.start for span in results.phases() if span.phase == "slide"), None)
