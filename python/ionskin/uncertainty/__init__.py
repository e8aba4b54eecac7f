# SPDX-License-Identifier: Apache-2.0
"""Effect of uncertain keys of a case on its results: `ionskin uncertainty`, and the same by ask and tell."""

from .study import Analysis, Uncertainty

__all__ = ["Analysis", "Uncertainty"]
