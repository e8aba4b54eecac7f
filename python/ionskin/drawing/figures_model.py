# SPDX-License-Identifier: Apache-2.0
"""Figures 2 and 3: what is simulated. Each function takes a Study and returns a Figure, or the reason for none."""

import numpy
from matplotlib.patches import FancyArrowPatch, Polygon, Rectangle

from ..charts.skin import ROLE_COLOURS, SLIDER_COLOUR, geometry
from ..quantity import si
from ..words import short
from . import style

STAGES = [("touchdown", (0, -1)), ("slide", (1, 0)), ("lift", (0, 1)), ("return", (-1, 0))]


NO_CONTACT = "the run has no slider, or one that this figure cannot draw"


def wall_potentials(results):
    """What holds for the potential at both walls of the core, as the run says it of its circuit."""
    floating = results.circuit is not None and results.circuit.has("voltage")
    top = results.circuit_words.get("top_potential", "φ = U" if floating else "φ = 0")
    return {"bottom": "φ = 0", "top": top}


def layers(study):
    """Figure 2: the layers, with what holds on their faces."""
    shape = geometry(study.typical.results)
    rows = shape["layers"] if shape else [
        (layer["name"], layer["role"], layer["material"], si(layer["thickness"]))
        for layer in study.typical.results.case.get("skin", {}).get("layers", [])]
    if not rows:
        return "the case names no layers"
    potential = wall_potentials(study.typical.results)
    law = study.typical.results.case.get("contact", {}).get("law", "coulomb").capitalize()
    figure = style.canvas(height=2.2, left=0.02, right=0.98, top=0.98, bottom=0.02)
    axes = figure.add_subplot()
    axes.set_axis_off()
    # Thin layers are drawn thicker than they are, or their names would not fit.
    drawn = [1.6 if role == "core" else 0.55 for _, role, _, _ in rows]
    height = 0.0
    for (name, role, material, thickness), part in zip(rows, drawn):
        axes.add_patch(Rectangle((0, height), 6, part, facecolor=ROLE_COLOURS[role], edgecolor=style.INK, lw=0.6))
        axes.text(3, height + part / 2, f"{short(name, 36)} ({short(material, 36)})", ha="center", va="center", fontsize=8.5)
        axes.text(-0.1, height + part / 2, f"{thickness * 1e6:.4g} µm", ha="right", va="center")
        if role == "core":
            axes.text(6.15, height + part / 2, "PNP ion transport; c mobile cations,\ncf fixed anions; sides: no flux",
                      va="center", fontsize=7.5)
            for face, word in ((height, "bottom"), (height + part, "top")):
                axes.annotate(f"{word} wall: n·J = 0, {potential[word]}; charge Q {word}", (6.0, face),
                              (6.15, face + (0.28 if word == "top" else -0.28)), va="center", fontsize=7.5,
                              arrowprops={"arrowstyle": "-", "lw": 0.5, "color": style.QUIET})
        height += part
    axes.plot([0, 6], [0, 0], color=style.INK, lw=2.5)
    axes.text(3, -0.12, "held: u = 0", ha="center", va="top", fontsize=7.5)
    axes.text(3, height + 0.1, f"contact with the slider: {law} friction", ha="center", va="bottom", fontsize=7.5)
    total = sum(thickness for *_, thickness in rows)
    axes.text(-0.1, height + 0.1, f"{total * 1e6:.4g} µm in all", ha="right", va="bottom", fontsize=7.5)
    axes.set(xlim=(-1.5, 10.6), ylim=(-0.5, height + 0.5))
    return figure


def stages(study):
    """Figure 3: the four stages of a cycle."""
    shape = geometry(study.typical.results)
    if shape is None:
        return NO_CONTACT
    figure = style.canvas(height=1.5, left=0.01, right=0.99, top=0.86, bottom=0.04, wspace=0.06)
    panels = figure.subplots(1, 4)
    length, slider = shape["length"], shape["slider"]
    start = shape["start"][0]
    end = start + shape["stroke"] * shape["direction"][0] / numpy.linalg.norm(shape["direction"])
    lifted, body = 0.30, 0.26
    across, rise = (values[0] for values in slider.lines(0.0))
    # Down the left side, along the underside, up the right one.
    outline = numpy.column_stack([numpy.concatenate([across[:1], across, across[-1:]]) / length,
                                  numpy.concatenate([[1], rise / slider.depth, [1]]) * body])
    places = [((start, lifted), (start, 0.0)), ((start, 0.0), (end, 0.0)), ((end, 0.0), (end, lifted)),
              ((end, lifted), (start, lifted))]
    for number, (panel, (name, _), (first, last)) in enumerate(zip(panels, STAGES, places), 1):
        panel.set_axis_off()
        panel.add_patch(Rectangle((0, -0.16), 1, 0.16, facecolor=ROLE_COLOURS["core"], edgecolor=style.INK, lw=0.5))
        for strip in (-0.16, -0.03):
            panel.add_patch(Rectangle((0, strip), 1, 0.03, facecolor=ROLE_COLOURS["electrode"], edgecolor=style.INK,
                                      lw=0.4))
        for (x, z), alpha in ((first, 0.35), (last, 1.0)):
            panel.add_patch(Polygon(outline + (x / length, z), facecolor=SLIDER_COLOUR, edgecolor=style.INK, lw=0.5,
                                    alpha=alpha))
        panel.add_patch(FancyArrowPatch((first[0] / length, first[1] + 0.13), (last[0] / length, last[1] + 0.13),
                                        arrowstyle="-|>", mutation_scale=9, color=style.INK, lw=1.1))
        panel.set(xlim=(-0.02, 1.02), ylim=(-0.2, 0.62))
        panel.set_title(f"{number}  {name}", fontsize=8, fontweight="bold", pad=2)
    return figure
