# SPDX-License-Identifier: Apache-2.0
"""Conversion of a recording to a path of waypoints: coordinate frame, normal force, spans of contact."""

import os

import numpy

from ...errors import CaseError
from . import contact, frame
from .channels import MOST_ROWS, noise_share
from .merging import merged
from .path import Path
from .tilt import Tilt

LEVELS, FRAMES = ("auto", "height", "force"), ("skin", "recording", "tool")
MOST_NAMED = 4  # rows that stand alone, by their force and time
LEAD = 0.1  # s before a recording that begins on the skin
PLACE_DECIMALS = 8  # of positions in m: 1 nm beside the middle of the skin, of rounded quaternions, would double the cost of a run


def motion(recordings, *, columns=(), origin=(0, 0, 0), x_axis=(1, 0, 0), y_axis=(0, 1, 0), tool=None, force_in="skin",
           level="auto", contact_force=None, tare=False, gap="1 mm", rate=None, filter=None, angles=False) -> Path:
    """Makes a Path of waypoints for the slider from recordings of a robot: position, and height or normal force.

    recordings     CSV file, or several of one clock, of which the first gives the instants
    columns        texts "ROLE=NAME [unit]" for columns whose names do not tell what they are; roles: time, x, y, z, height, qx,
                   qy, qz, qw (quaternion), fx, fy, fz, force
    origin         corner (0, 0) of the skin's top face in the frame of the recording: numbers [m], or a text with units
    x_axis, y_axis directions of the skin's x and y in the frame of the recording; they must be perpendicular
    tool           position of the finger's tip relative to the tracked point, in the frame that the quaternion turns: numbers
                   [m], or a text with units; None where the tip itself is tracked
    force_in       frame of fx, fy, fz: "skin" (fz is along the skin's normal), "recording" or "tool"
    level          "auto": force where the finger touches, height elsewhere; "height": only heights; "force": force where the
                   finger touches, the height `gap` elsewhere
    contact_force  normal force above which the finger touches, as text with a unit; None: a threshold above the noise
    tare           True to subtract the force at rest
    gap            height off the skin where none is recorded, as text with a unit
    rate           frequency at which the recording is resampled, such as "100 Hz"; None to keep the rows
    filter         cut-off frequency of a low-pass without delay, such as "20 Hz"; None for no filter
    angles         True for a path with the roll, pitch and yaw of the quaternion, up to 5 degrees of tilt; False for an upright
                   finger

    Raises CaseError when a file or an argument cannot be used.
    """
    _require_known(level, LEVELS, "--level")
    _require_known(force_in, FRAMES, "--force-in")
    notes = []
    record = merged([recordings] if isinstance(recordings, (str, os.PathLike)) else list(recordings), columns, notes)
    channels, share = record.channels, 1.0
    if filter is not None:
        frequency = frame.quantity(filter, "Hz", "--filter")
        share = noise_share(_positive(frequency, "--filter"), max(channels.interval(), record.sensed.interval()))
        channels = channels.filtered(frequency)
        notes.append(f"filtered at {frequency:.6g} Hz, without delay")
    if rate is not None:
        before = len(channels.time)
        channels = channels.resampled(_positive(frame.quantity(rate, "Hz", "--rate"), "--rate"))
        notes.append(f"resampled from {before} to {len(channels.time)} rows")
    if len(channels.time) > MOST_ROWS:
        raise CaseError(f"the recording has {len(channels.time)} rows\n"
                        f"  = a path may have {MOST_ROWS}: resample it with --rate")
    if tool is not None:
        _require_turn(record, "--tool", "leave out --tool where the tip itself is tracked")
    if force_in == "tool" and level != "height" and "forces" in channels.values and "force" not in channels.values:
        _require_turn(record, "--force-in tool", "name the force along the normal: --column force=NAME")
    place, height = _on_skin(channels, origin, x_axis, y_axis, tool)
    place = numpy.round(place, PLACE_DECIMALS)
    force = None if level == "height" else _normal_force(channels, x_axis, y_axis, force_in)
    if level == "force" and force is None:
        raise CaseError("no force is recorded\n  = name its column with --column force=NAME, or take --level height")
    if force is None and height is None:
        raise CaseError("neither a height (z) nor a force is recorded\n  = name one with --column")
    off = _positive(frame.quantity(gap, "m", "--gap"), "--gap")
    if force is not None:
        sensed = _normal_force(record.sensed, x_axis, y_axis, force_in)
        if not contact.compresses(sensed, contact_force is not None and not tare):
            notes.append("the sign of the force is turned: compression counts as positive")
            force, sensed = -force, -sensed
        above, rest = contact.threshold(sensed, share), contact.rest_level(sensed)
        _note_spikes(record.sensed.time, sensed, above, notes)
        flat = contact.saturated(sensed)
        if flat.any():
            notes.append(f"the force stays at its largest value, {sensed.max():.4g} N, in {flat.sum()} rows, the first of them "
                         f"{record.sensed.time[numpy.argmax(flat)]:.4g} s after the first row: if that is the limit of the "
                         "sensor, the finger pressed harder there")
        height, force = _by_force(force, height if level == "auto" else None, off, above, rest, contact_force, tare, notes)
    else:
        force = numpy.full(len(height), numpy.nan)
    time = channels.time
    pressed = numpy.isfinite(force)
    if angles:
        _require_angles(record, pressed)
    poses = _angles(channels, frame.axes(x_axis, y_axis), pressed if pressed.any() else height < 0, angles, notes)
    if not height[0] >= 0:
        notes.append(f"the recording begins on the skin: the finger lands there within {LEAD} s before it")
        time = numpy.concatenate(([0], time + LEAD))
        place, height, force = numpy.vstack((place[:1], place)), numpy.append(off, height), numpy.append(numpy.nan, force)
        poses = None if poses is None else numpy.vstack((poses[:1], poses))
    notes.append(_summary(time, place, height, force))
    return Path(time, place, height, force, notes, poses)


def _note_spikes(time, force, above, notes):
    """Adds a note on the rows of a force [rows] [N] that stand alone; `above` is the threshold of the contact [N]."""
    rows = contact.spikes(force, above)
    if not len(rows):
        return
    if len(rows) == 1:
        note, cells = f"one row alone has {force[rows[0]]:.4g} N, {time[rows[0]]:.4g} s after the first row", "its cell"
    else:
        note = ", ".join(f"{force[row]:.4g} N at {time[row]:.4g} s" for row in rows[:MOST_NAMED])
        note = f"{len(rows)} rows, each alone, have {note}{', ...' if len(rows) > MOST_NAMED else ''} after the first row"
        cells = "their cells"
    notes.append(f"{note}, and the others at most {contact.steady(force).max():.4g} N: if the sensor erred, empty {cells} in "
                 "the file, and convert it again")


def _require_angles(record, pressed):
    """Raises CaseError where a path cannot have angles; `pressed` is an array [rows], True where a force is prescribed."""
    _require_turn(record, "--angles", "leave out --angles")
    if not pressed.any():
        raise CaseError("--angles needs a force: a prescribed height is that of the lowest point of the tilted finger, which "
                        "is not recorded\n  = take --level auto, or leave out --angles")


def _angles(channels, axes, touches, wanted, notes):
    """Roll, pitch and yaw [rows, 3] [rad] where they are wanted; None otherwise, with a note on a tilt that is left out.

    touches  array [rows]: True in contact
    wanted   True for a path with angles

    Raises CaseError for a tilt that is too steep.
    """
    if "turn" not in channels.values or not touches.any():
        return None
    tilt = Tilt(channels.time, channels.values["turn"], axes, touches)
    if wanted:
        tilt.require_flat()
        return tilt.angles
    note = tilt.sentence()
    if note:
        notes.append(f"{note}, which the path leaves out: {tilt.remedy()}")
    return None


def _require_known(value, known, name):
    """Raises CaseError for a value of an option that is none of the known ones."""
    if value not in known:
        raise CaseError(f"{name} = {value!r} is none of {', '.join(known)}\n  = choose one of them")


def _positive(value, name):
    if not value > 0:
        raise CaseError(f"{name} must be above 0")
    return value


def _require_turn(record, option, otherwise):
    """Raises CaseError, with the remedy `otherwise` beside that of naming columns, where an option needs a quaternion and
    none is recorded."""
    if "turn" not in record.channels.values:
        raise CaseError(f"{option} needs a quaternion, and {record.turnless}\n  = name qx, qy, qz and qw with --column, or "
                        f"{otherwise}")


def _on_skin(channels, origin, x_axis, y_axis, tool):
    """Positions [rows, 2] and heights [rows] of the finger's tip in the frame of the skin [m]; heights are None without
    z or height.

    Raises CaseError.
    """
    values, turn = channels.values, frame.axes(x_axis, y_axis)
    place = values.get("place")
    if place is None:
        if "flat" not in values:
            raise CaseError("the recording has no columns of x and y that are known\n"
                            "  = name them: --column \"x=NAME [unit]\" --column \"y=NAME [unit]\"")
        place = numpy.column_stack((values["flat"], numpy.zeros(len(channels.time))))
    if tool is not None:
        place = place + frame.turned(values["turn"], frame.point(tool, "--tool"))
    on_skin = (place - frame.point(origin, "--origin")) @ turn.T
    height = values.get("height", on_skin[:, 2] if "place" in values else None)
    return on_skin[:, :2], height


def _normal_force(channels, x_axis, y_axis, force_in):
    """Normal force on the skin [rows] [N], of the recorded sign; None where no force is recorded. Raises CaseError."""
    values = channels.values
    if "force" in values or "forces" not in values:
        return values.get("force")
    forces = values["forces"]
    if force_in == "skin":
        return forces[:, 2]
    if force_in == "tool":
        forces = numpy.column_stack([numpy.sum(forces * frame.turned(_inverse(values["turn"]), axis), axis=1)
                                     for axis in numpy.eye(3)])
    return forces @ frame.axes(x_axis, y_axis)[2]


def _inverse(turn):
    return turn * numpy.array([-1, -1, -1, 1])


def _by_force(force, height, gap, above, rest, contact_force, tare, notes):
    """Height [rows] [m] off the skin and force [rows] [N] on it; each is NaN in rows in which the other is prescribed.

    above, rest  threshold of the contact, and level of the force at rest [N]

    Raises CaseError.
    """
    if contact_force is not None:
        above = _positive(frame.quantity(contact_force, "N", "--contact-force"), "--contact-force")
    if tare:
        notes.append(f"the force at rest, {rest:.4g} N, is subtracted")
        force = force - rest
    elif abs(rest) > above and contact_force is None:
        raise CaseError(f"the force is {rest:.4g} N at rest, beyond its noise\n  = subtract it with --tare if it is the "
                        "sensor's offset or the weight of a tool; if the finger never leaves the skin, say so by "
                        "--contact-force")
    touches = contact.touching(force, above) & (force > 0)
    touched = contact.parts(touches)
    if not touched:
        raise CaseError(f"the force never rises above {above:.4g} N, where a touch begins\n"
                        "  = lower it with --contact-force, or take --level height")
    notes.append(f"touches where the force is above {above:.4g} N, until half of it: {len(touched)} time"
                 f"{'s' if len(touched) > 1 else ''}")
    faint = sum(force[first:behind].max() < 2 * above for first, behind in touched)
    if faint and contact_force is None:
        notes.append(f"{faint} of the {len(touched)} touches stay{'s' if faint == 1 else ''} below twice this threshold: if that "
                     "is noise, set a larger one with --contact-force")
    if touched[-1][1] == len(force):
        notes.append(f"the last touch does not end: the last row has {force[-1]:.4g} N. If the finger has left the skin by "
                     "then, the force at rest drifts: subtract the drift before, or set a larger threshold with --contact-force. "
                     "Else the recording ends on the skin")
    if height is None:
        off = numpy.full(len(force), gap)
        notes.append(f"off the skin the height is {1e3 * gap:.4g} mm")
    else:
        off = numpy.maximum(height, 0)
        below = int(((height < 0) & ~touches).sum())
        if below:
            notes.append(f"{below} heights below 0 where nothing is felt are set to 0, the least of {1e3 * height.min():.3g} "
                         "mm: is the origin on the skin's top face?")
        landing = float(numpy.median([height[first] for first, _ in touched]))
        if abs(landing) > 1e-3:
            notes.append(f"the force begins at a height of {1e3 * landing:.4g} mm: is the origin on the skin's top face?")
    return numpy.where(touches, numpy.nan, off), numpy.where(touches, force, numpy.nan)


def _summary(time, place, height, force):
    speeds = numpy.linalg.norm(numpy.diff(place, axis=0), axis=1) / numpy.diff(time)
    low, high = 1e3 * place.min(axis=0), 1e3 * place.max(axis=0)
    loads = force[numpy.isfinite(force)]
    load = f"up to {loads.max():.4g} N" if len(loads) else f"down to {1e3 * height.min():.4g} mm"
    return (f"{len(time)} waypoints over {time[-1]:.6g} s, x {low[0]:.4g} to {high[0]:.4g} mm, y {low[1]:.4g} to "
            f"{high[1]:.4g} mm, {load}, {1e3 * speeds.max():.4g} mm/s at most")
