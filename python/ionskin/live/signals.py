# SPDX-License-Identifier: Apache-2.0
"""Signals of a reduced-order skin, the errors of these signals, and the range for which the skin was trained."""

import dataclasses
from collections.abc import Mapping

import numpy

OUTSIDE_PLACE, OUTSIDE_LOAD, OUTSIDE_SPEED, UNCONVERGED, REFUSED, PULLED, OUTSIDE_POSE, TOO_NEAR = 1, 2, 4, 8, 16, 32, 64, 128


@dataclasses.dataclass(frozen=True)
class SignalError:
    """Error of a signal against the full model, on touches on which the skin was not trained; all in the signal's SI unit.

    rms      root mean square of the error
    worst    largest error
    largest  largest magnitude of the signal itself
    """

    rms: float
    worst: float
    largest: float


class LiveSkinWarning(UserWarning):
    """Warning that the reported errors of a reduced-order skin are larger than ionskin promises."""


@dataclasses.dataclass(frozen=True)
class Range:
    """Range for which a reduced-order skin was trained.

    lowest, highest  corners (x, y) of the rectangle of positions of the slider's centre [m]
    force            largest normal force [N]
    indentation      largest indentation [m]
    speed            largest speed along the skin [m/s]
    friction         lowest and highest coefficient of friction [1]
    tilt             largest tilt of the slider [rad]
    turn             largest rate of turn about z [rad/s]
    """

    lowest: tuple[float, float]
    highest: tuple[float, float]
    force: float
    indentation: float
    speed: float
    friction: tuple[float, float]
    tilt: float = 0.0
    turn: float = 0.0


class Signals(Mapping):
    """Signals of one or several steps of a reduced-order skin, by name, in SI units.

    `signals["normal_force"]` is a number after `Skin.step`, an array [step] after `Skin.run`, [environment] after `Skins.step`.
    `flags`, a number or an array alike, is 0 for a valid step, else the sum of:

    OUTSIDE_PLACE, OUTSIDE_LOAD, OUTSIDE_POSE  position, load or tilt was outside the trained range, and set to the nearest
                                               trained value
    OUTSIDE_SPEED  the slider moved or turned faster than trained
    UNCONVERGED    the contact solver ended with a residual above 1e-3
    PULLED         the force was negative, and the slider detached
    TOO_NEAR       (`Fingers`) two sliders that touch come so close that one moves the skin under the other
    REFUSED        (`Skins.step`) an input was not finite or the time went back, and the environment did not move
    """

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
        """All signals as an array [..., signal], with the signals in the order of the names."""
        return self._values

    @property
    def outside(self):
        """True where a step was outside the trained range of position, load, speed or pose, or two fingers were too near; a
        boolean, or an array like `flags`."""
        return (self.flags & (OUTSIDE_PLACE | OUTSIDE_LOAD | OUTSIDE_SPEED | OUTSIDE_POSE | TOO_NEAR)) != 0

    def __repr__(self) -> str:
        return f"Signals({', '.join(f'{name}={self[name]!r}' for name in self)})"
