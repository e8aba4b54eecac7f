# SPDX-License-Identifier: Apache-2.0
"""A path of waypoints from what a robot recorded."""

from .making import motion
from .path import Path

__all__ = ["Path", "motion"]
