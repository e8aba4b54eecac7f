# SPDX-License-Identifier: Apache-2.0
"""Training data: signals and labels of many random touches of one case, in one HDF5 file."""

from .touches import Touches

__all__ = ["Touches"]
