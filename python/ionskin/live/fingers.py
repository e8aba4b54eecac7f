# SPDX-License-Identifier: Apache-2.0
"""Several sliders on one reduced skin."""

import os
import tomllib
from collections.abc import Iterator, Sequence

import numpy

from .checks import finite, one_load
from .signals import TOO_NEAR, SignalError, Signals
from .skin import Skin, require_ascending_times, require_turns

MOST_FINGERS = 4
_SHARED_TABLES = ("skin", "materials", "electrochemistry", "coupling", "water", "readout")
_SUMMED = ("charge_", "current_", "sampled_current_", "mean_shear", "shear_first_moment")
_REACH = 2.5  # core thicknesses over which one finger moves the skin under another


class Fingers:
    """Up to four sliders on one skin, each a `Skin` that was trained with that slider as the only one.

    Charges, currents and the shear of the core are linear in what the sliders do to it, and are sums over the fingers. Signals
    of a finger itself, such as its forces, end in _2, _3 and _4 for those behind the first. How one finger moves the skin
    under another is neglected: where two that touch come closer than 2.5 core thicknesses, both are flagged TOO_NEAR.
    """

    def __init__(self, skins: Sequence[Skin | str | os.PathLike]) -> None:
        """Skins, or their files; a skin that is given is stepped itself. ValueError: more than four or none, a skin that stands
        twice, or skins of different layers, materials, ions or readout."""
        self.skins = tuple(skin if isinstance(skin, Skin) else Skin(skin) for skin in skins)
        if not 1 <= len(self.skins) <= MOST_FINGERS:
            raise ValueError(f"skins: {len(self.skins)} fingers, and must be 1 to {MOST_FINGERS}")
        if len(set(map(id, self.skins))) < len(self.skins):
            raise ValueError("skins: one skin stands twice; give each finger its own, such as skin.copy()")
        tables = [_shared(skin.case) for skin in self.skins]
        for number, own in enumerate(tables[1:], 2):
            for name in _SHARED_TABLES:
                if own[name] != tables[0][name]:
                    raise ValueError(f"skins: finger {number} was trained on another skin than finger 1: [{name}] differs; train "
                                     "all from one case, such as by ionskin live CASE.toml --slider NUMBER")
        self._names()

    def _names(self) -> None:
        self._columns: dict[str, int] = {}
        self._targets = []  # of the signals of each skin: their columns
        for number, skin in enumerate(self.skins, 1):
            self._targets.append([self._columns.setdefault(_name(name, number), len(self._columns)) for name in skin.names])

    def __len__(self) -> int:
        return len(self.skins)

    def __iter__(self) -> Iterator[Skin]:
        return iter(self.skins)

    def __getitem__(self, finger: int) -> Skin:
        return self.skins[finger]

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the signals."""
        return tuple(self._columns)

    @property
    def size(self) -> tuple[float, float]:
        """Length and width of the skin [m]."""
        return self.skins[0].size

    @property
    def taxels(self) -> dict[str, tuple[float, float, float, float]]:
        """Lowest x, y, highest x, y of every taxel [m]."""
        return self.skins[0].taxels

    @property
    def errors(self) -> dict[str, SignalError]:
        """Errors by signal; of a sum, the sums of the errors and of the largest values of the fingers."""
        errors: dict[str, SignalError] = {}
        for number, skin in enumerate(self.skins, 1):
            for own_name, own in skin.errors.items():
                name = _name(own_name, number)
                before = errors.get(name, SignalError(0, 0, 0))
                errors[name] = SignalError(before.rms + own.rms, before.worst + own.worst, before.largest + own.largest)
        return errors

    def step(self, time: float, positions, *, heights=None, forces=None, angles=None) -> Signals:
        """Signals at a time [s], with the sliders at positions [finger, (x, y)] [m], each at a height [finger] above the
        undeformed top face [m], negative when it indents, or pressed by a force [finger] [N], 0 for none; `angles` are roll,
        pitch and yaw [finger, 3] [rad]. `flags` of the signals is an array [finger].
        ValueError: a value that is not a number, or a time before the last; no finger moves then."""
        kind, values = one_load(heights, forces, "s")
        name = "forces" if kind else "heights"
        signals = self.run(numpy.reshape(finite("time", time, ()), 1), finite("positions", positions, (len(self), 2))[None],
                           angles=None if angles is None else finite("angles", angles, (len(self), 3))[None],
                           **{name: finite(name, values, (len(self),))[None]})
        return Signals(self._columns, signals.array[0], signals.flags[0])

    def run(self, times: Sequence[float], positions, *, heights=None, forces=None, angles=None) -> Signals:
        """Many steps: times [n], positions [n, finger, 2], heights or forces [n, finger], angles [n, finger, 3]; signals are
        arrays [n], and flags an array [n, finger]. ValueError as `step`."""
        kind, values = one_load(heights, forces, "s")
        name = "forces" if kind else "heights"
        shape = (numpy.size(times), len(self))
        times = finite("times", times, shape[:1])
        positions = finite("positions", positions, (*shape, 2))
        values = finite(name, values, shape)
        angles = finite("angles", numpy.zeros((*shape, 3)) if angles is None else angles, (*shape, 3))
        require_turns("yaw", numpy.abs(angles[..., 2]).max(initial=0))
        require_ascending_times(times, max((skin.time for skin in self.skins if skin.time is not None), default=None))
        signals = numpy.zeros((len(times), len(self._columns)))
        flags = numpy.zeros(shape, dtype=numpy.uint32)
        for finger, (skin, targets) in enumerate(zip(self.skins, self._targets)):
            own = skin.run(times, positions[:, finger], angles=angles[:, finger], **{name: values[:, finger]})
            flags[:, finger] = own.flags
            for column, target in enumerate(targets):
                signals[:, target] += own.array[:, column]
        self._flag_near(signals, flags)
        return Signals(self._columns, signals, flags)

    def _flag_near(self, signals: numpy.ndarray, flags: numpy.ndarray) -> None:
        def of(name: str, finger: int) -> numpy.ndarray:
            return signals[:, self._columns[_name(name, finger + 1)]]

        boxes = [skin.footprint for skin in self.skins]
        reach = _REACH * self.skins[0].core_thickness
        for one in range(len(self)):
            for other in range(one):
                gaps = []
                for axis, name in enumerate(("slider_x", "slider_y")):
                    apart = of(name, one) - of(name, other)
                    gaps.append(numpy.maximum(apart + boxes[one][axis] - boxes[other][2 + axis],
                                              boxes[other][axis] - boxes[one][2 + axis] - apart).clip(min=0))
                near = ((numpy.hypot(*gaps) < reach) & (of("normal_force", one) > 0) & (of("normal_force", other) > 0))
                flags[near, one] |= TOO_NEAR
                flags[near, other] |= TOO_NEAR

    def copy(self) -> "Fingers":
        """A second one, in the same state."""
        return Fingers([skin.copy() for skin in self.skins])

    __copy__ = copy

    def __deepcopy__(self, memo) -> "Fingers":
        return self.copy()

    def save(self) -> list[bytes]:
        """The states of the skins, to be restored by those of the same files."""
        return [skin.save() for skin in self.skins]

    def restore(self, states: Sequence[bytes]) -> None:
        """Takes up states; time may go back by it. ValueError when they are not those of such skins; nothing changes then."""
        if len(states) != len(self):
            raise ValueError(f"states: {len(states)} of them, and there are {len(self)} fingers")
        before = self.save()
        try:
            for skin, state in zip(self.skins, states):
                skin.restore(state)
        except ValueError:
            for skin, state in zip(self.skins, before):
                skin.restore(state)
            raise

    def reset(self) -> None:
        """Back to a detached skin at rest."""
        for skin in self.skins:
            skin.reset()


def _shared(case: str) -> dict:
    """Tables of a case that all sliders on a skin share; of the readout, what the live skin reads."""
    tables = tomllib.loads(case)
    return {name: tables.get(name, {}) for name in _SHARED_TABLES}


def _name(name: str, number: int) -> str:
    """Name among the signals of all for a signal of a finger, counted from 1."""
    return name if number == 1 or name.startswith(_SUMMED) else f"{name}_{number}"
