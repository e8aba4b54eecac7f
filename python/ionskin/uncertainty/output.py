# SPDX-License-Identifier: Apache-2.0
"""Files and report page of an uncertainty study."""

import csv
import io

import numpy
from markupsafe import Markup

from .. import output_folder
from ..drawing import style
from ..page import pages
from ..page.inline_svg import inline_svg, white_background
from ..words import quantity, si_scale
from .bands import LEVELS, bands

PNG_DPI = 180


def _table(rows) -> str:
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    return text.getvalue()


def units(study) -> dict:
    """SI units of the metrics of a study, as a dict by name."""
    return study.outcomes[study.finished()[0]].units


def samples_table(study) -> str:
    """Table with one row for each sample, as CSV text: values, status, reason, metrics."""
    known = units(study)
    names = list(study.outcomes[study.finished()[0]].metrics)
    rows = [["sample", *(f"{one.key} [{one.unit}]" for one in study.parameters), "status", "reason",
             *(f"{name} [{known.get(name, '1')}]" for name in names)]]
    for trial in study.trials:
        outcome = study.outcomes.get(trial.number)
        status = "missing" if outcome is None else "failed" if outcome.reason else "finished"
        metrics = outcome.metrics if outcome else {}
        rows.append([trial.number, *(repr(value) for value in trial.values.values()), status, outcome.reason if outcome else "",
                     *(repr(metrics[name]) if name in metrics else "" for name in names)])
    return _table(rows)


def indices_table(analyses) -> str:
    """Table with one row for each metric and key, as CSV text: indices of Sobol' and their intervals."""
    rows = [["metric", "key", "first", "first_lower_95", "first_upper_95", "total", "total_lower_95", "total_upper_95"]]
    for name, one in analyses.items():
        rows += [[name, key, *map(repr, one.first[key]), *map(repr, one.total[key])] for key in one.first]
    return _table(rows)


def bands_table(found) -> str:
    """Table with one row for each instant and signal, as CSV text: quantiles."""
    rows = [["signal", "time [s]", *(f"quantile_{level:g}" for level in LEVELS)]]
    for name, (time, curves) in found.items():
        rows += [[name, repr(float(t)), *(repr(float(v)) for v in column)] for t, column in zip(time, curves.T)]
    return _table(rows)


def summary(study, analyses) -> dict:
    """Contents of uncertainty.json, as a dict: keys, samples, statistics and indices by metric."""
    known = units(study)
    return {
        "keys": {one.key: {"distribution": one.written, "unit": one.unit} for one in study.parameters},
        "samples": len(study.trials), "finished": len(study.finished()),
        "failed": sum(bool(outcome.reason) for outcome in study.outcomes.values()), "least_q2": study.least_q2,
        "metrics": {name: {
            "unit": known.get(name, "1"), "mean": one.mean, "standard_deviation": one.deviation,
            "quantiles": {f"{level:g}": value for level, value in one.quantiles.items()},
            "surrogate": {"q2": one.q2, "leave_one_out_error": one.leave_one_out, "degree": one.degree, "terms": one.terms},
            "sobol_indices": {key: {order: dict(zip(("value", "lower_95", "upper_95"), getattr(one, order)[key]))
                                    for order in ("first", "total")} for key in one.first} or None,
            "refused": one.refusal or None, "samples_needed": one.samples_needed or None}
            for name, one in analyses.items()}}


def indices_figure(study, analyses, width):
    """Bars of both indices with their intervals, one panel for each metric; None where every surrogate was refused."""
    valid = {name: one for name, one in analyses.items() if one.first}
    if not valid:
        return None
    drawing, axes = style.stacked(len(valid), share_x=False, width=width)
    places = numpy.arange(len(study.keys))
    for panel, (name, one) in zip(axes, valid.items()):
        for shift, (label, index, colour) in zip((-0.2, 0.2), (("first", one.first, style.BLUE), ("total", one.total, style.ORANGE))):
            middle, lower, upper = numpy.array([index[key] for key in study.keys]).T
            panel.bar(places + shift, middle, 0.36, color=colour, label=label)
            panel.vlines(places + shift, lower, upper, color=style.INK, linewidth=0.9)
        panel.set_xticks(places, [key.split(".", 1)[-1] for key in study.keys])
        panel.set_ylabel("Sobol' index")
        style.title(panel, name.replace("_", " "))
    style.legend(axes[0])
    return drawing


def bands_figure(found, known, width):
    """Median and bands of the signals over time; None without signals."""
    if not found:
        return None
    drawing, axes = style.stacked(len(found), share_x=False, width=width)
    for panel, (name, (time, curves)) in zip(axes, found.items()):
        divisor, prefix = si_scale(numpy.abs(curves).max())
        unit = known.get(name, "1")
        shown = curves / divisor if unit != "1" else curves
        panel.fill_between(time, shown[0], shown[4], color=style.BLUE, alpha=0.18, lw=0, label="5 to 95 %")
        panel.fill_between(time, shown[1], shown[3], color=style.BLUE, alpha=0.35, lw=0, label="25 to 75 %")
        panel.plot(time, shown[2], color=style.BLUE, label="median")
        word = name.split("/")[1].replace("_", " ")
        panel.set_ylabel(word if unit == "1" else f"{word} [{prefix}{unit}]")
    style.legend(axes[0])
    axes[-1].set_xlabel("time [s]")
    return drawing


def svg_of(drawing):
    """SVG text of a matplotlib figure."""
    text = io.StringIO()
    drawing.savefig(text, format="svg", metadata={"Date": None}, transparent=True)
    return text.getvalue()


def picture(folder, name, heading, caption, draw):
    """Saves a figure as PNG and SVG and returns its section of the page, which has a narrow drawing for telephones, too.

    draw  function of a width [inch] that returns the matplotlib figure
    """
    drawing = draw(style.WIDTH)
    output_folder.save(drawing, folder / "figures" / f"{name}.png", dpi=PNG_DPI)
    text = svg_of(drawing)
    output_folder.write_text(folder / "figures" / f"{name}.svg", white_background(text))
    image = Markup('<div class="desktop">{}</div><div class="telephone">{}</div>').format(
        Markup(inline_svg(text, name)), Markup(inline_svg(svg_of(draw(style.TELEPHONE_WIDTH)), f"{name}-narrow")))
    return pages.Section(name, heading, "figure", pages.Picture(name, heading, caption, image))


def write(study, analyses, kept) -> None:
    """Writes all result files, figures and the page of a finished study into its folder; `kept` is its StudyFolder."""
    found = bands([study.outcomes[number] for number in study.finished()])
    kept.write("uncertainty.json", summary(study, analyses))
    kept.write("samples.csv", samples_table(study))
    kept.write("sobol_indices.csv", indices_table(analyses))
    kept.write("bands.csv", bands_table(found))
    known = units(study)
    sections = [pages.Section("warnings", "Warnings", "warnings", {"texts": warnings(study, analyses)})]
    for name, heading, caption, draw in (
            ("sobol_indices", "Sobol' indices", "Share of the variance by a key alone (first) and with all its interplay "
             "(total), with 95 % intervals of the bootstrap.", lambda width: indices_figure(study, analyses, width)),
            ("bands", "Signals", "Quantiles of the samples at each instant.", lambda width: bands_figure(found, known, width))):
        if draw(style.WIDTH) is not None:
            sections.append(picture(kept.folder, name, heading, caption, draw))
    metrics = [(name, *(quantity(value, known.get(name, "1")) for value in (
        one.mean, one.deviation, one.quantiles[0.05], one.quantiles[0.5], one.quantiles[0.95])),
        "–" if one.q2 is None else f"{one.q2:.4f}") for name, one in analyses.items()]
    rows = [(name, key, *(f"{index[key][0]:.3f} ({index[key][1]:.3f} to {index[key][2]:.3f})" for index in (one.first, one.total)))
            for name, one in analyses.items() for key in one.first]
    sections += [
        pages.Section("metrics", "Metrics", "table", pages.Table(
            ("metric", "mean", "standard deviation", "5 %", "median", "95 %", "Q2"), metrics, tuple(range(1, 7)))),
        pages.Section("indices", "Indices with intervals", "table", pages.Table(("metric", "key", "first", "total"), rows, (2, 3))),
        pages.Section("keys", "What varied", "table", pages.Table(("key", "distribution"),
                                                                 [(one.key, one.written) for one in study.parameters]))]
    pages.write_page(kept.folder / "report.html", pages.page(
        "Uncertainty", f"{len(study.finished())} of {len(study.trials)} samples finished", sections))


def warnings(study, analyses) -> list[str]:
    """Warnings of a study that a reader should know: refused surrogates, failed samples and others."""
    failed = [outcome.reason for outcome in study.outcomes.values() if outcome.reason]
    texts = [f"{name}: {one.refusal}" for name, one in analyses.items() if one.refusal]
    if failed:
        texts.append(f"{len(failed)} of {len(study.trials)} samples failed and are left out, so the results hold for the others "
                     f"alone; the first: {failed[0]}")
    return texts
