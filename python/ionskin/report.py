# SPDX-License-Identifier: Apache-2.0
"""Makes report.html and figures/ of a run: /usr/bin/python3 -m ionskin.report FOLDER"""

import argparse
import html
import io
import pathlib
import re
import sys

from . import figures, report_text, style
from .results import Results

STYLE_SHEET = pathlib.Path(__file__).with_name("report.css")
PNG_DPI = 180
FAST_PNG = {"compress_level": 2}


def inline_svg(svg, name):
    """The SVG element of a figure, fit to stand in a page: scalable, themed, with ids of its own."""
    body = svg[svg.index("<svg"):]
    body = re.sub(r"<metadata>.*?</metadata>", "", body, flags=re.S)
    body = re.sub(r'(<svg[^>]*?) width="[^"]*"', r"\1", body, count=1)
    body = re.sub(r'(<svg[^>]*?) height="[^"]*"', r"\1", body, count=1)
    body = re.sub(r'id="([^"]+)"', rf'id="{name}-\1"', body)
    body = re.sub(r'(url\(#|xlink:href="#)', rf"\1{name}-", body)
    for colour, variable in style.THEMED_COLOURS.items():
        body = body.replace(colour, f"var(--{variable})")
    return body


def save_figures(results):
    """Writes figures/NAME.png and .svg; yields (Entry, inline SVG)."""
    folder = results.folder / "figures"
    folder.mkdir(exist_ok=True)
    for entry, figure in figures.draw_all(results):
        figure.savefig(folder / f"{entry.name}.png", dpi=PNG_DPI, pil_kwargs=FAST_PNG)
        page = io.StringIO()
        figure.savefig(page, format="svg", metadata={"Date": None}, transparent=True)
        svg = page.getvalue()
        yield entry, inline_svg(svg, entry.name)
        # A file of its own is seen on any background.
        (folder / f"{entry.name}.svg").write_text(white_background(svg), encoding="utf-8")


def white_background(svg):
    """The same SVG on white."""
    start = svg.index(">", svg.index("<svg")) + 1
    return f'{svg[:start]}\n <rect width="100%" height="100%" fill="white"/>{svg[start:]}'


def escaped(value):
    """Text for HTML."""
    return html.escape(str(value), quote=True)


def section(identifier, heading, body):
    """One section of the page; nothing when it has no body."""
    return f'<section id="{identifier}"><h2>{escaped(heading)}</h2>{body}</section>' if body else ""


def table(head, rows, number_columns=()):
    """An HTML table of texts; columns of numbers are aligned to the right."""
    if not rows:
        return ""

    def cell(tag, column, text):
        kind = ' class="number"' if column in number_columns else ""
        return f"<{tag}{kind}>{escaped(text)}</{tag}>"

    top = "".join(cell("th", column, text) for column, text in enumerate(head))
    body = "".join("<tr>" + "".join(cell("td", column, text) for column, text in enumerate(row)) + "</tr>"
                   for row in rows)
    return f'<div class="scroll"><table><thead><tr>{top}</tr></thead><tbody>{body}</tbody></table></div>'


def headline(results):
    """The few numbers that a reader wants first."""
    cards = [f'<div class="card"><b>{escaped(value)}</b><span>{escaped(label)}</span></div>'
             for label, value in report_text.headline(results)]
    return f'<div class="cards">{"".join(cards)}</div>' if cards else ""


def warnings(results):
    """The warnings of the run."""
    items = "".join(f"<li>{escaped(text)}</li>" for text in results.summary.get("warnings", []))
    return f'<ul class="warnings">{items}</ul>' if items else "<p>None.</p>"


def case_summary(results):
    """What was simulated."""
    groups = "".join(
        f"<div><h3>{escaped(heading)}</h3><dl>"
        + "".join(f"<dt>{escaped(key)}</dt><dd>{escaped(value)}</dd>" for key, value in entries)
        + "</dl></div>"
        for heading, entries in report_text.case_groups(results.case))
    layers = table(("layer, top first", "role", "material", "thickness"), report_text.layers(results.case))
    return f'{layers}<div class="groups">{groups}</div>' if groups or layers else ""


def numbers(results):
    """Every metric; the column of errors stands only where some are estimated."""
    head, rows = ("quantity", "value", "unit", "estimated error"), report_text.metric_rows(results)
    used = 4 if any(row[3] for row in rows) else 3
    return table(head[:used], [row[:used] for row in rows], (1, 3))


def figure_sections(drawn):
    """Every figure with its caption."""
    return "".join(
        section(entry.name, entry.heading,
                f'<figure role="img" aria-label="{escaped(entry.heading)}">{svg}'
                f"<figcaption>{escaped(entry.caption)}</figcaption></figure>")
        for entry, svg in drawn)


def contents(sections):
    """Links to the sections that the page has."""
    found = re.findall(r'<section id="([^"]+)"><h2>(.*?)</h2>', sections)
    return "<nav>" + "".join(f'<a href="#{identifier}">{heading}</a>' for identifier, heading in found) + "</nav>"


def page(results, drawn):
    """The whole page."""
    title = results.case.get("title", results.folder.resolve().name)
    sections = "".join([
        section("warnings", "Warnings", warnings(results)),
        section("case", "What was simulated", case_summary(results)),
        figure_sections(drawn),
        section("numbers", "Numbers", numbers(results)
                + f"<p class='note'>{escaped(report_text.NUMBERS_NOTE)}</p>"),
        section("timing", "Timing", table(("stage", "state", "wall time", "peak memory"),
                                          report_text.timing_rows(results), (2, 3))
                + table(("counter", "value"), report_text.counter_rows(results), (1,))),
        section("limits", "Limits of the model",
                "<ul>" + "".join(f"<li>{escaped(text)}</li>" for text in report_text.limits(results)) + "</ul>"),
        section("origin", "Origin", table(("", ""), report_text.origin_rows(results))),
    ])
    return (f'<!doctype html><html lang="en"><head><meta charset="utf-8">'
            f'<meta name="viewport" content="width=device-width, initial-scale=1">'
            f'<meta name="color-scheme" content="light dark">'
            f"<title>{escaped(title)} – ionskin</title><style>{STYLE_SHEET.read_text(encoding='utf-8')}</style></head>"
            f"<body><main><header><h1>{escaped(title)}</h1><p>{escaped(report_text.subtitle(results))}</p></header>"
            f"{headline(results)}{contents(sections)}{sections}</main></body></html>\n")


def make_report(folder):
    """Writes figures/ and report.html of a run's folder; returns the path of the report."""
    results = Results(folder)
    text = page(results, list(save_figures(results)))
    path = results.folder / "report.html"
    pending = path.with_suffix(".html.tmp")
    pending.write_text(text, encoding="utf-8")
    pending.replace(path)
    return path


def main():
    """Command line."""
    parser = argparse.ArgumentParser(prog="ionskin.report", description=__doc__)
    parser.add_argument("folder", type=pathlib.Path, help="output folder of a run")
    arguments = parser.parse_args()
    try:
        make_report(arguments.folder)
    except OSError as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
