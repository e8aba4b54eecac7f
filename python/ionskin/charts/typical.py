# SPDX-License-Identifier: Apache-2.0
"""Figures 11 to 15 and 20: motion, shear and current of the typical run of a study."""

import numpy

from ..analysis import derived
from .chart import Axis, Cell, Chart, Curve, Mark, Note, over_time, phase_spans, with_events
from .colours import BLUE, GREEN, INK, ORANGE, PALE, PURPLE, QUIET
from .spans import peak_of, sampled_label

NO_CURRENT = "the run has no currents"
NO_MOTION = "the run has no prescribed motion"
COLOURS = {"top": BLUE, "bottom": ORANGE, "difference": GREEN, "common": PURPLE}
MOST_NAMED = 4  # phases whose names fit side by side
BEFORE, AFTER = 0.2e-3, 1e-3  # of an event that is enlarged [s]


def needs(*columns):
    """Decorator that makes a figure of a Study's typical run from a function of Results.

    The figure is the reason for its absence where the run lacks currents or the named signals, or, without names, phases.
    """
    def wrapped(build):
        def drawn(study):
            results = study.typical.results
            if not results.sampled.has("current_top"):
                return NO_CURRENT
            if columns and not results.signals.has(*columns) or not columns and not results.phases():
                return NO_MOTION
            chart = build(results)
            member = "" if study.single else f"{study.label(study.typical)}."
            return chart._replace(note=f"{member} {chart.note}".strip())
        return drawn
    return wrapped


def scaled(values):
    """Divides a series by its largest magnitude."""
    return values / (peak_of(values) or 1.0)


def sampled(results, name, label="", divided=False, look=""):
    """Curve of a sampled current with its error band; `divided`: by its largest magnitude."""
    column = f"current_{name}"
    values = results.sampled[column]
    return Curve(results.sampled["time"], scaled(values) if divided else values, label, COLOURS[name], "held", look=look,
                 band=None if divided else results.band("sampled", column))


@needs("mean_shear")
def rate(results):
    """Figure 11: current with the rate of the shear, per readout interval, each divided by its largest magnitude."""
    correlations, speed = derived.rate_correlations(results), scaled(derived.sampled_rate(results))
    panels = []
    for name in ("top", "common", "difference"):
        title = (f"{name.capitalize()} current: r = {correlations[name, 'sampled']:.3f} sampled, "
                 f"{correlations[name, 'resolved']:.3f} resolved")
        panels.append((title, Axis("divided by its peak", "1", -1.15, 1.15),
                       [sampled(results, name, "current", True), Curve(results.sampled["time"], speed, "rate dγ/dt", INK, "held", 0.9, "dashed")],
                       0.9))
    return with_events(results, panels)._replace(note=f"{sampled_label(results).capitalize()}.")


@needs("slider_x", "slider_z")
def current_motion(results):
    """Figure 12: current with the motion."""
    signals = results.signals
    return with_events(results, [
        ("Centre of the slider", Axis("x", "m"), [Curve(signals["time"], signals["slider_x"], "", INK)], 0.6),
        ("Underside above the skin", Axis("z", "m"), [Curve(signals["time"], signals["slider_z"], "", INK)], 0.6),
        ("Electrode currents", Axis("sampled current", "A"), electrodes(results) + [sampled(results, "difference", "difference")], 1.1)])


def electrodes(results):
    """Sampled currents of both electrodes; the bottom one is dashed, as it may cover the top one."""
    return [sampled(results, "top", "top"), sampled(results, "bottom", "bottom", look="dashed")]


def first_cycle(results):
    """Start and end of the first cycle [s]."""
    spans = [span for span in results.phases() if span.cycle == 1]
    return (spans[0].start, spans[-1].end) if spans else (results.signals["time"][0], results.signals["time"][-1])


@needs("slider_x", "slider_z", "mean_shear")
def cycle(results):
    """Figure 13: one cycle of motion, shear and current."""
    signals = results.signals
    time = signals["time"]
    return with_events(results, [
        ("Motion", Axis("motion", "m"), [Curve(time, signals["slider_x"] - signals["slider_x"][0], "x − start", INK),
                                         Curve(time, signals["slider_z"], "z", INK, look="dashed")], 0.8),
        ("Shear", Axis("mean shear γ"), [Curve(time, signals["mean_shear"])], 0.8),
        (f"Electrodes, {sampled_label(results)}", Axis("current", "A"), electrodes(results), 0.9),
        ("Difference (top − bottom)/2, sampled", Axis("current", "A"), [sampled(results, "difference")], 0.8)], first_cycle(results))


@needs()
def phases(results):
    """Figure 14: the boundaries of the phases on the current of one cycle, with the events enlarged."""
    begin, end = first_cycle(results)
    own = [span for span in results.phases() if span.cycle == 1]
    marks, names = tuple(Mark(span.end) for span in own), tuple(Note((span.start + span.end) / 2, 1.0, span.phase, "middle", QUIET) for span in own)
    rows = []
    for name, words in (("top", "Top electrode"), ("difference", "Difference (top − bottom)/2")):
        rows.append([Cell(words, Axis("time" if rows else "", "s", begin, end), Axis("sampled current", "A"), (sampled(results, name),),
                          phase_spans(results), marks, phases=() if rows else names)])
    enlarged = [enlarge(results, *each) for each in events(results)]
    if enlarged:
        rows.append([cell if place == 0 else cell._replace(legend=False) for place, cell in enumerate(enlarged)])
    return Chart(rows, (1.0,) * max(1, len(enlarged)))


def events(results):
    """Contact, onset of sliding and loss of contact in the first cycle: instant, window before and after [s], name."""
    spans = {span.phase: span for span in reversed(results.phases())}
    found = []
    if "touchdown" in spans:
        found.append((spans["touchdown"].end, AFTER, 0.0, "Contact closes"))
    if "slide" in spans:
        found.append((spans["slide"].start, BEFORE, 6 * AFTER, "Sliding begins"))
    if "lift" in spans:
        found.append((spans["lift"].start, BEFORE, AFTER, "Contact opens"))
    return found


def enlarge(results, instant, before, after, words):
    """Cell with the resolved current of both electrodes about an event, from `before` to `after` it [s]."""
    signals = results.signals
    shown = (signals["time"] >= instant - before) & (numpy.concatenate([signals["time"][:1], signals["time"][:-1]]) <= instant + after)
    curves = tuple(Curve(signals["time"][shown], signals[f"current_{name}"][shown], f"{name}, resolved", COLOURS[name], "over", look=look)
                   for name, look in (("top", ""), ("bottom", "dashed")))
    return Cell(words, Axis(f"time from {instant:.4g} s", "s", instant - before, instant + after, instant), Axis("current", "A"), curves, height=1.0)


@needs("slider_x", "mean_shear")
def normalised(results):
    """Figure 15: motion, shear and current, each divided by its largest magnitude."""
    signals = results.signals
    time, travel = signals["time"], signals["slider_x"] - signals["slider_x"][0]
    panels = []
    for name, title in (("top", "Top electrode"), ("difference", "Difference (top − bottom)/2")):
        panels.append((title, Axis("divided by its peak", "1", -1.12, 1.12),
                       [Curve(time, scaled(travel), "slider x", PALE, width=1.5), Curve(time, scaled(signals["mean_shear"]), "mean shear γ", ORANGE),
                        sampled(results, name, f"{name} current, sampled", True)], 1.1))
    return with_events(results, panels)


@needs()
def charge(results):
    """Figure 20: charge that each phase moves, and the charge that the shear predicts."""
    signals, spans = results.signals, results.phases()
    factor = derived.charge_per_shear(results)
    fixed = results.case.get("coupling", {}).get("law", "fixed-charge") == "fixed-charge"
    time = numpy.array([spans[0].start, *(span.end for span in spans)])

    def gained(column):
        values = [signals.at(column, span.end) - signals.at(column, span.start) for span in spans]
        return numpy.array([values[0], *values])

    top, bottom, shear = gained("charge_top"), gained("charge_bottom"), gained("mean_shear")
    curves = [Curve(time, top, "top", BLUE, "over"), Curve(time, bottom, "bottom", ORANGE, "over"), Curve(time, top + bottom, "sum", PURPLE, "over")]
    if factor is not None and fixed:
        curves.append(Curve(time, factor * shear, "sum by F c₀ k ∫γ dV", INK, "over", 1.2, "dotted"))
    audit = results.metrics.get("charge_identity_error")
    title = f"Electrodes; charge identity to {audit.value:.0e}" if audit and audit.value is not None else "Electrodes"
    chart = over_time(results, [(title, Axis("charge gained", "C"), curves, 1.1),
                                ("Difference (top − bottom)/2", Axis("charge gained", "C"), [Curve(time, (top - bottom) / 2, "", GREEN, "over")], 0.9)])
    (first,), *rest = chart.rows
    few = spans if len(spans) <= MOST_NAMED else []
    names = tuple(Note((span.start + span.end) / 2, 1.0, span.phase, "middle", QUIET) for span in few)
    return chart._replace(rows=[[first._replace(phases=names)], *rest])
