# SPDX-License-Identifier: Apache-2.0
"""How uncertain keys of a case make its results: `ionskin uncertainty`, and the same by ask and tell."""

from .study import Analysis, Uncertainty

__all__ = ["Analysis", "Uncertainty"]
