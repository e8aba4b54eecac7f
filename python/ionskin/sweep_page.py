# SPDX-License-Identifier: Apache-2.0
"""report.html of a sweep, and the charts to explore in that of a run: offline, with data and script inside."""

import base64
import io
import json
import pathlib

import numpy

from . import claims, gallery, markup, report_text
from .sweep_results import Study

SCRIPT = pathlib.Path(__file__).with_name("sweep_page.js")
EMBEDDED_DPI = 130
DIGITS = 5
CURVES = [("slider_x", "position x", "m"), ("slider_z", "height z", "m"), ("mean_shear", "mean shear γ", "1"),
          ("current_top", "top", "A"), ("current_bottom", "bottom", "A"), ("current_difference", "difference", "A"),
          ("current_common", "common", "A")]
AGAINST = ["peak_mean_shear", "time_mean_shear", "peak_sampled_current_top", "peak_sampled_current_difference",
           "peak_current_top", "rms_current_top", "rms_current_difference", "normal_force_slide"]


def rounded(values):
    """Numbers short enough for the page; null where there is none."""
    return [float(f"{value:.{DIGITS}g}") if numpy.isfinite(value) else None for value in values]


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
    return {"label": study.label(member), "value": member.value, "time": rounded(time), "series": series,
            "phases": [[span.phase, round(span.start, 6), round(span.end, 6)] for span in results.phases()]}


def data(study):
    """Everything the script draws."""
    metrics = [{"name": name, "unit": study.typical.results.metrics[name].unit, "values": rounded(study.metric(name))}
               for name in AGAINST if name in study.typical.results.metrics]
    return {"axis": study.axis_label(), "members": [member_data(study, member) for member in study.members],
            "typical": study.members.index(study.typical), "metrics": metrics,
            "curves": [{"name": name, "label": label, "unit": unit} for name, label, unit in CURVES]}


def embedded(figure, entry):
    """A figure as a picture inside the page."""
    file = io.BytesIO()
    figure.savefig(file, format="png", dpi=EMBEDDED_DPI)
    picture = base64.b64encode(file.getvalue()).decode("ascii")
    return (f'<figure id="{entry.name}"><h3>{markup.escaped(entry.heading)}</h3>'
            f'<img alt="{markup.escaped(entry.heading)}" src="data:image/png;base64,{picture}">'
            f"<figcaption>{markup.escaped(entry.caption)}</figcaption></figure>")


def figures(study):
    """All numbered figures; a line for each that is left out."""
    parts = []
    for entry, figure in gallery.draw(study):
        parts.append(f"<p class='note'>{markup.escaped(f'{entry.heading}: left out, {figure}.')}</p>"
                     if isinstance(figure, str) else embedded(figure, entry))
    return f'<div class="gallery">{"".join(parts)}</div>'


def points(study):
    """The rows of sweep.csv that a reader wants to see."""
    sweep = study.sweep
    shown = [name for name in AGAINST if name in sweep.units]
    head = ["point", *(f"{key} [{unit}]" if unit else key for key, unit in sweep.keys.items()), "status",
            *(f"{name} [{sweep.units[name]}]" for name in shown)]
    rows = []
    for point in sweep.points:
        values = [f"{value:.6g}" if isinstance(value, float) else value for value in point.values.values()]
        metrics = [f"{point.metrics[name]:.5g}" if name in point.metrics else "–" for name in shown]
        rows.append([point.number, *values, point.status, *metrics])
    return markup.table(head, rows, range(len(sweep.keys) + 2, len(head)))


def failures(study):
    """The points that failed, with their reasons."""
    rows = [(point.folder.name, point.reason) for point in study.sweep.points if point.status == "failed"]
    return markup.table(("point", "reason"), rows)


def explore(study):
    """Charts to hover over and to zoom into; empty where nothing was sampled."""
    if "time" not in study.typical.results.sampled:
        return ""
    note = f'<p class="note">{markup.escaped(study.note)}</p>' if study.note else ""
    keys = "" if study.single else "; arrow keys step through the runs"
    return ('<div class="picker" role="group" aria-label="run"></div><div class="readout" aria-live="polite"></div>'
            '<div id="charts"></div><p class="note">Drag over a chart to enlarge a time span, double-click to see all '
            f"again{keys}. Currents are sampled: the charge gained over each readout interval divided by it.</p>" + note)


def script(study):
    """Data and code of the charts; None where there are none."""
    if "time" not in study.typical.results.sampled:
        return None
    payload = json.dumps(data(study), separators=(",", ":"), ensure_ascii=False).replace("</", "<\\/")
    return f"const DATA={payload};\n{SCRIPT.read_text(encoding='utf-8')}"


def page(study):
    """The whole page."""
    results = study.typical.results
    title = results.case.get("title") or study.folder.resolve().name
    finished = sum(point.status == "finished" for point in study.sweep.points)
    sections = "".join([
        markup.section("failures", "Points that failed", failures(study)),
        markup.section("explore", "Explore", explore(study)),
        markup.section("against", f"Against the {study.name}", '<div class="picker" id="metrics"></div><div id="trend"></div>'),
        markup.section("claims", "The paper's claims", markup.verdict_table(claims.judge(study))),
        markup.section("figures", "Figures", figures(study)),
        markup.section("points", "Points", points(study)),
        markup.section("limits", "Limits of the model", "<ul>" + "".join(
            f"<li>{markup.escaped(text)}</li>" for text in report_text.limits(results)) + "</ul>"),
        markup.section("origin", "Origin", markup.table(("", ""), report_text.origin_rows(study.sweep))),
    ])
    subtitle = f"{finished} of {len(study.sweep.points)} points finished · {solving_time(study)}"
    return markup.frame(f"{title}: sweep", subtitle, markup.contents(sections) + sections, script(study))


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


def make(folder):
    """Writes report.html of a sweep and returns its path."""
    return markup.write_page(pathlib.Path(folder) / "report.html", page(Study(folder)))
