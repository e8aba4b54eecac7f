# SPDX-License-Identifier: Apache-2.0
"""Results of a fit of keys of a case to measured data."""

import json
import pathlib
from typing import Any, NamedTuple

import numpy

from .results import read_json, read_table, whole


class Estimate(NamedTuple):
    """Estimate of one fitted key.

    value                fitted value, in SI units
    unit                 SI unit; "1" for pure numbers
    lower_95, upper_95   ends of the 95 % confidence interval, in SI units; None where the data do not determine the end
    log_standard_error   standard error of the logarithm of the value [1]; None where the data do not determine it, and for
                         parameters of the data (data.time_shift, ...), whose interval is symmetric
    start                value from which the fit started, in SI units
    at_bound             True if the value lies at a bound of the range that the key may have
    """

    value: float
    unit: str
    lower_95: float | None
    upper_95: float | None
    log_standard_error: float | None
    start: float
    at_bound: bool


class Fit:
    """Result of a fit: estimates of the keys, statistics, and the fitted signal. `fit["KEY"]` is the fitted value of a key.

    parameters        dict of key to Estimate
    column, unit      name of the fitted signal and its SI unit
    time              array [rows]: instants [s]
    measured, fitted  arrays [rows]: the measured signal and the fitted model, in `unit`
    fitted_error      array [rows]: numerical error estimate of `fitted`, in `unit`; None when the fit has none
    correlation       array [parameters, parameters]: correlation of the estimates [1]
    condition_number  condition number of the matrix of derivatives of the signal by the logarithms of the parameters [1];
                      None when it is singular
    warnings          list of texts that a reader should know; [] for none
    summary           dict: contents of fit.json
    folder            folder of the results; None when nothing was written
    """

    def __init__(self, summary: dict[str, Any], time, measured, fitted, folder: pathlib.Path | None = None) -> None:
        self.summary, self.folder = summary, folder
        self.parameters = {key: Estimate(**values) for key, values in summary["parameters"].items()}
        self.correlation = numpy.array(summary["correlation"])
        self.condition_number = summary["condition_number"]
        self.column, self.unit = summary["column"], summary["residual_deviation"]["unit"]
        self.warnings = summary["warnings"]
        self.fitted_error = None
        self.time, self.measured, self.fitted = (numpy.asarray(values, dtype=float) for values in (time, measured, fitted))

    @classmethod
    def from_folder(cls, folder) -> "Fit":
        """Reads a folder of `ionskin fit`. Raises FileNotFoundError without fit.json, CaseError for damaged files."""
        folder = pathlib.Path(folder)
        if not (folder / "fit.json").exists():
            raise FileNotFoundError(f"{folder} holds no fit.json: name the folder of a finished fit")
        summary, table = read_json(folder / "fit.json"), read_table(folder / "fit.csv")
        with whole(folder / "fit.json"):
            name = summary["column"]
            fit = cls(summary, table["time"], table[f"{name}_measured"], table[f"{name}_fitted"], folder)
            if f"{name}_fitted_error" in table:
                fit.fitted_error = table[f"{name}_fitted_error"]
            return fit

    @classmethod
    def from_text(cls, text: str, time, measured, fitted) -> "Fit":
        """Makes a Fit of the text of fit.json and arrays [rows] of time [s], measured and fitted signal in its SI unit."""
        return cls(json.loads(text), time, measured, fitted)

    def __getitem__(self, key: str) -> float:
        return self.parameters[key].value

    def __repr__(self) -> str:
        lines = [f"{key} = {one.value:.6g}{'' if one.unit == '1' else ' ' + one.unit} "
                 f"(95 %: {_end(one.lower_95)} to {_end(one.upper_95)})" for key, one in self.parameters.items()]
        return "\n".join(lines + [f"warning: {text}" for text in self.warnings])


def _end(value: float | None) -> str:
    return "unknown" if value is None else f"{value:.6g}"
