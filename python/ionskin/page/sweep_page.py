# SPDX-License-Identifier: Apache-2.0
"""report.html of a sweep, and the charts to explore in that of a run: offline, with data and script inside."""

import base64

from ..charts.spans import contact_spans
from ..sweep_results import value_text
from ..words import quantity
from . import pages, report_text
from .chart_data import rounded

TREND_NOTE = "A click on a mark shows its run in the charts above."
CURVES = [("slider_x", "position x", "m"), ("slider_z", "height z", "m"), ("mean_shear", "mean shear γ", "1"),
          ("current_top", "top", "A"), ("current_bottom", "bottom", "A"), ("current_difference", "difference", "A"),
          ("current_common", "common", "A")]
AGAINST = ["peak_mean_shear", "time_mean_shear", "peak_sampled_current_top", "peak_sampled_current_difference",
           "peak_current_top", "rms_current_top", "rms_current_difference", "normal_force_slide"]


def member_data(study, member):
    """What the charts need of one run: signals at the sampled rows, sampled currents, phases."""
    results = member.results
    time = results.sampled["time"]
    series = {}
    for name, _, _ in CURVES:
        if name in results.sampled and results.sampled.has(name):
            series[name] = rounded(results.sampled[name])
        elif results.signals.has(name):
            series[name] = rounded(results.signals.at(name, time))
    return {"label": study.label(member), "short": f"point {member.number}" if study.scattered else study.label(member),
            "time": rounded(time), "series": series,
            "phases": [[span.phase, round(span.start, 6), round(span.end, 6)] for span in contact_spans(results)]}


def axes(study):
    """What the charts of metrics can run along: the study's key first, of a scattered one every swept number."""
    keys = [study.key, *(key for key in study.numeric_keys if key != study.key)] if study.scattered else [study.key]
    return [{"name": study.axis_label(key).split(" [")[0], "axis": study.axis_label(key),
             "unit": study.sweep.keys.get(key, "1") if study.sweep else "1",
             "values": rounded([member.values.get(key, member.value) for member in study.members])} for key in keys]


def data(study):
    """Everything the script draws."""
    metrics = [{"name": name, "unit": study.typical.results.metrics[name].unit, "values": rounded(study.metric(name))}
               for name in AGAINST if name in study.typical.results.metrics]
    return {"keys": axes(study), "scattered": study.scattered,
            "members": [member_data(study, member) for member in study.members],
            "typical": study.members.index(study.typical), "metrics": metrics,
            "curves": [{"name": name, "label": label, "unit": unit} for name, label, unit in CURVES]}


def figures(made):
    """The numbered figures as pictures inside the page, a line for each that is left out. made: pairs of entry and Made"""
    pictures, notes = [], []
    for entry, each in made:
        if each.reason:
            notes.append(f"{entry.heading}: left out, {each.reason}.")
        else:
            address = "data:image/png;base64," + base64.b64encode(each.picture).decode("ascii")
            pictures.append(pages.Picture(entry.name, entry.heading, entry.caption, address))
    return {"pictures": pictures, "notes": notes}


def points(study):
    """The rows of sweep.csv that a reader wants to see."""
    sweep = study.sweep
    shown = [name for name in AGAINST if name in sweep.units]
    head = ("point", *sweep.keys, "status", *(name.replace("_", " ") for name in shown))
    rows = [(point.number, *(value_text(value, sweep.keys[key]) for key, value in point.values.items()), point.status,
             *(quantity(point.metrics.get(name), sweep.units[name]) for name in shown)) for point in sweep.points]
    return pages.Table(head, rows, tuple(range(len(sweep.keys) + 2, len(head))))


def failures(study):
    """The points that failed, with their reasons; None without any."""
    rows = [(point.folder.name, point.reason) for point in study.sweep.points if point.status == "failed"]
    return pages.Table(("point", "reason"), rows) if rows else None


def explore(study):
    """Charts to hover over and to zoom into; None where nothing was sampled."""
    if "time" not in study.typical.results.sampled:
        return None
    return {"several": not study.single, "notes": [study.note] if study.note else []}


def script(study):
    """The script of the charts to explore and its data; empty where there are none."""
    return {"DATA": ("sweep_page.js", data(study))} if "time" in study.typical.results.sampled else {}


def page(study, verdicts, made):
    """The whole page."""
    results = study.typical.results
    title = results.case.get("title") or study.folder.resolve().name
    finished = sum(point.status == "finished" for point in study.sweep.points)
    against = "Against the swept keys" if study.scattered else f"Against the {study.name}"
    sections = [
        pages.Section("failures", "Points that failed", "table", failures(study)),
        pages.Section("explore", "Explore", "explore", explore(study)),
        pages.Section("against", against, "trend", {"notes": [TREND_NOTE]}),
        verdicts,
        pages.Section("figures", "Figures", "gallery", figures(made)),
        pages.Section("points", "Points", "table", points(study)),
        pages.Section("limits", "Limits of the model", "list", report_text.limits(results)),
        pages.Section("origin", "Origin", "table", pages.Table(("", ""), report_text.origin_rows(study.sweep))),
    ]
    subtitle = f"{finished} of {len(study.sweep.points)} points finished · {solving_time(study)}"
    return pages.page(f"{title}: sweep", subtitle, sections, script=pages.chart_script(script(study)))


def solving_time(study):
    """How long the sweep took, by what and when."""
    manifest = study.sweep.manifest
    stages = manifest.get("stages", {})
    parts = [f"{name} {stages[name]['wall_time_s']:.3g} s" for name in ("mechanics", "points") if name in stages]
    program = manifest.get("program", {})
    parts.append(f"ionskin {program.get('version', '')}".strip())
    if manifest.get("started"):
        parts.append(manifest["started"].replace("T", " ").replace("Z", " UTC"))
    return " · ".join(parts)


def make(study, verdicts, made):
    """Writes report.html of a sweep and returns its path; `verdicts` is a section, `made` pairs of entry and Made."""
    return pages.write_page(study.folder / "report.html", page(study, verdicts, made))
