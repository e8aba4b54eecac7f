# SPDX-License-Identifier: Apache-2.0
"""Conversion of lengths and times of case files to SI units."""

import re

UNITS = {"m": 1.0, "mm": 1e-3, "um": 1e-6, "µm": 1e-6, "nm": 1e-9, "cm": 1e-2, "s": 1.0, "ms": 1e-3, "us": 1e-6}
NUMBER = re.compile(r"\s*([-+0-9.eE]+)\s*(\S+)\s*")


def si(text):
    """Converts a length or a time, such as "0.5 um", to a number [m] or [s]; a list or tuple to a list of such numbers.

    Raises ValueError for any other unit.
    """
    if isinstance(text, (list, tuple)):
        return [si(entry) for entry in text]
    match = NUMBER.fullmatch(str(text))
    if not match or match[2] not in UNITS:
        raise ValueError(f"{text!r} is not a length or a time that a figure can draw")
    return float(match[1]) * UNITS[match[2]]
