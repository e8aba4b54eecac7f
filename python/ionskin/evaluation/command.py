# SPDX-License-Identifier: Apache-2.0
"""What the commands that run many trials share: options, the base case, progress, exit codes."""

import argparse
import contextlib
import sys

from ..case import Case
from ..errors import CaseError
from .local import LocalEngine

SOLVER_GAVE_UP, INTERRUPTED = 3, 130


def parser(prog: str) -> argparse.ArgumentParser:
    """With the options that the front hands on for each of these commands."""
    result = argparse.ArgumentParser(prog=prog)
    result.add_argument("case")
    result.add_argument("--output", required=True)
    result.add_argument("--set", action="append", default=[], dest="edits")
    result.add_argument("--threads", type=int, default=0)
    for flag in ("--overwrite", "--resume", "--no-cache", "--quiet"):
        result.add_argument(flag, action="store_true")
    return result


def base_case(arguments) -> Case:
    """The case with the edits of --set. Raises CaseError."""
    case = Case.from_file(arguments.case)
    for edit in arguments.edits:
        key, _, text = edit.partition("=")
        case._edits[key.strip()] = text
    return case.check()


def engine(arguments) -> LocalEngine:
    """On this machine."""
    return LocalEngine(arguments.threads, cache=not arguments.no_cache)


class Progress:
    """Lines on standard error, one for each tenth."""

    def __init__(self, total: int, quiet: bool) -> None:
        self._total, self._done, self._quiet = total, 0, quiet

    def __call__(self, outcome) -> None:
        self._done += 1
        if outcome.reason and not self._quiet:
            print(f"failed: {outcome.reason}", file=sys.stderr, flush=True)
        if not self._quiet and self._done * 10 // self._total != (self._done - 1) * 10 // self._total:
            print(f"{self._done} of {self._total} runs ended", file=sys.stderr, flush=True)


@contextlib.contextmanager
def guarded():
    """The user's mistake ends with 2, an interrupt with 130."""
    try:
        yield
    except (CaseError, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        sys.exit(2)
    except KeyboardInterrupt:
        print("interrupted: finish with --resume", file=sys.stderr)
        sys.exit(INTERRUPTED)
