# SPDX-License-Identifier: Apache-2.0
"""Results of a fit."""

import json
import pathlib
from typing import Any, NamedTuple

import numpy

from .results import read_json, read_table, whole


class Estimate(NamedTuple):
    """One fitted key: its value with the ends of its 95 % interval, in the SI unit.

    Ends that the data do not tell are None. log_standard_error: of the logarithm of the value; None likewise, and of a
    key of the data (data.time_shift, ...), whose interval is symmetric.
    """

    value: float
    unit: str
    lower_95: float | None
    upper_95: float | None
    log_standard_error: float | None
    start: float
    at_bound: bool


class Fit:
    """A fit: estimates, statistics, and the fitted rows.

    parameters              Estimate by key
    time, measured, fitted  arrays [rows], SI; `column` and `unit` say of what
    fitted_error            stated numerical error of `fitted`, array [rows]; None where there is none
    correlation             array [parameters, parameters] of the estimates
    condition_number        of the derivatives by the logarithms of the parameters; None when singular
    warnings                what a reader must know
    summary                 dict, as in fit.json
    folder                  where the results are; None when nothing was written
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
        """Reads the folder of `ionskin fit`. Raises FileNotFoundError when it holds no fit.json."""
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
        """Fit made of the text of fit.json and the fitted rows."""
        return cls(json.loads(text), time, measured, fitted)

    def __getitem__(self, key: str) -> float:
        return self.parameters[key].value

    def __repr__(self) -> str:
        lines = [f"{key} = {one.value:.6g}{'' if one.unit == '1' else ' ' + one.unit} "
                 f"(95 %: {_end(one.lower_95)} to {_end(one.upper_95)})" for key, one in self.parameters.items()]
        return "\n".join(lines + [f"warning: {text}" for text in self.warnings])


def _end(value: float | None) -> str:
    return "unknown" if value is None else f"{value:.6g}"
