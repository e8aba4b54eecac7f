# SPDX-License-Identifier: Apache-2.0
"""The command `ionskin generate`."""

import os
import sys
import time
import warnings

import numpy

from .. import solver
from ..errors import CaseError
from ..evaluation import StudyFolder
from ..evaluation.command import SOLVER_GAVE_UP, Progress, base_case, engine, given_options, guarded, require_disk
from ..live import Skin
from . import store
from .live_touches import LiveEngine, LiveTouches, is_live_skin
from .rows import MOVING
from .touches import RATE, Touches

FIXED = ("motion.direction", "motion.touchdown", "motion.slide", "motion.lift")  # printed by name where they do not vary
PRINTED = ("normal_force", "charge_top", "current_top")  # whose stated errors are printed


def main() -> int:
    """Runs the command line of `ionskin generate` and returns the exit code."""
    arguments = given_options()
    touches, runner, lines = (of_live_skin if is_live_skin(arguments.case_path) else of_case)(arguments)
    question = {"study": "generate", **touches.identity, "vary": {one.key: one.written for one in touches.parameters},
                "seed": arguments.seed, "touches": arguments.touches}
    kept = StudyFolder(arguments.output, question, resume=arguments.resume, overwrite=arguments.overwrite, free=("touches",))
    kept.write("case.toml", touches.identity["case"])
    if not arguments.quiet:
        print("\n".join(lines), flush=True)
    finished = kept.finished_numbers()
    asked = [trial for trial in touches.trials if trial.number not in finished]
    progress, failed = Progress(len(asked), arguments.quiet, runner), []

    def on_result(trial, outcome):
        progress(outcome)
        if outcome.reason:
            failed.append(outcome.reason)

    begin = time.monotonic()
    runner.evaluate(None, asked, kept.points, on_result)
    seconds = time.monotonic() - begin
    size, choice = store.write(kept.folder / "touches.h5", touches, kept.points, balance=arguments.balance)
    if not arguments.quiet:
        rate = f"{len(asked) / seconds:.3g} touches a second, " if asked else ""
        print(f"{len(touches.trials)} touches, {len(failed)} failed; {rate}{size / len(touches.trials):.0f} bytes a touch")
        print("\n".join(of_rows(choice, arguments.balance)))
        print(f"store: {arguments.output}/touches.h5")
    return SOLVER_GAVE_UP if len(failed) == len(touches.trials) else 0


def of_case(arguments):
    """Touches of a case, the engine that runs them, and lines of text to print before."""
    touches = Touches(base_case(arguments), arguments.touches, seed=arguments.seed, vary=arguments.vary)
    runner = engine(arguments)
    require_disk(touches.trials, len(touches.trials), arguments.output, runner)
    lines = announcement(touches, arguments.output)
    if touches.redrawn:
        lines.append(f"{touches.redrawn} draws made no valid case and were drawn again")
    return touches, runner, lines


def of_live_skin(arguments):
    """Touches of a live skin, the engine that steps them, and lines of text to print before."""
    for option, given in (("--set", arguments.set_edits), ("--vary", arguments.vary), ("--on", arguments.on)):
        if given:
            raise CaseError(f"{option}: {arguments.case_path} is a live skin: its case is fixed, and it is stepped on this machine\n"
                            "  = leave the option out, or train another skin: the motion of the case says the range of places, "
                            "forces and speeds, ionskin live --friction LOW HIGH that of friction")
    with warnings.catch_warnings(record=True) as warned:
        warnings.simplefilter("always")
        skin = Skin(arguments.case_path)
    touches = LiveTouches(skin, arguments.touches, seed=arguments.seed, interval=1 / RATE)
    solver.load().require_disk(touches.size(), os.fsencode(arguments.output))
    return touches, LiveEngine(touches, arguments.threads), [f"warning: {one.message}" for one in warned] + live_announcement(touches)


def of_rows(choice, asked: int) -> list[str]:
    """Lines of text on the rows of a store: how many there are of each kind, and how many were chosen of each.

    choice  RowChoice
    asked   number of rows of each kind that were asked for; 0: none
    """
    total = max(1, sum(choice.counts.values()))
    lines = ["rows: " + ", ".join(f"{100 * count / total:.2g} % {kind}" for kind, count in choice.counts.items())]
    none = [kind for kind in MOVING if not choice.counts[kind]]
    if asked and none:
        lines.append(f"warning: balanced: no rows are chosen, because none is of the kind {' or '.join(none)}, and a choice has "
                     "as many of each kind\n  = make more touches, or others, in which this kind occurs; where it cannot, as "
                     "stick under a rigid block, choose rows by touch/NUMBER/kind")
    elif asked:
        each, rarest = len(choice.chosen()) // len(MOVING), min(MOVING, key=choice.counts.get)
        lines.append(f"balanced: {each} rows each of {', '.join(MOVING)}"
                     + (f"; there are no more of {rarest}: make more touches" if each < asked else ""))
    return lines


def announcement(touches: Touches, folder: str) -> list[str]:
    """Lines of text, printed before the touches run: what varies, what stays, how to widen it, and what is known of errors.

    folder  output folder of the command
    """
    case = touches.case
    lines = [f"{one.key} = {one.written}" for one in touches.parameters]
    varying = {one.key for one in touches.parameters}
    fixed = [key for key in FIXED if key in case and key not in varying]
    if fixed:
        lines.append(f"the same in all touches: {', '.join(fixed)}, and every other key of the case")
    lines.append('to vary more keys, or more widely: --vary "KEY=DISTRIBUTION", such as --vary "motion.slide=uniform(0.5 s, 2 s)"')
    lines.append(f"no errors are stated for these touches (preset {case['numerics.preset']}); the run of the case itself states them: "
                 f"ionskin run {folder}/case.toml -o OUT")
    lines.append("more touches in the same time, of varied motions and with stated errors: ionskin live CASE.toml -o SKIN.live, "
                 "then ionskin generate SKIN.live")
    return lines


def live_announcement(touches: LiveTouches) -> list[str]:
    """Lines of text, printed before the touches of a live skin are stepped: what varies, and the stated errors."""
    trained = touches.skin.range
    x, y = (f"{1e3 * low:g} mm only" if low == high else f"{1e3 * low:g} to {1e3 * high:g} mm"
            for low, high in zip(trained.lowest, trained.highest))
    by_force = "forces" in touches.skin.random_touch(touches.seed)
    load = f"forces up to {trained.force:.3g} N" if by_force else f"heights down to {-1e6 * trained.indentation:.3g} um"
    lines = [f"{one.key} = {one.written}" for one in touches.parameters]
    lines.append(f"x {x}, y {y}, {load}, speeds up to {1e3 * trained.speed:.3g} mm/s")
    if trained.tilt or trained.turn:
        lines.append(f"tilts up to {numpy.degrees(trained.tilt):.3g} degrees, turns up to {numpy.degrees(trained.turn):.3g} degrees a second")
    lines += ["each touch lands, slides, rests, changes its force and lifts off, at random (docs/training-data.md)"]
    for name in PRINTED:
        one = touches.skin.errors.get(name)
        if one and one.largest > 0:
            lines.append(f"stated error of {name} against the full model: {100 * one.rms / one.largest:.2g} % rms, "
                         f"{100 * one.worst / one.largest:.2g} % at most, of its largest value")
    return lines


if __name__ == "__main__":
    with guarded():
        sys.exit(main())
