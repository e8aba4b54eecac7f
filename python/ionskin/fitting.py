# SPDX-License-Identifier: Apache-2.0
"""Fit keys of a case to measured data."""

import os
import threading
from collections.abc import Sequence

import numpy

from . import solver
from .case import Case
from .errors import CaseError
from .fit_results import Fit
from .running import Progress, solve_settings


class FitModel:
    """A case as a function of a few of its keys, to be fitted to one set of data after another.

    free     keys of single real numbers, not 0 in the case, from which the fit starts; their signs stay. Of the data:
             data.time_shift, data.baseline, data.drift, data.gain, whose starts the fit finds itself
    threads  at most so many; 0: all processors
    cache    has no effect any more

    The mechanics is solved once where the keys leave it the same, and every solution is kept. Raises CaseError.
    """

    def __init__(self, case: Case, free: Sequence[str], *, threads: int = 0, cache: bool = True) -> None:
        self._model = solver.load().FitModel(case, list(free), threads)

    def fit(self, time, values, column: str = "current_difference", *, progress: Progress | None = None) -> Fit:
        """Least squares in the logarithms of the keys of the case, and in those of the data as they are.

        time, values  arrays [rows]: strictly ascending instants [s], and the signal in its SI unit; rows with NaN are
                      passed over
        column        the signal: a current (mean since the row before), a charge or the voltage, as in signals.csv, or one of
                      a taxel, as in taxels.csv; a voltage at one rate is a mean since the row before, too

        Raises CaseError, SolverError and KeyboardInterrupt.
        """
        time, values = (numpy.asarray(data, dtype=float) for data in (time, values))
        units = self._model.columns()
        if column not in units:
            raise CaseError(f"{column} is not a signal to fit\n  = known: {', '.join(units)}")
        if time.ndim != 1 or time.shape != values.shape:
            raise CaseError("time and values must be of one length, each a single row")
        if not numpy.isfinite(time).all():
            raise CaseError("a time is not a number")
        behind = numpy.flatnonzero(numpy.diff(time) <= 0)
        if len(behind):
            now, before = time[behind[0] + 1], time[behind[0]]
            raise CaseError(f"the time {now:.12g} s appears twice: average the values of one time, or drop all but one"
                            if now == before else f"the time must ascend, and {now:.12g} s comes after {before:.12g} s: "
                            "sort the rows by time")
        known = numpy.isfinite(values)
        main = threading.current_thread() is threading.main_thread()
        return Fit.from_text(*self._model.fit(column, units[column], time[known].tolist(), values[known].tolist(), main,
                                              progress))


def fit(case: Case, data: str | os.PathLike, free: Sequence[str], output: str | os.PathLike, *, column: str = "",
        threads: int = 0, progress: Progress | None = None, overwrite: bool = False, resume: bool = False,
        report: bool = False, cache: bool = True) -> Fit:
    """Fits keys of a case to a measurement in a file, and writes the results as `ionskin fit` does.

    data    CSV with units in its header, such as our own signals.csv: time [s],current_difference [uA]
    free    the keys, see FitModel
    output  folder: fitted.toml, fit.json, fit.csv, and with `report` the figure
    column  which signal of the data, where they hold several
    resume  go on with an interrupted fit of the same case, data and keys in its folder

    Raises CaseError before any work, SolverError and KeyboardInterrupt.
    """
    settings = solve_settings(os.fspath(output), threads, overwrite, resume, "", report, "fit")
    solver.load().fit_folder(case, os.fsencode(data), column, list(free), settings, progress)
    return Fit.from_folder(output)
