# SPDX-License-Identifier: Apache-2.0
"""Fits: values of keys of a case, estimated from measured data by least squares."""

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
    """Model that is fitted to measured data: a case as a function of some of its keys. It can fit one data set after
    another.

    case     the case; its values are the start of the fit
    free     names of the keys to fit: keys of single real numbers that are not 0 in the case, whose sign the fit keeps; and
             parameters of the data: "data.time_shift", "data.baseline", "data.drift", "data.gain", whose starting values the
             fit finds itself
    threads  largest number of threads; 0: one for each processor
    cache    ignored

    The mechanics (Study 1) is solved only once when the keys do not change it. Every solution is stored and reused.

    Raises CaseError when the case is wrong or a key cannot be fitted.
    """

    def __init__(self, case: Case, free: Sequence[str], *, threads: int = 0, cache: bool = True) -> None:
        self._model = solver.load().FitModel(case, list(free), threads)

    def fit(self, time, values, column: str = "current_difference", *, progress: Progress | None = None) -> Fit:
        """Fits the free keys to one measured signal by least squares and returns the Fit.

        Keys of the case are fitted by their logarithms, parameters of the data by their values.

        time      array [rows]: strictly ascending instants [s]
        values    array [rows]: the signal in its SI unit; rows with NaN or infinity are ignored
        column    name of the signal: a current, a charge or the voltage as in signals.csv, or such a signal of a taxel as in
                  taxels.csv. A current is the mean since the row before; a voltage, too, in data that come at one rate
        progress  called with (activity, finished fraction in [0, 1]); None for no calls

        Raises CaseError when the data or the column cannot be used, SolverError, and KeyboardInterrupt.
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
    """Fits keys of a case to measured data in a file, as `ionskin fit` does, writes the results and returns the Fit.

    data       CSV file with units in its header, such as: time [s],current_difference [uA]
    free       names of the keys to fit, as those of FitModel
    output     folder for fitted.toml, fit.json and fit.csv, and with `report` for the figure
    column     name of the signal to fit; "" when the data hold only one
    overwrite  True to replace earlier results in the folder
    resume     True to continue an interrupted fit of the same case, data and keys in its folder

    `threads`, `progress` and `cache` are those of `run`. Raises CaseError before any work, SolverError, and KeyboardInterrupt.
    """
    settings = solve_settings(os.fspath(output), threads, overwrite, resume, "", report, "fit")
    solver.load().fit_folder(case, os.fsencode(data), column, list(free), settings, progress)
    return Fit.from_folder(output)
