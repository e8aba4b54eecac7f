# SPDX-License-Identifier: Apache-2.0
"""Figures 2 and 3: the layers with the conditions on their faces, and the stages of a cycle."""

import numpy

from ..quantity import si
from ..words import short
from .chart import Axis, Cell, Chart, Note, Shape
from .colours import INK
from .skin import ROLE_COLOURS, SLIDER_COLOUR, geometry

STAGES = ("touchdown", "slide", "lift", "return")
NO_CONTACT = "the run has no slider, or one that this figure cannot draw"
NO_CYCLE = "the path of the slider is free: it has no stages"
CORE, THIN, FACE = 1.5, 0.7, 0.4  # heights of the core, of a thin layer and of a line of words beside them
LIFTED, BODY, SHEET, FOIL = 0.30, 0.26, 0.16, 0.03  # heights of a stage over the skin's length


def wall_potentials(results):
    """Condition on the potential at both walls of the core, as the run states it of its circuit."""
    floating = results.circuit is not None and results.circuit.has("voltage")
    top = results.circuit_words.get("top_potential", "φ = U" if floating else "φ = 0")
    return {"bottom": "φ = 0", "top": top}


def box(low, high):
    """Corners of a rectangle."""
    return numpy.array([low, (high[0], low[1]), high, (low[0], high[1])], float)


def layers(study):
    """Figure 2: the layers, with the conditions on their faces."""
    results = study.typical.results
    rows = [(layer["name"], layer["role"], layer["material"], si(layer["thickness"])) for layer in results.case.get("skin", {}).get("layers", [])]
    if not rows:
        return "the case names no layers"
    potential, law = wall_potentials(results), results.case.get("contact", {}).get("law", "coulomb").capitalize()
    shapes, notes, height = [], [Note(0.5, 0.2, "held: u = 0", "middle")], FACE
    shapes.append(Shape([numpy.array([(0, FACE), (1, FACE)])], None, INK, 2.5))
    for name, role, material, thickness in rows:  # thin layers are drawn thicker than they are, or their names would not fit
        top = height + (CORE if role == "core" else THIN)
        shapes.append(Shape([box((0, height), (1, top))], ROLE_COLOURS[role], INK, 0.6))
        words = f"{short(name, 24)}\n{short(material, 24)}, {thickness * 1e6:.4g} µm"
        if role == "core":
            notes.append(Note(0.5, top - 0.2, f"n·J = 0, {potential['top']}; charge Q top", "middle"))
            notes.append(Note(0.5, height + 0.2, f"n·J = 0, {potential['bottom']}; charge Q bottom", "middle"))
            words += "; sides: no flux"
        notes.append(Note(0.5, (height + top) / 2, words, "middle"))
        height = top
    notes.append(Note(0.5, height + 0.2, f"contact with the slider: {law} friction", "middle"))
    total = sum(thickness for *_, thickness in rows)
    return Chart([[Cell(f"{total * 1e6:.4g} µm in all", Axis("", "1", 0.0, 1.0), Axis("", "1", 0.0, height + FACE), shapes=tuple(shapes),
                        notes=tuple(notes), height=0.4 * height, bare=True)]])


def stages(study):
    """Figure 3: the four stages of a cycle."""
    shape = geometry(study.typical.results)
    if shape is None:
        return NO_CONTACT
    if shape["path"] is not None:
        return NO_CYCLE
    length, slider = shape["length"], shape["slider"]
    start = shape["start"][0]
    end = start + shape["stroke"] * shape["direction"][0] / numpy.linalg.norm(shape["direction"])
    across, rise = (values[0] for values in slider.lines(0.0))
    # Down the left side, along the underside, up the right one.
    outline = numpy.column_stack([numpy.concatenate([across[:1], across, across[-1:]]) / length,
                                  numpy.concatenate([[1], rise / slider.depth, [1]]) * BODY])
    places = (((start, LIFTED), (start, 0.0)), ((start, 0.0), (end, 0.0)), ((end, 0.0), (end, LIFTED)), ((end, LIFTED), (start, LIFTED)))
    cells = []
    for number, (name, (first, last)) in enumerate(zip(STAGES, places), 1):
        shapes = [Shape([box((0, -SHEET), (1, 0))], ROLE_COLOURS["core"], INK, 0.5)]
        shapes += [Shape([box((0, strip), (1, strip + FOIL))], ROLE_COLOURS["electrode"], INK, 0.4) for strip in (-SHEET, -FOIL)]
        (x0, z0), (x1, z1) = ((x / length, z) for x, z in (first, last))
        shapes += [Shape([outline + (x0, z0)], None, INK, 0.6, "dotted"), Shape([outline + (x1, z1)], SLIDER_COLOUR, INK, 0.5)]
        shapes += arrow(numpy.array([x0, z0 + BODY / 2]), numpy.array([x1, z1 + BODY / 2]))
        cells.append(Cell(f"{number}  {name}", Axis("", "1", -0.02, 1.02), Axis("", "1", -0.2, 0.62), shapes=tuple(shapes), height=0.7, bare=True))
    return Chart([cells], (1.0,) * 4, 2)


def arrow(begin, end):
    """A straight arrow; nothing where it has no length."""
    way = end - begin
    size = numpy.linalg.norm(way)
    if not size:
        return []
    ahead = way / size
    head = 0.06 * ahead
    aside = 0.02 * numpy.array([-ahead[1], ahead[0]])
    return [Shape([numpy.array([begin, end])], None, INK, 1.0), Shape([numpy.array([end, end - head + aside, end - head - aside])], INK, INK, 0.4)]
