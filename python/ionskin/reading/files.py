# SPDX-License-Identifier: Apache-2.0
"""Safe reading of files that may come from elsewhere: ordinary files of bounded size, and
JSON of bounded depth and finite numbers."""

import csv
import io
import json
import math
import os
import stat

from ..errors import CaseError

LARGEST_JSON, DEEPEST_JSON = 16 << 20, 32  # as the program reads it: base/files/read_json.hpp
LARGEST_TABLE = 2 << 30


def open_ordinary(path, most):
    """Opens an ordinary file to read its bytes.

    most  largest allowed size [bytes]

    Raises FileNotFoundError when it is missing, CaseError when it is a folder, a pipe, a device or a link to itself, is larger
    than `most`, or cannot be read.
    """
    try:
        descriptor = os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC)  # opening a pipe would wait for its other end
    except FileNotFoundError:
        raise
    except (OSError, ValueError) as error:
        raise CaseError(f"{path} cannot be read: {getattr(error, 'strerror', None) or error}\n  = check its name and its "
                        "permissions") from error
    try:
        state = os.fstat(descriptor)
        if stat.S_ISDIR(state.st_mode):
            raise CaseError(f"{path} is a folder\n  = a file is wanted there: move the folder away")
        if not stat.S_ISREG(state.st_mode):
            raise CaseError(f"{path} is a pipe or a device\n  = an ordinary file is wanted there")
        if state.st_size > most:
            raise CaseError(f"{path} has {state.st_size} bytes, more than the {most} that such a file may have\n"
                            "  = name the right file")
        return os.fdopen(descriptor, "rb")
    except BaseException:
        os.close(descriptor)
        raise


def read_text(path, most=LARGEST_TABLE) -> str:
    """Reads an ordinary file of UTF-8 text. Raises as `open_ordinary` does, and CaseError for text that is not UTF-8."""
    with open_ordinary(path, most) as file:
        content = file.read(most + 1)[:most]
    try:
        return content.decode("utf-8")
    except UnicodeDecodeError as error:
        raise CaseError(f"{path} is damaged: it is not UTF-8 text (byte {error.start})\n  = make it anew") from error


def parse_json(text: str):
    """Parses a JSON text. Raises ValueError for anything but JSON, for NaN and infinity, and for deep nesting."""
    try:
        value = json.loads(text, parse_constant=_refuse_constant, parse_float=_finite)
    except RecursionError as error:
        raise ValueError(f"it is nested deeper than {DEEPEST_JSON} levels") from error
    level = [value]
    for _ in range(DEEPEST_JSON + 1):
        level = [inner for one in level if isinstance(one, (dict, list))
                 for inner in (one.values() if isinstance(one, dict) else one)]
        if not level:
            return value
    raise ValueError(f"it is nested deeper than {DEEPEST_JSON} levels")


def read_json(path, most=LARGEST_JSON, remedy="run the case again"):
    """Reads a JSON file; `remedy` is what the message tells the user to do. Raises as
    `read_text` does, and CaseError when it is damaged."""
    try:
        return parse_json(read_text(path, most))
    except CaseError:
        raise
    except ValueError as error:
        raise CaseError(f"{path} is damaged: {error}\n  = {remedy}") from error


def _refuse_constant(word):
    raise ValueError(f"{word} is not a number of JSON")


def _finite(text):
    value = float(text)
    if not math.isfinite(value):
        raise ValueError(f"{text[:20]} is too large a number")
    return value


def read_rows(path):
    """Reads the rows of a CSV file, each a list of cells; the first is the header.

    Raises as `read_text` does, csv.Error for damaged cells, and ValueError without a header.
    """
    rows = list(csv.reader(io.StringIO(read_text(path), newline=""), strict=True))
    if not rows:
        raise ValueError("it has no header")
    return rows
