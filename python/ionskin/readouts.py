# SPDX-License-Identifier: Apache-2.0
"""Draws runs of one strain history below each other, each as its readout circuit shows it:
/usr/bin/python3 -m ionskin.readouts FOLDER... -o FIGURE.png"""

import argparse
import pathlib

import numpy
from matplotlib.figure import Figure

from . import figures
from .drawing import figures_readout, style
from .errors import exit_on
from .results import Results

PNG_DPI = 180
COLOURS = (style.BLUE, style.ORANGE, style.GREEN, style.PURPLE, style.QUIET)
TAXEL_PREFIX = "current_top_"


def draw_taxels(panel, taxels):
    """Currents of a segmented top electrode."""
    names = [name for name in taxels.columns if name.startswith(TAXEL_PREFIX)]
    for name, colour in zip(names, COLOURS):
        panel.plot(taxels["time"], taxels[name], color=colour, lw=0.8, label=name.removeprefix(TAXEL_PREFIX),
                   **figures.STEP)
    figures.signed_log_axis(panel, "A", figures.peak_of(*(taxels[name] for name in names)))
    panel.set_ylabel("current")
    style.title(panel, "Taxels of the top electrode, shorted")
    style.legend(panel, columns=len(names))


def draw_short(results, panel):
    """Difference current of the short circuit."""
    current = results.signals["current_difference"]
    panel.plot(results.signals["time"], current, color=style.BLUE, lw=0.8, **figures.STEP)
    figures.signed_log_axis(panel, "A", figures.peak_of(current))
    panel.set_ylabel("current")
    style.title(panel, "Short circuit, difference current")


def draw_panel(results, panel):
    """What the run's readout shows."""
    if results.taxels is not None:
        draw_taxels(panel, results.taxels)
    elif results.circuit is None:
        draw_short(results, panel)
    else:
        figures_readout.circuit_panel(panel, results)


def draw(folders) -> Figure:
    """One panel per run, on a common axis of time."""
    runs = [Results(folder) for folder in folders]
    figure, axes = style.stacked(len(runs), heights=[0.85] * len(runs), left=0.125)
    for results, panel in zip(runs, axes):
        draw_panel(results, panel)
        # Runs from the strain file of the first know no phases.
        figures.shade_phases(runs[0], panel)
    axes[-1].set_xlim(runs[0].signals["time"][0], max(numpy.max(results.signals["time"]) for results in runs))
    axes[-1].set_xlabel("time [s]")
    figure.subplots_adjust(hspace=0.32, right=0.97)
    return figure


def main():
    """Command line."""
    parser = argparse.ArgumentParser(prog="ionskin.readouts", description=__doc__)
    parser.add_argument("folders", type=pathlib.Path, nargs="+", help="output folders of runs")
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True, help="figure to write")
    arguments = parser.parse_args()
    with exit_on(OSError):
        draw(arguments.folders).savefig(arguments.output, dpi=PNG_DPI)


if __name__ == "__main__":
    main()
