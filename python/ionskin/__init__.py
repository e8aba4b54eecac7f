# SPDX-License-Identifier: Apache-2.0
"""Run ionskin from Python, read its results, draw them and make the reports of runs and sweeps.

    import ionskin
    case = ionskin.Case.from_file("cases/quick.toml")
    case["contact.friction"] = 0.2
    result = ionskin.run(case)
    result.signals["current_difference"]  # numpy array; result.signals.units has its unit

Running needs the compiled solver (PYTHONPATH=build/python); reading and drawing do not.
"""

from .case import Case, Value
from .cluster.running import ClusterError
from .design import Design
from .errors import CaseError, SolverError
from .fit_results import Fit
from .fitting import FitModel, fit
from .reading.recording import motion
from .results import Metric, Results, Table
from .running import run, sweep
from .sweep_results import Study, Sweep, open_results
from .uncertainty import Analysis, Uncertainty

__all__ = ["Analysis", "Case", "CaseError", "ClusterError", "Design", "Fit", "FitModel", "Metric", "Results", "SolverError",
           "Study", "Sweep", "Table", "Uncertainty", "Value", "fit", "motion", "open_results", "run", "sweep"]
