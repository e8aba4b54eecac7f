# SPDX-License-Identifier: Apache-2.0
"""The output folder of one run, as arrays and plain dictionaries."""

import json
import pathlib
import tomllib
from typing import NamedTuple

import numpy

from . import labelled

TEXT_COLUMNS = ("phase",)


class Metric(NamedTuple):
    """One named quantity of summary.json; the value is None when it is not finite."""

    value: float | None
    unit: str


class PhaseSpan(NamedTuple):
    """One phase of one cycle: start and end in seconds."""

    cycle: int
    phase: str
    start: float
    end: float


class Table:
    """Columns over time by name, with units. Empty entries are NaN.

    columns  numpy array [rows] by name, in the order of the file
    units    SI unit by name, "1" for pure numbers, "" for cycle and phase
    """

    def __init__(self, columns: dict[str, numpy.ndarray], units: dict[str, str]) -> None:
        self.columns = columns
        self.units = units

    def __iter__(self):
        return iter(self.columns)

    def __repr__(self) -> str:
        names = ", ".join(f"{name} [{unit}]" if unit else name for name, unit in self.units.items())
        return f"Table of {len(next(iter(self.columns.values()), ()))} rows: {names}"

    def to_xarray(self):
        """The columns over time as an xarray.Dataset. Raises ImportError when xarray is missing."""
        return labelled.table_dataset(self)

    def __getitem__(self, name):
        return self.columns[name]

    def __contains__(self, name):
        return name in self.columns

    def has(self, *names):
        """True when every named column is there and holds at least one number."""
        return all(name in self and numpy.isfinite(self[name]).any() for name in names)

    def at(self, name, time):
        """The column at instants in seconds, linear between the rows."""
        return numpy.interp(time, self["time"], self[name])


def read_table(path):
    """Reads signals.csv or sampled.csv. Raises FileNotFoundError when it is missing."""
    header, *rows = pathlib.Path(path).read_text(encoding="utf-8").splitlines()
    titles = [title.rstrip("]").split(" [") for title in header.split(",")]
    cells = zip(*(row.split(",") for row in rows)) if rows else ([] for _ in titles)
    columns, units = {}, {}
    for (name, *unit), values in zip(titles, cells):
        units[name] = unit[0] if unit else ""
        if name in TEXT_COLUMNS:
            columns[name] = numpy.array(values, dtype=str)
        else:
            columns[name] = numpy.array([value or "nan" for value in values], dtype=float)
    return Table(columns, units)


def read_json(path):
    """The content of a JSON file; empty when it is missing."""
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}


class Results:
    """What a run has written into its folder.

    signals, sampled  Table; see the documentation of the columns
    taxels, circuit   Table, or None in runs without
    metrics           dict of name to Metric
    summary, manifest dict, as in the files; empty when the file is missing
    case              dict of the case file, quantities as texts

    Raises FileNotFoundError when the folder holds no signals.csv.
    """

    def __init__(self, folder, keep=None):
        """keep: whatever must live as long as the folder is needed, such as the owner of a temporary one."""
        self._keep = keep
        self.folder = pathlib.Path(folder)
        if not (self.folder / "signals.csv").exists():
            raise FileNotFoundError(f"{self.folder} holds no signals.csv: name the folder of a finished run")
        self.signals = read_table(self.folder / "signals.csv")
        self.sampled = read_table(self.folder / "sampled.csv")
        self.taxels, self.circuit = (read_table(path) if path.exists() else None
                                     for path in (self.folder / "taxels.csv", self.folder / "circuit.csv"))
        self.summary = read_json(self.folder / "summary.json")
        self.manifest = read_json(self.folder / "manifest.json")
        self.metrics = {
            name: Metric(entry["value"], entry["unit"]) for name, entry in self.summary.get("metrics", {}).items()
        }
        case = self.folder / "case.toml"
        self.case = tomllib.loads(case.read_text(encoding="utf-8")) if case.exists() else {}

    @property
    def warnings(self) -> list[str]:
        """What a reader of the results must know."""
        return self.summary.get("warnings", [])

    def to_xarray(self):
        """The signals over time as an xarray.Dataset. Raises ImportError when xarray is missing."""
        return self.signals.to_xarray()

    def __repr__(self) -> str:
        return f"Results({self.folder}: {len(self.signals['time'])} rows, {len(self.metrics)} metrics)"

    def open_fields(self):
        """results.h5 as an h5py.File, for the strain, the ions and the contact maps."""
        import h5py  # costs a quarter of a second that most readers need not pay

        return h5py.File(self.folder / "results.h5")

    def phases(self):
        """The phases in order, as PhaseSpan; empty in runs from a strain file."""
        time, cycle, phase = (self.signals[name] for name in ("time", "cycle", "phase"))
        spans = []
        for row in range(len(time)):
            if not phase[row]:
                continue
            key = (int(cycle[row]), str(phase[row]))
            if not spans or (spans[-1].cycle, spans[-1].phase) != key:
                # A row belongs to the step that ends there, so a phase starts at the row before.
                spans.append(PhaseSpan(*key, time[max(row - 1, 0)], time[row]))
            else:
                spans[-1] = spans[-1]._replace(end=time[row])
        return spans
