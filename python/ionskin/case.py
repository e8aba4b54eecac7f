# SPDX-License-Identifier: Apache-2.0
"""A case to read, change and run."""

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
LIST_ENTRY = re.compile(r"(?P<list>.+)\[(?P<index>\d+)\]")  # slider.start[0]


class Value(NamedTuple):
    """One value of a case.

    value    SI number, list of SI numbers, or text
    unit     SI unit; "1" for pure numbers and texts
    origin   "file", "--set" (changed here), "default" or "preset" (of a material)
    written  as it stands in the case
    """

    value: Any
    unit: str
    origin: str
    written: str


def toml_text(value: Any, unit: str) -> str:
    """A Python value as TOML: numbers get the SI unit, texts are quoted, sequences become arrays.

    Raises TypeError for anything else.
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
    """A case: the text of a case file and the changes made to it.

    case["contact.friction"] = 0.2         a number in SI units
    case["motion.preload"] = "0.5 um"      or a text with its unit
    case["skin.layers[1].thickness"]       1.8e-4; SI number, list of them, or text
    case["slider.start[0]"]                4.5e-3; one entry of a list, to read and to set
    case["readout.taxels"] = {"rows": 4, "columns": 4}   a table, or a list of tables

    A wrong key or value raises CaseError at once. Values that do not fit together, and missing ones, raise it when
    the case is used: by `check`, `run`, `sweep`, or reading back.
    """

    def __init__(self, text: str, path: str = "case.toml") -> None:
        """text: TOML as in a case file. path: names it in messages; files that it names lie in the same folder."""
        self._original, self._path = text, path
        self._edits: dict[str, str] = {}
        solver.load().check_values(self)

    @classmethod
    def from_file(cls, path: str | os.PathLike) -> "Case":
        """Reads and checks a case file. Raises CaseError."""
        try:
            text = files.read_text(path, LARGEST)
        except OSError as error:
            raise CaseError(f"the case {os.fspath(path)} cannot be read: {error.strerror}\n  = check its name") from error
        return cls(text, os.fspath(path)).check()

    @classmethod
    def from_text(cls, text: str, folder: str | os.PathLike = ".") -> "Case":
        """Takes the text of a case; files that it names are looked for in `folder`. Raises CaseError."""
        return cls(text, os.path.join(os.fspath(folder), "case.toml")).check()

    def check(self) -> "Case":
        """Checks the whole case and returns it. Raises CaseError with every mistake."""
        solver.load().values(self)
        return self

    def copy(self) -> "Case":
        """A case of its own with the same values."""
        twin = Case.__new__(Case)  # the text was checked when this one was made
        twin._original, twin._path, twin._edits = self._original, self._path, dict(self._edits)
        return twin

    def __setitem__(self, key: str, value: Any) -> None:
        edit = _text_of(key, value)
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
        """The value of a key with its unit and origin. Raises CaseError for keys that the case does not have."""
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
        """Every value of the case by key, defaults and material presets included."""
        return {key: Value(*value) for key, value in solver.load().values(self).items()}

    @property
    def text(self) -> str:
        """The TOML text with all changes in place; comments and order are kept."""
        return solver.load().case_text(self)

    def _edit_list(self) -> list[str]:
        return [f"{key}={text}" for key, text in self._edits.items()]

    def __repr__(self) -> str:
        changes = ", ".join(self._edit_list())
        return f"Case({self._path}{'; ' + changes if changes else ''})"


def _text_of(key: str, value: Any) -> str:
    """A value of a key as TOML; a table, or a list of tables, by the keys of its entries."""
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{name} = {_text_of(f'{key}.{name}', entry)}" for name, entry in value.items()) + "}"
    if isinstance(value, (list, tuple)) and value and all(isinstance(entry, Mapping) for entry in value):
        return "[" + ", ".join(_text_of(f"{key}[{i}]", entry) for i, entry in enumerate(value)) + "]"
    return toml_text(value, solver.load().key_unit(key) or "")


def _no_such_key(key: str) -> str:
    if solver.load().key_unit(key) is not None:
        return f"{key} has no value in this case"
    nearest = solver.load().nearest_key(key)
    return f"unknown key {key}" + (f"\n  = did you mean {nearest}?" if nearest else "")
