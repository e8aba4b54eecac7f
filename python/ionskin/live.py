# SPDX-License-Identifier: Apache-2.0
"""The reduced skin, stepped in a loop: what `ionskin live CASE.toml -o skin.live` trained.

    import ionskin.live
    skin = ionskin.live.Skin("skin.live")
    signals = skin.step(0.001, (6e-3, 1e-3), height=-0.5e-6)
    signals["normal_force"], signals["charge_top"]
"""

import ctypes
import dataclasses
import os
import pathlib
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor

import numpy

from .errors import CaseError

OUTSIDE_PLACE, OUTSIDE_LOAD, OUTSIDE_SPEED, UNCONVERGED, PULLED = 1, 2, 4, 8, 32
_INTERFACE = 1
_HEIGHT, _FORCE = 0, 1
_NUMBERS = ctypes.POINTER(ctypes.c_double)


def _load() -> ctypes.CDLL:
    beside = pathlib.Path(__file__).parent.parent
    for folder in (beside, beside.parents[1]):  # the build folder; lib, above lib/python3/dist-packages
        for name in ("libionskin_live.so", "libionskin_live.so.1"):
            if (folder / name).exists():
                library = ctypes.CDLL(str(folder / name))
                if library.ionskin_live_interface() == _INTERFACE:
                    return _declared(library)
    raise ImportError("libionskin_live.so of this version is not beside this package: build it (make build) and put "
                      "build/python on PYTHONPATH, or install all parts of ionskin")


def _declared(library: ctypes.CDLL) -> ctypes.CDLL:
    skin, text, number, size = ctypes.c_void_p, ctypes.c_char_p, ctypes.c_double, ctypes.c_size_t
    texts = ctypes.POINTER(text)
    for name, result, arguments in (
            ("open", skin, [text, text, size]), ("copy", skin, [skin]), ("close", None, [skin]),
            ("signal_count", size, [skin]), ("signal_name", text, [skin, size]),
            ("step", ctypes.c_uint32, [skin, number, number, number, ctypes.c_int, number, _NUMBERS]),
            ("run", None, [skin, size, _NUMBERS, _NUMBERS, ctypes.c_int, _NUMBERS, _NUMBERS,
                           ctypes.POINTER(ctypes.c_uint32)]),
            ("state_size", size, [skin]), ("save", None, [skin, _NUMBERS]),
            ("restore", ctypes.c_int, [skin, _NUMBERS, size]), ("reset", None, [skin]),
            ("set_friction", ctypes.c_int, [skin, number]), ("friction", None, [skin, _NUMBERS]),
            ("text", text, [skin, text]), ("range", None, [skin, _NUMBERS]), ("size", None, [skin, _NUMBERS]),
            ("taxel", ctypes.c_int, [skin, size, texts, _NUMBERS]),
            ("error", ctypes.c_int, [skin, size, texts, _NUMBERS, _NUMBERS, _NUMBERS])):
        function = getattr(library, "ionskin_live_" + name)
        function.restype, function.argtypes = result, arguments
    return library


@dataclasses.dataclass(frozen=True)
class SignalError:
    """Error of a signal on touches that the skin was not trained on, and the signal's largest value, in its unit."""

    rms: float
    worst: float
    largest: float


@dataclasses.dataclass(frozen=True)
class Range:
    """The range that the skin was trained for: places of the slider's centre [m], force [N], indentation [m], speed
    [m/s], lowest and highest coefficient of friction."""

    lowest: tuple[float, float]
    highest: tuple[float, float]
    force: float
    indentation: float
    speed: float
    friction: tuple[float, float]


class Signals(Mapping):
    """Signals by name, SI units. `flags` is 0 where all is well, else the sum of OUTSIDE_PLACE, OUTSIDE_LOAD,
    OUTSIDE_SPEED, UNCONVERGED and PULLED; of `Skin.run` an array."""

    def __init__(self, columns: dict[str, int], values: numpy.ndarray, flags) -> None:
        self._columns, self._values, self.flags = columns, values, flags

    def __getitem__(self, name: str):
        value = self._values[..., self._columns[name]]
        return float(value) if value.ndim == 0 else value

    def __iter__(self):
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    @property
    def outside(self):
        """True where a step lies outside the trained range, in place, load or speed."""
        return (self.flags & (OUTSIDE_PLACE | OUTSIDE_LOAD | OUTSIDE_SPEED)) != 0

    def __repr__(self) -> str:
        return f"Signals({', '.join(f'{name}={self[name]!r}' for name in self)})"


def _pointer(array: numpy.ndarray):
    return array.ctypes.data_as(_NUMBERS)


def _finite(name: str, values, shape: tuple) -> numpy.ndarray:
    try:
        array = numpy.asarray(values, dtype=float, order="C")
    except (TypeError, ValueError) as wrong:
        raise ValueError(f"{name}: numbers are wanted, not {values!r}") from wrong
    if array.shape != shape:
        raise ValueError(f"{name}: the shape is {array.shape}, and must be {shape}")
    if not numpy.isfinite(array).all():
        raise ValueError(f"{name}: holds NaN or infinity")
    return array


def _one_load(height, force, plural: str) -> tuple[int, object]:
    if (height is None) == (force is None):
        raise TypeError(f"give either height{plural} or force{plural}, " +
                        ("not both" if height is not None else "one of both is missing"))
    return (_HEIGHT, height) if force is None else (_FORCE, force)


class Skin:
    """A reduced skin. Times ascend; the first step may begin in contact. One thread at a time steps it. `friction` is a
    coefficient within `range.friction`, that of the case without it; it can be set again between two steps."""

    def __init__(self, path: str | os.PathLike, *, friction: float | None = None) -> None:
        self._library = _load()
        message = ctypes.create_string_buffer(4096)
        self._handle = self._library.ionskin_live_open(os.fsencode(path), message, len(message))
        if not self._handle:
            raise CaseError(message.value.decode(errors="replace"))
        self._take_names()
        if friction is not None:
            self.friction = friction

    def _take_names(self) -> None:
        self._time = None
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
        self._library.ionskin_live_range(self._handle, _pointer(values))
        return Range(tuple(values[:2].tolist()), tuple(values[2:4].tolist()), *values[4:].tolist(),
                     tuple(self._friction()[1:].tolist()))

    def _friction(self) -> numpy.ndarray:
        values = numpy.empty(3)
        self._library.ionskin_live_friction(self._handle, _pointer(values))
        return values

    @property
    def friction(self) -> float:
        """Coefficient of friction; no part of what `save` keeps. ValueError: set outside the trained range."""
        return float(self._friction()[0])

    @friction.setter
    def friction(self, coefficient: float) -> None:
        coefficient = float(_finite("friction", coefficient, ()))
        if not self._library.ionskin_live_set_friction(self._handle, coefficient):
            low, high = self.range.friction
            raise ValueError(f"friction: {coefficient:g} is outside the trained range, {low:g} to {high:g}; train a wider "
                             "one by ionskin live --friction LOW HIGH")

    @property
    def size(self) -> tuple[float, float]:
        """Length and width of the skin [m]."""
        values = numpy.empty(2)
        self._library.ionskin_live_size(self._handle, _pointer(values))
        return tuple(values.tolist())

    @property
    def taxels(self) -> dict[str, tuple[float, float, float, float]]:
        """Lowest x, y, highest x, y of every taxel [m]."""
        taxels, name, corners = {}, ctypes.c_char_p(), numpy.empty(4)
        while self._library.ionskin_live_taxel(self._handle, len(taxels), ctypes.byref(name), _pointer(corners)):
            taxels[name.value.decode()] = tuple(corners.tolist())
        return taxels

    @property
    def errors(self) -> dict[str, SignalError]:
        """Errors by signal; those of currents over the sampling interval of the case are named sampled_NAME."""
        errors, name, values = {}, ctypes.c_char_p(), numpy.empty(3)
        places = [_pointer(values[i:]) for i in range(3)]
        while self._library.ionskin_live_error(self._handle, len(errors), ctypes.byref(name), *places):
            errors[name.value.decode()] = SignalError(*values.tolist())
        return errors

    def step(self, time: float, position: Sequence[float], *, height: float | None = None,
             force: float | None = None) -> Signals:
        """The signals at a time [s] with the slider's centre at (x, y) [m] and its underside at a height above the
        undeformed top face [m], negative when it indents, or pressed by a force [N]. Currents are means since the
        step before. ValueError: a value that is not a number, or a time before the last."""
        kind, value = _one_load(height, force, "")
        time = float(_finite("time", time, ()))
        self._require_ascending(time)
        place = _finite("position", position, (2,))
        value = _finite("force" if kind else "height", value, ())
        signals = numpy.empty(len(self._columns))
        flags = self._library.ionskin_live_step(self._handle, time, place[0], place[1], kind, value, _pointer(signals))
        self._time = time
        return Signals(self._columns, signals, flags)

    def run(self, times: Sequence[float], positions, *, heights=None, forces=None) -> Signals:
        """Many steps at once: times [n], positions [n, 2], heights or forces [n]; signals are arrays [n]."""
        kind, values = _one_load(heights, forces, "s")
        times = _finite("times", times, (numpy.size(times),))
        positions = _finite("positions", positions, (len(times), 2))
        values = _finite("forces" if kind else "heights", values, (len(times),))
        if (numpy.diff(times) < 0).any():
            later = int(numpy.argmax(numpy.diff(times) < 0)) + 1
            raise ValueError(f"times: {times[later]} s (index {later}) comes after {times[later - 1]} s")
        signals = numpy.empty((len(times), len(self._columns)))
        flags = numpy.zeros(len(times), dtype=numpy.uint32)
        if len(times):
            self._require_ascending(times[0])
            self._library.ionskin_live_run(self._handle, len(times), _pointer(times), _pointer(positions), kind,
                                           _pointer(values), _pointer(signals),
                                           flags.ctypes.data_as(ctypes.POINTER(ctypes.c_uint32)))
            self._time = float(times[-1])
        return Signals(self._columns, signals, flags)

    def play(self, path: str | os.PathLike, times: Sequence[float], positions, *, heights=None, forces=None) -> Signals:
        """Runs as `run` does, and writes a page that plays it in a browser, without any network: the slider over the
        skin, the taxels coloured by their currents, the signals as they grow."""
        from .page import live_page  # a controller needs no templates

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
        other._library = self._library
        other._handle = self._library.ionskin_live_copy(self._handle)
        if not other._handle:
            raise MemoryError("no memory for another skin")
        other._take_names()
        other._time = self._time
        return other

    def save(self) -> bytes:
        """The state, to be restored by a skin of the same file."""
        state = numpy.empty(self._library.ionskin_live_state_size(self._handle))
        self._library.ionskin_live_save(self._handle, _pointer(state))
        return state.tobytes()

    def restore(self, state: bytes) -> None:
        """Takes up a state; time may go back by it. ValueError when it is of another skin or damaged; nothing changes
        then."""
        if len(state) % 8:
            raise ValueError("state: is none of a skin")
        values = numpy.frombuffer(state)
        if not self._library.ionskin_live_restore(self._handle, _pointer(values), len(values)):
            raise ValueError("state: is that of a skin from another file, or damaged: a number is not finite or beyond what a "
                             "step can leave")
        # First numbers of a state: whether it was stepped, and when.
        self._time = float(values[1]) if values[0] else None

    def reset(self) -> None:
        """Back to a detached skin at rest."""
        self._library.ionskin_live_reset(self._handle)
        self._time = None

    def _require_ascending(self, time: float) -> None:
        if self._time is not None and time < self._time:
            raise ValueError(f"time: {time} s comes before the last step at {self._time} s; restore a state, or reset")
