# SPDX-License-Identifier: Apache-2.0
"""Draws runs of one strain history below each other, each as its readout circuit shows it:
/usr/bin/python3 -m ionskin.readouts FOLDER... -o FIGURE.png"""

import argparse
import pathlib

import numpy

from .charts.chart import Axis, Cell, Chart, Curve, current_axis, phase_spans
from .charts.colours import BLUE, GREEN, ORANGE, PURPLE, QUIET
from .charts.readout import TAXEL, VOLTAGE, circuit_panel, has_voltages, taxel_names
from .errors import exit_on
from .results import Results

PNG_DPI = 180
COLOURS = (BLUE, ORANGE, GREEN, PURPLE, QUIET)
HEIGHT = 0.85


def panel(results):
    """Title, vertical Axis and list of Curve of the voltages or currents that the readout circuit of a run measures."""
    if has_voltages(results):
        names = taxel_names(results)
        return ("Taxels with circuits of their own", Axis("voltage", "V"),
                [Curve(results.taxels["time"], results.taxels[VOLTAGE + name], name, colour, True, 0.8) for name, colour in zip(names, COLOURS)])
    if results.taxels is not None:
        columns = [results.taxels[TAXEL + name] for name in taxel_names(results)]
        curves = [Curve(results.taxels["time"], values, name, colour, True, 0.8)
                  for name, values, colour in zip(taxel_names(results), columns, COLOURS)]
        return "Taxels of the top electrode, shorted", current_axis(*columns), curves
    if results.circuit is not None:
        return circuit_panel(results)[:3]
    current = results.signals["current_difference"]
    return ("Short circuit, difference current", current_axis(current),
            [Curve(results.signals["time"], current, "", BLUE, True, 0.8)])


def draw(folders):
    """Draws the readouts of the runs in some folders, one panel for each on a common time axis, as a matplotlib figure."""
    from .drawing import draw_chart

    runs = [Results(folder) for folder in folders]
    begin, end = runs[0].signals["time"][0], max(numpy.max(results.signals["time"]) for results in runs)
    spans = phase_spans(runs[0])  # runs from the strain file of the first know no phases
    rows = []
    for place, results in enumerate(runs):
        title, y, curves = panel(results)
        rows.append([Cell(title, Axis("time" if place == len(runs) - 1 else "", "s", begin, end), y, tuple(curves), spans, height=HEIGHT)])
    return draw_chart.draw(Chart(rows))


def main():
    """Draws the readouts of several runs on one axis of time, by the command line."""
    parser = argparse.ArgumentParser(prog="ionskin.readouts", description=__doc__)
    parser.add_argument("folders", type=pathlib.Path, nargs="+", help="output folders of runs")
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True, help="figure to write")
    arguments = parser.parse_args()
    with exit_on(OSError):
        draw(arguments.folders).savefig(arguments.output, dpi=PNG_DPI)


if __name__ == "__main__":
    main()
