# SPDX-License-Identifier: Apache-2.0
"""Makes report.html and figures/ of a run or a sweep: /usr/bin/python3 -m ionskin.report FOLDER"""

import argparse
import io
import pathlib
import re

from markupsafe import Markup

from . import figures, output_folder
from .analysis import claims, paper
from .drawing import gallery, style
from .errors import exit_on
from .page import pages, report_text, sweep_page
from .results import Results
from .sweep_results import Study

PNG_DPI = 180
FAST_PNG = {"compress_level": 2}
FIRST = ("model",)  # figures that stand before the charts to explore


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
    """Writes figures/NAME.png and .svg; yields a section of the page for each."""
    folder = results.folder / "figures"
    for entry, figure in figures.draw_all(results):
        if isinstance(figure, str):
            yield pages.Section(entry.name, entry.heading, "paragraphs", [f"Not drawn: {figure}."])
            continue
        output_folder.save(figure, folder / f"{entry.name}.png", dpi=PNG_DPI, pil_kwargs=FAST_PNG)
        page = io.StringIO()
        figure.savefig(page, format="svg", metadata={"Date": None}, transparent=True)
        svg = page.getvalue()
        picture = pages.Picture(entry.name, entry.heading, entry.words(results), Markup(inline_svg(svg, entry.name)))
        yield pages.Section(entry.name, entry.heading, "figure", picture)
        # A file of its own is seen on any background.
        output_folder.write_text(folder / f"{entry.name}.svg", white_background(svg))


def white_background(svg):
    """The same SVG on white."""
    start = svg.index(">", svg.index("<svg")) + 1
    return f'{svg[:start]}\n <rect width="100%" height="100%" fill="white"/>{svg[start:]}'


def numbers(results):
    """Every metric; the column of errors stands only where some are estimated."""
    head, rows = ("quantity", "value", "unit", "estimated error"), report_text.metric_rows(results)
    used = 4 if any(row[3] for row in rows) else 3
    return {"tables": [pages.Table(head[:used], [row[:used] for row in rows], (1, 3))], "notes": [report_text.NUMBERS_NOTE]}


def timing(results):
    """Wall time per stage and counters of the solvers."""
    return {"tables": [pages.Table(("stage", "state", "wall time", "peak memory"), report_text.timing_rows(results), (2, 3)),
                       pages.Table(("counter", "value"), report_text.counter_rows(results), (1,))], "notes": []}


def case_summary(results):
    """What was simulated."""
    layers = pages.Table(("layer, top first", "role", "material", "thickness"), report_text.layers(results.case))
    groups = report_text.case_groups(results.case)
    return {"layers": layers, "groups": groups} if groups or layers.rows else None


def claims_section(study, wanted=False):
    """Verdicts on the article's claims, for its own case or where they are asked for."""
    own = paper.is_own_case(study.typical.results.case)
    data = {"about": paper.ABOUT, "verdicts": claims.judge(study)} if own or wanted else None
    return pages.Section("claims", "The article's claims", "verdicts", data)


def page(results, drawn, with_claims=False):
    """The whole page."""
    title = results.case.get("title", results.folder.resolve().name)
    study = Study(results.folder)
    sections = [
        pages.Section("warnings", "Warnings", "warnings", {"texts": results.warnings}),
        pages.Section("case", "What was simulated", "case", case_summary(results)),
        *[picture for picture in drawn if picture.identifier in FIRST],
        pages.Section("explore", "Explore", "explore", sweep_page.explore(study)),
        *[picture for picture in drawn if picture.identifier not in FIRST],
        claims_section(study, with_claims),
        pages.Section("numbers", "Numbers", "tables", numbers(results)),
        pages.Section("timing", "Timing", "tables", timing(results)),
        pages.Section("limits", "Limits of the model", "list", report_text.limits(results)),
        pages.Section("origin", "Origin", "table", pages.Table(("", ""), report_text.origin_rows(results))),
    ]
    return pages.page(title, report_text.subtitle(results), sections, cards=report_text.headline(results),
                      script=sweep_page.script(study))


def make_report(folder, with_claims=False):
    """Writes figures/ and report.html of a run or a sweep; returns the path of the report.

    with_claims  judge the article's claims although the case is not its own
    """
    folder = pathlib.Path(folder)
    if (folder / "sweep.csv").exists():
        study = Study(folder)
        return sweep_page.make(study, claims_section(study, with_claims))
    results = Results(folder)
    return pages.write_page(folder / "report.html", page(results, list(save_figures(results)), with_claims))


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
    parser.add_argument("--claims", action="store_true", help="judge the article's claims whatever the case")
    parser.add_argument("--figure", action="append", default=[], metavar="NAME", help="this numbered figure only")
    arguments = parser.parse_args()
    with exit_on(OSError, ValueError):
        if arguments.all:
            tell(arguments.folder, arguments.figure, arguments.claims)
        if not arguments.figure:
            make_report(arguments.folder, arguments.claims)


def tell(folder, only, with_claims):
    """Draws the numbered figures and prints where they are, what was left out, and the verdicts."""
    for name, reason in make_gallery(folder, only):
        print(f"{name}: left out, {reason}")
    print(f"figures: {folder}/figures (PNG, SVG, PDF)")
    if not only:
        section = claims_section(Study(folder), with_claims)
        for verdict in section.data["verdicts"] if section.data else ():
            print(f"{verdict.verdict}: {verdict.claim}; {verdict.number}")
        print(f"report: {folder}/report.html")


if __name__ == "__main__":
    main()
