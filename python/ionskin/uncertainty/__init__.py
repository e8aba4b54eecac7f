# SPDX-License-Identifier: Apache-2.0
"""Effect of uncertain keys of a case on its results: the command `ionskin uncertainty`, and its study by ask and tell."""

from .study import Analysis, Uncertainty

__all__ = ["Analysis", "Uncertainty"]
