# SPDX-License-Identifier: Apache-2.0
"""HTML report of a sweep, and the interactive charts in the report of a run, without a
network: data and script are in the page."""

import re

import numpy

from ..charts import numbered, skin, trends
from ..charts.readout import carries_nothing, is_open
from ..charts.spans import contact_spans
from ..sweep_results import symbol, value_text
from ..words import quantity, without_folders
from . import pages, quantities, report_text
from .chart_data import chart_data, rounded

READABLE = ("peak_voltage", "peak_amplifier_current", "peak_sampled_current_difference", "peak_mean_shear")  # the first that the runs have
NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
TOLD_BY = 40  # letters from its beginning that tell a warning from another
MOST_NAMED = 3  # points of a warning
TREND_NOTE = "A click on a mark shows its run in the charts above."
GRID_NOTE = "Blue: the runs that differ from this run in the key of the axis alone."
CURVES = [("slider_x", "position x", "m"), ("slider_z", "height z", "m"), ("slider_y", "position y", "m"),
          ("mean_shear", "mean shear γ", "1"), ("voltage", "voltage", "V"), ("current_top", "top", "A"), ("current_bottom", "bottom", "A"), ("current_difference", "difference", "A"),
          ("current_common", "common", "A")]
AGAINST = ["peak_mean_shear", "time_mean_shear", "peak_sampled_current_top", "peak_sampled_current_difference",
           "peak_current_top", "rms_current_top", "rms_current_difference", "normal_force_slide"]
COLUMNS = ["peak_sampled_current_difference", "peak_voltage", "peak_mean_shear", "normal_force_slide"]  # of the table of points


def member_data(study, member):
    """Data of one Member for the interactive charts: signals and currents at the readout's instants, phases.

    study  the Study, whose `whole` has the member
    """
    results = member.results
    time = results.sampled["time"]
    rounding = ("current_",) if carries_nothing(results) else ("current_difference",) if is_open(results) else ()  # columns of nothing else
    series = {}
    for name, _, _ in CURVES:
        if name == "slider_y" and not skin.moves_across(results) or name.startswith(rounding):
            continue
        if name == "voltage" and results.sampled_circuit is not None and results.sampled_circuit.has(name):
            series[name] = rounded(results.sampled_circuit.at(name, time))
        elif name in results.sampled and results.sampled.has(name):
            series[name] = rounded(results.sampled[name])
        elif results.signals.has(name):
            series[name] = rounded(results.signals.at(name, time))
    label = without_folders(study.whole.label(member))
    return {"label": label, "short": short_label(study, member), "time": rounded(time), "series": series,
            "phases": [[span.phase, round(span.start, 6), round(span.end, 6)] for span in contact_spans(results)]}


def axes(study):
    """Data of the axes for charts of metrics: the study's key, and where several keys vary every swept key that is a number."""
    return [{"name": study.axis_label(key).split(" [")[0], "axis": study.axis_label(key),
             "unit": study.sweep.keys.get(key, "1") if study.sweep else "1",
             "values": rounded([member.values.get(key, member.value) for member in study.whole.members])} for key in axis_keys(study)]


def axis_keys(study):
    """Keys of the axes for charts of metrics."""
    more = study.numeric_keys if study.whole.scattered else []
    return [study.key, *(key for key in more if key != study.key)]


def choices(study):
    """Data of the rows of buttons that choose a run: one for each key of a grid that varies, else one of all runs.

    name   key in words
    texts  words of the buttons
    of     index in `texts` for each member of the whole study
    axis   index of the key in `axes`; None for a key of texts
    """
    members = study.whole.members
    if study.whole is study:
        return [{"name": "run", "texts": [short_label(study, member) for member in members], "of": list(range(len(members))), "axis": 0}]
    found, numbers = [], axis_keys(study)
    for key, unit in study.sweep.keys.items():
        values = list(dict.fromkeys(member.values[key] for member in members))
        if unit:
            values.sort()
        if len(values) > 1:
            texts = [without_folders(f"{symbol(key)} = {value_text(each, unit)}") for each in values]
            found.append({"name": study.axis_label(key).split(" [")[0], "texts": texts, "of": [values.index(member.values[key]) for member in members],
                          "axis": numbers.index(key) if key in numbers else None})
    return found


def short_label(study, member):
    """Label of a member for a button and the title of a chart."""
    return f"point {member.number}" if study.scattered else without_folders(study.whole.label(member))


def data(study):
    """Data of the script that draws the interactive charts of a Study: of every point of a grid."""
    whole = study.whole
    metrics = [{"name": quantities.words(name), "unit": study.typical.results.metrics[name].unit, "values": rounded(whole.metric(name))}
               for name in AGAINST if name in study.typical.results.metrics]
    return {"keys": axes(study), "choices": choices(study), "scattered": study.scattered,
            "members": [member_data(study, member) for member in whole.members],
            "typical": whole.members.index(study.typical), "metrics": metrics,
            "curves": [{"name": name, "label": label, "unit": unit} for name, label, unit in CURVES]}


def figures(study):
    """Data of the section of a Study's numbered figures, {"at", "pictures", "notes"}, and dict of name to Chart."""
    pictures, reasons, charts = [], {}, {}
    for entry, chart in numbered.charts(study):
        if isinstance(chart, str):
            reasons.setdefault(chart, []).append(str(entry.number))
        else:
            charts[entry.name] = chart
            pictures.append(pages.Picture(entry.name, f"Figure {entry.number}. {entry.heading}", f"{entry.caption} {chart.note}".strip(), None))
    notes = [f"Figure{'s' * (len(names) > 1)} {', '.join(names)}: left out, {reason}." for reason, names in reasons.items()]
    return {"at": "" if study.whole is study else study.note, "pictures": pictures, "notes": notes}, charts


def warnings(study):
    """Warnings of all members of a Study, each once, with the points to which it belongs."""
    found = {}
    for member in study.members:
        for text in map(quantities.in_words, member.results.warnings):
            found.setdefault(NUMBER.sub("#", text)[:TOLD_BY], []).append((member, text))
    texts = []
    for same in found.values():
        if len(same) == len(study.members):
            of = "Every point"
        else:
            between = "; " if study.scattered else ", "  # labels of several keys have commas
            of = between.join(study.label(member) for member, _ in same[:MOST_NAMED]) + (f" and {len(same) - MOST_NAMED} more" if len(same) > MOST_NAMED else "")
        texts.append(f"{of}: {same[-1][1]}" + (f" (of {study.label(same[-1][0])})" if len({text for _, text in same}) > 1 else ""))
    return texts


def points(study):
    """Table of a sweep's points with their most important metrics."""
    sweep = study.sweep
    shown = [name for name in COLUMNS if name in sweep.units]
    head = ("point", *sweep.keys, "status", *map(quantities.words, shown))
    rows = [(point.number, *(value_text(value, sweep.keys[key]) for key, value in point.values.items()), point.status,
             *(quantity(point.metrics.get(name), sweep.units[name], 3) for name in shown)) for point in sweep.points]
    return pages.Table(head, rows, tuple(range(len(sweep.keys) + 2, len(head))))


def failures(study):
    """Table of the points that failed, with their reasons; None when none did."""
    rows = [(point.folder.name, point.reason) for point in study.sweep.points if point.status == "failed"]
    return pages.Table(("point", "reason"), rows) if rows else None


def explore(study):
    """Data of the section with interactive charts; None where nothing was sampled."""
    if "time" not in study.typical.results.sampled:
        return None
    runs = [member.results for member in study.whole.members]
    currents = any("current_difference" in run.sampled and not carries_nothing(run) for run in runs)
    voltages = any(run.sampled_circuit is not None and run.sampled_circuit.has("voltage") for run in runs)
    sampled = [words for drawn, words in ((currents, "Currents are sampled: the charge gained over each readout interval divided by it"),
                                          (voltages, "Voltages are sampled: the mean over each readout interval")) if drawn]
    return {"several": not study.single, "pickers": [choice["name"] for choice in choices(study)],
            "sampled": [f"{words}, shown from the interval's end to that of the next." for words in sampled], "notes": []}


def script(study):
    """Script of the interactive charts with its data, as for `pages.chart_script`; {} without such charts."""
    return {"DATA": ("sweep_page.js", data(study))} if "time" in study.typical.results.sampled else {}


def readable(study):
    """Name of the metric of an instrument's reading that the members have; None without one."""
    return next((name for name in READABLE if numpy.isfinite(study.metric(name)).any() and name in study.typical.results.metrics), None)


def answer(study):
    """Opening sentences of a sweep's page: how the reading between the electrodes follows the key, and where it is largest."""
    whole, name = study.whole, readable(study)
    if name is None:
        return [whole.note] if whole.note else []
    values, unit = numpy.array(whole.metric(name), float), study.typical.results.metrics[name].unit
    order = numpy.argsort(numpy.nan_to_num(values, nan=-numpy.inf))
    most, least = (whole.members[place] for place in (order[-1], order[len(values) - numpy.isfinite(values).sum()]))

    def with_error_at(member):
        error = report_text.error(member.results, name)
        return report_text.value(member.results, name) + (f" ({error})" if error else "") + f" at {whole.label(member)}"

    words = quantities.words(name)
    if quantity(numpy.nanmin(values), unit, 3) == quantity(numpy.nanmax(values), unit, 3):
        first = f"{words}: {quantity(numpy.nanmax(values), unit, 3)} at every point."
    else:
        first = f"{words}: from {with_error_at(least)} to {with_error_at(most)}."
    return [first, *([whole.note] if whole.note else [])]


def page(study, verdicts):
    """The page of a sweep, as HTML."""
    results = study.typical.results
    gallery, charts = figures(study)
    picture = None
    if readable(study) is not None and not study.single:
        charts["reading"] = trends.reading(study, readable(study))
        picture = pages.Picture("reading", "What can be read", "One mark per run. Shaded: the stated error.", None)
    title = results.case.get("title") or study.folder.resolve().name
    finished = sum(point.status == "finished" for point in study.sweep.points)
    against = "Against the swept keys" if study.whole.scattered else f"Against the {study.name}"
    sections = [
        pages.Section("warnings", "Warnings", "warnings", {"texts": warnings(study.whole)}),
        pages.Section("failures", "Points that failed", "table", failures(study)),
        pages.Section("explore", "Explore", "explore", explore(study)),
        pages.Section("against", against, "trend", {"notes": [TREND_NOTE if study.whole is study else f"{TREND_NOTE} {GRID_NOTE}"]}),
        verdicts,
        pages.Section("figures", "Figures", "gallery", gallery),
        pages.Section("points", "Points", "table", points(study)),
        pages.Section("limits", "Limits of the model", "list", report_text.limits(results)),
        pages.Section("origin", "Origin", "table", pages.Table(("", ""), report_text.origin_rows(study.sweep))),
    ]
    subtitle = f"{finished} of {len(study.sweep.points)} points finished · {solving_time(study)}"
    return pages.page(f"{title}: sweep", subtitle, sections, answer=(answer(study), picture),
                      script=pages.chart_script({**script(study), "FIGURES": ("chart_cells.js", chart_data(charts))}))


def solving_time(study):
    """One line on a sweep: times of its stages, version and date."""
    manifest = study.sweep.manifest
    stages = manifest.get("stages", {})
    parts = [f"{name} {stages[name]['wall_time_s']:.3g} s" for name in ("mechanics", "points") if name in stages]
    program = manifest.get("program", {})
    parts.append(f"ionskin {program.get('version', '')}".strip())
    if manifest.get("started"):
        parts.append(manifest["started"].replace("T", " ").replace("Z", " UTC"))
    return " · ".join(parts)


def make(study, verdicts):
    """Writes report.html of a sweep and returns its path; `verdicts` is a section."""
    return pages.write_page(study.folder / "report.html", page(study, verdicts))
