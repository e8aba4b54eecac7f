# SPDX-License-Identifier: Apache-2.0
"""Opening sentences of a page: what an instrument between the electrodes reads, with its error."""

import math

import numpy

from ..charts.readout import VOLTAGE, has_own_circuits, has_voltages, is_crossbar, is_open
from ..charts.spans import contact_spans, sampling_interval
from ..words import percent, quantity
from . import report_text

NEAR = 0.03  # of the length of a run: an instant so near an event is given by the time between them
TAXEL = "current_top_"
READING = "reading_"  # of an amplifier at a taxel
WHILE = {"touchdown": ", while the slider lands", "lift": ", while the slider lifts"}


def largest(table, name):
    """Instant [s] and magnitude of the entry of a Table's column with the largest magnitude."""
    values = numpy.nan_to_num(numpy.abs(table[name]))
    row = int(values.argmax())
    return float(table["time"][row]), float(values[row])


def with_error(results, metric, fallback, unit):
    """Text of a metric with its reported error estimate, "478 µA (± 0.9 %)"; of `fallback`
    in `unit` where the run lacks the metric."""
    found = results.metrics.get(metric)
    if found is None or found.value is None:
        return quantity(fallback, unit, 3)
    error = report_text.error(results, metric)
    return report_text.value(results, metric) + (f" ({error})" if error else "")


def below_error(results, metric):
    """True if the reported error estimate of a metric is larger than its value."""
    share = results.summary.get("error_estimate", {}).get(metric)
    return share is not None and share > 1 and metric not in results.not_converging


def nothing_above(peak, unit):
    """Words for a reading that is nowhere larger than its error estimate."""
    return f"nothing above its error, which is larger than the peak of {quantity(peak, unit, 3)}"


def events(results):
    """Instants [s] of the beginnings and ends of contact and of sliding, with their words, in order of time; [] without a contact."""
    spans = contact_spans(results)
    if not spans:
        return []
    found = {(spans[0].start, "contact begins")}
    if spans[-1].end < results.signals["time"][-1]:
        found.add((spans[-1].end, "contact ends"))
    found |= {(span.start, "contact begins") for span in spans if span.phase == "touchdown"}
    found |= {(span.start, "sliding begins") for span in spans if span.phase == "slide"}
    found |= {(span.end, "contact ends") for span in spans if span.phase == "lift"}
    return sorted(found)


def event(results, instant, *, mean=False):
    """Words for an instant [s] and the event by it: " at 0.5 s, as contact begins", " at 0.497 s, 3 ms before sliding begins".

    mean  True if what is read at the instant is a mean over the sampling interval before it

    An event names the instant if it lies at most a sampling interval before it; what a mean shows began before the interval ended.
    """
    words = f" at {instant:.4g} s"
    reach = NEAR * (results.signals["time"][-1] - results.signals["time"][0])
    sample = sampling_interval(results) * (1 + 1e-6)
    slack = 1e-6 * max(sample, reach)
    now = [what for at, what in events(results) if instant - sample <= at <= (instant - slack if mean else instant + slack)]
    if now:
        return f"{words}, as {' and '.join(dict.fromkeys(now))}"
    near = [(abs(at - instant), at, what) for at, what in events(results) if abs(at - instant) < reach]
    if not near:
        return words
    apart, at, what = min(near)
    if apart <= slack:
        return f"{words}, just before {what}"
    phase = next((span.phase for span in contact_spans(results) if span.start < instant <= span.end), None)
    return f"{words}, {quantity(apart, 's', 2)} {'after' if at < instant else 'before'} {what}{WHILE.get(phase, '') if at > instant else ''}"


def of_circuit(results):
    """Sentence on the reading of a run with a load, an open circuit or an amplifier; None for other circuits."""
    table = results.circuit
    if table is None:
        return None
    if table.has("voltage"):
        instant, peak = largest(table, "voltage")
        if below_error(results, "peak_voltage"):
            return f"Between the electrodes a voltmeter reads {nothing_above(peak, 'V')}."
        text = f"Between the electrodes a voltmeter reads up to {with_error(results, 'peak_voltage', peak, 'V')}{event(results, instant)}"
        if table.has("current") and not is_open(results):
            text += f", with up to {quantity(largest(table, 'current')[1], 'A', 3)} through what joins them"
        return f"{text}."
    if table.has("current"):
        instant, peak = largest(table, "current")
        if below_error(results, "peak_amplifier_current"):
            return f"The amplifier between the electrodes reads {nothing_above(peak, 'A')}."
        return f"The amplifier between the electrodes reads up to {with_error(results, 'peak_amplifier_current', peak, 'A')}{event(results, instant)}."
    return None


def of_own_taxel(results):
    """Reading of the instrument at the taxel, or at the crossing or line of a crossbar, with the strongest
    signal; None unless taxels have circuits of their own."""
    if results.sampled_taxels is None or not has_own_circuits(results):
        return None
    prefix, unit, words = (VOLTAGE, "V", "A voltmeter") if has_voltages(results) else ("current_circuit_", "A", "An ammeter")
    if unit == "A" and any(name.startswith(READING) for name in results.sampled_taxels):
        prefix, words = READING, "An amplifier"
    names = [name for name in results.sampled_taxels if name.startswith(prefix)]
    if not names:
        return None
    name = max(names, key=lambda one: largest(results.sampled_taxels, one)[1])
    instant, peak = largest(results.sampled_taxels, name)
    read = with_error(results, "peak_taxel_voltage", peak, unit) if unit == "V" else taxel_current(results, peak)
    return f"{words} {where(results, name.removeprefix(prefix)[:20])} reads up to {read}{event(results, instant, mean=True)}."


def taxel_current(results, peak):
    """Text of an instrument's peak current [A], with the error estimate of the largest
    taxel current where it is this current."""
    known = results.metrics.get("peak_sampled_taxel_current")
    same = known is not None and known.value is not None and math.isclose(known.value, peak, rel_tol=1e-3)
    return with_error(results, "peak_sampled_taxel_current", peak, "A") if same else quantity(peak, "A", 3)


def where(results, name):
    """Words for the position of the instrument of a taxel, or of a crossing or line of a crossbar."""
    if not is_crossbar(results):
        return f"between the taxel {name} and the bottom electrode"
    if name.startswith("r") and "c" in name:
        row, column = name.split("c")
        return f"between the column c{column} and the row {row} of the crossbar"
    return f"between the {'column' if name.startswith('c') else 'row'} {name} of the crossbar and the ground"


def of_current(results):
    """Sentence on the reading of an ammeter between the shorted electrodes; None without currents."""
    sampled = results.sampled
    if not sampled.has("current_difference"):
        return None
    instant, peak = largest(sampled, "current_difference")
    if peak == 0:
        return "An ammeter between the electrodes reads nothing: no current flows from one to the other."
    if below_error(results, "peak_sampled_current_difference"):
        return f"An ammeter between the electrodes reads {nothing_above(peak, 'A')}{mean_over(results)}."
    return (f"An ammeter between the electrodes reads up to {with_error(results, 'peak_sampled_current_difference', peak, 'A')}"
            f"{event(results, instant, mean=True)}{mean_over(results)}.")


def mean_over(results):
    """Words for the interval over which a sampled current is a mean; "" where nothing is sampled."""
    over = sampling_interval(results)
    return f", the mean over {quantity(round(over, 9), 's')}" if over else ""


def of_largest_taxel(results):
    """Sentence on the taxel with the largest sampled current, in a list; [] where taxels have circuits of their own or carry none.
    Of an open electrode no taxel is read."""
    if results.sampled_taxels is None or has_own_circuits(results) or is_open(results):
        return []
    peaks = {name.removeprefix(TAXEL): largest(results.sampled_taxels, name) for name in results.sampled_taxels if name.startswith(TAXEL)}
    peaks.pop("rest", None)  # of the electrode, between the taxels
    if not peaks:
        return []
    name = max(peaks, key=lambda one: peaks[one][1])
    instant, peak = peaks[name]
    if not peak:
        return []
    return [f"Of {len(peaks)} taxels {name[:20]} reads most: up to {taxel_current(results, peak)}{event(results, instant, mean=True)}"
            f"{mean_over(results)}."]


def of_mechanics(results):
    """Sentence on force and shear, for a run without ions."""
    parts = [f"{words} {with_error(results, name, 0.0, '1')}" for name, words in (
        ("normal_force_slide", "the slider presses with"), ("mean_shear_slide", "the core's mean shear is")) if name in results.metrics]
    text = " and ".join(parts)
    return f"In mid-slide {text}; the ions were not asked for." if text else None


def sampled_readings(results):
    """Largest magnitudes of what each instrument of a run reads, means over the sampling interval."""
    table, names = results.sampled, ["current_difference"]
    if results.sampled_taxels is not None and has_own_circuits(results):
        table, flow = results.sampled_taxels, "current_circuit_"
        names = [name for name in table if name.startswith((VOLTAGE, READING))
                 or name.startswith(flow) and name.replace(flow, READING) not in table]
    elif results.sampled_circuit is not None:
        table = results.sampled_circuit
        names = [name for name in ("voltage", "current") if table.has(name)]
    return [largest(table, name)[1] for name in names]


def of_noise(results, before):
    """Sentences on the noise of one reading, its parts, and the ratio of the peak to it; [] for runs of older versions.

    before  sentences before it, which may name this peak
    """
    def metric(name):
        found = results.metrics.get(name)
        return None if found is None else found.value

    ratio = metric("signal_to_noise")
    if not ratio:
        return []
    unit = results.metrics["sample_noise"].unit
    parts = ", ".join(f"{quantity(value, unit, 2)} by {words}" for words, value in (
        ("the skin's thermal noise", metric("sample_noise_thermal")), ("the amplifier", metric("sample_noise_amplifier")),
        ("the converter's steps", metric("sample_noise_quantisation"))) if value)
    peak = quantity(ratio * metric("sample_noise"), unit, 3)
    # An amplifier's reading counts without the noise that the amplifier draws.
    quiet = "" if peak in {quantity(value, unit, 3) for value in sampled_readings(results)} else " without noise"
    peak = "that peak" if any(f" {peak}" in sentence for sentence in before) else f"the largest sampled reading, {peak}{quiet}"
    verdict = (f"{float(f'{ratio:.2g}'):,g} times smaller than {peak}" if ratio >= 3 else
               f"no smaller than a third of {peak}: one reading does not show it" if ratio >= 1 else f"larger than {peak}: it cannot be read")
    return [f"The noise of one reading is {quantity(metric('sample_noise'), unit, 2)} rms ({parts}), {verdict}."]


def readings(results):
    """Sentences on what an instrument reads, those on a taxel first; a sentence on the lack of readings where there are none."""
    whole = of_own_taxel(results) or of_circuit(results) or of_current(results) or of_mechanics(results)
    return of_largest_taxel(results) + ([whole] if whole else []) or ["This run has no currents to read."]


def sentences(results):
    """Opening sentences of a run's page: the first ones say what an instrument reads, further ones on what this depends."""
    first = readings(results)
    found = [*first, *of_noise(results, first)]
    if "peak_open_circuit_voltage" in results.metrics and "V" not in first[-1]:
        found.append(f"Left open, the cell would give up to {with_error(results, 'peak_open_circuit_voltage', 0.0, 'V')} at once.")
    coefficient = results.case.get("coupling", {}).get("coefficient")
    if coefficient and results.signals.has("current_difference") and report_text.law(results) != "poroelastic":
        found.append(f"The reading is in proportion to the coupling coefficient k = {coefficient:g}, an assumption that no measurement supports yet.")
    return found + taxels(results)


def taxels(results):
    """Sentences on the taxel that moves most charge, and on the crosstalk between taxels."""
    if results.taxels is None:
        return []
    crosstalk = results.metrics.get("taxel_crosstalk")
    told_crosstalk = [] if crosstalk is None or crosstalk.value is None else [
        f"Of what one taxel reads another one shows up to {with_error(results, 'taxel_crosstalk', 0.0, '1')} through the core (crosstalk)."]
    return most_charge(results) + told_crosstalk


def most_charge(results):
    """Sentence on the taxel that moves most charge, in a list; [] where none moves any."""
    moved = {name.removeprefix("charge_top_"): largest(results.taxels, name)[1] for name in results.taxels if name.startswith("charge_top_")}
    moved.pop("rest", None)  # of the electrode, between the taxels
    if not moved or not max(moved.values()):
        return []
    name = max(moved, key=moved.get)
    share = moved[name] / sum(moved.values())
    return [f"Of {len(moved)} taxels {name[:20]} moves most charge: {quantity(moved[name], 'C', 3)}, {percent(share)} of their sum."]
