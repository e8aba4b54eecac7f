# SPDX-License-Identifier: Apache-2.0
"""Results of a sweep, read from its folder, and the runs that a report draws, in the order of one swept key."""

import copy
import functools
import pathlib
import re
from typing import NamedTuple

import numpy

from .reading import files, labelled
from .results import Results, name_and_unit, read_json, whole
from .words import quantity, short

FRICTION = "contact.friction"
POINT = re.compile(r"points/(?!\.{1,2}$)[^/\0]+")
NAMES = {FRICTION: "friction coefficient µ", "coupling.coefficient": "coupling coefficient k",
         "motion.preload": "preload", "motion.stroke": "stroke", "electrochemistry.diffusivity": "diffusivity"}
LONGEST_VALUE = 24  # letters of a swept text in a label
MOST_EXPLORED = 200  # points of a grid of which every curve is kept
TYPICAL_FRICTION = 0.3  # the paper's representative curves are drawn at one coefficient within its sweep


def symbol(key):
    """Symbol of a key for labels: "µ" for the friction coefficient, else the key's last word, such as "preload"."""
    return "µ" if key == FRICTION else key.rsplit(".", maxsplit=1)[-1]


def value_text(value, unit):
    """Text of a swept value for a label: number with prefixed unit, such as "0.5 µm", or a text cut to fit (unit "")."""
    return quantity(value, unit, 4) if unit else short(value, LONGEST_VALUE)


class Point(NamedTuple):
    """Point of a sweep: one run, a row of sweep.csv.

    number   number of the point in the sweep
    folder   output folder of the run
    values   dict of swept key to its value: number in SI units, or text
    status   "finished", or another word for a point without results
    reason   why the point failed; "" when it did not
    metrics  dict of metric name to its value in SI units; metrics that the point lacks are left out
    """

    number: int
    folder: pathlib.Path
    values: dict
    status: str
    reason: str
    metrics: dict


class Sweep:
    """Results of a parameter sweep, read from its folder: the points with their scalar results. len(sweep) counts the
    points.

    points    list of Point, in the order of sweep.csv
    keys      dict of swept key to its SI unit; "1" for pure numbers, "" for keys whose values are texts
    units     dict of metric name to its SI unit
    manifest  dict: contents of manifest.json; {} when the file is missing

    Raises FileNotFoundError when the folder holds no sweep.csv, CaseError when a file in it is damaged.
    """

    def __init__(self, folder, keep=None):
        """Reads a sweep.

        folder  output folder of the sweep
        keep    object that must live as long as the folder is needed, such as the owner of a temporary folder
        """
        self._keep = keep
        self.folder = pathlib.Path(folder)
        path = self.folder / "sweep.csv"
        if not path.exists():
            raise FileNotFoundError(f"{self.folder} holds no sweep.csv: name the folder of a sweep")
        with whole(path):
            header, *rows = files.read_rows(path)
            titles = [name_and_unit(title) for title in header]
            status = header.index("status")
            self.keys = dict(titles[2:status])
            self.units = dict(titles[status + 2:])
            self.points = [self._point(titles, status, row) for row in rows]
        self.manifest = read_json(self.folder / "manifest.json")

    def values(self, key):
        """Values of a swept key, as an array [points] of numbers in SI units or of texts."""
        return numpy.array([point.values[key] for point in self.points])

    def metric(self, name):
        """Values of a metric, as an array [points] in SI units; NaN where a point lacks
        it. Raises KeyError for unknown names."""
        if name not in self.units:
            raise KeyError(f"{name} is not a metric of this sweep; it has {', '.join(self.units) or 'none yet'}")
        return numpy.array([point.metrics.get(name, numpy.nan) for point in self.points])

    def result(self, index):
        """Reads the Results of a point; `index` is its index in `points`. Raises FileNotFoundError when it has not finished."""
        return Results(self.points[index].folder, self._keep)

    def to_xarray(self):
        """Converts the metrics to an xarray.Dataset over the points. Raises ImportError when xarray is missing."""
        return labelled.sweep_dataset(self)

    def __len__(self):
        return len(self.points)

    def __repr__(self):
        finished = sum(point.status == "finished" for point in self.points)
        return f"Sweep({self.folder}: {finished} of {len(self)} points finished, over {', '.join(self.keys)})"

    def _point(self, titles, status, row):
        values = {name: float(text) if unit else text for (name, unit), text in zip(titles[2:status], row[2:status])}
        metrics = {name: float(text) for (name, _), text in zip(titles[status + 2:], row[status + 2:]) if text}
        if len(row) != len(titles) or not POINT.fullmatch(row[1]):
            raise ValueError(f"row {row[0][:20]} is none of a sweep")
        return Point(int(row[0]), self.folder / row[1], values, row[status], row[status + 1], metrics)


class Member(NamedTuple):
    """Run of a Study.

    value    value of the study's key in this run, in SI units
    results  Results of the run
    number   number of its point in the sweep; 0 for a single run
    values   dict of all swept keys of that point to their values; {} for a single run
    """

    value: float
    results: Results
    number: int = 0
    values: dict = {}


class Study:
    """Runs that the figures of a report show: the finished points of a sweep along one key, or a single run.

    In a grid of several keys the members are the points at which the other keys have the values of the first finished point;
    `slices` and `whole` have the other points of a grid of at most 200 points.

    key, name, unit  the key along which the members lie, its name in words and its SI unit; key is "point" where no swept key
                     is a number
    members          list of Member, in ascending order of the key's value
    scattered        True if other keys vary along the members, too, as in a sampled sweep: they do not form a curve
    note             text that says which points of the sweep are not shown; "" when all are
    at               text of the values of the other keys of a grid, such as "preload = 1 N"; "" without a grid
    sweep            the Sweep; None for a single run

    Raises FileNotFoundError when the folder holds no results or no point has finished, CaseError for damaged files.
    """

    def __init__(self, folder, results=None):
        """Reads a study.

        folder   output folder of a sweep or a run
        results  Results of the folder's run, where they have been read already; None to read the folder
        """
        folder = pathlib.Path(folder)
        self.folder, self.note, self.at, self.scattered = folder, "", "", False
        self._more = []  # points of the other slices
        self.sweep = Sweep(folder) if results is None and (folder / "sweep.csv").exists() else None
        if self.sweep:
            self._take_members()
        else:
            results = results or Results(folder)
            friction = results.case.get("contact", {}).get("friction", 0.0)
            self.key, self.members = FRICTION, [Member(float(friction), results)]
            self.unit = "1"
        self.name = NAMES.get(self.key, self.key)

    def _take_members(self):
        numeric = self.numeric_keys
        finished = [point for point in self.sweep.points if point.status == "finished"]
        if not finished:
            raise FileNotFoundError(f"{self.folder}: no point of this sweep has finished")
        self.key = FRICTION if FRICTION in numeric else numeric[0] if numeric else "point"
        self.unit = self.sweep.keys.get(self.key, "1")
        slices = {}
        for point in finished:
            slices.setdefault(tuple(value for key, value in point.values.items() if key != self.key), []).append(point)
        shown, *more = slices.values()
        self.scattered = len(shown) < min(2, len(finished))
        if self.scattered:
            shown = finished
            self.note = f"{' and '.join(self.sweep.keys)} vary at once: every finished point is shown."
        self._take(shown)
        if more and not self.scattered:
            self._name_slice(len(finished))
            self._more = more if len(finished) <= MOST_EXPLORED else []

    def _take(self, points):
        self.members = sorted((Member(point.values.get(self.key, point.number), Results(point.folder), point.number,
                                      point.values) for point in points), key=lambda member: member.value)

    def _name_slice(self, finished):
        values = {key: value_text(value, self.sweep.keys[key]) for key, value in self.members[0].values.items() if key != self.key}
        self.at = ", ".join(f"{symbol(key)} = {value}" for key, value in values.items())
        at = ", ".join(f"{key} = {value}" for key, value in values.items())
        self.note = f"Shown at {at}: {len(self.members)} of {finished} finished points."

    @functools.cached_property
    def slices(self):
        """Studies along the key in a grid of several keys, one for each combination of values of the other keys, this study
        first; [self] without a grid."""
        finished = len(self.members) + sum(map(len, self._more))
        found = [self]
        for points in self._more:
            each = self._without_slices()
            each._take(points)
            each._name_slice(finished)
            found.append(each)
        return found

    @functools.cached_property
    def whole(self):
        """Study of every finished point of a grid of several keys, `scattered` as several keys vary; the study itself without
        a grid."""
        if not self._more:
            return self
        found = self._without_slices()
        found.members = [member for each in self.slices for member in each.members]
        found.scattered, found.note, found.at = True, "", ""
        return found

    def _without_slices(self):
        found = copy.copy(self)
        for name in ("slices", "whole", "typical"):
            found.__dict__.pop(name, None)
        found._more = []
        return found

    @property
    def numeric_keys(self):
        """Names of the swept keys whose values are numbers; [] for a single run."""
        return [key for key, unit in self.sweep.keys.items() if unit] if self.sweep else []

    @property
    def single(self):
        """True if the study has only one member."""
        return len(self.members) == 1

    @functools.cached_property
    def typical(self):
        """Member that represents the study: friction coefficient nearest to 0.3, or the middle one along another key."""
        if self.key == FRICTION:
            return min(self.members, key=lambda member: abs(member.value - TYPICAL_FRICTION))
        return self.members[len(self.members) // 2]

    def label(self, member):
        """Label of a member: symbol and value of the key, such as "µ = 0.3"; of all swept keys in a scattered study."""
        if not self.scattered:
            return f"{symbol(self.key)} = {value_text(member.value, self.unit)}"
        return ", ".join(f"{symbol(key)} = {value_text(member.values[key], unit)}" for key, unit in self.sweep.keys.items())

    def panel_label(self, member):
        """Title of a member's small panel: symbol and value of the key, in a scattered study behind the number of the point."""
        if not self.scattered:
            return self.label(member)
        return f"point {member.number}, {symbol(self.key)} = {value_text(member.value, self.unit)}"

    def axis_label(self, key=None):
        """Label of an axis along a swept key: name and SI unit in brackets; None for the study's own key."""
        key = key or self.key
        unit = self.sweep.keys.get(key, "1") if self.sweep else "1"
        name = NAMES.get(key, key)
        return name if unit == "1" else f"{name} [{unit}]"

    def metric(self, name):
        """Values of a metric, as a list with one number in SI units for each member; NaN where a member lacks it."""
        return [value if (value := member.results.metrics.get(name, (None,))[0]) is not None else float("nan")
                for member in self.members]

    def errors(self, name):
        """Reported relative error estimates [1] of a metric, as a list with one number for each member; 0 where it has none."""
        return [0.0 if name in member.results.not_converging
                else member.results.summary.get("error_estimate", {}).get(name) or 0.0 for member in self.members]


def open_results(folder):
    """Reads an output folder: returns Results for a run, a Sweep for a sweep.

    A run that has not ended can be read once its mechanics (Study 1) is finished; `Results.complete` is False then.

    Raises FileNotFoundError when the folder holds nothing to read yet, CaseError when a file in it is damaged.
    """
    folder = pathlib.Path(folder)
    return Sweep(folder) if (folder / "sweep.csv").exists() else Results(folder, unfinished=True)
