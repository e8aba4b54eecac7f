# SPDX-License-Identifier: Apache-2.0
"""Errors of the package, with the messages of the program. An interrupt is Python's own KeyboardInterrupt."""

import contextlib
import os
import sys


class CaseError(ValueError):
    """The case, a file or a setting is wrong; nothing was computed. The message says what, where, and the remedy."""


class SolverError(RuntimeError):
    """A solver gave up on a valid case; what was finished is kept in the output folder.

    remedy  what can be changed
    """

    def __init__(self, what_happened: str, remedy: str = "") -> None:
        super().__init__(f"{what_happened}\nremedy: {remedy}" if remedy else what_happened)
        self.remedy = remedy

    def __reduce__(self):
        return _restored_solver_error, (str(self), self.remedy)


def _restored_solver_error(message: str, remedy: str) -> SolverError:
    error = SolverError(message)
    error.remedy = remedy
    return error


def in_words(error: Exception) -> str:
    """Message of an error; of the system's it names the file and the remedy."""
    if isinstance(error, OSError) and error.strerror:
        place = error.filename2 or error.filename
        where = f"{os.fsdecode(place)}: " if isinstance(place, (str, bytes, os.PathLike)) else ""
        return f"{where}{error.strerror}\n  = check the name, the permissions and the free space"
    return str(error)


@contextlib.contextmanager
def exit_on(*kinds):
    """Ends a program at an error of these kinds as ionskin ends at the user's mistake: with its message and code 2."""
    try:
        yield
    except kinds as error:
        print(f"error: {in_words(error)}", file=sys.stderr)
        sys.exit(2)
