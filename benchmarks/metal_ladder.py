#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The voltage that metal with a sheet resistance makes of a touch, by a net of resistors and cells apart from the solver:
docs/readouts.md.

    build/ionskin run CASE.toml -o out/taxels --set 'readout.taxels={rows=12, columns=30}' --set output.fields=[] ...
    benchmarks/metal_ladder.py out/taxels 0 0.1 1 10 --samples 131072

The run has electrodes of one potential each and taxels that share it: their charges are those that sources below the
nodes of the net drive. Each node has the impedance of its column, docs/model.md (33), the metal joins neighbours, and
leads touch the end at x = 0. Linear in the charges: for touches that make few millivolts. Times by Fourier transforms
along a line beside the imaginary axis.
"""

import argparse
import csv
import math
import pathlib
import sys
import tomllib

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "python"))
from ionskin.quantity import si  # noqa: E402

FARADAY, GAS = 96485.33212, 8.314462618
DECAY = 8.0  # of what comes round again after a period, as a power of e


def read_case(folder):
    """The numbers of case.toml that the cell needs, in SI units; its taxels."""
    case = tomllib.loads((folder / "case.toml").read_text(encoding="utf-8"))
    numbers = {f"skin.{key}": si(case["skin"][key]) for key in ("length", "width")}
    for key, unit in (("temperature", "K"), ("diffusivity", "m2/s"), ("permittivity", "F/m"), ("fixed_charge_concentration", "mol/m3")):
        value, _, written = case["electrochemistry"][key].partition(" ")
        if written != unit:
            raise SystemExit(f"electrochemistry.{key} must be in {unit}")
        numbers[f"electrochemistry.{key}"] = float(value)
    numbers["thickness"] = next(si(layer["thickness"]) for layer in case["skin"]["layers"] if layer["role"] == "core")
    return numbers, case["readout"]["taxels"]


def cell_impedance(s, numbers):
    """Impedance times area of a cell with blocking electrodes [ohm m2], docs/model.md (33)."""
    thermal = GAS * numbers["electrochemistry.temperature"] / FARADAY
    density = FARADAY * numbers["electrochemistry.fixed_charge_concentration"]
    permittivity, diffusivity = numbers["electrochemistry.permittivity"], numbers["electrochemistry.diffusivity"]
    debye = math.sqrt(permittivity * thermal / density)
    time = debye**2 / diffusivity
    a, p = numbers["thickness"] / (2 * debye), s * time
    q = numpy.sqrt(1 + p)
    return 2 * debye * time / permittivity * (numpy.tanh(q * a) + p * q * a) / (p * q**3)


def charges(folder, rows, columns):
    """Times and charge of every taxel [row][column][time]."""
    with open(folder / "taxels.csv", encoding="utf-8") as file:
        table = csv.reader(file)
        names = [title.split()[0] for title in next(table)]
        values = numpy.array([[float(value) for value in row] for row in table])
    return values[:, 0], numpy.array([[values[:, names.index(f"charge_top_r{row + 1}c{column + 1}")] for column in range(columns)]
                                      for row in range(rows)])


def net(rows, columns, conductance_x, conductance_y):
    """Laplacian of the metal between nodes, and the conductance of each to the lead."""
    size = rows * columns
    matrix, lead = numpy.zeros((size, size)), numpy.zeros(size)
    for row in range(rows):
        lead[row * columns] = 2 * conductance_x  # half a column away
        for column in range(columns):
            here = row * columns + column
            for there, conductance in ((here + 1, conductance_x) if column + 1 < columns else (None, 0),
                                       (here + columns, conductance_y) if row + 1 < rows else (None, 0)):
                if there is not None:
                    matrix[here, here] += conductance
                    matrix[there, there] += conductance
                    matrix[here, there] -= conductance
                    matrix[there, here] -= conductance
    return matrix, lead


def voltage(time, charge, both_metals, load, numbers, samples):
    """Voltage of the leads over uniform times; `both_metals` is the resistance of a square of both together [ohm]."""
    rows, columns = charge.shape[:2]
    dx, dy = numbers["skin.length"] / columns, numbers["skin.width"] / rows
    period = 2 * time[-1]
    uniform = numpy.arange(samples) * period / samples
    shift = DECAY / period
    held = numpy.array([[numpy.interp(uniform, time, one) for one in row] for row in charge]).reshape(rows * columns, samples)
    spectrum = numpy.fft.rfft(held * numpy.exp(-shift * uniform), axis=1)
    s = shift + 2j * numpy.pi * numpy.arange(spectrum.shape[1]) / period
    sources = -s * spectrum  # currents out of the top metal that the cells draw at equal potentials
    cells = dx * dy / cell_impedance(s, numbers)
    found = numpy.empty(len(s), complex)
    if both_metals == 0:
        found = sources.sum(axis=0) / (rows * columns * cells + 1 / load)
    else:
        matrix, lead = net(rows, columns, dy / dx / both_metals, dx / dy / both_metals)
        system = numpy.zeros((rows * columns + 1,) * 2)
        system[:-1, :-1] = matrix + numpy.diag(lead)
        system[:-1, -1] = system[-1, :-1] = -lead
        system[-1, -1] = lead.sum() + 1 / load
        # Modes of the net with the capacity of the nodes alike: one factorisation for all frequencies.
        inner, to_lead = system[:-1, :-1], system[:-1, -1]
        rates, modes = numpy.linalg.eigh(inner)
        drawn, joined = modes.T @ sources, modes.T @ to_lead
        for k in range(len(s)):
            answer = 1 / (rates + cells[k])
            found[k] = -(joined * answer * drawn[:, k]).sum() / (system[-1, -1] - (joined**2 * answer).sum())
    return uniform[:samples // 2], (numpy.fft.irfft(found, samples) * numpy.exp(shift * uniform))[:samples // 2]


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("folder", type=pathlib.Path)
    options.add_argument("resistances", type=float, nargs="+", help="of a square of each metal [ohm]")
    options.add_argument("--load", type=float, default=1e6, help="between the leads [ohm]")
    options.add_argument("--samples", type=int, default=2**14, help="of twice the run")
    options.add_argument("--against", type=pathlib.Path, nargs="*", default=[], help="runs with these resistances and that load")
    given = options.parse_args()
    numbers, taxels = read_case(given.folder)
    time, charge = charges(given.folder, taxels["rows"], taxels["columns"])
    print(f"{'ohm a square':>14}{'peak [V]':>12}{'at [s]':>9}")
    for place, resistance in enumerate(given.resistances):
        at, found = voltage(time, charge, 2 * resistance, given.load, numbers, given.samples)
        peak = int(numpy.abs(found).argmax())
        words = f"{resistance:>14g}{abs(found[peak]):>12.4g}{at[peak]:>9.3f}"
        if place < len(given.against):
            with open(given.against[place] / "circuit.csv", encoding="utf-8") as file:
                table = csv.reader(file)
                names = [title.split()[0] for title in next(table)]
                values = numpy.array([[float(value) for value in row] for row in table])
            solved = values[:, names.index("voltage")]
            difference = numpy.interp(at, values[:, 0], solved) - found
            words += (f"   solver {numpy.abs(solved).max():.4g} at {values[numpy.abs(solved).argmax(), 0]:.3f}; rms of the difference "
                      f"{numpy.sqrt((difference**2).mean() / (found**2).mean()):.3g} of the voltage")
        print(words)


if __name__ == "__main__":
    main()
