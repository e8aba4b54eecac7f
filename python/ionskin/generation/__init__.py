# SPDX-License-Identifier: Apache-2.0
"""Training data: many random touches of one case in one store."""

from .touches import Touches

__all__ = ["Touches"]
