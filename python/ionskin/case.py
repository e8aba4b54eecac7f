# SPDX-License-Identifier: Apache-2.0
"""Cases: the input of a run, read from a TOML file or text, changed key by key, checked and run."""

import json
import numbers
import os
import re
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

import numpy

from . import solver
from .errors import CaseError
from .reading import files


LARGEST = 1 << 20  # bytes, as the program reads
TWO_UNITS = re.compile(r"(?:slider\[\d+\]\.)?motion\.preload")  # an indentation or a force
LIST_ENTRY = re.compile(r"(?P<list>.+)\[(?P<index>\d+)\]")  # slider.start[0]


class Value(NamedTuple):
    """Value of one key of a case, with its unit and where it comes from.

    value    number in SI units, list of such numbers, or text
    unit     SI unit of the value; "1" for pure numbers and texts
    origin   "file" (the case file), "--set" (changed on this Case), "default" (of ionskin), or "preset" (of a material)
    written  text of the value as the case has it, such as "0.5 um"
    """

    value: Any
    unit: str
    origin: str
    written: str


def toml_text(value: Any, unit: str) -> str:
    """Writes a Python value as TOML: numbers with their SI unit, texts in quotes, sequences as arrays.

    value  number in SI units, text, or a list, tuple or numpy array of them
    unit   SI unit that is written behind each number; "" or "1" for pure numbers

    Raises TypeError for any other type of value.
    """
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, numbers.Real) and not isinstance(value, (bool, numpy.bool_)):
        number = repr(int(value)) if isinstance(value, numbers.Integral) else repr(float(value))
        return number if unit in ("", "1") else f'"{number} {unit}"'
    if isinstance(value, (list, tuple, numpy.ndarray)):
        return "[" + ", ".join(toml_text(entry, unit) for entry in value) + "]"
    raise TypeError(f"{value!r} is not a value of a case: give a number in SI units, a text such as '0.5 um', or a list")


class Case:
    """Case, the input of a run: the text of a case file (TOML) and the changes made to its keys, which are indexed by name.

    case["contact.friction"] = 0.2         sets a number in SI units
    case["motion.preload"] = 0.5           sets a force [N] where the case has a force, an indentation [m] where it has one
    case["motion.preload"] = "0.5 um"      sets a quantity from a text with a unit
    case["skin.layers[1].thickness"]       1.8e-4; reads a number in SI units, a list of them, or a text
    case["slider.start[0]"]                4.5e-3; reads one entry of a list, which can be set as well
    case["readout.taxels"] = {"rows": 4, "columns": 4}   sets a table, or a list of tables

    Setting an unknown key, or a value of the wrong type, unit or range, raises CaseError and leaves the case as it was.
    Missing values, and values that do not fit together, raise CaseError when the case is used: by `check`, `run`, `sweep`, or
    when a key is read. `key in case` is True for keys that have a value; iterating over a case gives these keys.
    """

    def __init__(self, text: str, path: str = "case.toml") -> None:
        """Makes a case of a text and checks each value on its own. Raises CaseError.

        text  TOML as in a case file
        path  name of the case in messages; its folder is where files that the case names are looked for
        """
        self._original, self._path = text, path
        self._edits: dict[str, str] = {}
        solver.load().check_values(self)

    @classmethod
    def from_file(cls, path: str | os.PathLike) -> "Case":
        """Reads a case file and checks it as a whole. Raises CaseError when it cannot be read or holds mistakes."""
        try:
            text = files.read_text(path, LARGEST)
        except OSError as error:
            raise CaseError(f"the case {os.fspath(path)} cannot be read: {error.strerror}\n  = check its name") from error
        return cls(text, os.fspath(path)).check()

    @classmethod
    def from_text(cls, text: str, folder: str | os.PathLike = ".") -> "Case":
        """Makes a case of TOML text and checks it as a whole; files that it names are looked for in `folder`.

        Raises CaseError when it holds mistakes.
        """
        return cls(text, os.path.join(os.fspath(folder), "case.toml")).check()

    def check(self) -> "Case":
        """Checks the whole case and returns it. Raises CaseError with every mistake, in values and in how they fit together."""
        solver.load().values(self)
        return self

    def copy(self) -> "Case":
        """Makes an independent case with the same text and changes."""
        twin = Case.__new__(Case)  # the text was checked when this one was made
        twin._original, twin._path, twin._edits = self._original, self._path, dict(self._edits)
        return twin

    def __setitem__(self, key: str, value: Any) -> None:
        edit = _text_of(self, key, value)
        former = dict(self._edits)
        self._edits.pop(key, None)
        self._edits[key] = edit
        try:
            solver.load().check_values(self)
        except CaseError:
            self._edits = former
            raise

    def __getitem__(self, key: str) -> Any:
        return self.value(key).value

    def __contains__(self, key: str) -> bool:
        return self._find(key) is not None

    def __iter__(self) -> Iterator[str]:
        return iter(solver.load().values(self))

    def value(self, key: str) -> Value:
        """Value of a key, with its unit and origin. Raises CaseError when the key is unknown or has no value in this case."""
        found = self._find(key)
        if found is None:
            raise CaseError(_no_such_key(key))
        return found

    def _find(self, key: str) -> Value | None:
        values = solver.load().values(self)
        if key in values:
            return Value(*values[key])
        entry = LIST_ENTRY.fullmatch(key)
        whole = Value(*values[entry["list"]]) if entry and entry["list"] in values else None
        if whole is None or not isinstance(whole.value, list) or int(entry["index"]) >= len(whole.value):
            return None
        number = whole.value[int(entry["index"])]
        return whole._replace(value=number, written=toml_text(number, whole.unit))

    def values(self) -> dict[str, Value]:
        """All values of the case by key, including defaults and values of material presets. Raises CaseError."""
        return {key: Value(*value) for key, value in solver.load().values(self).items()}

    @property
    def text(self) -> str:
        """TOML text of the case with all changes written into it; comments and the order of keys are kept."""
        return solver.load().case_text(self)

    def _edit_list(self) -> list[str]:
        return [f"{key}={text}" for key, text in self._edits.items()]

    def __repr__(self) -> str:
        changes = ", ".join(self._edit_list())
        return f"Case({self._path}{'; ' + changes if changes else ''})"


def unit_of_number(case: Case, key: str) -> str:
    """SI unit of a number that is given for a key of a case without a unit; "" for texts and unknown keys.

    A key that takes an indentation or a force keeps the unit of the value that the case has. Raises CaseError where the case has none.
    """
    if not TWO_UNITS.fullmatch(key):
        return solver.load().key_unit(key) or ""
    try:
        values = solver.load().values(case)
    except CaseError:
        values = {}
    for standing in (key, "motion.preload"):  # which also holds for the sliders of a list
        if standing in values:
            return Value(*values[standing]).unit
    raise CaseError(f'{key}: a number without a unit may be an indentation or a force, and this case has no value whose unit it keeps\n'
                    '  = write it as a text with its unit, such as "0.5 um" or "0.5 N"')


def _text_of(case: Case, key: str, value: Any) -> str:
    """Writes the value of a key as TOML; numbers within a table, or a list of tables, get the units of their own keys."""
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{name} = {_text_of(case, f'{key}.{name}', entry)}" for name, entry in value.items()) + "}"
    if isinstance(value, (list, tuple)) and value and all(isinstance(entry, Mapping) for entry in value):
        return "[" + ", ".join(_text_of(case, f"{key}[{i}]", entry) for i, entry in enumerate(value)) + "]"
    return toml_text(value, "" if isinstance(value, str) else unit_of_number(case, key))


def _no_such_key(key: str) -> str:
    if solver.load().key_unit(key) is not None:
        return f"{key} has no value in this case"
    nearest = solver.load().nearest_key(key)
    return f"unknown key {key}" + (f"\n  = did you mean {nearest}?" if nearest else "")
