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
from .checks import FORCE, finite, one_load, require_ascending_times, require_turns, whole
from .library import TOUCH_ROWS, load, pointer
from .signals import LiveSkinWarning, Range, SignalError, Signals


class Skin:
    """Reduced-order (live) skin, stepped in a loop by one thread at a time.

    path      file that `ionskin live` wrote
    friction  coefficient of friction within `range.friction`; None for that of the case. It can be set again between steps.

    Times ascend; the first step may begin in contact. Raises CaseError for a file that is not a live skin. Warns with
    LiveSkinWarning where the file states errors that are larger than promised.
    """

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
        """TOML text of the case that the skin was trained on."""
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
    def digest(self) -> str:
        """Digest of the file, which two files share only if they are the same."""
        return self._digest.decode()

    @property
    def range(self) -> Range:
        """Trained range of positions, loads, speeds, friction and poses."""
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
        """True if the underside looks alike from all sides. Then its yaw does not matter, only its turn within a step."""
        return bool(self._pose_range()[2])

    def _friction(self) -> numpy.ndarray:
        values = numpy.empty(3)
        self._library.ionskin_live_friction(self._handle, pointer(values))
        return values

    @property
    def friction(self) -> float:
        """Coefficient of friction. It is not part of the state that `save` returns. Setting a value outside the trained range
        raises ValueError."""
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
        """Lowest x, y, highest x, y of the contact cells, from the slider's centre [m]; the slider touches nothing beyond
        them."""
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
        """Stated errors over whole touches, a dict of signal name to SignalError. Errors of currents that are means over the
        case's sampling interval have names sampled_NAME."""
        return self._errors().get("", {})

    @property
    def event_errors(self) -> dict[str, dict[str, SignalError]]:
        """Stated errors within events of a touch: a dict of event ("landing", "slip_onset", "hold", "lift", "load_step")
        to a dict of signal name to SignalError, whose largest value is taken within such events."""
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
        """Line of text on the events whose errors are larger than promised; empty if there are none."""
        return self._library.ionskin_live_text(self._handle, b"shortfall").decode()

    def step(self, time: float, position: Sequence[float] | None = None, *, height: float | None = None,
             force: float | None = None, angles: Sequence[float] | None = None,
             pose: Sequence[float] | None = None, moments: Sequence[float] | None = None) -> Signals:
        """Steps to a time and returns the signals; currents are means over the time since the step before.

        time      [s], not before that of the last step
        position  centre of the slider (x, y) [m]
        height    height of the lowest point of the underside above the undeformed top face [m], below 0 where it indents; or
        force     normal force [N], 0 or less for a detached slider
        angles    roll, pitch and yaw [rad]; None for an upright slider
        pose      (x, y, z, roll, pitch, yaw) instead of position, height and angles; with a force, z is not used and may be
                  None
        moments   about x and y (M_x, M_y) that are held with a force [N m], such as (0, 0) of a finger on a free hinge: the slider
                  tilts until the forces on the skin have them about its centre on the undeformed top face. Roll and pitch of
                  angles or pose are then not used and may be None; `angles` tells what they became.

        Raises ValueError for a value that is not a finite number and for a time before the last, TypeError for both or neither
        of height and force, for moments without a force, and for a part of the pose beside it.
        """
        if pose is not None:
            position, height, angles = _parted(pose, position, height, angles, force)
        kind, value = one_load(height, force, "")
        time = float(finite("time", time, ()))
        require_ascending_times(numpy.reshape(time, 1), self._time)
        place = finite("position", position, (2,))
        value = finite("force" if kind else "height", value, ())
        angles = (0, 0, 0) if angles is None else angles
        if moments is not None:
            if kind != FORCE:
                raise TypeError("moments: they are held with a force, not with a height")
            moments, angles = finite("moments", moments, (2,)), (0, 0, *angles[2:])
        angles = finite("angles", angles, (3,))
        require_turns("yaw", angles[2])
        signals = numpy.empty(len(self._columns))
        if moments is None:
            flags = self._library.ionskin_live_step_posed(self._handle, time, *place, pointer(angles), kind, value, pointer(signals))
        else:
            flags = self._library.ionskin_live_step_held(self._handle, time, *place, angles[2], value, pointer(moments), pointer(signals))
        self._time, self._stepped = time, True
        return Signals(self._columns, signals, flags)

    @property
    def angles(self) -> tuple[float, float, float]:
        """Roll, pitch and yaw that the last step took [rad]; zeros before the first."""
        values = numpy.empty(3)
        self._library.ionskin_live_angles(self._handle, pointer(values))
        return tuple(values.tolist())

    def stiffness(self) -> numpy.ndarray:
        """Derivative of the wrench on the skin at the end of the last step with respect to a rigid motion of the slider.

        Returns an array [6, 6]: rows are the forces along x, y, z [N] and the moments about x, y, z [N m], columns the
        translations along x, y, z [m] and the rotations about x, y, z through the slider's centre on the undeformed top face
        [rad]. Columns 1, 3 and 5 are NaN for a skin that is solved as one symmetric half, as for a path on the middle line of the
        skin; docs/live.md says how to train the whole.

        Raises ValueError if no step led to this state, ArithmeticError if the equations were not solved.
        """
        return self._derivatives("stiffness", 6)

    @property
    def charge_names(self) -> tuple[str, ...]:
        """Names of the signals that are charges: top and bottom electrode, then the taxels."""
        return tuple(name for name in self._columns if name.startswith("charge_"))

    def charge_derivatives(self) -> numpy.ndarray:
        """Derivatives of the charges at the end of the last step with respect to the motions of `stiffness`: an array
        [charge, 6] [C/m], [C/rad], rows in the order of `charge_names`. NaN columns and exceptions are those of `stiffness`."""
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
        """Makes many steps and returns their signals as arrays [n].

        times [n], positions [n, 2], heights or forces [n], angles [n, 3] as in `step`. Raises as `step` does.
        """
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

    def random_touch(self, seed: int = 1, number: int = 0, interval: float = 1e-3) -> dict[str, numpy.ndarray]:
        """Draws a random touch within the trained range, such as those of which `errors` states the errors: the slider waits
        above the skin, lands, slides and rests in turn, turns back, changes its force, lifts off and waits. docs/training-data.md
        says how its pieces are distributed.

        seed      whole number from 0 on
        number    number of the touch, from 0 on; a touch depends on the seed and its number alone
        interval  time between two steps [s]; steps of more than a millisecond cut corners of the touch

        Returns the arguments of `run` as a dict: times [step] [s] from one interval on, positions [step, 2] [m], angles [step, 3]
        [rad], and forces [step] [N], 0 without contact, or heights [step] [m] if the skin was trained with heights. Friction
        is not part of it. Raises ValueError for an interval that is not above 0, and for another seed or number.
        """
        seed, number = whole("seed", seed, 0), whole("number", number, 0)
        if not finite("interval", interval, ()) > 0:
            raise ValueError(f"interval: {interval:g} s is not above 0")
        mixed = int(numpy.random.SeedSequence([seed, number]).generate_state(1, numpy.uint64)[0])
        rows = numpy.empty((TOUCH_ROWS, 7))
        kind = ctypes.c_int()
        count = self._library.ionskin_live_random_touch(self._handle, mixed, pointer(rows), ctypes.byref(kind))
        if not count:
            raise MemoryError("no memory for a touch")
        corners = rows[:count].T
        times = interval * numpy.arange(1, int(numpy.floor(corners[0, -1] / interval * (1 + 1e-12))) + 1)
        x, y, loads, *angles = (numpy.interp(times, corners[0], column) for column in corners[1:])
        return {"times": times, "positions": numpy.column_stack([x, y]), "forces" if kind.value == FORCE else "heights": loads,
                "angles": numpy.column_stack(angles)}

    def play(self, path: str | os.PathLike, times: Sequence[float], positions, *, heights=None, forces=None) -> Signals:
        """Makes steps as `run` does, returns their signals, and writes an HTML page that plays them in a browser without
        network: the slider over the skin, the taxels coloured by their currents, the signals over time."""
        from ..page import live_page  # a controller needs no templates

        signals = self.run(times, positions, heights=heights, forces=forces)
        live_page.write(path, self, numpy.asarray(times, dtype=float), signals)
        return signals

    def batch(self, trajectories: Sequence[Mapping], threads: int | None = None) -> list[Signals]:
        """Runs many trajectories, each from the present state, which stays as it is.

        trajectories  mappings with the arguments of `run`
        threads       number of threads; None for one for each processor

        Returns the signals of each trajectory, in their order. Raises as `run` does, with the index of the trajectory.
        """
        threads = os.cpu_count() if threads is None else whole("threads", threads, 1)
        trajectories = list(trajectories)
        for number, arguments in enumerate(trajectories):
            _require_arguments(f"trajectories[{number}]", arguments)

        def one(number: int) -> Signals:
            try:
                return self.copy().run(**trajectories[number])
            except (TypeError, ValueError) as wrong:
                wrong.args = (f"trajectories[{number}]: {wrong}",)
                raise

        with ThreadPoolExecutor(threads) as pool:
            return list(pool.map(one, range(len(trajectories))))

    def copy(self) -> "Skin":
        """Returns a second skin of the same file in the same state."""
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
        """Opens the file again, by its absolute path. Raises ValueError if its content has changed."""
        self.__init__(kept["path"])
        if self._digest != kept["digest"]:
            raise ValueError(f"{kept['path']}: the file is another than that of the skin that was kept")
        self.restore(kept["state"])
        if self.friction != kept["friction"]:
            self.friction = kept["friction"]

    def save(self) -> bytes:
        """Returns the state as bytes, for `restore` of a skin of the same file."""
        state = numpy.empty(self._library.ionskin_live_state_size(self._handle))
        self._library.ionskin_live_save(self._handle, pointer(state))
        return state.tobytes()

    def restore(self, state: bytes) -> None:
        """Restores a state that `save` returned, or a row of `Skins.save`; the time may go back. Raises ValueError, with nothing changed, for a state of
        another skin and for a damaged one."""
        try:
            values = numpy.frombuffer(state)
        except (TypeError, ValueError, BufferError) as wrong:
            raise ValueError(f"state: the bytes that save returned are wanted, not {state!r:.40}") from wrong
        size = self._library.ionskin_live_state_size(self._handle)
        if len(values) == size + 1:  # of Skins, with its steps of noise
            values = values[:size]
        if not self._library.ionskin_live_restore(self._handle, pointer(values), len(values)):
            raise ValueError("state: is that of a skin from another file, or damaged: a number is not finite or beyond what a "
                             "step can leave")
        # First numbers of a state: whether it was stepped, and when.
        self._time, self._stepped = float(values[1]) if values[0] else None, False

    def reset(self) -> None:
        """Resets the skin: detached and at rest."""
        self._library.ionskin_live_reset(self._handle)
        self._time, self._stepped = None, False


_TAKEN = ("times", "positions", "heights", "forces", "angles")


def _require_arguments(name: str, arguments) -> None:
    """Raises TypeError for anything but a mapping with arguments of `Skin.run`."""
    if not isinstance(arguments, Mapping):
        raise TypeError(f"{name}: a mapping with the arguments of run is wanted, not {arguments!r:.40}")
    for argument in _TAKEN[:2]:
        if argument not in arguments:
            raise TypeError(f"{name}: {argument} is missing")
    for argument in arguments:
        if argument not in _TAKEN:
            raise TypeError(f"{name}: run takes no {argument}\n  = it takes {', '.join(_TAKEN)}")


def _parted(pose, position, height, angles, force):
    """Splits a pose into position, height and angles. Raises TypeError where one of these is given beside it, ValueError
    for a pose that has not six numbers."""
    if position is not None or height is not None or angles is not None:
        raise TypeError("give either a pose or position, height and angles, not both")
    if len(pose) != 6:
        raise ValueError(f"pose: {len(pose)} numbers, and must be six: x, y, z, roll, pitch, yaw")
    return pose[:2], pose[2] if force is None else None, pose[3:]


def _digest(path: str | os.PathLike) -> bytes:
    """Returns the digest that ends the file of a live skin."""
    with open(path, "rb") as file:
        file.seek(-32, os.SEEK_END)
        return file.read()
