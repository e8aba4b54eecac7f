# SPDX-License-Identifier: Apache-2.0
"""Trial of a study (one run of its case with other values), and its outcome."""

import contextlib
import difflib
import json
import os
import pathlib
import zipfile
from typing import Any, NamedTuple

import numpy

from ..case import Case
from ..errors import CaseError
from ..reading import files
from ..results import Results

TABLES = ("signals", "sampled", "sampled_taxels")
LARGEST = 1 << 30  # bytes of an outcome
LARGEST_NUMBER = 1e30  # in SI units; squares of larger ones, and single precision, would overflow


class Trial(NamedTuple):
    """Trial of a study: one evaluation that the study asks for.

    number  number of the trial, from 0
    values  dict of key to its value in SI units
    case    Case with these values; None where the study has no case
    """

    number: int
    values: dict
    case: Case | None = None


@contextlib.contextmanager
def _pending(path: pathlib.Path):
    """Context that yields a file to write; at its end the file gets the name `path`, whole."""
    pending = path.with_name(f"{path.name}.{os.getpid()}.pending")
    with open(pending, "wb") as file:
        yield file
        file.flush()
        os.fsync(file.fileno())
    os.replace(pending, path)


class Outcome:
    """Outcome of a trial: its metrics and signals, or the reason why it failed.

    metrics  dict of metric name to value in SI units
    units    dict of the names of metrics and columns to SI units; {} where the caller gave only numbers
    columns  dict of "signals/NAME", "sampled/NAME" or "sampled_taxels/NAME" to array [rows]; {} where the caller gave only
             numbers
    reason   why the trial failed; "" for a finished trial
    """

    def __init__(self, metrics: dict, units: dict, columns: dict | None = None, reason: str = "") -> None:
        self.metrics, self.units, self.columns, self.reason = metrics, units, columns or {}, reason

    @classmethod
    def of(cls, result: Any) -> "Outcome":
        """Makes an outcome of the Results of a run, a dict of metric name to number, or the exception with which a run
        ended.

        Raises CaseError for anything else.
        """
        if isinstance(result, Outcome):
            return result
        if isinstance(result, Exception):
            return cls({}, {}, reason=" ".join(str(result).split()) or type(result).__name__)
        if isinstance(result, Results):
            known = {name: one for name, one in result.metrics.items() if one.value is not None}
            tables = [table for table in TABLES if getattr(result, table) is not None]
            columns = {f"{table}/{name}": values for table in tables
                       for name, values in getattr(result, table).columns.items() if values.dtype.kind == "f"}
            units = {name: one.unit for name, one in known.items()}
            units |= {f"{table}/{name}": unit for table in tables for name, unit in getattr(result, table).units.items()}
            return cls({name: one.value for name, one in known.items()}, units, columns)
        if isinstance(result, dict):
            return cls({name: float(value) for name, value in result.items()}, {})
        raise CaseError(f"a result is the Results of a run, numbers by name, or an exception; not {type(result).__name__}")

    def require(self, names) -> None:
        """Requires that a finished outcome has all metrics in `names`. Raises CaseError for a name that it lacks."""
        for name in () if self.reason else names:
            if name not in self.metrics:
                near = difflib.get_close_matches(name, self.metrics, n=1)
                remedy = f"did you mean {near[0]}? " if near else ""
                raise CaseError(f"{name} is not a metric of these runs\n  = {remedy}known: {', '.join(self.metrics)}")

    def write(self, path: pathlib.Path) -> None:
        """Writes the outcome into one file (.npz), which appears when it is whole."""
        head = json.dumps({"metrics": self.metrics, "units": self.units, "reason": self.reason})
        with _pending(path) as file:
            numpy.savez_compressed(file, head=numpy.array(head), **self.columns)

    @staticmethod
    def keep(content: bytes, path: pathlib.Path) -> None:
        """Writes the bytes of an outcome's file that another machine made."""
        with _pending(path) as file:
            file.write(content)

    @classmethod
    def read(cls, path: pathlib.Path) -> "Outcome | None":
        """Reads an outcome from a file; None when it is missing or damaged, so that the trial is run again."""
        try:
            with files.open_ordinary(path, LARGEST) as content:
                with zipfile.ZipFile(content) as archive:
                    if sum(entry.file_size for entry in archive.infolist()) > LARGEST:
                        return None
                with numpy.load(content, allow_pickle=False) as arrays:
                    head = files.parse_json(str(arrays["head"]))
                    columns = {name: arrays[name] for name in arrays.files if name != "head"}
            found = cls(head["metrics"], head["units"], columns, head["reason"])
            return found if found._is_sound() else None
        except Exception:  # whatever a damaged archive raises
            return None

    @classmethod
    def read_back(cls, path: pathlib.Path) -> "Outcome":
        """Reads an outcome that was just written; a damaged file becomes an outcome that says so as its reason."""
        return cls.read(path) or cls({}, {}, reason="what it wrote cannot be read back: is the disk full?")

    def _is_sound(self) -> bool:
        """True if the outcome has the types and shapes that `of` gives it, and numbers of reasonable size."""
        metrics, units, columns = self.metrics, self.units, self.columns
        if not (isinstance(metrics, dict) and isinstance(units, dict) and isinstance(self.reason, str)):
            return False
        if not all(isinstance(value, (int, float)) and not isinstance(value, bool) and abs(value) <= LARGEST_NUMBER
                   for value in metrics.values()):
            return False
        if not all(isinstance(unit, str) for unit in units.values()) or (units and not set(metrics) <= set(units)):
            return False
        for name, values in columns.items():
            clock = columns.get(f"{name.split('/')[0]}/time")
            if name.split("/")[0] not in TABLES or values.dtype.kind != "f" or clock is None or values.ndim != 1:
                return False
            if values.shape != clock.shape or (numpy.abs(values) > LARGEST_NUMBER).any() or not (numpy.diff(clock) >= 0).all():
                return False
        return all(numpy.isfinite(columns[name]).all() for name in columns if name.endswith("/time"))
