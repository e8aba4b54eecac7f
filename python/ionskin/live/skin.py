# SPDX-License-Identifier: Apache-2.0
"""One reduced skin, stepped by one thread."""

import ctypes
import itertools
import os
import pathlib
import warnings
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor

import numpy

from ..errors import CaseError
from .checks import finite, one_load
from .library import load, pointer
from .signals import LiveSkinWarning, Range, SignalError, Signals


_MOST_TURNED = 1e6  # yaw [rad]


class Skin:
    """A reduced skin. Times ascend; the first step may begin in contact. One thread at a time steps it. `friction` is a
    coefficient within `range.friction`, that of the case without it; it can be set again between two steps."""

    def __init__(self, path: str | os.PathLike, *, friction: float | None = None) -> None:
        self._library = load()
        message = ctypes.create_string_buffer(4096)
        self._handle = self._library.ionskin_live_open(os.fsencode(path), message, len(message))
        if not self._handle:
            raise CaseError(message.value.decode(errors="replace"))
        self._path, self._digest = pathlib.Path(path).absolute(), _digest(path)
        self._take_names()
        if friction is not None:
            self.friction = friction
        if shortfall := self.shortfall:
            warnings.warn(f"{os.fspath(path)}: {shortfall}", LiveSkinWarning, stacklevel=2)

    def _take_names(self) -> None:
        self._time, self._stepped = None, False
        self._columns = {self._library.ionskin_live_signal_name(self._handle, i).decode(): i
                         for i in range(self._library.ionskin_live_signal_count(self._handle))}

    def __del__(self) -> None:
        if getattr(self, "_handle", None):
            self._library.ionskin_live_close(self._handle)
            self._handle = None

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the signals."""
        return tuple(self._columns)

    @property
    def case(self) -> str:
        """Text of the case that it was trained on."""
        return self._library.ionskin_live_text(self._handle, b"case").decode()

    @property
    def version(self) -> str:
        """Version of ionskin that trained the skin."""
        return self._library.ionskin_live_text(self._handle, b"version").decode()

    @property
    def command(self) -> str:
        """Command that trained the skin."""
        return self._library.ionskin_live_text(self._handle, b"command").decode()

    @property
    def range(self) -> Range:
        values = numpy.empty(7)
        self._library.ionskin_live_range(self._handle, pointer(values))
        return Range(tuple(values[:2].tolist()), tuple(values[2:4].tolist()), *values[4:].tolist(),
                     tuple(self._friction()[1:].tolist()), *self._pose_range()[:2].tolist())

    def _pose_range(self) -> numpy.ndarray:
        values = numpy.empty(3)
        self._library.ionskin_live_pose_range(self._handle, pointer(values))
        return values

    @property
    def turns_into_itself(self) -> bool:
        """True if the underside looks alike from all sides: such a slider may turn about z."""
        return bool(self._pose_range()[2])

    def _friction(self) -> numpy.ndarray:
        values = numpy.empty(3)
        self._library.ionskin_live_friction(self._handle, pointer(values))
        return values

    @property
    def friction(self) -> float:
        """Coefficient of friction; no part of what `save` keeps. ValueError: set outside the trained range."""
        return float(self._friction()[0])

    @friction.setter
    def friction(self, coefficient: float) -> None:
        coefficient = float(finite("friction", coefficient, ()))
        if not self._library.ionskin_live_set_friction(self._handle, coefficient):
            low, high = self.range.friction
            raise ValueError(f"friction: {coefficient:g} is outside the trained range, {low:g} to {high:g}; train a wider "
                             "one by ionskin live --friction LOW HIGH")

    @property
    def size(self) -> tuple[float, float]:
        """Length and width of the skin [m]."""
        values = numpy.empty(2)
        self._library.ionskin_live_size(self._handle, pointer(values))
        return tuple(values.tolist())

    @property
    def footprint(self) -> tuple[float, float, float, float]:
        """Lowest x, y, highest x, y of the contact cells, from the slider's centre [m]: nothing beyond them touches."""
        values = numpy.empty(4)
        self._library.ionskin_live_footprint(self._handle, pointer(values))
        return tuple(values.tolist())

    @property
    def core_thickness(self) -> float:
        """Thickness of the core [m]."""
        return float(self._library.ionskin_live_core_thickness(self._handle))

    @property
    def time(self) -> float | None:
        """Time of the last step [s], None before the first."""
        return self._time

    @property
    def taxels(self) -> dict[str, tuple[float, float, float, float]]:
        """Lowest x, y, highest x, y of every taxel [m]."""
        taxels, name, corners = {}, ctypes.c_char_p(), numpy.empty(4)
        while self._library.ionskin_live_taxel(self._handle, len(taxels), ctypes.byref(name), pointer(corners)):
            taxels[name.value.decode()] = tuple(corners.tolist())
        return taxels

    @property
    def errors(self) -> dict[str, SignalError]:
        """Errors by signal; those of currents over the sampling interval of the case are named sampled_NAME."""
        return self._errors().get("", {})

    @property
    def event_errors(self) -> dict[str, dict[str, SignalError]]:
        """Errors by event of a touch, "landing", "slip_onset", "hold" and "lift", and by signal; the largest value is
        that within such events."""
        return {event: errors for event, errors in self._errors().items() if event}

    def _errors(self) -> dict[str, dict[str, SignalError]]:
        errors, event, name, values = {}, ctypes.c_char_p(), ctypes.c_char_p(), numpy.empty(3)
        places = [pointer(values[i:]) for i in range(3)]
        for index in itertools.count():
            if not self._library.ionskin_live_event_error(self._handle, index, ctypes.byref(event), ctypes.byref(name),
                                                          *places):
                return errors
            errors.setdefault(event.value.decode(), {})[name.value.decode()] = SignalError(*values.tolist())

    @property
    def shortfall(self) -> str:
        """One line on the events whose errors are larger than promised, empty where none are. Loading warns of it, too:
        LiveSkinWarning."""
        return self._library.ionskin_live_text(self._handle, b"shortfall").decode()

    def step(self, time: float, position: Sequence[float] | None = None, *, height: float | None = None,
             force: float | None = None, angles: Sequence[float] = (0, 0, 0),
             pose: Sequence[float] | None = None) -> Signals:
        """The signals at a time [s] with the slider's centre at (x, y) [m] and its underside at a height above the
        undeformed top face [m], negative when it indents, or pressed by a force [N]. Currents are means since the
        step before. `angles` are roll, pitch and yaw [rad], and the height that of the lowest point as it stands. A pose
        (x, y, z, roll, pitch, yaw) takes the place of position, height and angles; with a force its z is not used and
        may be None. ValueError: a value that is not a number, or a time before the last."""
        if pose is not None:
            position, height, angles = _parted(pose, position, height, force)
        kind, value = one_load(height, force, "")
        time = float(finite("time", time, ()))
        require_ascending_times(numpy.reshape(time, 1), self._time)
        place = finite("position", position, (2,))
        value = finite("force" if kind else "height", value, ())
        angles = finite("angles", angles, (3,))
        require_turns("yaw", angles[2])
        signals = numpy.empty(len(self._columns))
        flags = self._library.ionskin_live_step_posed(self._handle, time, place[0], place[1], pointer(angles), kind, value,
                                                      pointer(signals))
        self._time, self._stepped = time, True
        return Signals(self._columns, signals, flags)

    def stiffness(self) -> numpy.ndarray:
        """Derivative [6, 6] of the last step's wrench on the skin, forces along and moments about x, y and z, by a rigid
        motion of the slider at the end of that step: ways along x, y and z [m], turns about x, y and z through its centre on
        the undeformed top face [rad]. Of a skin that is computed as one half, columns 1, 3 and 5 are NaN. ValueError: no
        step led to this state. ArithmeticError: it was not found."""
        return self._derivatives("stiffness", 6)

    @property
    def charge_names(self) -> tuple[str, ...]:
        """Names of the charges among the signals: of top and bottom and of the taxels."""
        return tuple(name for name in self._columns if name.startswith("charge_"))

    def charge_derivatives(self) -> numpy.ndarray:
        """Derivatives [charge, 6] of the last step's charges, in the order of `charge_names`, by a rigid motion of the
        slider as `stiffness` has it [C/m], [C/rad]; what is NaN, and the errors, are those of `stiffness`, too."""
        return self._derivatives("charge_derivatives", self._library.ionskin_live_charge_count(self._handle))

    def _derivatives(self, what: str, rows: int) -> numpy.ndarray:
        if self._time is None:
            raise ValueError(f"{what}: no step was taken, of which it is the derivative; call step first")
        values = numpy.empty((rows, 6))
        if not getattr(self._library, "ionskin_live_" + what)(self._handle, pointer(values)):
            if not self._stepped:
                raise ValueError(f"{what}: the state was restored, and the step that led to it is unknown; call step first")
            raise ArithmeticError(f"{what}: the equations of the contact were not solved")
        return values

    def run(self, times: Sequence[float], positions, *, heights=None, forces=None, angles=None) -> Signals:
        """Many steps at once: times [n], positions [n, 2], heights or forces [n], angles [n, 3]; signals are arrays [n]."""
        kind, values = one_load(heights, forces, "s")
        times = finite("times", times, (numpy.size(times),))
        positions = finite("positions", positions, (len(times), 2))
        values = finite("forces" if kind else "heights", values, (len(times),))
        angles = finite("angles", numpy.zeros((len(times), 3)) if angles is None else angles, (len(times), 3))
        require_turns("yaw", numpy.abs(angles[:, 2]).max(initial=0))
        require_ascending_times(times, self._time)
        signals = numpy.empty((len(times), len(self._columns)))
        flags = numpy.zeros(len(times), dtype=numpy.uint32)
        if len(times):
            self._library.ionskin_live_run_posed(self._handle, len(times), pointer(times), pointer(positions),
                                                 pointer(angles), kind, pointer(values), pointer(signals),
                                                 flags.ctypes.data_as(ctypes.POINTER(ctypes.c_uint32)))
            self._time, self._stepped = float(times[-1]), True
        return Signals(self._columns, signals, flags)

    def play(self, path: str | os.PathLike, times: Sequence[float], positions, *, heights=None, forces=None) -> Signals:
        """Runs as `run` does, and writes a page that plays it in a browser, without any network: the slider over the
        skin, the taxels coloured by their currents, the signals as they grow."""
        from ..page import live_page  # a controller needs no templates

        signals = self.run(times, positions, heights=heights, forces=forces)
        live_page.write(path, self, numpy.asarray(times, dtype=float), signals)
        return signals

    def batch(self, trajectories: Sequence[Mapping], threads: int | None = None) -> list[Signals]:
        """Runs of many trajectories, each from the present state: mappings with the arguments of `run`."""
        def one(arguments: Mapping) -> Signals:
            return self.copy().run(**arguments)

        with ThreadPoolExecutor(threads or os.cpu_count()) as pool:
            return list(pool.map(one, trajectories))

    def copy(self) -> "Skin":
        """A second skin in the same state."""
        other = object.__new__(Skin)
        other._library, other._path, other._digest = self._library, self._path, self._digest
        other._handle = self._library.ionskin_live_copy(self._handle)
        if not other._handle:
            raise MemoryError("no memory for another skin")
        other._take_names()
        other._time, other._stepped = self._time, self._stepped
        return other

    __copy__ = copy

    def __deepcopy__(self, memo) -> "Skin":
        return self.copy()

    def __getstate__(self) -> dict:
        return {"path": self._path, "digest": self._digest, "state": self.save(), "friction": self.friction}

    def __setstate__(self, kept: dict) -> None:
        """Opens the file again, by its absolute path. ValueError when it is another by now."""
        self.__init__(kept["path"])
        if self._digest != kept["digest"]:
            raise ValueError(f"{kept['path']}: the file is another than that of the skin that was kept")
        self.restore(kept["state"])
        if self.friction != kept["friction"]:
            self.friction = kept["friction"]

    def save(self) -> bytes:
        """The state, to be restored by a skin of the same file."""
        state = numpy.empty(self._library.ionskin_live_state_size(self._handle))
        self._library.ionskin_live_save(self._handle, pointer(state))
        return state.tobytes()

    def restore(self, state: bytes) -> None:
        """Takes up a state; time may go back by it. ValueError when it is of another skin or damaged; nothing changes
        then."""
        if len(state) % 8:
            raise ValueError("state: is none of a skin")
        values = numpy.frombuffer(state)
        if not self._library.ionskin_live_restore(self._handle, pointer(values), len(values)):
            raise ValueError("state: is that of a skin from another file, or damaged: a number is not finite or beyond what a "
                             "step can leave")
        # First numbers of a state: whether it was stepped, and when.
        self._time, self._stepped = float(values[1]) if values[0] else None, False

    def reset(self) -> None:
        """Back to a detached skin at rest."""
        self._library.ionskin_live_reset(self._handle)
        self._time, self._stepped = None, False


def _parted(pose, position, height, force):
    """Position, height and angles of a pose. TypeError: given beside it. ValueError: not six."""
    if position is not None or height is not None:
        raise TypeError("give either a pose or a position and a height, not both")
    if len(pose) != 6:
        raise ValueError(f"pose: {len(pose)} numbers, and must be six: x, y, z, roll, pitch, yaw")
    return pose[:2], pose[2] if force is None else None, pose[3:]


def require_ascending_times(times: numpy.ndarray, last: float | None) -> None:
    """ValueError: times go back, or begin before that of the last step; None: there was none."""
    if (numpy.diff(times) < 0).any():
        later = int(numpy.argmax(numpy.diff(times) < 0)) + 1
        raise ValueError(f"times: {times[later]} s (index {later}) comes after {times[later - 1]} s")
    if last is not None and len(times) and times[0] < last:
        raise ValueError(f"time: {times[0]} s comes before the last step at {last} s; restore a state, or reset")


def require_turns(name: str, yaw: float) -> None:
    """ValueError: the yaw is beyond what a step takes [rad]."""
    if abs(yaw) > _MOST_TURNED:
        raise ValueError(f"{name}: {yaw:g} rad is outside +-{_MOST_TURNED:g} rad")


def _digest(path: str | os.PathLike) -> bytes:
    """Digest at the end of a file of a live skin."""
    with open(path, "rb") as file:
        file.seek(-32, os.SEEK_END)
        return file.read()
