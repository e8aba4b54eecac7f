# SPDX-License-Identifier: Apache-2.0
"""Makes report.html of a run or a sweep, and its figures as files where asked for: /usr/bin/python3 -m ionskin.report FOLDER"""

import argparse
import pathlib
import sys

from . import figures
from .article import claims, paper
from .charts import numbered
from .errors import exit_on
from .page import answer, chart_data, pages, quantities, report_text, sweep_page
from .results import Results
from .sweep_results import Study

ANSWER = ("reading", "circuit", "taxel_voltages", "water_voltage", "taxels")  # the first of these figures that a run has stands at the top
FIRST = ("model", "plan")  # figures that stand before the charts to explore


def chart_section(results, entry, chart):
    """Section of a page for a figure of a run: `chart` is a Chart, or a text that says what the run lacks for it."""
    if isinstance(chart, str):
        return pages.Section(entry.name, entry.heading, "paragraphs", [f"Not drawn: {chart}."])
    words = f"{entry.words(results)} {chart.note}".strip()
    return pages.Section(entry.name, entry.heading, "chart", pages.Picture(entry.name, entry.heading, words, None))


def numbers(results):
    """Data of the section of all metrics, with a column of errors where some are estimated; None without metrics."""
    rows = report_text.metric_rows(results)
    return {"rows": rows, "stated": any(row[3] for row in rows), "notes": [report_text.NUMBERS_NOTE]} if rows else None


def timing(results):
    """Data of the section on timing: wall time and memory of each stage, counters of the solvers."""
    return {"tables": [pages.Table(("stage", "state", "wall time", "peak memory"), report_text.timing_rows(results), (2, 3)),
                       pages.Table(("counter", "value"), report_text.counter_rows(results), (1,))], "notes": []}


def case_summary(results):
    """Data of the section on the case: its layers and groups of its values; None where there are none."""
    layers = pages.Table(("layer, top first", "role", "material", "thickness"), report_text.layers(results.case))
    groups = report_text.case_groups(results.case, results.sliders[1:])
    return {"layers": layers, "groups": groups} if groups or layers.rows else None


def claims_section(study, wanted=False):
    """Section with verdicts on the article's claims; empty for another case than the article's, unless `wanted`."""
    own = paper.is_own_case(study.typical.results.case)
    if not own and not wanted:
        return pages.Section("claims", "The article's claims", "verdicts", None)
    judged = claims.judge(study)
    verdicts = [verdict for verdict in judged if wanted or verdict.verdict != claims.OPEN]
    left = len(judged) - len(verdicts)
    about = paper.ABOUT if study.whole is study else f"{paper.ABOUT} {study.note}"
    data = {"about": about, "verdicts": verdicts, "more": claims.more(study, left) if left else ""}
    return pages.Section("claims", "The article's claims", "verdicts", data)


def page(results, with_claims=False):
    """HTML text of the page of a run (Results); `with_claims` as for `make_report`."""
    charts = list(figures.charts(results))
    top = next((each for name in ANSWER for each in charts if each[0].name == name), None)
    drawn = [chart_section(results, *each) for each in charts if each != top]
    title = results.case.get("title", results.folder.resolve().name)
    study = Study(results.folder, results)
    sections = [
        pages.Section("warnings", "Warnings", "warnings", {"texts": [quantities.in_words(text) for text in results.warnings]}),
        pages.Section("case", "What was simulated", "case", case_summary(results)),
        *[picture for picture in drawn if picture.identifier in FIRST],
        pages.Section("explore", "Explore", "explore", sweep_page.explore(study)),
        *[picture for picture in drawn if picture.identifier not in FIRST],
        claims_section(study, with_claims),
        pages.Section("numbers", "Numbers", "numbers", numbers(results)),
        pages.Section("words", "Words", "glossary", quantities.glossary(results.metrics)),
        pages.Section("timing", "Timing", "tables", timing(results)),
        pages.Section("limits", "Limits of the model", "list", report_text.limits(results)),
        pages.Section("origin", "Origin", "table", pages.Table(("", ""), report_text.origin_rows(results))),
    ]
    shown = chart_data.chart_data({entry.name: chart for entry, chart in charts if not isinstance(chart, str)})
    shown_first = chart_section(results, *top) if top else None
    opening = (answer.sentences(results), shown_first.data if shown_first and shown_first.part == "chart" else None)
    return pages.page(title, report_text.subtitle(results), sections, cards=list(report_text.headline(results).values()), answer=opening,
                      script=pages.chart_script({**sweep_page.script(study), "FIGURES": ("chart_cells.js", shown)}))


def make_report(folder, with_claims=False, *, files=False, progress=None, left_out=None):
    """Writes report.html of a run or a sweep into its folder and returns the path of the file.

    folder       output folder of the run or sweep
    with_claims  True to judge the article's claims even for another case than the article's
    files        True to write every figure into figures/, too
    progress     called with the finished part, from 0 to 1; None for no calls
    left_out     list to which pairs of name and reason of the figures that are not written are added; None for no list
    """
    folder = pathlib.Path(folder)
    on_progress = progress or (lambda part: None)
    if (folder / "sweep.csv").exists():
        study = Study(folder)
        path = sweep_page.make(study, claims_section(study, with_claims))
        results = None
    else:
        results = Results(folder)
        path = pages.write_page(folder / "report.html", page(results, with_claims))
    if files:
        missing = make_gallery(folder, progress=on_progress, results=results)
        if left_out is not None:
            left_out += missing
    on_progress(1.0)
    return path


def make_gallery(folder, only=(), *, progress=None, results=None):
    """Writes figures of a run or a sweep as files into its folder figures/; returns pairs of name and reason for
    figures that cannot be drawn.

    only      names of numbered figures; empty for all of them, and for a run also the figures of its page
    progress  called with the finished part, from 0 to 1; None for no calls
    results   Results of the folder's run, where they have been read already; None to read the folder

    Raises ValueError for unknown names.
    """
    from .drawing import making  # a page needs no matplotlib

    unknown = [name for name in only if name not in numbered.known_names()]
    if unknown:
        raise ValueError(f"there is no figure {unknown[0]}: choose among {', '.join(numbered.known_names())}")
    study = Study(folder, results)
    jobs = making.numbered_jobs(study, only)
    if not only and study.sweep is None:
        jobs += making.of_page(study.typical.results)
    made = making.make(jobs, pathlib.Path(folder) / "figures", progress)
    return [(each.name, each.reason) for each in made if each.reason]


def tell_progress(part):
    """Prints the finished part, from 0 to 1, as a line on standard error that the program ionskin reads."""
    print(f"progress {part:.3f}", file=sys.stderr, flush=True)


def main():
    """Runs the command line of `ionskin report`."""
    parser = argparse.ArgumentParser(prog="ionskin.report", description=__doc__)
    parser.add_argument("folder", type=pathlib.Path, help="output folder of a run or a sweep")
    parser.add_argument("--figures", action="store_true", help="every figure as a file too")
    parser.add_argument("--figure", action="append", default=[], metavar="NAME", help="this numbered figure as a file, no page")
    parser.add_argument("--claims", action="store_true", help="judge the article's claims whatever the case")
    parser.add_argument("--tell", action="store_true", help="print what was made, and the verdicts")
    parser.add_argument("--progress", action="store_true", help="print the finished part on standard error")
    arguments = parser.parse_args()
    progress = tell_progress if arguments.progress else None
    left_out = []
    with exit_on(OSError, ValueError):
        if arguments.figure:
            left_out += make_gallery(arguments.folder, arguments.figure, progress=progress)
        else:
            make_report(arguments.folder, arguments.claims, files=arguments.figures, progress=progress, left_out=left_out)
        if arguments.tell:
            tell(arguments, left_out)


def tell(arguments, left_out):
    """Prints what was made and where, what was left out, and the verdicts."""
    if arguments.figures or arguments.figure:
        for name, reason in left_out:
            print(f"{name}: left out, {reason}")
        print(f"figures: {arguments.folder}/figures (PNG, SVG, PDF)")
    if arguments.figure:
        return
    section = claims_section(Study(arguments.folder), arguments.claims)
    for verdict in section.data["verdicts"] if section.data else ():
        print(f"{verdict.verdict}: {verdict.claim}; {verdict.number}")
    print(f"report: {arguments.folder}/report.html")


if __name__ == "__main__":
    main()
