# SPDX-License-Identifier: Apache-2.0
"""Lists the differences of two runs in parameters, metrics and signals, and which differences are within their stated errors.
/usr/bin/python3 -m ionskin.compare A B"""

import argparse
import json
import re
import tomllib

import numpy

from .errors import exit_on
from .page import quantities, report_text
from .reading.sliders import SHARED
from .results import Results
from .words import aligned, percent, quantity, short

LONGEST_TITLE = 24


def flat(value, prefix=""):
    """Flattens a nested case to one dictionary by full key: {"skin.layers[0].name": "..."}."""
    if isinstance(value, dict):
        return {key: entry for name, inner in value.items()
                for key, entry in flat(inner, f"{prefix}.{name}" if prefix else name).items()}
    if isinstance(value, list) and value and isinstance(value[0], dict):
        return {key: entry for i, inner in enumerate(value) for key, entry in flat(inner, f"{prefix}[{i}]").items()}
    return {prefix: value}


def with_all_sliders(results):
    """Case of a run as a nested dict; with several sliders each entry of the list "slider" holds its own motion and contact."""
    if len(results.sliders) == 1:
        return results.case
    entries = [case["slider"] | {name: case.get(name, {}) for name in SHARED} for case in results.sliders]
    return {name: value for name, value in results.case.items() if name not in SHARED} | {"slider": entries}


def parameters(first, second, defaults):
    """Differences of the cases of two Results, as rows (key, first value, second value) of texts.

    defaults  dict of key, with [] for indices, to the value that it has in a case that leaves it out
    """
    one, two = flat(with_all_sliders(first)), flat(with_all_sliders(second))
    rows = []
    for key in dict.fromkeys([*one, *two]):
        default = defaults.get(re.sub(r"\[\d+\]", "[]", key))
        if one.get(key, default) != two.get(key, default):
            rows.append((key, *(given(case, key, default) for case in (one, two))))
    return rows


def given(case, key, default):
    """Text of a key's value in a flattened case; "... (default)" or "not given" where the case leaves it out."""
    if key in case:
        return repr(case[key])
    return "not given" if default is None else f"{default!r} (default)"


def relative(first, second):
    """Relative difference of two numbers, |first - second| / max(|first|, |second|) [1]; 0 for two zeros."""
    scale = max(abs(first), abs(second))
    return abs(first - second) / scale if scale else 0.0


def metrics(first, second, tolerance):
    """Metrics of two Results that differ, as rows (name, first value, second value, unit, relative difference).

    tolerance  relative difference [1] up to which values count as equal. A value is None where a run has none
    """
    rows = []
    for name in dict.fromkeys([*first.metrics, *second.metrics]):
        one, two = first.metrics.get(name), second.metrics.get(name)
        values = [entry.value if entry else None for entry in (one, two)]
        difference = relative(*values) if None not in values else float(values[0] is not values[1])
        if difference > tolerance:
            rows.append((name, *values, (one or two).unit, difference))
    return rows


def verdict(first, second, name):
    """Verdict on the difference of a metric between two Results, by the sum of both reported error estimates.

    "within the stated errors", "beyond the stated errors", "does not converge", or "" where a run has no error estimate.
    """
    if name in first.not_converging or name in second.not_converging:
        return "does not converge"
    errors = [run.stated_error(name) for run in (first, second)]
    if None in errors or name not in first.metrics or name not in second.metrics:
        return ""
    gap = abs(first.metrics[name].value - second.metrics[name].value)
    return "within the stated errors" if gap <= sum(errors) else "beyond the stated errors"


def exceeding(first, second, table, name, time):
    """Share of instants at which a signal of two Results differs by more than the sum of both reported error estimates [1].

    table, name  table and column of the signal
    time         instants of the first run that the second run covers [s]

    None where a run has no error estimate of the signal.
    """
    errors = [run.errors.get(table) for run in (first, second)]
    if any(error is None or name not in error for error in errors):
        return None
    one, two = (getattr(run, table) for run in (first, second))
    gap = numpy.abs(one[name][:len(time)] - two.at(name, time))
    allowed = errors[0][name][:len(time)] + numpy.interp(time, errors[1]["time"], errors[1][name])
    return float(numpy.mean(gap > allowed))


def signals(first, second, tolerance):
    """Signals of two Results that differ, as rows (table, name, largest difference, its ratio to the peak, share).

    The share is that of `exceeding`, None without error estimates. Signals are compared at the instants of the first run that
    both runs cover. `tolerance` is the ratio to the peak [1] up to which signals count as equal.
    """
    rows = []
    for table in ("signals", "sampled"):
        one, two = getattr(first, table), getattr(second, table)
        time = one["time"][one["time"] <= two["time"][-1]]
        for name in one.columns:
            if name in ("time", "cycle", "phase") or name not in two or not (one.has(name) and two.has(name)):
                continue
            gap = numpy.nanmax(numpy.abs(one[name][:len(time)] - two.at(name, time)))
            scale = max(numpy.nanmax(numpy.abs(one[name])), numpy.nanmax(numpy.abs(two[name])))
            if scale and gap > tolerance * scale:
                rows.append((table, name, gap, gap / scale, exceeding(first, second, table, name, time)))
    return rows


def with_error(run, name):
    """Text of a metric with its reported error estimate, such as "491 µA ± 5 %"; "–" where the run has no such metric."""
    if name not in run.metrics:
        return "–"
    return f"{report_text.value(run, name)} {report_text.error(run, name)}".strip()


def metric_lines(first, second, tolerance):
    """Metrics that differ, as rows of texts: words, both values with their errors,
    relative difference, verdict, name in files."""
    return [(quantities.words(name), with_error(first, name), with_error(second, name), "–" if None in (one, two) else percent(gap),
             verdict(first, second, name), name) for name, one, two, _, gap in metrics(first, second, tolerance)]


def signal_lines(first, second, tolerance):
    """Signals that differ, as rows of texts: words, largest difference, its ratio to the peak, verdict, name in files."""
    def remark(share):
        if share is None:
            return ""
        return f"beyond the stated errors at {percent(share)} of the instants" if share else "within the stated errors"

    return [(quantities.column_words(table, name), quantity(gap, getattr(first, table).units[name], report_text.DIGITS), percent(part),
             remark(share), f"{table}/{name}") for table, name, gap, part, share in signals(first, second, tolerance)]


def report(first, second, tolerance, defaults=None):
    """Differences of two runs as lines of text.

    first, second  Results
    tolerance      relative difference [1] up to which values count as equal
    defaults       dict of key to its default, as `parameters` takes it; None for no defaults
    """
    titles = [short(run.folder.name or str(run.folder), LONGEST_TITLE) for run in (first, second)]
    lines = []
    for heading, titled, rows in (
            ("parameters", (), [f"{key}: {one} | {two}" for key, one, two in parameters(first, second, defaults or {})]),
            ("numbers", ("", *titles, "differ by", "", "name in summary.json"), metric_lines(first, second, tolerance)),
            ("signals", ("", "largest difference", "of the peak", "", "table and column"), signal_lines(first, second, tolerance))):
        if rows:
            lines += [heading, *(f"  {row}" for row in (aligned([titled, *rows]) if titled else rows))]
    return lines or [f"no differences above {tolerance:g}"]


def main():
    """Runs the command line of `ionskin compare`."""
    parser = argparse.ArgumentParser(prog="ionskin.compare", description=__doc__)
    parser.add_argument("first", help="output folder of a run")
    parser.add_argument("second", help="output folder of a run")
    parser.add_argument("--tolerance", type=float, default=1e-9, help="relative difference that counts as none")
    parser.add_argument("--defaults", type=json.loads, default={}, help="JSON object: the TOML text of each key's default")
    arguments = parser.parse_args()
    defaults = {key: tomllib.loads(f"value = {text}")["value"] for key, text in arguments.defaults.items()}
    with exit_on(OSError):
        print("\n".join(report(Results(arguments.first), Results(arguments.second), arguments.tolerance, defaults)))


if __name__ == "__main__":
    main()
