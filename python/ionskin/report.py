# SPDX-License-Identifier: Apache-2.0
"""Makes report.html and figures/ of a run or a sweep: /usr/bin/python3 -m ionskin.report FOLDER"""

import argparse
import io
import pathlib
import re

from . import claims, figures, gallery, markup, report_text, style, sweep_page
from .errors import exit_on
from .results import Results
from .sweep_results import Study

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


def headline(results):
    """The few numbers that a reader wants first."""
    cards = [f'<div class="card"><b>{markup.escaped(value)}</b><span>{markup.escaped(label)}</span></div>'
             for label, value in report_text.headline(results)]
    return f'<div class="cards">{"".join(cards)}</div>' if cards else ""


def warnings(results):
    """The warnings of the run."""
    items = "".join(f"<li>{markup.escaped(text)}</li>" for text in results.summary.get("warnings", []))
    return f'<ul class="warnings">{items}</ul>' if items else "<p>None.</p>"


def case_summary(results):
    """What was simulated."""
    groups = "".join(
        f"<div><h3>{markup.escaped(heading)}</h3><dl>"
        + "".join(f"<dt>{markup.escaped(key)}</dt><dd>{markup.escaped(value)}</dd>" for key, value in entries)
        + "</dl></div>"
        for heading, entries in report_text.case_groups(results.case))
    layers = markup.table(("layer, top first", "role", "material", "thickness"), report_text.layers(results.case))
    return f'{layers}<div class="groups">{groups}</div>' if groups or layers else ""


def numbers(results):
    """Every metric; the column of errors stands only where some are estimated."""
    head, rows = ("quantity", "value", "unit", "estimated error"), report_text.metric_rows(results)
    used = 4 if any(row[3] for row in rows) else 3
    return markup.table(head[:used], [row[:used] for row in rows], (1, 3))


def figure_sections(drawn):
    """Every figure with its caption."""
    return "".join(
        markup.section(entry.name, entry.heading,
                f'<figure role="img" aria-label="{markup.escaped(entry.heading)}">{svg}'
                f"<figcaption>{markup.escaped(entry.caption)}</figcaption></figure>")
        for entry, svg in drawn)


def page(results, drawn):
    """The whole page."""
    title = results.case.get("title", results.folder.resolve().name)
    study = Study(results.folder)
    sections = "".join([
        markup.section("warnings", "Warnings", warnings(results)),
        markup.section("case", "What was simulated", case_summary(results)),
        markup.section("explore", "Explore", sweep_page.explore(study)),
        figure_sections(drawn),
        markup.section("claims", "The paper's claims", markup.verdict_table(claims.judge(study))),
        markup.section("numbers", "Numbers", numbers(results)
                + f"<p class='note'>{markup.escaped(report_text.NUMBERS_NOTE)}</p>"),
        markup.section("timing", "Timing", markup.table(("stage", "state", "wall time", "peak memory"),
                                          report_text.timing_rows(results), (2, 3))
                + markup.table(("counter", "value"), report_text.counter_rows(results), (1,))),
        markup.section("limits", "Limits of the model",
                "<ul>" + "".join(f"<li>{markup.escaped(text)}</li>" for text in report_text.limits(results)) + "</ul>"),
        markup.section("origin", "Origin", markup.table(("", ""), report_text.origin_rows(results))),
    ])
    return markup.frame(title, report_text.subtitle(results), f"{headline(results)}{markup.contents(sections)}{sections}",
                        sweep_page.script(study))


def make_report(folder):
    """Writes figures/ and report.html of a run or a sweep; returns the path of the report."""
    folder = pathlib.Path(folder)
    if (folder / "sweep.csv").exists():
        return sweep_page.make(folder)
    results = Results(folder)
    return markup.write_page(folder / "report.html", page(results, list(save_figures(results))))


def make_gallery(folder, only=()):
    """Writes the numbered figures; returns pairs of name and reason for those that cannot be drawn."""
    unknown = [name for name in only if name not in gallery.known_names()]
    if unknown:
        raise ValueError(f"there is no figure {unknown[0]}: choose among {', '.join(gallery.known_names())}")
    left_out = []
    for entry, figure in gallery.draw(Study(folder), only):
        if isinstance(figure, str):
            left_out.append((entry.name, figure))
        else:
            gallery.save(figure, pathlib.Path(folder) / "figures", entry.name)
    return left_out


def main():
    """Command line."""
    parser = argparse.ArgumentParser(prog="ionskin.report", description=__doc__)
    parser.add_argument("folder", type=pathlib.Path, help="output folder of a run or a sweep")
    parser.add_argument("--all", action="store_true", help="the numbered figures too, and what was left out")
    parser.add_argument("--figure", action="append", default=[], metavar="NAME", help="this numbered figure only")
    arguments = parser.parse_args()
    with exit_on(OSError, ValueError):
        if arguments.all:
            tell(arguments.folder, arguments.figure)
        if not arguments.figure:
            make_report(arguments.folder)


def tell(folder, only):
    """Draws the numbered figures and prints where they are, what was left out, and the verdicts."""
    for name, reason in make_gallery(folder, only):
        print(f"{name}: left out, {reason}")
    print(f"figures: {folder}/figures (PNG, SVG, PDF)")
    if not only:
        for verdict in claims.judge(Study(folder)):
            print(f"{verdict.verdict}: {verdict.claim}; {verdict.number}")
        print(f"report: {folder}/report.html")


if __name__ == "__main__":
    main()
