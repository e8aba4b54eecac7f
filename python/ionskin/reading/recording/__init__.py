# SPDX-License-Identifier: Apache-2.0
"""Paths of waypoints for the slider, made from recordings of a robot."""

from .making import motion
from .path import Path

__all__ = ["Path", "motion"]
