# SPDX-License-Identifier: Apache-2.0
"""Figures 11 to 15: motion, shear and current of the run that stands for all."""

import numpy

from ..analysis import derived
from ..charts.spans import peak_of, sampled_label
from . import event_panels, style
from .panels import STEP, error_band, name_phases, scaled, shade_phases

NO_CURRENT = "the run has no currents"
NO_MOTION = "the run has no prescribed motion"
COLOURS = {"top": style.BLUE, "bottom": style.ORANGE, "difference": style.GREEN}


def has_currents(results):
    """True when the run solved the ion transport."""
    return results.sampled.has("current_top")


def title_of(study, text):
    """A panel title that names the member."""
    return f"{text}, {study.label(study.typical)}"


def rate(study):
    """Figure 11: current with the rate of the shear, per readout interval."""
    results = study.typical.results
    if not has_currents(results):
        return NO_CURRENT
    sampled = results.sampled
    correlations = derived.rate_correlations(results)
    shear_rate = derived.sampled_rate(results)
    figure, axes = event_panels.rows(results, [0.9] * 3, right=0.90)
    for panel, (name, colour) in zip(axes, (("top", style.BLUE), ("common", style.PURPLE), ("difference", style.GREEN))):
        column = f"current_{name}"
        unit = scaled(panel, "current", "A", peak_of(sampled[column]))
        panel.plot(sampled["time"], sampled[column] / unit, color=colour, lw=1.0, **STEP)
        twin = panel.twin()
        twin.plot(sampled["time"], shear_rate, color=style.ORANGE, lw=0.8, ls=(0, (3, 1.5)), **STEP)
        twin.panels[-1].set_ylabel("dγ/dt [1/s]", color=style.ORANGE)
        for each, values in ((panel, sampled[column] / unit), (twin, shear_rate)):
            limit = 1.15 * peak_of(values) or 1
            each.set_ylim(-limit, limit)
        words = f"{name.capitalize()} current"
        style.title(panel, title_of(study, words) if panel is axes[0] else words)
        panel.panels[-1].set_title(f"r = {correlations[name, 'sampled']:.3f} sampled, "
                                   f"{correlations[name, 'resolved']:.3f} resolved", loc="right", fontsize=7.5, pad=4)
    event_panels.finish(results, axes)
    figure.text(0.01, 0.008, f"dashed: rate; {sampled_label(results)}", fontsize=6.5, color=style.QUIET)
    return figure


def plot_sampled(panel, results, label, names, width):
    """Sampled currents with their stated errors, the bottom one dashed: it may cover the top one."""
    sampled = results.sampled
    unit = scaled(panel, label, "A", peak_of(sampled["current_top"]))
    for name in names:
        error_band(panel, results, "sampled", f"current_{name}", unit, COLOURS[name])
        panel.plot(sampled["time"], sampled[f"current_{name}"] / unit, color=COLOURS[name], lw=width, label=name,
                   ls=(0, (3, 1.5)) if name == "bottom" else "-", **STEP)
    style.legend(panel)


def current_motion(study):
    """Figure 12: current with the motion."""
    results = study.typical.results
    if not has_currents(results):
        return NO_CURRENT
    if not results.signals.has("slider_x"):
        return NO_MOTION
    signals, sampled = results.signals, results.sampled
    figure, axes = event_panels.rows(results, [0.6, 0.6, 1.1])
    axes[0].plot(signals["time"], signals["slider_x"] * 1e3, color=style.INK, lw=1.0)
    axes[0].set_ylabel("x [mm]")
    axes[1].plot(signals["time"], signals["slider_z"] * 1e3, color=style.INK, lw=1.0)
    axes[1].set_ylabel("z [mm]")
    plot_sampled(axes[2], results, "sampled current", ("top", "bottom", "difference"), 0.9)
    style.title(axes[0], title_of(study, "Centre of the slider"))
    style.title(axes[1], "Underside above the skin")
    style.title(axes[2], "Electrode currents")
    event_panels.finish(results, axes)
    return figure


def first_cycle(results):
    """Start and end of the first cycle [s]."""
    spans = [span for span in results.phases() if span.cycle == 1]
    return (spans[0].start, spans[-1].end) if spans else (results.signals["time"][0], results.signals["time"][-1])


def cycle(study):
    """Figure 13: one cycle of motion, shear and current."""
    results = study.typical.results
    if not has_currents(results):
        return NO_CURRENT
    if not results.signals.has("slider_x"):
        return NO_MOTION
    signals, sampled = results.signals, results.sampled
    figure, axes = event_panels.rows(results, [0.75, 0.75, 0.85, 0.75])
    axes[0].plot(signals["time"], (signals["slider_x"] - signals["slider_x"][0]) * 1e3, color=style.INK, label="x − start")
    axes[0].plot(signals["time"], signals["slider_z"] * 1e3, color=style.INK, ls="--", label="z")
    axes[0].set_ylabel("motion [mm]")
    style.legend(axes[0])
    divisor = scaled(axes[1], "mean shear γ", "1", peak_of(signals["mean_shear"]))
    axes[1].plot(signals["time"], signals["mean_shear"] / divisor, color=style.BLUE)
    plot_sampled(axes[2], results, "current", ("top", "bottom"), 1.0)
    unit = scaled(axes[3], "current", "A", peak_of(sampled["current_difference"]))
    error_band(axes[3], results, "sampled", "current_difference", unit, style.GREEN)
    axes[3].plot(sampled["time"], sampled["current_difference"] / unit, color=style.GREEN, lw=1.0, **STEP)
    event_panels.finish(results, axes, first_cycle(results))
    for panel, words in zip(axes, ("Motion", title_of(study, "Shear"), "Electrodes, " + sampled_label(results),
                                   "Difference (top − bottom)/2, sampled")):
        style.title(panel, words)
    return figure


def phases(study):
    """Figure 14: the boundaries of the phases on the current of one cycle, with the three events enlarged."""
    results = study.typical.results
    if not has_currents(results):
        return NO_CURRENT
    if not results.phases():
        return NO_MOTION
    sampled = results.sampled
    start, end = first_cycle(results)
    figure = style.canvas(height=4.9, left=0.085, right=0.975, top=0.93, bottom=0.125, hspace=0.62, wspace=0.42)
    grid = figure.add_gridspec(3, 3)
    for row, (name, colour, words) in enumerate((("top", style.BLUE, "Top electrode"),
                                                 ("difference", style.GREEN, "Difference (top − bottom)/2"))):
        panel = figure.add_subplot(grid[row, :])
        column = f"current_{name}"
        shown = (sampled["time"] > start) & (sampled["time"] <= end)
        unit = scaled(panel, "sampled current", "A", peak_of(sampled[column][shown]))
        panel.plot(sampled["time"], sampled[column] / unit, color=colour, **STEP)
        shade_phases(results, panel)
        for span in results.phases():
            if span.cycle == 1:
                panel.axvline(span.end, color=style.QUIET, lw=0.8, ls="--")
        panel.set_xlim(start, end)
        panel.set_title(title_of(study, words) if row == 0 else words, loc="left", pad=13 if row == 0 else 4,
                        fontweight="bold")
        if row == 0:
            name_phases(results, panel, 0.0, 1)
        else:
            panel.set_xlabel("time [s]")
    panel = None
    for place, (instant, before, after, words) in enumerate(events(results)):
        panel = figure.add_subplot(grid[2, place])
        enlarged(panel, results, instant, before, after, words)
    if panel is not None:
        figure.legend(*panel.get_legend_handles_labels(), loc="lower center", ncol=3, fontsize=7, borderaxespad=0.1)
    return figure


def events(results):
    """Contact, onset of sliding and loss of contact in the first cycle: instant, window before and after [s], name."""
    spans = {span.phase: span for span in reversed(results.phases())}
    found = []
    if "touchdown" in spans:
        found.append((spans["touchdown"].end, 1.0e-3, 0.0, "contact closes"))
    if "slide" in spans:
        found.append((spans["slide"].start, 0.2e-3, 6e-3, "sliding begins"))
    if "lift" in spans:
        found.append((spans["lift"].start, 0.2e-3, 1.0e-3, "contact opens"))
    return found


def enlarged(panel, results, instant, before, after, words):
    """The resolved current of both electrodes around an event, with the sampled one."""
    signals, sampled = results.signals, results.sampled
    shown = (signals["time"] >= instant - before) & (signals["time"] <= instant + after)
    columns = [(f"current_{name}", name, colour, dash) for name, colour, dash in
               (("top", style.BLUE, "-"), ("bottom", style.ORANGE, (0, (3, 1.5))))]
    unit = scaled(panel, "current", "A", peak_of(*(signals[column][shown] for column, *_ in columns)))
    for column, name, colour, dash in columns:
        panel.plot((signals["time"] - instant) * 1e3, signals[column] / unit, color=colour, ls=dash, lw=1.0,
                   label=f"{name}, resolved", **STEP)
    panel.plot((sampled["time"] - instant) * 1e3, sampled["current_top"] / unit, color=style.PALE, lw=2.0, zorder=1,
               label="top, sampled", **STEP)
    panel.set_xlim(-1e3 * before, 1e3 * after)
    values = numpy.concatenate([signals[column][shown] for column, *_ in columns]) / unit
    low, high = min(0.0, numpy.nanmin(values)), max(0.0, numpy.nanmax(values))
    panel.set_ylim(low - 0.08 * (high - low), high + 0.08 * (high - low))
    panel.set_xlabel(f"time from {instant:.4g} s [ms]")
    style.title(panel, words)


def normalised(study):
    """Figure 15: motion, shear and current, each divided by its largest magnitude."""
    results = study.typical.results
    if not has_currents(results):
        return NO_CURRENT
    if not results.signals.has("slider_x"):
        return NO_MOTION
    signals, sampled = results.signals, results.sampled
    figure, axes = event_panels.rows(results, [1.1, 1.1])
    travel = signals["slider_x"] - signals["slider_x"][0]
    for panel, names in zip(axes, (("slider x", "mean shear γ"), ("_", "_"))):  # the first panel's legend tells both
        panel.plot(signals["time"], travel / (peak_of(travel) or 1), color=style.PALE, lw=1.4, label=names[0])
        panel.plot(signals["time"], signals["mean_shear"] / (peak_of(signals["mean_shear"]) or 1), color=style.ORANGE,
                   lw=1.1, label=names[1])
        panel.set_ylabel("divided by its peak")
        panel.set_ylim(-1.12, 1.12)
    for panel, (name, colour) in zip(axes, (("top", style.BLUE), ("difference", style.GREEN))):
        values = sampled[f"current_{name}"]
        panel.plot(sampled["time"], values / (peak_of(values) or 1), color=colour, lw=0.9, label=f"{name} current, sampled",
                   **STEP)
        style.legend(panel)
        style.title(panel, "Top electrode" if name == "top" else title_of(study, "Difference"))
    event_panels.finish(results, axes)
    return figure


def charge(study):
    """Figure 20: charge that each phase moves, and the audit against the shear."""
    results = study.typical.results
    spans = results.phases()
    if not has_currents(results):
        return NO_CURRENT
    if not spans:
        return NO_MOTION
    signals = results.signals
    factor = derived.charge_per_shear(results)
    fixed = results.case.get("coupling", {}).get("law", "fixed-charge") == "fixed-charge"
    figure, axes = style.stacked(2, heights=[1.1, 0.9], share_x=False)
    place = numpy.arange(len(spans))

    def gained(column):
        return numpy.array([signals.at(column, span.end) - signals.at(column, span.start) for span in spans])

    top, bottom, shear = gained("charge_top"), gained("charge_bottom"), gained("mean_shear")
    unit = scaled(axes[0], "charge gained", "C", peak_of(top, bottom, top + bottom))
    for shift, values, colour, label in ((-0.27, top, style.BLUE, "top"), (0.0, bottom, style.ORANGE, "bottom"),
                                         (0.27, top + bottom, style.PURPLE, "sum")):
        axes[0].bar(place + shift, values / unit, 0.25, color=colour, label=label)
    if factor is not None and fixed:
        axes[0].plot(place + 0.27, factor * shear / unit, ls="", marker="_", markersize=9, markeredgewidth=1.4,
                     color=style.INK, label="sum by F c₀ k ∫γ dV")
    half = (top - bottom) / 2
    unit = scaled(axes[1], "charge gained", "C", peak_of(half))
    axes[1].bar(place, half / unit, 0.5, color=style.GREEN)
    names = [f"{span.phase}\n{span.cycle}" for span in spans]
    for panel in axes:
        panel.axhline(0, color=style.QUIET, lw=0.6)
        panel.set_xticks(place, names if panel is axes[1] else [""] * len(spans), fontsize=6.5)
        panel.grid(axis="x", visible=False)
        panel.set_xlim(-0.6, len(spans) - 0.4)
    axes[1].set_xlabel("phase and cycle")
    figure.subplots_adjust(bottom=0.62 / figure.get_figheight(), hspace=0.25)
    error = results.metrics.get("charge_identity_error")
    style.title(axes[0], f"Charge identity to {error.value:.0e}" if error and error.value is not None else "Electrodes")
    style.title(axes[1], f"Difference (top − bottom)/2, {study.label(study.typical)}")
    style.legend(axes[0])
    return figure
