# SPDX-License-Identifier: Apache-2.0
"""Merging of several recordings of one clock into channels over one time."""

import dataclasses

import numpy

from ...errors import CaseError
from . import columns
from .channels import Channels


def _recording(path, wanted, notes):
    """Reads one file: Channels named by their roles, the first time stamp [s], and why there is no quaternion."""
    notes.append(f"{path}:")
    known = columns.read(path)
    there = {one.name for one in known}
    own = [text for text in wanted if text.partition("=")[2].rsplit("[", 1)[0].strip().lower() in there or len(wanted) == 0]
    found = columns.assign(known, own)
    time, first = columns.instants(found, notes)
    values = {}
    for name, roles, unit, default in (("place", ("x", "y", "z"), "m", "m"), ("flat", ("x", "y"), "m", "m"),
                                       ("turn", ("qx", "qy", "qz", "qw"), "1", "1"), ("forces", ("fx", "fy", "fz"), "N", "N"),
                                       ("height", ("height",), "m", "m"), ("force", ("force",), "N", "N"),
                                       ("force", ("fz",), "N", "N")):
        if name in values or (name == "flat" and "place" in values) or (roles == ("fz",) and "forces" in values):
            continue
        part = columns.vector(found, roles, unit, default, notes)
        if part is not None:
            values[name] = part[:, 0] if len(roles) == 1 else part
    used = {found[role].name for role in found}
    passed = [one.name for one in known if one.name and one.name not in used]
    if passed:
        notes.append("not used: " + ", ".join(passed[:8]) + (f" and {len(passed) - 8} more" if len(passed) > 8 else ""))
    turnless = ""
    if "turn" in values:
        zero = numpy.linalg.norm(values["turn"], axis=1) == 0
        names = ", ".join(found[role].name for role in ("qx", "qy", "qz", "qw"))
        if zero.all():  # a tracker of places alone
            notes.append("the quaternion is 0 in every row, and left out")
            del values["turn"]
            turnless = f"that of {path} ({names}) is 0, which is no orientation, in row 1 and all others"
        else:
            if zero.any():
                notes.append(f"the quaternion is 0, which is no orientation, in {zero.sum()} rows, the first of which is row "
                             f"{numpy.argmax(zero) + 1}")
            values["turn"] = _continuous(numpy.where(zero[:, None], numpy.nan, values["turn"]))
    stamps = " and ".join(found[role].name for role in columns.stamp_roles(found))
    return Channels.cleaned(time, values, notes, f"{path}, {stamps}"), first + float(numpy.nanmin(time)), turnless


def _continuous(turn):
    """Flips signs of quaternions [rows, 4] so that neighbours can be averaged: q and -q are the same rotation."""
    against = numpy.sum(turn[1:] * turn[:-1], axis=1) < 0
    return turn * numpy.where(numpy.concatenate(([0], numpy.cumsum(against))) % 2, -1, 1)[:, None]


@dataclasses.dataclass
class Merged:
    """Recordings of one clock over one time.

    channels  all Channels, at the instants of the first recording
    sensed    Channels of the force and of the quaternion at the instants at which the force was recorded, from the same
              beginning; `channels` where there are none
    turnless  why there is no quaternion, as the end of a sentence
    """

    channels: Channels
    sensed: Channels
    turnless: str


def merged(paths, wanted, notes) -> Merged:
    """Merges recordings of one clock at the instants of the first, over the time that all cover.

    paths   CSV files
    wanted  texts "ROLE=NAME [unit]" for columns whose names do not tell what they are
    notes   list to which sentences on the conversion are added

    Raises CaseError when a file cannot be used or the recordings do not overlap.
    """
    if not paths:
        raise CaseError("no recording is named")
    text = [wanted] if isinstance(wanted, str) else list(wanted)
    _require_known(paths, text)
    read = [_recording(path, text, notes) for path in paths]
    parts = [(one, first) for one, first, _ in read]
    base, start = parts[0]
    begin, end = 0.0, float(base.time[-1])
    for other, first in parts[1:]:
        begin, end = max(begin, first - start), min(end, first - start + float(other.time[-1]))
    rows = (base.time >= begin - 1e-9) & (base.time <= end + 1e-9)
    if rows.sum() < 2:
        raise CaseError(_apart(paths, parts))
    if not rows.all():
        notes.append(f"{(~rows).sum()} rows are left out where not every recording has begun, or has ended already")
    time = base.time[rows]
    values = {name: one[rows] for name, one in base.values.items()}
    for other, first in parts[1:]:
        for name, one in other.at(time + start - first).values.items():
            values.setdefault(name, one)
    channels = Channels(time - time[0], values)
    turnless = next((why for *_, why in read if why), "the recording has none")
    return Merged(channels, _sensed(parts, start + time[0], channels.time[-1]) or channels, turnless)


def _apart(paths, parts):
    """Message that recordings share too little time: the span of each of them, and the remedy.

    paths  CSV files
    parts  pairs of Channels and first time stamp [s], one for each file
    """
    begins, ends = [first for _, first in parts], [first + float(one.time[-1]) for one, first in parts]
    spans = ", ".join(f"{path} from {_seconds(begin)} to {_seconds(end)} s" for path, begin, end in zip(paths, begins, ends))
    late, early = begins.index(max(begins)), ends.index(min(ends))
    if begins[late] <= ends[early]:
        return (f"fewer than two rows of {paths[0]} lie within the time that all recordings cover: {spans}\n"
                "  = name a recording with more rows first")
    return (f"the recordings do not overlap in time: {spans}\n"
            f"  = correct the offset between the clocks (if {paths[late]} and {paths[early]} began at one instant, subtract "
            f"{_seconds(begins[late] - begins[early])} s from the times of {paths[late]}), or name the unit of the times with "
            "--column \"time=NAME [unit]\"")


def _seconds(value):
    """Text of a number of seconds to the microsecond, without trailing zeros."""
    return f"{value:.6f}".rstrip("0").rstrip(".")


def _sensed(parts, begin, duration):
    """Channels of the force at its own instants, between the stamp `begin` [s] and so many seconds later.

    None without a force, and where fewer than two rows of it are within this time.
    """
    for name in ("force", "forces"):
        for one, first in parts:
            if name not in one.values:
                continue
            time = one.time + (first - begin)
            rows = (time >= -1e-9) & (time <= duration + 1e-9)
            if rows.sum() < 2:
                return None
            values = {name: one.values[name][rows]}
            for other, stamp in parts:
                if "turn" in other.values:
                    values.setdefault("turn", other.at(one.time[rows] + (first - stamp)).values["turn"])
            return Channels(time[rows], values)
    return None


def _require_known(paths, wanted):
    """Raises CaseError where a --column names no known role, or no column of any of the recordings."""
    there = {one.name for path in paths for one in columns.read(path)} if wanted else set()
    for text in wanted:
        role, _, rest = (part.strip() for part in text.partition("="))
        name = rest.rsplit("[", 1)[0].strip().lower() if rest.lower() not in there else rest.lower()
        if role not in columns.NAMES or name not in there:
            problem, remedy = ((f"{role!r} is not a role", f"roles: {', '.join(columns.NAMES)}") if role not in columns.NAMES else
                               (f"no column is named {name!r}", f"columns: {', '.join(sorted(there - {''}))}"))
            raise CaseError(f"--column {text}: {problem}\n  = {remedy}")
