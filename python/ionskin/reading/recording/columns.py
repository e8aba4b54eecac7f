# SPDX-License-Identifier: Apache-2.0
"""Columns of a recording, and their roles by the names that robots, ROS and force sensors give them."""

import os
import re

import numpy

from ... import solver
from ...errors import CaseError

# A role and the names that mean it, without the unit, in small letters. The first that fits counts.
AXES = "xyz"
NAMES = {
    "time": (r"(?:.*\.)?header\.stamp", r"(?:.*[./])?stamp", r"rosbagtimestamp", r"__time", r"timestamp(?:_(?:s|ms|us|ns))?",
             r"time(?:stamp)?(?:_(?:s|sec|ms|us|ns))?", r"t", r"elapsed(?:_time)?", r"seconds"),
    "seconds": (r"(?:.*[./_])?stamp[./_]secs?",),
    "nanoseconds": (r"(?:.*[./_])?stamp[./_](?:nsecs?|nanosecs?|nanosec)",),
    "height": (r"height", r"tip_height"),
    "force": (r"force", r"normal_force", r"force_n"),
    **{axis: (axis, rf"(?:.*[./])?(?:position|translation|pos)[./_]{axis}", rf"p(?:os)?_rs_r_{axis}", rf"p_?{axis}",
              rf"pos_?{axis}", rf"(?:tool|tcp|tip|ee)_?{axis}", rf"(?:actual_)?tcp_pose_{i}", rf"o_t_ee\[{12 + i}\]",
              rf"{axis}_(?:m|mm|um)")
       for i, axis in enumerate(AXES)},
    **{f"q{axis}": (rf"q_?{axis}", rf"(?:.*[./])?(?:orientation|rotation)[./_]{axis}", rf"q_rs_{axis}", rf"quat_{axis}")
       for axis in "xyzw"},
    **{f"f{axis}": (rf"f_?{axis}", rf"(?:.*[./])?(?:force)[./_]{axis}", rf"(?:actual_)?tcp_force_{i}",
                    rf"o_f_ext_hat_k\[{i}\]", rf"f{axis}_n") for i, axis in enumerate(AXES)},
}
NEEDED = {"time", "x", "y"}
LENGTHS, FORCES = {"x", "y", "z", "height"}, {"force", "fx", "fy", "fz"}
SUFFIXES = re.compile(r".*_(ns|us|ms|s|mm|um|m|n)")
STAMPS = ((1e17, "ns"), (1e14, "us"), (1e11, "ms"))  # an epoch above the first is in the second


class Column:
    """Column of a recording.

    name    title without the unit
    unit    unit of the title; None without one
    first   first value, in the unit
    values  array [rows]: differences to the first value, in the unit; None for a column that does not hold numbers
    text    first cell that is not a number, where there is one, and
    line    its line in the file; 0 without one
    """

    def __init__(self, name, unit, first, values, text="", line=0):
        if unit is not None and unit.isdigit():  # O_T_EE[12] is an entry, no unit
            name, unit = f"{name}[{unit}]", None
        self.name, self.unit, self.first, self.values = name, unit, first, values
        self.text, self.line = text, line

    def si(self, target, default):
        """Converts to the SI unit `target`: array [rows] of differences to the first value, and the first value.

        default  unit of a column without one

        Raises CaseError when the unit does not convert.
        """
        unit, convert = self.unit or default, solver.load().convert_unit
        zero, one = convert(0.0, unit, target), convert(1.0, unit, target)
        if one is None:
            raise CaseError(f"the unit [{unit}] of {self.name} does not convert to {target}\n"
                            f"  = name the column and its unit, such as --column \"ROLE={self.name} [{target}]\"")
        return self.values * (one - zero), zero + self.first * (one - zero)


def read(path) -> list[Column]:
    """Reads all columns of a CSV file. Raises CaseError."""
    return [Column(*one) for one in solver.load().number_table(os.fsencode(path), "recording")]


def assign(columns, wanted) -> dict[str, Column]:
    """Finds the column of each role, as a dict of role to Column; roles without a column are left out.

    columns  all columns of the recording
    wanted   texts "ROLE=NAME" or "ROLE=NAME [unit]" of the user, which take precedence over known names

    Raises CaseError for a role or a name that is unknown, and for a column of text or of another unit.
    """
    found = {}
    for text in wanted:
        role, _, rest = (part.strip() for part in text.partition("="))
        if role not in NAMES or not rest:
            raise CaseError(f"--column {text}: a role, = and a name of a column are wanted\n  = roles: {', '.join(NAMES)}")
        match = re.fullmatch(r"(.*?)\s*(?:\[([^\[\]\d][^\[\]]*)\])?", rest)
        named = [one for one in columns if one.name == match[1].lower()]
        if not named:
            raise CaseError(f"--column {text}: the recording has no column {match[1]}\n  = its columns: "
                            + ", ".join(one.name for one in columns if one.name))
        column = named[0]
        if column.values is None:
            raise CaseError(f"--column {text}: {_no_numbers(column)}\n  = name another column")
        _require_one(named, role)
        found[role] = Column(column.name, match[2] or column.unit, column.first, column.values)
    numbers = [one for one in columns if one.values is not None]
    for role, patterns in NAMES.items():
        if role in found:
            continue
        for pattern in patterns:
            fitting = [one for one in numbers if re.fullmatch(pattern, one.name) and _may_be(role, one)]
            if fitting:
                found[role] = fitting[0]
                _require_one([one for one in fitting if one.name == fitting[0].name], role)
                break
        else:
            _require_none(columns, role)
    return found


def _require_one(columns, role):
    """Raises CaseError for several columns of one name whose numbers differ."""
    first = columns[0]
    for other in columns[1:]:
        if (other.unit, other.first) != (first.unit, first.first) or not numpy.array_equal(other.values, first.values, True):
            raise CaseError(f"{len(columns)} columns of the recording are named {first.name}, and differ: which is {role} is "
                            "not known\n  = rename the others in the file, or name another column: --column "
                            f"\"{role}=NAME [unit]\"")


def _require_none(columns, role):
    """Raises CaseError for a column whose name means the role, but whose cells or unit do not fit."""
    for one in columns:
        if not any(re.fullmatch(pattern, one.name) for pattern in NAMES[role]):
            continue
        if one.line:
            raise CaseError(f"{_no_numbers(one)}\n  = write numbers (times in seconds, no dates), empty cells where nothing was "
                            f"measured, or name another column: --column \"{role}=NAME [unit]\"")
        if one.values is not None and role in NEEDED:
            raise CaseError(f"the unit [{one.unit}] of {one.name} does not convert to {_unit_of(role)}\n"
                            f"  = name the column and its unit: --column \"{role}={one.name} [{_unit_of(role)}]\"")


def _no_numbers(column):
    return f"{column.name} holds \"{column.text}\" in line {column.line}, which is not a number" if column.line else (
        f"{column.name} holds no numbers")


def _may_be(role, column):
    """True if the unit of a column fits the role: tx [m] may be a position, Tx [N m] is a torque."""
    if column.unit is None:
        return True
    target = _unit_of(role)
    return solver.load().convert_unit(1.0, column.unit, target) is not None or (target == "1" and column.unit == "")


def _unit_of(role):
    return "m" if role in LENGTHS else "N" if role in FORCES else "s" if role in ("time", "seconds", "nanoseconds") else "1"


def unit_by_name(column):
    """Unit at the end of a column's name: "mm" for pos_mm; None without one."""
    match = SUFFIXES.fullmatch(column.name)
    return {"n": "N"}.get(match[1], match[1]) if match else None


def stamp_roles(found):
    """Roles of the columns that give the time: "seconds" and "nanoseconds", or "time"."""
    return ("seconds", "nanoseconds") if "seconds" in found and "nanoseconds" in found else ("time",)


def instants(found, notes):
    """Array [rows] of seconds since the first time stamp, and that stamp [s]. Raises CaseError without a column of times."""
    if len(stamp_roles(found)) == 2:
        seconds, nanoseconds = found["seconds"], found["nanoseconds"]
        notes.append(f"time: {seconds.name} and {nanoseconds.name}")
        return seconds.values + 1e-9 * nanoseconds.values, seconds.first + 1e-9 * nanoseconds.first
    if "time" not in found:
        raise CaseError("the recording has no column of times that is known\n  = name it: --column \"time=NAME [unit]\"")
    column = found["time"]
    unit = column.unit or unit_by_name(column)
    if not unit:
        unit = next((name for least, name in STAMPS if abs(column.first) > least), "s")
    notes.append(f"time: {column.name} in {unit}")
    return column.si("s", unit)


def vector(found, roles, target, default, notes):
    """Columns of several roles as an array [rows, roles] in the SI unit `target`; None where a role is missing.

    default  unit of columns without one
    notes    list to which a sentence on each column is added
    """
    if any(role not in found for role in roles):
        return None
    parts = []
    for role in roles:
        column = found[role]
        unit = column.unit or unit_by_name(column) if target != "1" else "1"
        values, first = column.si(target, unit or default)
        parts.append(values + first)
        if target != "1":
            notes.append(f"{role}: {column.name} in {unit or default}" + ("" if unit else ", as nothing else is said"))
    return numpy.column_stack(parts)
