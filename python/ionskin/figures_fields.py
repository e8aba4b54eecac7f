# SPDX-License-Identifier: Apache-2.0
"""Figures 17 to 19, which the paper lacks: stick and slip, contact and core shear maps, ions through the thickness."""

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
    if len(histories) == 1:
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


def mirrored(file, values):
    """A map of the half model completed to the full footprint, with its y edges."""
    edges = file["contact/grid/y"][...]
    if edges[-1] > 1e-9:
        return edges, values
    return numpy.concatenate([edges, -edges[-2::-1]]), numpy.concatenate([values, values[::-1]])


def capped(values, areas, share=0.95):
    """Upper end of a colour scale that the mesh-dependent peaks at the edges do not set: what `share` of the area
    stays below."""
    order = numpy.argsort(values, axis=None)
    below = numpy.cumsum(numpy.broadcast_to(areas, values.shape).ravel()[order])
    return float(values.ravel()[order][numpy.searchsorted(below, share * below[-1])]) or 1.0


def touchdown_state(file):
    """Name of the state at the end of the first touchdown, which takes one step or several; None without any."""
    return max((name for name in file["contact"] if name.startswith("touchdown")), default=None)


def middle_state(file):
    """Name of the state of steady sliding nearest the middle of the slide, or of touchdown."""
    steady = sorted(name for name in file["contact"] if name.startswith("steady_"))
    return steady[len(steady) // 2] if steady else touchdown_state(file)


def contact_maps(study):
    """Figure 18: pressure under the slider and shear in the core, in the slider's frame."""
    results = study.typical.results
    if fields_of(results) is None:
        return NO_FIELDS
    with fields_of(results) as file:
        if "contact" not in file or touchdown_state(file) is None:
            return NO_CONTACT
        figure = style.canvas(height=4.9, left=0.085, right=0.93, top=0.95, bottom=0.095, hspace=0.62, wspace=0.30)
        panels = figure.subplots(3, 2)
        x = file["contact/grid/x"][...] * 1e3
        for column, (state, words) in enumerate(((touchdown_state(file), "end of touchdown"),
                                                    (middle_state(file), "mid-slide"))):
            group = file["contact"][state]
            y, pressure = mirrored(file, group["pressure"][...])
            shear = numpy.hypot(group["shear_x"][...], group["shear_y"][...])
            for row, (values, name) in enumerate(((pressure, "pressure"), (mirrored(file, shear)[1], "shear traction"))):
                panel = panels[row, column]
                top = capped(values, mirrored(file, cell_areas(file))[1])
                image = panel.pcolormesh(x, y * 1e3, values / 1e6, cmap=style.SEQUENCE, vmin=0, vmax=top / 1e6,
                                         rasterized=True)
                panel.set(xlabel="x from the slider's centre [mm]", ylabel="y [mm]" if column == 0 else "")
                style.title(panel, f"{name.capitalize()} [MPa], {words}")
                panel.grid(False)
                figure.colorbar(image, ax=panel, extend="max", pad=0.02)
        core_sections(figure, panels[2], file, results)
    return figure


def core_sections(figure, panels, file, results):
    """Shear of the core at the end of touchdown and mid-slide, on the section at mid-width."""
    strain = file["strain"]
    time = strain["time"][...]
    x, z = strain["grid/x"][...] * 1e3, strain["grid/z"][...] * 1e6
    spans = {span.phase: span for span in reversed(results.phases())}
    slide = spans.get("slide")
    instants = (spans["touchdown"].end, (slide.start + slide.end) / 2) if slide else (time[0], time[-1])
    middle = strain["gamma"].shape[2] // 2
    sections = [strain["gamma"][int(numpy.abs(time - instant).argmin()), :, middle, :] for instant in instants]
    for panel, section, words in zip(panels, sections, ("end of touchdown", "mid-slide")):
        top = capped(section, numpy.diff(x), 0.99)
        image = panel.pcolormesh((x[1:] + x[:-1]) / 2, z, section * 1e3, cmap=style.SEQUENCE, vmin=0, vmax=top * 1e3,
                                 shading="gouraud", rasterized=True)
        panel.set(xlabel="x from the slider's centre [mm]", ylabel="z [µm]" if panel is panels[0] else "")
        panel.set_xlim(-3.5, 3.5)
        panel.grid(False)
        style.title(panel, f"Core shear γ [10⁻³], {words}")
        figure.colorbar(image, ax=panel, extend="max", pad=0.02)


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
