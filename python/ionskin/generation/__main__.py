# SPDX-License-Identifier: Apache-2.0
"""The command `ionskin generate`."""

import sys
import time

from ..evaluation import StudyFolder
from ..evaluation.command import SOLVER_GAVE_UP, Progress, base_case, engine, given_options, guarded, require_disk
from . import store
from .touches import Touches

FIXED = ("motion.direction", "motion.touchdown", "motion.slide", "motion.lift")  # told by name where they do not vary


def main() -> int:
    """Runs the command line of `ionskin generate` and returns the exit code."""
    arguments = given_options()
    case = base_case(arguments)
    touches = Touches(case, arguments.touches, seed=arguments.seed, vary=arguments.vary)
    runner = engine(arguments)
    require_disk(touches.trials, len(touches.trials), arguments.output, runner)
    varying = {one.key: one.written for one in touches.parameters}
    kept = StudyFolder(arguments.output, {"study": "generate", "case": touches.case.text, "vary": varying,
                                          "seed": arguments.seed, "touches": arguments.touches},
                       resume=arguments.resume, overwrite=arguments.overwrite, free=("touches",))
    kept.write("case.toml", touches.case.text)
    if not arguments.quiet:
        print("\n".join(announcement(touches, arguments.output)))
        if touches.redrawn:
            print(f"{touches.redrawn} draws made no valid case and were drawn again")
    finished = kept.finished()
    asked = [trial for trial in touches.trials if trial.number not in finished]
    progress, failed = Progress(len(asked), arguments.quiet, runner), []

    def on_result(trial, outcome):
        progress(outcome)
        if outcome.reason:
            failed.append(outcome.reason)

    begin = time.monotonic()
    runner.evaluate(case, asked, kept.points, on_result)
    seconds = time.monotonic() - begin
    size = store.write(kept.folder / "touches.h5", touches, kept.points,
                       {"case": touches.case.text, "seed": arguments.seed, "made_by": "ionskin generate"})
    if not arguments.quiet:
        rate = f"{len(asked) / seconds:.3g} touches a second, " if asked else ""
        print(f"{len(touches.trials)} touches, {len(failed)} failed; {rate}{size / len(touches.trials):.0f} bytes a touch")
        print(f"store: {arguments.output}/touches.h5")
    return SOLVER_GAVE_UP if len(failed) == len(touches.trials) else 0


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
    return lines


if __name__ == "__main__":
    with guarded():
        sys.exit(main())
