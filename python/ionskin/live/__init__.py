# SPDX-License-Identifier: Apache-2.0
"""The reduced skin, stepped in a loop; `ionskin live CASE.toml -o skin.live` trains one.

    import ionskin.live
    skin = ionskin.live.Skin("skin.live")
    signals = skin.step(0.001, (6e-3, 1e-3), height=-0.5e-6)
    signals["normal_force"], signals["charge_top"]

`Skins` steps many of them together, for a learner; `Fingers` is one skin under several sliders.
"""

from .fingers import Fingers
from .signals import (OUTSIDE_LOAD, OUTSIDE_PLACE, OUTSIDE_POSE, OUTSIDE_SPEED, PULLED, REFUSED, TOO_NEAR, UNCONVERGED,
                      LiveSkinWarning, Range, SignalError, Signals)
from .skin import Skin
from .skins import Skins
from .touch_path import touch_path

__all__ = ["OUTSIDE_LOAD", "OUTSIDE_PLACE", "OUTSIDE_POSE", "OUTSIDE_SPEED", "PULLED", "REFUSED", "TOO_NEAR",
           "UNCONVERGED", "Fingers", "LiveSkinWarning", "Range", "SignalError", "Signals", "Skin", "Skins", "touch_path"]
