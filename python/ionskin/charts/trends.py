# SPDX-License-Identifier: Apache-2.0
"""Figures 7, 8, 16, 17 and 23: numbers of the runs of a sweep against its key."""

import numpy

from ..analysis import slip
from ..article import regimes
from ..page.quantities import words
from ..words import quantity
from .chart import Axis, Cell, Chart, Curve, Map, Mark, Span, quiet_note
from .colours import BAND_STRONG, BLUE, GREEN, INK, ORANGE, PALE, PURPLE
from .family import NEEDS_SEVERAL, NO_CURRENT, key_axis, looks, spread, value_edges
from .fields import NO_CONTACT, STUCK, cell_areas, fields_of
from .spans import peak_of, slide_start

CURRENTS = (("top", BLUE), ("bottom", ORANGE), ("difference", GREEN), ("common", PURPLE))
NO_ONSET = "nothing sticks when the slide begins, or nothing slides"
FULL_SLIP_SHOWN = 1.25  # times the longest time to full slip


def along(study, named=True):
    """Horizontal axis along the members of a Study; `named`: with the name of its key."""
    values = [member.value for member in study.members]
    room = 0.04 * (max(values) - min(values)) or 0.1 * abs(values[0]) or 1.0
    return Axis(study.name if named else "", study.unit, min(values) - room, max(values) + room)


def trend(study, values, label="", colour=BLUE, look="", errors=None):
    """Curve of values over the members of a Study, only marks where other keys vary, too;
    `errors` are those of the values, in their unit."""
    values = numpy.asarray(values, float)
    band = None if errors is None or not numpy.any(errors) else (values - errors, values + errors)
    return Curve(numpy.array([member.value for member in study.members], float), values, label, colour,
                 look="none" if study.scattered or study.single else look, marks=True, band=band)


def metric(study, name, label="", colour=BLUE, look=""):
    """Curve of a metric over the members of a Study, with its error estimates."""
    values = numpy.array(study.metric(name), float)
    return trend(study, values, label, colour, look, numpy.nan_to_num(numpy.array(study.errors(name)) * numpy.abs(values)))


def reading(study, name):
    """Chart of a metric, with its stated errors, against the swept key; of a grid with a curve for each slice."""
    looks_of_slices = spread(study.slices, lambda each: each.at) if len(study.slices) > 1 else [(study, GREEN, "")]
    curves = tuple(metric(each, name, label, colour) for each, colour, label in looks_of_slices)
    unit = study.typical.results.metrics[name].unit
    top = float(numpy.nanmax(numpy.concatenate([curve.band[1] if curve.band else curve.y for curve in curves])))
    low = float(numpy.nanmin(numpy.concatenate([curve.y for curve in curves])))
    return Chart([[Cell(words(name), along(study.whole), Axis("value", unit, min(0.0, low), 1.08 * top or 1.0), curves, height=1.2)]])


def shear_cell(study, name, axis, title):
    """Cell with a metric of the shear and the power laws that fit it, and the text on these laws."""
    curve = metric(study, name)
    if not numpy.isfinite(curve.y).any():
        return Cell(title, along(study), Axis(axis, "1", 0.0, 1.0), notes=(quiet_note("the runs have no shear"),), height=1.3), ""
    curves, marks, note = [curve], (), ""
    fit = None if study.scattered else regimes.fit(curve.x, curve.y)
    if fit is not None:
        x = numpy.geomspace(fit.values[0], fit.values[-1], 60)
        curves.append(Curve(x, fit(x), "power law" + "s" * fit.two, INK, look="dotted", width=0.9))
        note = f"One power law: exponent {fit.low:.2f} ± {fit.low_error:.2f}."
        if fit.two:
            marks = (Mark(fit.break_at, "dashed"),)
            at = quantity(fit.break_at, study.unit, 2)
            note = (f"Two power laws: exponent {fit.low:.2f} ± {fit.low_error:.2f} below {at}, {fit.high:.2f} ± "
                    f"{fit.high_error:.2f} above.")
    upper = numpy.nanmax(curve.band[1] if curve.band else curve.y)
    return Cell(title, along(study), Axis(axis, "1", 0.0, 1.08 * float(upper) or 1.0), tuple(curves), marks=marks, height=1.3), note


def current_cell(study, title, families):
    """Metrics of the currents on a logarithmic axis. families: pairs of name with a {} for the electrode, and look"""
    curves = [metric(study, name.format(current), f"{current}{kind}", colour, look) for name, kind, look in families
              for current, colour in CURRENTS if numpy.isfinite(study.metric(name.format(current))).any()]
    curves = [curve for curve in curves if numpy.nanmax(curve.y) > 0]
    if not curves:
        return Cell(title, along(study), Axis("current", "A", 0.0, 1.0), notes=(quiet_note(NO_CURRENT),), height=1.3)
    return Cell(title, along(study), Axis("current", "A", log=True), tuple(curves), height=1.3)


def peaks(study):
    """Figure 7: peak shear and peak currents against the swept key."""
    first, note = shear_cell(study, "peak_mean_shear", "peak mean shear γ", "Peak shear")
    second = current_cell(study, "Peak current", (("peak_current_{}", ", resolved", ""), ("peak_sampled_current_{}", ", sampled", "dashed")))
    return Chart([[first, second]], (1.0, 1.0), note=note)


def means(study):
    """Figure 8: mean shear and rms currents against the swept key."""
    first, note = shear_cell(study, "time_mean_shear", "time mean of γ", "Time mean of the mean shear")
    return Chart([[first, current_cell(study, "Rms current, resolved", (("rms_current_{}", "", ""),))]], (1.0, 1.0), note=note)


def correlation(study):
    """Figure 16: peak current against peak shear."""
    if study.single:
        return NEEDS_SEVERAL
    if not numpy.isfinite(study.metric("peak_current_top")).any():
        return NO_CURRENT
    shears = numpy.array(study.metric("peak_mean_shear"), float)
    cells = []
    for name, title in (("peak_current_top", "Top, resolved"), ("peak_sampled_current_top", "Top, sampled"),
                        ("peak_sampled_current_difference", "Difference, sampled")):
        values = numpy.array(study.metric(name), float)
        with numpy.errstate(invalid="ignore", divide="ignore"):
            r = numpy.corrcoef(shears, values)[0, 1]
        curves = [] if study.scattered else [Curve(shears, values, "", PALE)]
        order = {id(member): place for place, member in enumerate(study.members)}
        for member, colour, label in looks(study):
            place = order[id(member)]
            curves.append(Curve(shears[[place]], values[[place]], label if not cells and place in (0, len(study.members) - 1) else "", colour,
                                look="none", marks=True, width=1.8))
        cells.append(Cell(f"{title}: r = {r:.3f}", Axis("peak mean shear γ", "1", 0.0, 1.08 * peak_of(shears) or 1.0),
                          Axis("peak current", "A", 0.0, 1.15 * peak_of(values) or 1.0), tuple(curves), height=1.2))
    return Chart([cells], (1.0, 1.0, 1.0))


def stick_history(file):
    """Time since the begin of the first slide [s], and stuck share of the contact area,
    at the onset states of an open results.h5."""
    states = [file["contact"][name] for name in sorted(file["contact"]) if name.startswith("onset_")]
    areas = cell_areas(file)
    times = numpy.array([float(state.attrs["parameter"]) for state in states]) - file["path/onset_begin"][0]
    speeds = [state["slip"][...] / step for state, step in zip(states, numpy.diff(times, prepend=0.0))]
    sliding = max(speed.max() for speed in speeds)
    parts = []
    for state, speed in zip(states, speeds):
        touching = state["pressure"][...] > 0
        parts.append((areas * (touching & (speed < STUCK * sliding))).sum() / max((areas * touching).sum(), 1e-300))
    # Before the first state of the onset everything sticks.
    return numpy.concatenate([[0.0], times]), numpy.concatenate([[1.0], parts])


def stick_slip(study):
    """Figure 17: stuck part of the contact over the time since the slide began, and the swept key."""
    results = study.typical.results
    if fields_of(results) is None or slide_start(results) is None:
        return NO_CONTACT
    histories = {}
    for member in study.members:
        with fields_of(member.results) as file:
            if "contact" in file and any(name.startswith("onset_") for name in file["contact"]):
                histories[id(member)] = stick_history(file)
    if not histories:
        return "no run has an onset of sliding"
    slips = {each: own[numpy.argmax(stuck <= 0)] if (stuck <= 0).any() else own[-1] for each, (own, stuck) in histories.items()}
    end = float(FULL_SLIP_SHOWN * max(slips.values()))
    curves = [Curve(*histories[id(member)], label, colour) for member, colour, label in looks(study) if id(member) in histories]
    time = Axis("time since the slide began", "s", 0.0, end)
    cells = [Cell("Onset of sliding", time, Axis("stuck part of the contact area", "1", -0.02, 1.05), tuple(curves), height=1.3)]
    shown = [member for member in study.members if id(member) in histories]
    if len(shown) == 1 or study.scattered:
        return Chart([cells])
    edges, values = numpy.linspace(0, end, 301), value_edges([member.value for member in shown])
    rows = numpy.array([numpy.interp((edges[1:] + edges[:-1]) / 2, *histories[id(member)], right=0) for member in shown])
    line = numpy.array([(slips[id(member)], member.value) for member in shown])
    cells.append(Cell("Sticking; line: full slip", time, key_axis(study, values),
                      map=Map(edges, values, rows, name="stuck part", lines=(line,)), height=1.3))
    return Chart([cells], (1.0, 1.0))


def friction_window(study):
    """Figure 23: lead time and change of the currents before full slip, against the swept key."""
    if study.single:
        return "a single run has no window: sweep contact.friction"
    leads = numpy.array(study.metric("slip_lead_time"), float)
    if not numpy.isfinite(leads).any():
        return NO_ONSET
    precursors = {current: [slip.precursor(member.results, current) for member in study.members] for current in slip.CURRENTS}
    spans = window_spans(study, precursors)
    cells = [lead_cell(study, leads, precursors), departure_cell(study, precursors)]
    return Chart([[cell._replace(spans=spans) for cell in cells]], (1.0, 1.0),
                 note=f"{window_words(study, precursors).capitalize()}.")


def floored(values, errors):
    """Errors of a logarithmic axis: downwards they end at a fifth of the value."""
    return numpy.minimum(errors, 0.8 * numpy.abs(values))


def lead_cell(study, leads, precursors):
    """Times from the first micro-slip, and from where each current is seen, to full slip."""
    errors = numpy.array([slip.error(member.results, "slip_lead_time") for member in study.members])
    curves = [trend(study, leads, "from micro-slip", BLUE, "", floored(leads, errors))]
    for current, colour in (("difference", GREEN), ("common", PURPLE)):
        own = numpy.array([each.lead for each in precursors[current]])
        if numpy.isfinite(own).any():
            curves.append(trend(study, own, f"from the {current} current", colour, "dashed"))
    interval = precursors["difference"][0].interval
    marks = (Mark(float(interval), "dotted", "y", "readout interval"),) if numpy.isfinite(interval) else ()
    return Cell("Lead before full slip", along(study), Axis("lead", "s", log=True), tuple(curves), marks=marks, height=1.3)


def departure_cell(study, precursors):
    """The departure of each current with its stated error, and the noise floor."""
    curves = []
    for current, colour in (("difference", GREEN), ("common", PURPLE)):
        own = numpy.array([each.departure for each in precursors[current]])
        errors = numpy.nan_to_num(numpy.array([each.error for each in precursors[current]]))
        own = numpy.where(own > 0, own, numpy.nan)
        if numpy.isfinite(own).any():
            curves.append(trend(study, own, current, colour, "", floored(numpy.nan_to_num(own), errors)))
    if not curves:
        return Cell("Departure of a reading", along(study), Axis("departure", "A", 0.0, 1.0), height=1.3,
                    notes=(quiet_note("no reading falls before full slip"),))
    floor = slip.SEEN * numpy.array([each.noise for each in precursors["difference"]])
    if numpy.isfinite(floor).any() and numpy.nanmax(floor) > 0:
        curves.append(trend(study, floor, f"{slip.SEEN} × noise floor", INK, "dotted"))
    return Cell("Departure of a reading", along(study), Axis("departure", "A", log=True), tuple(curves), height=1.3)


def inside(precursors):
    """Booleans, one for each member: True if any current shows the onset of slip before full slip."""
    return [any(each.certain for each in pair) for pair in zip(*precursors.values())]


def window_spans(study, precursors):
    """Bands over the values whose slip is recognised, half way to their neighbours."""
    if study.scattered:
        return ()
    values = numpy.array([member.value for member in study.members], float)
    edges = numpy.concatenate([values[:1], (values[1:] + values[:-1]) / 2, values[-1:]])
    return tuple(Span(float(low), float(high), BAND_STRONG)
                 for low, high, certain in zip(edges, edges[1:], inside(precursors)) if certain)


def window_words(study, precursors):
    """Words for the shaded values: "recognised at 0.1–0.3, 0.5"."""
    runs = []
    for before, member, certain in zip([False, *inside(precursors)], study.members, inside(precursors)):
        if certain:
            value = quantity(member.value, study.unit, 3)
            runs = [*runs[:-1], (runs[-1][0], value)] if before else [*runs, (value, value)]
    texts = [first if first == last else f"{first}–{last}" for first, last in runs]
    return "recognised at " + ", ".join(texts) if texts else "no window"
