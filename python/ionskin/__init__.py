# SPDX-License-Identifier: Apache-2.0
"""Read the results of ionskin, draw them and make the report of a run."""

from .results import Metric, Results, Table

__all__ = ["Metric", "Results", "Table"]
