# SPDX-License-Identifier: Apache-2.0
"""Runs a module of this package for the program: python3 -I -B isolated.py ionskin.report FOLDER

In Python's isolated mode neither the working folder nor a variable such as PYTHONPATH says what is imported; this
package is the one that holds this file. Ends with 2 and one line "error: REASON", or with 3 where a library is missing.
"""

import os
import runpy
import sys

LONGEST_REASON = 300
MISSING_LIBRARY = 3


def reason(error):
    """Message of an error as one line of printable text, at most `LONGEST_REASON` characters long."""
    text = " ".join(str(error).split())
    text = "".join(letter if letter.isprintable() else "?" for letter in text)
    text = text if len(text) <= LONGEST_REASON else text[:LONGEST_REASON] + " ..."
    return text or type(error).__name__


def import_matplotlib(package):
    """Imports matplotlib so that its settings come from the user's own folder, not from
    a `matplotlibrc` in the working folder."""
    here = os.open(".", os.O_RDONLY)
    os.chdir(package)
    try:
        import matplotlib  # pylint: disable=import-outside-toplevel,unused-import
    finally:
        os.fchdir(here)
        os.close(here)


def main():
    """Runs a module of this package by its name, with the arguments of the command line."""
    package = os.path.dirname(os.path.abspath(__file__))
    sys.stdout.reconfigure(errors="backslashreplace")  # a terminal of Latin-1 has no superscripts
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # no matrix here is large: threads that wait cost more than they give
    sys.path.insert(0, os.path.dirname(package))
    module, sys.argv = sys.argv[1], sys.argv[1:]
    try:
        runpy.run_module(module, run_name="__main__", alter_sys=True)
    except ImportError as error:
        print(f"error: {reason(error)}", file=sys.stderr)
        sys.exit(MISSING_LIBRARY)
    except Exception as error:  # whatever cannot be drawn is reported in one line, not in a trace
        print(f"error: {type(error).__name__}: {reason(error)}", file=sys.stderr)
        sys.exit(2)


if __name__ == "__main__":
    main()
