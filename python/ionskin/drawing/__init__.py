# SPDX-License-Identifier: Apache-2.0
"""Figures drawn with matplotlib, for files and for the pages of sweeps."""

import os
import sys

from ..isolated import import_matplotlib

if sys.flags.isolated:
    import_matplotlib(os.path.dirname(os.path.abspath(__file__)))
