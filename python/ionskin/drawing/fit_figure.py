# SPDX-License-Identifier: Apache-2.0
"""Draws the figure of a fit from the folder of `ionskin fit`: /usr/bin/python3 -m ionskin.drawing.fit_figure FOLDER"""

import sys

import numpy

from ..fit_results import Fit
from . import making, style


def figure(fit: Fit):
    """Data and model over time, the residuals below."""
    drawing, axes = style.stacked(2, heights=[1.6, 0.8])
    divisor, prefix = style.si_scale(numpy.abs(fit.measured).max())
    axes[0].plot(fit.time, fit.measured / divisor, ".", color=style.PALE, markersize=3, label="measured")
    if fit.fitted_error is not None:
        axes[0].fill_between(fit.time, (fit.fitted - fit.fitted_error) / divisor,
                             (fit.fitted + fit.fitted_error) / divisor, color=style.BLUE, alpha=0.25, lw=0,
                             label="numerical error")
    axes[0].plot(fit.time, fit.fitted / divisor, color=style.BLUE, label="fitted")
    axes[0].legend(loc="upper right")
    axes[0].set_ylabel(f"{fit.column.replace('_', ' ')} [{prefix}{fit.unit}]")
    title = "; ".join(f"{key.rsplit('.', maxsplit=1)[-1]} {one.value:.4g}" + ("" if one.unit == "1" else f" {one.unit}") +
                      f" ({_end_short(one.lower_95)} to {_end_short(one.upper_95)})" for key, one in fit.parameters.items())
    style.title(axes[0], title)
    residual = fit.measured - fit.fitted
    divisor, prefix = style.si_scale(numpy.abs(residual).max() or 1.0)
    axes[1].plot(fit.time, residual / divisor, ".", color=style.ORANGE, markersize=3)
    axes[1].axhline(0, color=style.QUIET, linewidth=0.6)
    axes[1].set_ylabel(f"residual [{prefix}{fit.unit}]")
    axes[1].set_xlabel("time [s]")
    axes[1].set_xlim(fit.time[0], fit.time[-1])
    drawing.subplots_adjust(right=0.965)
    return drawing


def _end_short(value: float | None) -> str:
    return "?" if value is None else f"{value:.4g}"


def draw(folder) -> None:
    """Writes figures/fit.png, .svg and .pdf."""
    fit = Fit.from_folder(folder)
    making.save(figure(fit), fit.folder / "figures", {"fit": making.ALL})


if __name__ == "__main__":
    draw(sys.argv[1])
