# SPDX-License-Identifier: Apache-2.0
"""Results of one run, read from its output folder into numpy arrays and dictionaries."""

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
    """Scalar result of a run, as in summary.json: its value, None when not finite, and its SI unit, "1" for pure numbers."""

    value: float | None
    unit: str


class PhaseSpan(NamedTuple):
    """Time span of one phase of the motion: number of the cycle, name of the phase, start and end [s]."""

    cycle: int
    phase: str
    start: float
    end: float


class Table:
    """Table of signals over time: `table["time"]` [s] and one column for each signal, all of one length.

    columns  dict of name to numpy array [rows], in the order of the file; empty cells are NaN, "phase" holds texts
    units    dict of name to SI unit; "1" for pure numbers, "" for cycle and phase
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
        """Converts the table to an xarray.Dataset over time. Raises ImportError when xarray is missing."""
        return labelled.table_dataset(self)

    def __getitem__(self, name):
        return self.columns[name]

    def __contains__(self, name):
        return name in self.columns

    def has(self, *names):
        """True if the table has every named column, and each holds at least one finite number."""
        return all(name in self and numpy.isfinite(self[name]).any() for name in names)

    def at(self, name, time):
        """Interpolates a column linearly at the instants `time` [s]; outside the table its first or last value holds."""
        return numpy.interp(time, self["time"], self[name])


def name_and_unit(title):
    """Splits the title of a column into name and unit: "slider.start[0] [m]" gives ("slider.start[0]", "m"); "" for no unit."""
    name, opening, unit = title.rpartition(" [")
    return (name, unit.removesuffix("]")) if opening else (title, "")


def read_table(path, needs=()):
    """Reads a CSV table of a run, such as signals.csv, as a Table.

    needs  names of columns that it must have

    Raises FileNotFoundError when the file is missing, CaseError when it is damaged or lacks a column.
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
    """Reads a JSON file that holds an object, as a dict; {} when the file is missing. Raises CaseError when it is damaged."""
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
    """Context in which a file is read: turns exceptions that a damaged file causes into a CaseError that names `path`."""
    try:
        yield
    except CaseError:
        raise
    except (csv.Error, ValueError, TypeError, KeyError, IndexError, AttributeError, RecursionError) as error:
        raise CaseError(f"{path} is damaged: {error}\n  = run the case again") from error


class Results:
    """Results of a run, read from its output folder.

    signals           Table with a row for each time step of the solver
    sampled           Table with a row for each sampling interval of the readout: currents are the charge gained over the
                      interval, divided by the interval
    taxels, circuit   Table of the taxels and of the readout circuit, by time step; None in runs without them
    sampled_taxels, sampled_circuit  Table of the same signals by sampling interval, or None
    water             Table of the pore water under the coupling law poroelastic; None under other laws
    errors            dict of table name to Table with the same columns: reported error estimate of each signal, as half the
                      width of its error band; {} when the run has none
    metrics           dict of name to Metric: scalar results
    summary, manifest dict: contents of summary.json and manifest.json; {} when the file is missing
    circuit_words     dict of texts that describe the readout circuit: name, words, top_potential; {} in folders of earlier
                      versions
    case              dict: contents of case.toml, quantities as texts; with several sliders, as a case of the first one alone
    sliders           list of dict: one such case for each slider; [{}] when case.toml is missing
    complete          False for a run that has not ended, or whose solver gave up. `signals` holds position, height and forces
                      of the slider then, and `metrics` only those of the contact; where the solver gave up, `signals` holds
                      all signals until then

    Raises FileNotFoundError, with the state of the run, when the folder holds no finished run, and CaseError when a file in
    it is damaged.
    """

    def __init__(self, folder, keep=None, *, unfinished=False):
        """Reads the results in a folder.

        folder      output folder of a run
        keep        object that must live as long as the folder is needed, such as the owner of a temporary folder
        unfinished  True to read a run that has not ended, too, once its mechanics (Study 1) is finished
        """
        self._keep = keep
        self.folder = pathlib.Path(folder)
        if self.folder.is_file():
            raise CaseError(f"{folder} is a file, and the folder of a run is wanted\n  = run a case first: ionskin run CASE.toml -o DIR")
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
        """True if a stage of the run did not finish: the tables end at the instant at which its solver gave up."""
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
        """Metrics that do not converge under refinement of mesh or time step, as a dict of name to the reason; {} for none."""
        return self.summary.get("not_converging", {})

    def stated_error(self, name):
        """Reported error estimate of a metric, in the metric's unit; None when it has none or the metric does not converge."""
        parts = self.summary.get("error_parts", {}).get(name)
        return None if parts is None or name in self.not_converging else sum(parts.values())

    def band(self, table, name):
        """Error band of a signal: arrays [rows] of its lower and upper end, in the signal's unit.

        table  name of the table, such as "signals" or "sampled"
        name   name of the column

        None when the run has no error estimate of the signal.
        """
        errors = self.errors.get(table)
        if errors is None or name not in errors or len(errors[name]) != len(getattr(self, table)[name]):
            return None
        values = getattr(self, table)[name]
        return values - errors[name], values + errors[name]

    @property
    def warnings(self) -> list[str]:
        """Warnings of the run that a reader of its results should know; [] for none."""
        return self.summary.get("warnings", [])

    def to_xarray(self):
        """Converts `signals` to an xarray.Dataset over time. Raises ImportError when xarray is missing."""
        return self.signals.to_xarray()

    def __repr__(self) -> str:
        return f"Results({self.folder}: {len(self.signals['time'])} rows, {len(self.metrics)} metrics)"

    def open_fields(self):
        """Opens results.h5, which holds the strain history, the ion fields and the contact maps, as an h5py.File to read.

        Raises FileNotFoundError when the file is missing, and CaseError when it is damaged or refers to other files.
        """
        return open_hdf5(self.folder / "results.h5")

    def phases(self):
        """Phases of the motion in order of time, as a list of PhaseSpan; [] for runs from
        a strain file and for unfinished runs."""
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
