# SPDX-License-Identifier: Apache-2.0
"""Figures 17 and 19: stick and slip over the onset of sliding, ions through the thickness."""

import numpy

from . import style
from .figures_family import value_edges
from .panels import peak_of, scaled, slide_start

STUCK = 1e-6  # speed of slip over the largest one below which a cell sticks
NO_FIELDS = "the run has no results.h5"
NO_CONTACT = "the run has no contact"


def fields_of(results):
    """results.h5, or None."""
    return results.open_fields() if (results.folder / "results.h5").exists() else None


def cell_areas(file):
    """Area per cell of the footprint [y][x]."""
    return numpy.outer(numpy.diff(file["contact/grid/y"][...]), numpy.diff(file["contact/grid/x"][...]))


def stick_history(file):
    """Time since the begin of the first slide [s] and stuck part of the contact area along its onset."""
    states = [file["contact"][name] for name in sorted(file["contact"]) if name.startswith("onset_")]
    areas = cell_areas(file)
    times = numpy.array([float(state.attrs["parameter"]) for state in states]) - file["path/onset_begin"][0]
    speeds = [state["slip"][...] / step for state, step in zip(states, numpy.diff(times, prepend=0.0))]
    sliding = max(speed.max() for speed in speeds)
    fractions = []
    for state, speed in zip(states, speeds):
        touching = state["pressure"][...] > 0
        stuck = touching & (speed < STUCK * sliding)
        fractions.append((areas * stuck).sum() / max((areas * touching).sum(), 1e-300))
    return times, numpy.array(fractions)


def stick_slip(study):
    """Figure 17: stuck part of the contact over the time since the slide began, and the swept key."""
    results = study.typical.results
    if fields_of(results) is None or slide_start(results) is None:
        return NO_CONTACT
    histories = []
    for member in study.members:
        with fields_of(member.results) as file:
            if "contact" not in file or not any(name.startswith("onset_") for name in file["contact"]):
                continue
            histories.append((member, *stick_history(file)))
    if not histories:
        return "no run has an onset of sliding"
    slipping = [own[numpy.argmax(stuck <= 0)] if (stuck <= 0).any() else own[-1] for _, own, stuck in histories]
    end = 1.25 * max(slipping)
    figure = style.canvas(height=2.6, left=0.09, right=0.965, top=0.90, bottom=0.17, wspace=0.28)
    axes = figure.subplots(1, 2)
    edges = numpy.linspace(0, end, 601)
    centres = (edges[1:] + edges[:-1]) / 2
    # Before the first state of the onset everything sticks.
    histories = [(member, numpy.concatenate([[0], own]), numpy.concatenate([[1], stuck]))
                 for member, own, stuck in histories]
    rows = numpy.array([numpy.interp(centres, own, stuck, right=0) for _, own, stuck in histories])
    colours = style.sequence(len(histories))
    for (member, own, stuck), colour in zip(histories, colours):
        axes[0].plot(own * 1e3, stuck, color=colour, lw=1.0,
                     label=study.label(member) if member in (histories[0][0], histories[-1][0]) else None)
    axes[0].set(xlabel="time since the slide began [ms]", ylabel="stuck part of the contact area", ylim=(-0.02, 1.05))
    axes[0].set_xlim(0, 1e3 * end)
    axes[0].legend(loc="upper right")
    style.title(axes[0], "Onset of sliding")
    if len(histories) == 1 or study.scattered:
        axes[1].set_visible(False)
        return figure
    image = axes[1].pcolormesh(edges * 1e3, value_edges([member.value for member, *_ in histories]), rows,
                               cmap=style.SEQUENCE, vmin=0, vmax=1, rasterized=True)
    axes[1].set(xlabel="time since the slide began [ms]", ylabel=study.axis_label())
    axes[1].grid(False)
    axes[1].plot(numpy.array(slipping) * 1e3, [member.value for member, *_ in histories], color="white", marker="o",
                 markersize=2.5, lw=0.8)
    style.title(axes[1], "Sticking; line: full slip")
    figure.colorbar(image, ax=axes[1], pad=0.02).set_label("stuck part of the contact area")
    return figure


def ions(study):
    """Figure 19: concentration and potential through the thickness at the instants of the case's output.fields."""
    results = study.typical.results
    if fields_of(results) is None:
        return NO_FIELDS
    with fields_of(results) as file:
        instants = sorted((name for name in file.get("ions", {}) if name != "grid"), key=float)
        if not instants:
            return "the case asks for no fields: set output.fields"
        grid = file["ions/grid"]
        z = grid["z"][...] * 1e6
        column = loaded_column(file, instants)
        figure = style.canvas(height=3.9, left=0.09, right=0.975, top=0.90, bottom=0.115, hspace=0.22, wspace=0.10)
        panels = figure.subplots(2, 3, sharex="col", sharey="row", gridspec_kw={"width_ratios": [1, 1.4, 1]})
        initial = file["ions"][instants[0]]["concentration"][0].mean()
        potentials = [file["ions"][name]["potential"][0][:, column[0], column[1]] for name in instants]
        unit = scaled(panels[1, 0], "potential φ", "V", peak_of(*potentials))
        for name, potential, colour in zip(instants, potentials, style.sequence(len(instants))):
            concentration = file["ions"][name]["concentration"][0][:, column[0], column[1]]
            for place in range(3):
                panels[0, place].plot(z, concentration / initial, color=colour, lw=1.0, label=f"{float(name):g} s")
                panels[1, place].plot(z, potential / unit, color=colour, lw=1.0)
        panels[0, 0].set_ylabel("concentration c / mean")
        wall = 0.03 * z[-1]
        for row in panels:
            for panel, limits in zip(row, ((0, wall), (0, z[-1]), (z[-1] - wall, z[-1]))):
                panel.set_xlim(*limits)
        for panel, words in zip(panels[0], ("bottom wall", "whole core", "top wall")):
            style.title(panel, words)
        for panel in panels[1]:
            panel.set_xlabel("height in the core [µm]")
        centre = [(edges[i] + edges[i + 1]) / 2 * 1e3
                  for edges, i in ((grid["x"][...], column[1]), (grid["y"][...], column[0]))]
        panels[0, 1].legend(loc="lower left", fontsize=6.5, ncol=2)
        words = (f"{study.label(study.typical)}; column at x = {centre[0]:.3g} mm, y = {centre[1]:.3g} mm, where the "
                 "potential deviates most")
        figure.text(0.985, 0.985, words, ha="right", va="top", fontsize=7, color=style.QUIET)
    return figure


def loaded_column(file, instants):
    """Index (y, x) of the column whose potential deviates most over the chosen instants."""
    largest = None
    for name in instants:
        amplitude = numpy.abs(file["ions"][name]["potential"][0]).max(axis=0)
        largest = amplitude if largest is None else numpy.maximum(largest, amplitude)
    return numpy.unravel_index(int(largest.argmax()), largest.shape)
