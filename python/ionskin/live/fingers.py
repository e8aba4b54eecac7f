# SPDX-License-Identifier: Apache-2.0
"""Several sliders on one reduced skin."""

import os
import tomllib
from collections.abc import Iterator, Sequence

import numpy

from .checks import finite, one_load, require_ascending_times, require_turns
from .signals import TOO_NEAR, SignalError, Signals
from .skin import Skin

MOST_FINGERS = 4
_SHARED_TABLES = ("skin", "materials", "electrochemistry", "coupling", "water", "readout")
_SUMMED = ("charge_", "current_", "sampled_current_")
_ADDITIVE_LAWS = ("column-neutral", "poroelastic")  # the strain far from a finger, the same through the core, moves no charge
_LINEAR_MEASURE = "signed-xz"
_REACH = 2.5  # distance over which one finger deforms the skin under another [core thicknesses]


class Fingers:
    """Reduced-order skin under up to four sliders. Each slider is a `Skin` of its own, trained with that slider only.

    Charges and currents are sums over the fingers, under the coupling laws and measures that allow it (`require_additive`).
    Signals of a single finger, such as its forces and the shear that it makes by itself, end in _2, _3 and _4 for the second, third
    and fourth finger. The class neglects how one finger deforms the skin under another: if two fingers touch and their contact
    cells come closer than 2.5 core thicknesses, both get the flag TOO_NEAR.
    """

    def __init__(self, skins: Skin | str | os.PathLike | Sequence[Skin | str | os.PathLike]) -> None:
        """Combines skins.

        skins  1 to 4 skins, or paths of their files; a `Skin` object is used itself, not copied. One skin, or one path, is one
               finger

        Raises ValueError for another number of skins, for one object given twice, for skins whose layers, materials, ions,
        coupling, water or readout differ, and for a coupling under which the charges of several fingers are no sums.
        """
        if isinstance(skins, (Skin, str, os.PathLike)):
            skins = [skins]
        self.skins = tuple(skin if isinstance(skin, Skin) else Skin(skin) for skin in skins)
        if not 1 <= len(self.skins) <= MOST_FINGERS:
            raise ValueError(f"skins: {len(self.skins)} fingers, and must be 1 to {MOST_FINGERS}")
        if len(set(map(id, self.skins))) < len(self.skins):
            raise ValueError("skins: one skin stands twice; give each finger its own, such as skin.copy()")
        require_additive(self.skins)
        self._names()

    def _names(self) -> None:
        self._columns: dict[str, int] = {}
        self._targets = []  # [finger][signal of that skin]: column among all signals
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
        """Names of all signals."""
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
        """Stated errors, a dict of signal name to SignalError. For a signal that is a sum, errors and largest values of the
        fingers are added."""
        errors: dict[str, SignalError] = {}
        for number, skin in enumerate(self.skins, 1):
            for own_name, own in skin.errors.items():
                name = _name(own_name, number)
                before = errors.get(name, SignalError(0, 0, 0))
                errors[name] = SignalError(before.rms + own.rms, before.worst + own.worst, before.largest + own.largest)
        return errors

    def step(self, time: float, positions, *, heights=None, forces=None, angles=None) -> Signals:
        """Steps all fingers to a time and returns their signals; `flags` is an array [finger].

        time       [s], not before that of the last step
        positions  centres of the sliders [finger, (x, y)] [m]
        heights    heights of the undersides above the undeformed top face [finger] [m], below 0 where they indent; or instead
        forces     normal forces [finger] [N]; a finger with 0 is detached
        angles     roll, pitch and yaw [finger, 3] [rad]; None for upright sliders

        Raises ValueError for a value that is not a finite number, and for a time before the last; no finger moves then.
        Raises TypeError for both or neither of heights and forces.
        """
        kind, values = one_load(heights, forces, "s")
        name = "forces" if kind else "heights"
        signals = self.run(numpy.reshape(finite("time", time, ()), 1), finite("positions", positions, (len(self), 2))[None],
                           angles=None if angles is None else finite("angles", angles, (len(self), 3))[None],
                           **{name: finite(name, values, (len(self),))[None]})
        return Signals(self._columns, signals.array[0], signals.flags[0])

    def run(self, times: Sequence[float], positions, *, heights=None, forces=None, angles=None) -> Signals:
        """Makes many steps and returns their signals as arrays [step]; `flags` is an array [step, finger].

        The arguments are those of `step` with a first axis [step] each. Raises as `step` does.
        """
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
        self._flag_near(signals, positions, flags)
        return Signals(self._columns, signals, flags)

    def _flag_near(self, signals: numpy.ndarray, given: numpy.ndarray, flags: numpy.ndarray) -> None:
        """Flags fingers that touch and are too near each other, at the places [step, finger, 2] that were given or at those
        within the trained range that were taken instead."""
        def of(name: str, finger: int) -> numpy.ndarray:
            return signals[:, self._columns[_name(name, finger + 1)]]

        taken = numpy.stack([numpy.column_stack([of("slider_x", finger), of("slider_y", finger)]) for finger in range(len(self))], axis=1)
        boxes = [skin.footprint for skin in self.skins]
        reach = _REACH * self.skins[0].core_thickness
        for one in range(len(self)):
            for other in range(one):
                near = numpy.zeros(len(signals), dtype=bool)
                for places in (given, taken):
                    gaps = []
                    for axis in range(2):
                        apart = places[:, one, axis] - places[:, other, axis]
                        gaps.append(numpy.maximum(apart + boxes[one][axis] - boxes[other][2 + axis],
                                                  boxes[other][axis] - boxes[one][2 + axis] - apart).clip(min=0))
                    near |= numpy.hypot(*gaps) < reach
                near &= (of("normal_force", one) > 0) & (of("normal_force", other) > 0)
                flags[near, one] |= TOO_NEAR
                flags[near, other] |= TOO_NEAR

    def copy(self) -> "Fingers":
        """Returns a second object with copies of all skins, in the same states."""
        return Fingers([skin.copy() for skin in self.skins])

    __copy__ = copy

    def __deepcopy__(self, memo) -> "Fingers":
        return self.copy()

    def save(self) -> list[bytes]:
        """Returns the states of the skins, one `bytes` object for each finger, for `restore`."""
        return [skin.save() for skin in self.skins]

    def restore(self, states: Sequence[bytes]) -> None:
        """Restores states that `save` returned; the time may go back. Raises ValueError, with nothing changed, for states of
        other skins or of another number of fingers."""
        if not isinstance(states, Sequence):
            raise ValueError(f"states: the list that save returned is wanted, not {states!r:.40}")
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
        """Resets all fingers: detached, with the skin at rest."""
        for skin in self.skins:
            skin.reset()


def require_additive(skins: Sequence[Skin]) -> None:
    """Raises ValueError for skins of different cases, and for a coupling under which charges of several fingers are no sums."""
    tables = [_shared(skin.case) for skin in skins]
    for number, own in enumerate(tables[1:], 2):
        for name in _SHARED_TABLES:
            if own[name] != tables[0][name]:
                raise ValueError(f"skins: finger {number} was trained on another skin than finger 1: [{name}] differs; train all "
                                 "from one case, such as by ionskin live CASE.toml --slider NUMBER")
    coupling = tables[0]["coupling"]
    law = coupling.get("law", "fixed-charge")
    if len(skins) > 1 and law not in _ADDITIVE_LAWS and coupling.get("measure") != _LINEAR_MEASURE:
        raise ValueError(f'skins: under coupling.law = "{law}" the charges of several fingers are no sums, because the magnitude of '
                         'the shear that all make is not the sum of magnitudes; train with coupling.law = "column-neutral" or '
                         'coupling.measure = "signed-xz", or run the full model')


def _shared(case: str) -> dict:
    """Tables of a case, given as TOML text, that must be the same for all fingers on a skin."""
    tables = tomllib.loads(case)
    return {name: tables.get(name, {}) for name in _SHARED_TABLES}


def _name(name: str, number: int) -> str:
    """Name, among the signals of all fingers, of a signal of one finger; `number` counts fingers from 1."""
    return name if number == 1 or name.startswith(_SUMMED) else f"{name}_{number}"
