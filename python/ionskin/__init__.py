# SPDX-License-Identifier: Apache-2.0
"""Read the results of ionskin, draw them and make the reports of runs and sweeps."""

from .results import Metric, Results, Table
from .sweep import Study, Sweep

__all__ = ["Metric", "Results", "Study", "Sweep", "Table"]
