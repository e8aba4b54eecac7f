# SPDX-License-Identifier: Apache-2.0
"""Process of a TrialProcess: takes tasks as lines of JSON on standard input, and answers "done" or the mistake of the case."""

import json
import os
import pathlib
import sys
import threading
import time

import ionskin
from ionskin import solver
from ionskin.evaluation.trial import Outcome


def end_with(parent: int) -> None:
    """Ends this process when the process `parent` that started it has ended, for whatever reason."""
    while os.getppid() == parent:
        time.sleep(0.5)
    os._exit(1)


def run(task: dict) -> str:
    """Runs the case of a task and writes its outcome; returns "done", or the message of a mistake of the case."""
    if task["build"] != solver.load().build():
        return "a worker has another build of ionskin, whose numbers differ\n  = start it from the same build"
    case = ionskin.Case(task["text"], task["path"])
    case._edits = task["edits"]
    try:
        result = ionskin.run(case, pathlib.Path(task["scratch"]) / "run", threads=1)
    except ionskin.SolverError as error:
        result = error
    except ionskin.CaseError as error:
        return str(error)
    Outcome.of(result).write(pathlib.Path(task["file"]))
    return "done"


def main() -> None:
    """Answers tasks until standard input ends; its one argument is the process number of the parent."""
    threading.Thread(target=end_with, args=(int(sys.argv[1]),), daemon=True).start()
    answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)  # nothing else gets among the answers
    for line in sys.stdin:
        print(json.dumps(run(json.loads(line))), file=answers, flush=True)


if __name__ == "__main__":
    main()
