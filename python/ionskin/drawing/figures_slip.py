# SPDX-License-Identifier: Apache-2.0
"""Figure 23: whether the currents tell a slip before it happens."""

import numpy
from matplotlib.ticker import EngFormatter, NullFormatter

from ..analysis import slip
from ..words import quantity
from . import style

LOOKS = {"difference": (style.GREEN, "o"), "common": (style.PURPLE, "s")}
NO_ONSET = "nothing sticks when the slide begins, or nothing slides"


def friction_window(study):
    """Figure 23: lead time and what the currents show before full slip, against the swept key."""
    told = {current: [slip.told(member.results, current) for member in study.members] for current in slip.CURRENTS}
    leads = numpy.array(study.metric("slip_lead_time"))
    if study.single:
        return "a single run has no window: sweep contact.friction"
    if not numpy.isfinite(leads).any():
        return NO_ONSET
    figure = style.canvas(height=2.9, left=0.105, right=0.975, top=0.90, bottom=0.17, wspace=0.36)
    axes = figure.subplots(1, 2)
    lead_panel(study, axes[0], leads, told)
    departure_panel(study, axes[1], told)
    for panel, unit in zip(axes, "sA"):
        panel.set_yscale("log")
        panel.yaxis.set_major_formatter(EngFormatter(unit))
        panel.yaxis.set_minor_formatter(NullFormatter())
        panel.set_xlabel(study.axis_label())
        shade_window(panel, study, told)
    style.title(axes[0], "Lead before full slip")
    style.title(axes[1], "Departure")
    axes[1].set_title(window_words(study, told), loc="right", pad=4, color=style.QUIET, fontsize=7.5)
    return figure


def lead_panel(study, panel, leads, told):
    """From the first micro-slip, and from where each current is seen, to full slip."""
    values = [member.value for member in study.members]
    line = "" if study.scattered else "-"
    errors = numpy.array([slip.error(member.results, "slip_lead_time") for member in study.members])
    panel.errorbar(values, leads, below(leads, errors), color=style.BLUE, marker="^", markersize=3.5, ls=line,
                   capsize=2, lw=0.9, label="micro-slip")
    for current, (colour, marker) in LOOKS.items():
        own = numpy.array([each.lead for each in told[current]])
        if numpy.isfinite(own).any():
            panel.plot(values, own, color=colour, marker=marker, markersize=3, ls=line and "--", lw=0.9,
                       markerfacecolor="white", label=current)
    interval = told["difference"][0].interval
    if numpy.isfinite(interval):
        panel.axhline(interval, color=style.INK, lw=0.8, ls=":", label="readout interval")
    panel.set_ylabel("lead")
    panel.legend(fontsize=6.5, loc="lower right", bbox_to_anchor=(1.0, 0.2), frameon=True, framealpha=0.85, facecolor="white", edgecolor="none")


def below(values, errors):
    """Bars of a logarithmic axis: downwards they end at a fifth of the value."""
    return numpy.array([numpy.minimum(errors, 0.8 * numpy.abs(values)), errors])


def departure_panel(study, panel, told):
    """The departure of each current with its stated error, and the noise floor."""
    values = [member.value for member in study.members]
    line = "" if study.scattered else "-"
    for current, (colour, marker) in LOOKS.items():
        own = numpy.array([each.departure for each in told[current]])
        noise = numpy.array([each.noise for each in told[current]])
        if not (own > noise).any():
            continue
        errors = numpy.array([each.error for each in told[current]])
        panel.errorbar(values, own, below(own, errors), color=colour, marker=marker, markersize=3.5, ls=line,
                       capsize=2, lw=0.9, label=current)
    floor = slip.SEEN * numpy.array([each.noise for each in told["difference"]])
    if numpy.isfinite(floor).any():
        panel.plot(values, floor, color=style.INK, lw=0.8, ls=":", label=f"{slip.SEEN} × noise floor")
    panel.set_ylabel("departure of a reading")
    panel.legend(fontsize=6.5, loc="lower right", bbox_to_anchor=(1.0, 0.1), frameon=True, framealpha=0.85, facecolor="white", edgecolor="none")


def inside(told):
    """Per member whether any current tells."""
    return [any(each.told for each in pair) for pair in zip(*told.values())]


def shade_window(panel, study, told):
    """Shades the values whose slip is told, half way to their neighbours."""
    if study.scattered:
        return
    values = numpy.array([member.value for member in study.members])
    middles = (values[1:] + values[:-1]) / 2
    edges = numpy.concatenate([values[:1], middles, values[-1:]])
    for low, high, tells in zip(edges, edges[1:], inside(told)):
        if tells:
            panel.axvspan(low, high, color=style.BAND_STRONG, lw=0, zorder=0)


def window_words(study, told):
    """The shaded values in words: "told at 0.1–0.3, 0.5"."""
    unit = study.unit if study.unit != "1" else ""
    runs = []
    for before, member, tells in zip([False, *inside(told)], study.members, inside(told)):
        if tells:
            words = quantity(member.value, unit, 3) if unit else f"{member.value:.3g}"
            runs = [*runs[:-1], (runs[-1][0], words)] if before else [*runs, (words, words)]
    texts = [first if first == last else f"{first}–{last}" for first, last in runs]
    return "told at " + ", ".join(texts) if texts else "no window"
