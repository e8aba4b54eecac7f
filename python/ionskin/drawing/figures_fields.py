# SPDX-License-Identifier: Apache-2.0
"""Figure 17: stick and slip over the onset of sliding."""

import numpy

from ..charts.fields import NO_CONTACT, STUCK, cell_areas, fields_of
from ..charts.spans import slide_start
from . import style
from .figures_family import value_edges



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
