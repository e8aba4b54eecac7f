# SPDX-License-Identifier: Apache-2.0
"""Exceptions of the package, with the messages of the program. An interrupt (Ctrl-C) is Python's own KeyboardInterrupt."""

import contextlib
import os
import sys


class CaseError(ValueError):
    """Error of the user: the case, a file or a setting is wrong, and nothing was computed.

    The message says what is wrong, where, and the remedy.
    """


class SolverError(RuntimeError):
    """Error of a solver that gave up on a valid case; finished parts stay in the output folder.

    remedy  text that says what the user can change; "" for none
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
    """Message of an exception for the user; for an error of the operating system with the file's name and a remedy."""
    if isinstance(error, OSError) and error.strerror:
        place = error.filename2 or error.filename
        where = f"{os.fsdecode(place)}: " if isinstance(place, (str, bytes, os.PathLike)) else ""
        return f"{where}{error.strerror}\n  = check the name, the permissions and the free space"
    return str(error)


@contextlib.contextmanager
def exit_on(*kinds):
    """Context of a command line program: at an exception of these kinds prints its message and exits with code 2."""
    try:
        yield
        sys.stdout.flush()
    except BrokenPipeError:  # the reader, such as head, has seen enough
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    except kinds as error:
        print(f"error: {in_words(error)}", file=sys.stderr)
        sys.exit(2)
