# SPDX-License-Identifier: Apache-2.0
"""The output folder of one run, as arrays and plain dictionaries."""

import contextlib
import csv
import pathlib
import tomllib
from typing import NamedTuple

import numpy

from .errors import CaseError
from .reading import files, labelled
from .reading.hdf5 import open_hdf5
from .reading.sliders import cases_of_sliders
from .reading.unfinished import mechanics, reason

TEXT_COLUMNS = ("phase",)
LARGEST_SUMMARY = 64 << 20  # a warning for each instant of a long motion


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


def name_and_unit(title):
    """Parts of a column's title: "slider.start[0] [m]" is ("slider.start[0]", "m"); the unit is "" without one."""
    name, opening, unit = title.rpartition(" [")
    return (name, unit.removesuffix("]")) if opening else (title, "")


def read_table(path, needs=()):
    """Reads a table of the results, such as signals.csv.

    needs  columns that it must have

    Raises FileNotFoundError when it is missing, CaseError when it is damaged.
    """
    with whole(path):
        return _table(needs, *files.read_rows(path))


def _table(needs, header, *rows):
    titles = [name_and_unit(title) for title in header]
    cells = zip(*rows) if rows else ([] for _ in titles)
    columns, units = {}, {}
    for (name, unit), values in zip(titles, cells):
        units[name] = unit
        if name in TEXT_COLUMNS:
            columns[name] = numpy.array(values, dtype=str)
        else:
            columns[name] = numpy.array([value or "nan" for value in values], dtype=float)
    for name in needs:
        if name not in columns:
            raise ValueError(f"it has no column {name}")
    return Table(columns, units)


def read_json(path):
    """The object in a JSON file; empty when it is missing. Raises CaseError when it is damaged."""
    try:
        found = files.read_json(path, LARGEST_SUMMARY)
    except FileNotFoundError:
        return {}
    if not isinstance(found, dict):
        raise CaseError(f"{path} is damaged: it is not a JSON object\n  = run the case again")
    return found


def _object(parent, name):
    found = parent.get(name, {}) if isinstance(parent, dict) else None
    if not isinstance(found, dict):
        raise ValueError(f"{name} is not an object")
    return found


@contextlib.contextmanager
def whole(path):
    """Turns what a damaged file raises into a CaseError that names it."""
    try:
        yield
    except CaseError:
        raise
    except (csv.Error, ValueError, TypeError, KeyError, IndexError, AttributeError, RecursionError) as error:
        raise CaseError(f"{path} is damaged: {error}\n  = run the case again") from error


class Results:
    """The results that a run has written into its folder.

    signals, sampled  Table; see the documentation of the columns
    taxels, circuit   Table, or None in runs without; sampled_taxels and sampled_circuit likewise
    water             Table of what the water does under the law poroelastic, or None
    errors            dict of table name to Table: stated errors of the signals, same columns; empty without
    metrics           dict of name to Metric
    summary, manifest dict, as in the files; empty when the file is missing
    circuit_words     dict: name, words and top_potential of the circuit; empty in folders of earlier versions
    case              dict of the case file, quantities as texts
    complete          False for a run that has not ended: it gives place, height and forces of the slider and the
                      metrics of the contact alone, and where its ion transport gave up all signals until then

    Raises FileNotFoundError, with what the run is at, when the folder holds no signals.csv, and CaseError when a file
    in it is damaged.
    """

    def __init__(self, folder, keep=None, *, unfinished=False):
        """
        keep        whatever must live as long as the folder is needed, such as the owner of a temporary one
        unfinished  take a run that has not ended too, once its mechanics is finished
        """
        self._keep = keep
        self.folder = pathlib.Path(folder)
        self.manifest = read_json(self.folder / "manifest.json")
        tables = all((self.folder / f"{name}.csv").exists() for name in ("signals", "sampled"))
        self.complete = tables and not self._gave_up()
        tables = tables and (self.complete or unfinished)
        if tables:
            self.signals = read_table(self.folder / "signals.csv", ["time"])
            self.sampled = read_table(self.folder / "sampled.csv", ["time"])
        else:
            self._take_mechanics(unfinished)
        self.taxels, self.circuit, self.sampled_taxels, self.sampled_circuit = (
            read_table(path) if path.exists() else None for path in (
                self.folder / f"{name}.csv" for name in ("taxels", "circuit", "sampled_taxels", "sampled_circuit")))
        water = self.folder / "water.csv"
        self.water = read_table(water) if water.exists() else None
        self.errors = {name: read_table(path) for name in ("signals", "sampled", "taxels", "circuit", "water")
                       if (path := self.folder / f"{name}_error.csv").exists()}
        self.summary = read_json(self.folder / "summary.json")
        if tables:
            with whole(self.folder / "summary.json"):
                self.metrics = {name: Metric(entry["value"], entry["unit"])
                                for name, entry in _object(self.summary, "metrics").items()}
        with whole(self.folder / "summary.json"):
            self.circuit_words = {name: str(text) for name, text in _object(self.summary, "circuit").items()}
        case = self.folder / "case.toml"
        self.case, self.sliders = {}, [{}]
        if case.exists():
            with whole(case):
                self.sliders = cases_of_sliders(tomllib.loads(files.read_text(case, files.LARGEST_JSON)))
                self.case = self.sliders[0]

    def _gave_up(self):
        """True where a study did not come to its end: the tables of such a run end where it gave up."""
        with whole(self.folder / "manifest.json"):
            stages = _object(self.manifest, "stages")
            return any(_object(stages, name).get("state", "finished") != "finished"
                       for name in ("mechanics", "strain", "electrochemistry"))

    def _take_mechanics(self, wanted):
        found = mechanics(self.folder / "results.h5") if wanted else None
        if found is None:
            with whole(self.folder / "manifest.json"):
                message = reason(self.folder, self.manifest)
            raise FileNotFoundError(message)
        columns, units, metrics = found
        self.signals, self.sampled = Table(columns, units), Table({"time": numpy.empty(0)}, {"time": "s"})
        self.metrics = {name: Metric(value, unit) for name, value, unit in metrics}

    @property
    def not_converging(self) -> dict[str, str]:
        """Metrics that finer meshes or steps change on and on, each with the reason."""
        return self.summary.get("not_converging", {})

    def stated_error(self, name):
        """The stated error of a metric in its unit; None where none is stated or the metric does not converge."""
        parts = self.summary.get("error_parts", {}).get(name)
        return None if parts is None or name in self.not_converging else sum(parts.values())

    def band(self, table, name):
        """Lower and upper end of a signal within its stated error; None where none is stated."""
        errors = self.errors.get(table)
        if errors is None or name not in errors or len(errors[name]) != len(getattr(self, table)[name]):
            return None
        values = getattr(self, table)[name]
        return values - errors[name], values + errors[name]

    @property
    def warnings(self) -> list[str]:
        """Warnings that a reader of the results must know."""
        return self.summary.get("warnings", [])

    def to_xarray(self):
        """The signals over time as an xarray.Dataset. Raises ImportError when xarray is missing."""
        return self.signals.to_xarray()

    def __repr__(self) -> str:
        return f"Results({self.folder}: {len(self.signals['time'])} rows, {len(self.metrics)} metrics)"

    def open_fields(self):
        """results.h5 as an h5py.File, for the strain, the ions and the contact maps.

        Raises CaseError when the file is damaged or leads to other files.
        """
        return open_hdf5(self.folder / "results.h5")

    def phases(self):
        """The phases in order, as PhaseSpan; empty in runs from a strain file and in those that have not ended."""
        if "phase" not in self.signals:
            return []
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
