# SPDX-License-Identifier: Apache-2.0
"""Signals of a live skin, their errors and the range that it was trained for."""

import dataclasses
from collections.abc import Mapping

import numpy

OUTSIDE_PLACE, OUTSIDE_LOAD, OUTSIDE_SPEED, UNCONVERGED, REFUSED, PULLED, OUTSIDE_POSE, TOO_NEAR = 1, 2, 4, 8, 16, 32, 64, 128


@dataclasses.dataclass(frozen=True)
class SignalError:
    """Error of a signal on touches that the skin was not trained on, and the signal's largest value, in its unit."""

    rms: float
    worst: float
    largest: float


class LiveSkinWarning(UserWarning):
    """A live skin states errors that are larger than promised."""


@dataclasses.dataclass(frozen=True)
class Range:
    """Range that the skin was trained for: places of the slider's centre [m], force [N], indentation [m], speed [m/s],
    lowest and highest coefficient of friction, tilt [rad], turn about z [rad/s]."""

    lowest: tuple[float, float]
    highest: tuple[float, float]
    force: float
    indentation: float
    speed: float
    friction: tuple[float, float]
    tilt: float = 0.0
    turn: float = 0.0


class Signals(Mapping):
    """Signals by name, SI units. `flags` is 0 where all is well, else the sum of OUTSIDE_PLACE, OUTSIDE_LOAD,
    OUTSIDE_SPEED, UNCONVERGED, PULLED, OUTSIDE_POSE and, of `Fingers`, TOO_NEAR; of `Skin.run` an array."""

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
    def array(self) -> numpy.ndarray:
        """All signals, of which the last axis is that of the names."""
        return self._values

    @property
    def outside(self):
        """True where a step lies outside the trained range, in place, load, speed or pose, or fingers are too near."""
        return (self.flags & (OUTSIDE_PLACE | OUTSIDE_LOAD | OUTSIDE_SPEED | OUTSIDE_POSE | TOO_NEAR)) != 0

    def __repr__(self) -> str:
        return f"Signals({', '.join(f'{name}={self[name]!r}' for name in self)})"
