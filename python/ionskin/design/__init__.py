# SPDX-License-Identifier: Apache-2.0
"""The best values of free keys under constraints, with few evaluations: ask and tell."""

from .search import Design

__all__ = ["Design"]
