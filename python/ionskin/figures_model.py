# SPDX-License-Identifier: Apache-2.0
"""Figures 1 to 4: what is simulated. Each function takes a Study and returns a Figure, or the reason for none."""

import numpy
from matplotlib.patches import FancyArrowPatch, Rectangle
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

from . import style
from .panels import motion_panels, name_phases
from .quantity import si

ROLE_COLOURS = {"electrode": "#a9b1bd", "core": "#7fc4b0"}
SLIDER_COLOUR = "#e3a27c"
MAGNIFIED = 5  # the skin's thickness in the view of the model
STAGES = [("touchdown", (0, -1)), ("slide", (1, 0)), ("lift", (0, 1)), ("return", (-1, 0))]


def geometry(results):
    """Skin, slider and motion in metres, or None without a contact."""
    case = results.case
    if case.get("strain", {}).get("source") == "file" or "slider" not in case:
        return None
    try:
        skin, slider, motion = case["skin"], case["slider"], case["motion"]
        size = slider.get("size") or [slider["radius"], slider["radius"]]
        return {"length": si(skin["length"]), "width": si(skin["width"]), "size": si(size),
                "start": si(slider["start"]), "gap": si(motion["gap"]), "stroke": si(motion["stroke"]),
                "direction": motion.get("direction", [1, 0]), "shape": slider.get("shape", "flat"),
                "radius": si(slider["radius"]) if "radius" in slider else None,
                "layers": [(layer["name"], layer["role"], layer["material"], si(layer["thickness"]))
                           for layer in skin["layers"]]}
    except (KeyError, ValueError):
        return None


CAP_DEPTH = 0.7  # drawn part of a sphere [mm]
NO_CONTACT = "the run has no slider, or one that this figure cannot draw"


def box(axes, low, high, colour, alpha):
    """A box between two corners."""
    x, y, z = ((low[i], high[i]) for i in range(3))
    corners = numpy.array([[x[i], y[j], z[k]] for i in (0, 1) for j in (0, 1) for k in (0, 1)])
    faces = [(0, 1, 3, 2), (4, 5, 7, 6), (0, 1, 5, 4), (2, 3, 7, 6), (0, 2, 6, 4), (1, 3, 7, 5)]
    axes.add_collection3d(Poly3DCollection([corners[list(face)] for face in faces], facecolor=colour, alpha=alpha,
                                           edgecolor=style.INK, linewidth=0.4, clip_on=False))


def cap(axes, centre, lowest, radius, colour):
    """The lowest part of a sphere; lengths in mm."""
    depth = min(CAP_DEPTH, radius)
    rims = numpy.linspace(0, numpy.sqrt(2 * radius * depth - depth**2), 9)
    turns = numpy.linspace(0, 2 * numpy.pi, 49)
    heights = lowest + radius - numpy.sqrt(radius**2 - rims**2)
    rings = [numpy.stack([centre[0] + rim * numpy.cos(turns), centre[1] + rim * numpy.sin(turns),
                          numpy.full_like(turns, height)], axis=1) for rim, height in zip(rims, heights)]
    faces = [numpy.array([low[i], low[i + 1], high[i + 1], high[i]])
             for low, high in zip(rings, rings[1:]) for i in range(len(turns) - 1)]
    axes.add_collection3d(Poly3DCollection(faces, facecolor=colour, edgecolor="none", clip_on=False))
    axes.add_collection3d(Poly3DCollection([rings[-1]], facecolor=colour, edgecolor=style.INK, linewidth=0.4, clip_on=False))


def slider_words(shape, size):
    """Shape and measures of the slider."""
    if shape["radius"] is not None:
        return f"slider ({shape['shape']}): radius {shape['radius'] * 1e3:.4g} mm"
    return f"slider ({shape['shape']}): {size[0]:.4g} mm × {size[1]:.4g} mm"


def model(study):
    """Figure 1: the skin and the slider above it, in 3D."""
    shape = geometry(study.typical.results)
    if shape is None:
        return NO_CONTACT
    figure = style.canvas(height=3.1)
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0), projection="3d", computed_zorder=False, proj_type="ortho")
    height, length, width = 0.0, shape["length"] * 1e3, shape["width"] * 1e3
    handles = []
    for name, role, material, thickness in shape["layers"]:
        top = height + MAGNIFIED * thickness * 1e3
        box(axes, (0, 0, height), (length, width, top), ROLE_COLOURS[role], 1.0)
        handles.append(Rectangle((0, 0), 1, 1, facecolor=ROLE_COLOURS[role], edgecolor=style.INK, lw=0.4,
                                 label=f"{name}: {material}, {thickness * 1e6:.4g} µm"))
        height = top
    start, size, gap = (numpy.array(shape[name]) * 1e3 for name in ("start", "size", "gap"))
    low, high = start - size / 2, start + size / 2
    body = CAP_DEPTH if shape["shape"] == "sphere" else 1.0
    if shape["shape"] == "sphere":
        cap(axes, start, height + gap, shape["radius"] * 1e3, SLIDER_COLOUR)
        low = high = start
    else:
        box(axes, (*low, height + gap), (*high, height + gap + body), SLIDER_COLOUR, 0.95)
    handles.append(Rectangle((0, 0), 1, 1, facecolor=SLIDER_COLOUR, edgecolor=style.INK, lw=0.4,
                             label=slider_words(shape, size)))
    stroke = numpy.array(shape["direction"]) / numpy.linalg.norm(shape["direction"]) * shape["stroke"] * 1e3
    axes.quiver(*start, height + gap + body, *stroke, 0, color=style.INK, linewidth=1.0, arrow_length_ratio=0.06,
                clip_on=False)
    axes.text(*(start + stroke), height + gap + body + 0.25, f"stroke {shape['stroke'] * 1e3:.4g} mm", fontsize=7.5)
    axes.plot([high[0]] * 2, [low[1]] * 2, [height, height + gap], color=style.INK, lw=0.8, clip_on=False)
    axes.text(high[0] + 0.2, low[1], height + gap / 2, f"gap {gap:.4g} mm", fontsize=7.5, va="center",
              bbox=style.BEHIND_TEXT)
    axes.text(length / 2, 0, -0.35, f"length {length:.4g} mm (x)", fontsize=7.5, ha="center", va="top")
    axes.text(length + 0.35, width / 2, 0, f"width {width:.4g} mm (y)", fontsize=7.5)
    tall = height + gap + 1.5
    axes.set(xlim=(0, length), ylim=(0, width), zlim=(0, tall))
    axes.set_box_aspect((length, width, tall), zoom=1.7)
    axes.view_init(elev=22, azim=-66)
    axes.set_axis_off()
    figure.legend(handles=handles[::-1], loc="upper right", bbox_to_anchor=(0.99, 0.99))
    figure.text(0.01, 0.98, f"Thickness of the skin drawn {MAGNIFIED} times; the slider's height is not part of the "
                            "model.", fontsize=7, color=style.QUIET, va="top", wrap=False)
    return figure


def layers(study):
    """Figure 2: the layers, with what holds on their faces."""
    shape = geometry(study.typical.results)
    rows = shape["layers"] if shape else [
        (layer["name"], layer["role"], layer["material"], si(layer["thickness"]))
        for layer in study.typical.results.case.get("skin", {}).get("layers", [])]
    if not rows:
        return "the case names no layers"
    law = study.typical.results.case.get("contact", {}).get("law", "coulomb").capitalize()
    figure = style.canvas(height=2.2, left=0.02, right=0.98, top=0.98, bottom=0.02)
    axes = figure.add_subplot()
    axes.set_axis_off()
    # Thin layers are drawn thicker than they are, or their names would not fit.
    drawn = [1.6 if role == "core" else 0.55 for _, role, _, _ in rows]
    height = 0.0
    for (name, role, material, thickness), part in zip(rows, drawn):
        axes.add_patch(Rectangle((0, height), 6, part, facecolor=ROLE_COLOURS[role], edgecolor=style.INK, lw=0.6))
        axes.text(3, height + part / 2, f"{name} ({material})", ha="center", va="center", fontsize=8.5)
        axes.text(-0.1, height + part / 2, f"{thickness * 1e6:.4g} µm", ha="right", va="center")
        if role == "core":
            axes.text(6.15, height + part / 2, "PNP ion transport; c mobile cations,\ncf fixed anions; sides: no flux",
                      va="center", fontsize=7.5)
            for face, word in ((height, "bottom"), (height + part, "top")):
                axes.annotate(f"{word} wall: n·J = 0, φ = 0; charge Q$_\\mathrm{{{word}}}$", (6.0, face),
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
    length, size = shape["length"], shape["size"][0]
    start = shape["start"][0]
    end = start + shape["stroke"] * shape["direction"][0] / numpy.linalg.norm(shape["direction"])
    lifted = 0.30
    places = [((start, lifted), (start, 0.0)), ((start, 0.0), (end, 0.0)), ((end, 0.0), (end, lifted)),
              ((end, lifted), (start, lifted))]
    for number, (panel, (name, _), (first, last)) in enumerate(zip(panels, STAGES, places), 1):
        panel.set_axis_off()
        panel.add_patch(Rectangle((0, -0.16), 1, 0.16, facecolor=ROLE_COLOURS["core"], edgecolor=style.INK, lw=0.5))
        for strip in (-0.16, -0.03):
            panel.add_patch(Rectangle((0, strip), 1, 0.03, facecolor=ROLE_COLOURS["electrode"], edgecolor=style.INK,
                                      lw=0.4))
        for (x, z), alpha in ((first, 0.35), (last, 1.0)):
            panel.add_patch(Rectangle(((x - size / 2) / length, z), size / length, 0.26, facecolor=SLIDER_COLOUR,
                                      edgecolor=style.INK, lw=0.5, alpha=alpha))
        panel.add_patch(FancyArrowPatch((first[0] / length, first[1] + 0.13), (last[0] / length, last[1] + 0.13),
                                        arrowstyle="-|>", mutation_scale=9, color=style.INK, lw=1.1))
        panel.set(xlim=(-0.02, 1.02), ylim=(-0.2, 0.62))
        panel.set_title(f"{number}  {name}", fontsize=8, fontweight="bold", pad=2)
    return figure


def motion(study):
    """Figure 4: prescribed position and height of the slider over time."""
    results = study.typical.results
    if not results.signals.has("slider_x", "slider_z"):
        return NO_CONTACT
    figure, axes = motion_panels(results, 0.75, (style.BLUE, style.ORANGE))
    style.title(axes[1], "Underside above the undeformed skin")
    name_phases(results, axes[0], 0.0, 1)
    return figure
