# SPDX-License-Identifier: Apache-2.0
"""The command `ionskin design`."""

import csv
import io
import re
import sys

from ..errors import CaseError
from ..evaluation import StudyFolder
from ..evaluation.command import SOLVER_GAVE_UP, Progress, base_case, engine, given_options, guarded, require_disk
from .search import Design

RANGE = re.compile(r"\s*([^=]+?)\s*=\s*([^:]+):\s*([-+.\deE]+)\s*(.*?)\s*")


def free_range(text: str) -> tuple[str, tuple[str, str]]:
    """Reads "KEY=50:500 um" as the key and the texts of both ends; one unit, behind the
    second, serves both. Raises CaseError."""
    match = RANGE.fullmatch(text)
    if not match:
        raise CaseError(f'"{text}" is not a range\n  = write KEY=LOWEST:HIGHEST UNIT, such as '
                        '"skin.layers[1].thickness=50:500 um"')
    key, low, high, unit = (part.strip() for part in match.groups())
    low = low if re.search(r"[^\d.eE+-]", low) else f"{low} {unit}"
    return key, (low.strip(), f"{high} {unit}".strip())


def evaluations(study: Design) -> str:
    """CSV text of a search, one row for each evaluation: values of the keys, metrics and, where it failed, the reason."""
    units = next((outcome.units for outcome in study.outcomes.values() if not outcome.reason), {})
    names = list(dict.fromkeys([study.objective, *(one.metric for one in study.constraints)]))
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(["evaluation", *(f"{one.key} [{one.unit}]" for one in study.parameters),
                    *(f"{name} [{units.get(name, '1')}]" for name in names), "reason"])
    for trial in study.trials:
        outcome = study.outcomes[trial.number]
        table.writerow([trial.number, *map(repr, trial.values.values()),
                        *(repr(outcome.metrics[name]) if name in outcome.metrics else "" for name in names), outcome.reason])
    return text.getvalue()


def main() -> int:
    """Runs the command line of `ionskin design` and returns the exit code."""
    arguments = given_options()
    case = base_case(arguments)
    study = Design(case, dict(free_range(text) for text in arguments.free), arguments.maximise or arguments.minimise,
                   maximise=bool(arguments.maximise), subject_to=arguments.subject_to, budget=arguments.budget,
                   seed=arguments.seed)
    runner = engine(arguments)
    require_disk(study.trials, arguments.budget, arguments.output, runner)
    question = {"study": "design", "case": case.text, "free": {one.key: one.written for one in study.parameters},
                "objective": study.objective, "maximise": bool(arguments.maximise), "subject_to": arguments.subject_to,
                "seed": arguments.seed, "budget": arguments.budget}
    kept = StudyFolder(arguments.output, question, resume=arguments.resume, overwrite=arguments.overwrite, free=("budget",))
    kept.write("case.toml", case.text)
    finished, progress = kept.finished(), Progress(arguments.budget, arguments.quiet, runner)

    def on_result(trial, outcome):
        study.tell(trial, outcome)
        progress(outcome)

    while asked := study.ask():
        for trial in asked:
            if trial.number in finished:
                on_result(trial, finished[trial.number])
        missing = [trial for trial in asked if trial.number not in finished]
        if missing:
            runner.evaluate(case, missing, kept.points, on_result)
    kept.write("evaluations.csv", evaluations(study))
    found, converged = study.best(), len(study.trials) < arguments.budget
    if found is None:
        print(f"error: none of {len(study.trials)} evaluations meets every constraint; evaluations.csv has them all\n"
              "  = loosen a constraint, widen the ranges, or --resume with a larger --budget", file=sys.stderr)
        return SOLVER_GAVE_UP
    trial, metrics = found
    units = study.outcomes[trial.number].units
    named = dict.fromkeys([study.objective, *(one.metric for one in study.constraints)])
    kept.write("design.json", {"values": {one.key: {"value": trial.values[one.key], "unit": one.unit} for one in study.parameters},
                               "metrics": {name: {"value": metrics[name], "unit": units.get(name, "1")} for name in named},
                               "evaluation": trial.number, "evaluations": len(study.trials), "converged": converged})
    kept.write("best.toml", trial.case.text)
    if not arguments.quiet:
        for one in study.parameters:
            print(f"{one.key} = {trial.values[one.key]:.6g} {'' if one.unit == '1' else one.unit}".rstrip())
        for name in named:
            print(f"{name}: {metrics[name]:.6g} {units.get(name, '1')}")
        if not converged:
            print("warning: the budget ended before the search did\n  = continue with --resume and a larger --budget")
        print(f"{len(study.trials)} evaluations; best case: {arguments.output}/best.toml")
    return 0


if __name__ == "__main__":
    with guarded():
        sys.exit(main())
