# SPDX-License-Identifier: Apache-2.0
"""Draws the spectrum that `ionskin impedance` has written: /usr/bin/python3 -m ionskin.impedance FOLDER"""

import argparse
import pathlib

import numpy

from .drawing import making, style  # first: they import matplotlib without the settings of the working folder
from .errors import exit_on
from .results import read_table

from matplotlib.ticker import EngFormatter, MultipleLocator  # isort: skip

MARKED = 4  # decades that stand beside the Nyquist curve, at most


def nyquist(spectrum):
    """Nyquist plot of a spectrum (Table of impedance.csv): minus imaginary over real
    part [ohm], decades of frequency marked."""
    real, imaginary = spectrum["impedance_real"], -spectrum["impedance_imaginary"]
    figure, axes = style.stacked(1, heights=[1.7])
    panel = axes[0]
    divisor, prefix = style.si_scale(real.max())
    panel.plot(real / divisor, imaginary / divisor, color=style.BLUE, marker=".", markersize=2.5)
    for row in decade_rows(spectrum["frequency"], imaginary, 6 * real.max()):
        panel.plot(real[row] / divisor, imaginary[row] / divisor, "o", color=style.ORANGE, markersize=3.5)
        panel.annotate(f"{EngFormatter(unit='Hz').format_eng(spectrum['frequency'][row])}Hz",
                       (real[row] / divisor, imaginary[row] / divisor), xytext=(6, 0),
                       textcoords="offset points", va="center", fontsize=7.5, color=style.QUIET)
    # The capacitive end grows without bound; the bulk shows at the scale of the resistance.
    panel.set_ylim(0, min(imaginary.max(), 1.6 * real.max()) / divisor * 1.05)
    panel.set_xlim(0, 1.25 * real.max() / divisor)
    panel.set_xlabel(f"real part [{prefix}Ω]")
    panel.set_ylabel(f"−imaginary part [{prefix}Ω]")
    style.title(panel, "Nyquist: impedance between the electrodes at rest")
    return figure


def decade_rows(frequency, imaginary, ceiling):
    """Rows of a spectrum that are nearest to whole decades of frequency, at most `MARKED` of them.

    frequency, imaginary  arrays [rows]: frequency [Hz], ascending, and minus the imaginary part [ohm]
    ceiling               rows with a larger `imaginary` are left out, since they lie outside the picture [ohm]
    """
    decades = 10.0 ** numpy.arange(numpy.ceil(numpy.log10(frequency[0]) - 1e-9),
                                   numpy.floor(numpy.log10(frequency[-1]) + 1e-9) + 1)
    rows = [int(numpy.argmin(numpy.abs(numpy.log(frequency / decade)))) for decade in decades]
    return [row for row in rows if imaginary[row] < ceiling][:MARKED]


def bode(spectrum):
    """Bode plot of a spectrum (the Table of impedance.csv): magnitude [ohm] and phase [deg] over frequency [Hz]."""
    figure, axes = style.stacked(2, heights=[1.1, 0.9])
    axes[0].loglog(spectrum["frequency"], spectrum["magnitude"], color=style.BLUE)
    axes[0].yaxis.set_major_formatter(EngFormatter(unit="Ω"))
    axes[0].set_ylabel("magnitude")
    style.title(axes[0], "Bode: impedance between the electrodes at rest")
    axes[1].semilogx(spectrum["frequency"], spectrum["phase_angle"], color=style.ORANGE)
    axes[1].set_ylim(-95, 5)
    axes[1].yaxis.set_major_locator(MultipleLocator(30))
    axes[1].set_ylabel("phase [°]")
    axes[1].xaxis.set_major_formatter(EngFormatter(unit="Hz"))
    axes[1].set_xlabel("frequency")
    axes[1].set_xlim(spectrum["frequency"][0], spectrum["frequency"][-1])
    figure.subplots_adjust(right=0.965)
    return figure


def draw(folder):
    """Draws impedance.csv of a folder into figures/nyquist and figures/bode of this folder, each as .png, .svg and .pdf."""
    folder = pathlib.Path(folder)
    spectrum = read_table(folder / "impedance.csv")
    for name, figure in (("nyquist", nyquist(spectrum)), ("bode", bode(spectrum))):
        making.save(figure, folder / "figures", {name: making.ALL})


def main():
    """Draws the figures of an impedance spectrum, by the command line."""
    parser = argparse.ArgumentParser(prog="ionskin.impedance", description=__doc__)
    parser.add_argument("folder", type=pathlib.Path, help="output folder of `ionskin impedance`")
    arguments = parser.parse_args()
    with exit_on(OSError):
        draw(arguments.folder)


if __name__ == "__main__":
    main()
