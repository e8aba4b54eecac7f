# SPDX-License-Identifier: Apache-2.0
"""The folder of a sweep, and what a report draws: members in the order of one swept key."""

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
TYPICAL_FRICTION = 0.3  # the paper's representative curves are drawn at one coefficient within its sweep


def symbol(key):
    """Symbol of a key for labels: "µ", "preload"."""
    return "µ" if key == FRICTION else key.rsplit(".", maxsplit=1)[-1]


def value_text(value, unit):
    """A swept value with its prefixed unit, or a text cut to the length of a label."""
    return quantity(value, unit, 4) if unit else short(value, LONGEST_VALUE)


class Point(NamedTuple):
    """One row of sweep.csv. values: SI number, or text, by key."""

    number: int
    folder: pathlib.Path
    values: dict
    status: str
    reason: str
    metrics: dict


class Sweep:
    """sweep.csv as points; `keys` maps each swept key to its SI unit, "" for texts.

    points, units  list of Point, and the SI unit of each metric by name

    Raises FileNotFoundError when the folder holds no sweep.csv.
    """

    def __init__(self, folder, keep=None):
        """keep: whatever must live as long as the folder is needed, such as the owner of a temporary one."""
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
        """The values of a swept key as an array [points]: SI numbers, or texts."""
        return numpy.array([point.values[key] for point in self.points])

    def metric(self, name):
        """One metric as an array [points]; NaN where a point has none."""
        if name not in self.units:
            raise KeyError(f"{name} is not a metric of this sweep; it has {', '.join(self.units) or 'none yet'}")
        return numpy.array([point.metrics.get(name, numpy.nan) for point in self.points])

    def result(self, index):
        """The Results of a finished point, by its place in `points`."""
        return Results(self.points[index].folder, self._keep)

    def to_xarray(self):
        """Metrics over the points as an xarray.Dataset. Raises ImportError when xarray is missing."""
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
    """One run of a study. value: on the study's key; number, values: of its point in the sweep."""

    value: float
    results: Results
    number: int = 0
    values: dict = {}


class Study:
    """The source of figures: the members of a sweep along one key, or the one run there is.

    key, name, unit  the swept key, its name in words, its unit; "point" where no key is a number
    members          in ascending order of the value
    scattered        True where other keys vary along the members too, as in a sampled design: they are points, no curve
    note             what of the sweep is not shown; "" for nothing
    """

    def __init__(self, folder, results=None):
        """results: of the folder's run, where they have been read already"""
        folder = pathlib.Path(folder)
        self.folder, self.note, self.scattered = folder, "", False
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
        others = [key for key in self.sweep.keys if key != self.key]
        first = finished[0].values
        shown = [point for point in finished if all(point.values[key] == first[key] for key in others)]
        self.scattered = len(shown) < min(2, len(finished))
        if self.scattered:
            shown = finished
            self.note = f"{' and '.join(self.sweep.keys)} vary at once: every finished point is shown."
        elif len(shown) < len(finished):
            at = ", ".join(f"{key} = {value_text(first[key], self.sweep.keys[key])}" for key in others)
            self.note = f"Shown at {at}: {len(shown)} of {len(finished)} finished points."
        self.members = sorted((Member(point.values.get(self.key, point.number), Results(point.folder), point.number,
                                      point.values) for point in shown), key=lambda member: member.value)

    @property
    def numeric_keys(self):
        """Swept keys whose values are numbers."""
        return [key for key, unit in self.sweep.keys.items() if unit] if self.sweep else []

    @property
    def single(self):
        """True when there is one run only."""
        return len(self.members) == 1

    @functools.cached_property
    def typical(self):
        """The member that stands for all: µ nearest 0.3, or the middle one along another key."""
        if self.key == FRICTION:
            return min(self.members, key=lambda member: abs(member.value - TYPICAL_FRICTION))
        return self.members[len(self.members) // 2]

    def label(self, member):
        """Value with symbol: "µ = 0.3"; of a scattered study all values."""
        if not self.scattered:
            return f"{symbol(self.key)} = {value_text(member.value, self.unit)}"
        return ", ".join(f"{symbol(key)} = {value_text(member.values[key], unit)}" for key, unit in self.sweep.keys.items())

    def panel_label(self, member):
        """Title of a small panel: value with symbol; of a scattered study its point and the value along the key."""
        if not self.scattered:
            return self.label(member)
        return f"point {member.number}, {symbol(self.key)} = {value_text(member.value, self.unit)}"

    def axis_label(self, key=None):
        """For an axis along the members, or along another swept key."""
        key = key or self.key
        unit = self.sweep.keys.get(key, "1") if self.sweep else "1"
        name = NAMES.get(key, key)
        return name if unit == "1" else f"{name} [{unit}]"

    def metric(self, name):
        """One metric of all members; NaN where a member lacks it."""
        return [value if (value := member.results.metrics.get(name, (None,))[0]) is not None else float("nan")
                for member in self.members]

    def errors(self, name):
        """Stated relative errors of a metric of all members; 0 where none is stated."""
        return [0.0 if name in member.results.not_converging
                else member.results.summary.get("error_estimate", {}).get(name) or 0.0 for member in self.members]


def open_results(folder):
    """Results of a run's folder, or Sweep of a sweep's. Of a run in its ion transport the mechanics can be read already.

    Raises FileNotFoundError when the folder holds nothing to read yet.
    """
    folder = pathlib.Path(folder)
    return Sweep(folder) if (folder / "sweep.csv").exists() else Results(folder, unfinished=True)
