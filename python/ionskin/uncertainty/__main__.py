# SPDX-License-Identifier: Apache-2.0
"""The command `ionskin uncertainty`."""

import sys

from ..evaluation import StudyFolder
from ..evaluation.command import SOLVER_GAVE_UP, Progress, base_case, engine, given_options, guarded, require_disk
from . import output
from .study import Uncertainty


def tell(study, analyses, arguments) -> None:
    """Prints mean, deviation and Sobol' indices of each metric as lines, then warnings and the path of the report."""
    for name, one in analyses.items():
        print(f"{name}: mean {one.mean:.6g}, standard deviation {one.deviation:.3g}"
              + ("" if one.q2 is None else f", Q2 {one.q2:.4f}"))
        for key in one.first:
            (first, low, high), (total, least, most) = one.first[key], one.total[key]
            print(f"  {key:<40} first {first:.3f} ({low:.3f} to {high:.3f})  total {total:.3f} ({least:.3f} to {most:.3f})")
    for text in output.warnings(study, analyses):
        print(f"warning: {text}")
    print(f"report: {arguments.output}/report.html")


def main() -> int:
    """Runs the command line of `ionskin uncertainty` and returns the exit code."""
    arguments = given_options()
    case = base_case(arguments)
    study = Uncertainty(case, arguments.vary, samples=arguments.samples, design=arguments.design, seed=arguments.seed,
                        metrics=arguments.metrics, least_q2=arguments.least_q2)
    runner = engine(arguments)
    require_disk(study.trials, len(study.trials), arguments.output, runner)
    question = {"study": "uncertainty", "case": case.text, "vary": {one.key: one.written for one in study.parameters},
                "design": arguments.design, "seed": arguments.seed, "samples": arguments.samples}
    kept = StudyFolder(arguments.output, question, resume=arguments.resume, overwrite=arguments.overwrite,
                       free=("samples",) if arguments.design == "sobol" else ())
    kept.write("case.toml", case.text)
    for number, outcome in kept.finished().items():
        if number < len(study.trials):
            study.tell(study.trials[number], outcome)
    asked = study.ask()
    progress = Progress(len(asked), arguments.quiet, runner)

    def on_result(trial, outcome):
        study.tell(trial, outcome)
        progress(outcome)

    runner.evaluate(case, asked, kept.points, on_result)
    if not study.finished():
        print(f"error: every sample failed; the first: {study.outcomes[0].reason}", file=sys.stderr)
        return SOLVER_GAVE_UP
    analyses = study.analyse()
    output.write(study, analyses, kept)
    if not arguments.quiet:
        tell(study, analyses, arguments)
    refused = [one.refusal for one in analyses.values() if one.q2 is not None and one.refusal]
    return SOLVER_GAVE_UP if refused and not any(one.first for one in analyses.values()) else 0


if __name__ == "__main__":
    with guarded():
        sys.exit(main())
