# SPDX-License-Identifier: Apache-2.0
"""Figures 1 to 4: what is simulated. Each function takes a Study and returns a Figure, or the reason for none."""

import numpy
from matplotlib.patches import FancyArrowPatch, Polygon, Rectangle
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

from ..quantity import si
from ..words import short
from . import style
from .panels import motion_panels, name_phases
from .underside import Underside, read_heights

ROLE_COLOURS = {"electrode": "#a9b1bd", "core": "#7fc4b0"}
SLIDER_COLOUR = "#e3a27c"
SLIDER_SHADES = {"top": "#ecbda1", "cut": SLIDER_COLOUR, "side": "#cf8a62"}
MAGNIFIED = 5  # the skin's thickness in the view of the model
STAGES = [("touchdown", (0, -1)), ("slide", (1, 0)), ("lift", (0, 1)), ("return", (-1, 0))]


def geometry(results):
    """Skin, slider and motion in metres, or None without a contact."""
    case = results.case
    if case.get("strain", {}).get("source") == "file" or "slider" not in case:
        return None
    try:
        skin, slider, motion = case["skin"], case["slider"], case["motion"]
        return {"length": si(skin["length"]), "width": si(skin["width"]), "slider": Underside(slider, read_heights(results)),
                "start": si(slider["start"]), "gap": si(motion["gap"]), "stroke": si(motion["stroke"]),
                "direction": motion.get("direction", [1, 0]),
                "layers": [(layer["name"], layer["role"], layer["material"], si(layer["thickness"]))
                           for layer in skin["layers"]]}
    except (KeyError, ValueError):
        return None


NO_CONTACT = "the run has no slider, or one that this figure cannot draw"


def box(axes, low, high, colour, alpha):
    """A box between two corners."""
    x, y, z = ((low[i], high[i]) for i in range(3))
    corners = numpy.array([[x[i], y[j], z[k]] for i in (0, 1) for j in (0, 1) for k in (0, 1)])
    faces = [(0, 1, 3, 2), (4, 5, 7, 6), (0, 1, 5, 4), (2, 3, 7, 6), (0, 2, 6, 4), (1, 3, 7, 5)]
    axes.add_collection3d(Poly3DCollection([corners[list(face)] for face in faces], facecolor=colour, alpha=alpha,
                                           edgecolor=style.INK, linewidth=0.4, clip_on=False))


def half_body(axes, slider, centre, lowest):
    """The half of a slider behind its middle, whose cut shows the underside; centre and height in mm."""
    y = slider.half_size[1] * numpy.linspace(0, 1, 25)
    x, heights = slider.lines(y, 61)
    points = numpy.stack([1e3 * x + centre[0], numpy.broadcast_to(1e3 * y[:, None] + centre[1], x.shape),
                          1e3 * heights + lowest], axis=-1)
    top = lowest + 1e3 * slider.depth

    def raised(line):
        return numpy.column_stack([line[:, :2], numpy.full(len(line), top)])

    def add(faces, part, width):
        colour = SLIDER_SHADES[part]
        axes.add_collection3d(Poly3DCollection(faces, facecolor=colour, edgecolor=style.INK if width else colour,
                                               linewidth=width or 0.2, clip_on=False))

    add([numpy.array([near[i], near[i + 1], far[i + 1], far[i]])
         for near, far in zip(points, points[1:]) for i in range(points.shape[1] - 1)], "side", 0)
    add([numpy.concatenate([points[:, -1], raised(points[:, -1])[::-1]])], "side", 0.4)
    add([raised(numpy.concatenate([points[:, 0], points[::-1, -1]]))], "top", 0.4)
    add([numpy.concatenate([points[0], raised(points[0, [-1, 0]])])], "cut", 0.4)


def slider_words(slider):
    """Shape and measures of the slider."""
    plan = " × ".join(f"{1e3 * side:.4g} mm" for side in slider.size)
    if slider.shape == "sphere":
        return f"slider (sphere): radius {slider.radius * 1e3:.4g} mm"
    if slider.shape == "cylinder":
        return f"slider (cylinder): radius {slider.radius * 1e3:.4g} mm, length {slider.size[1] * 1e3:.4g} mm"
    if slider.edge_radius > 0:
        return f"slider (flat): {plan}, edges {slider.edge_radius * 1e3:.4g} mm"
    if slider.unknown:
        return f"slider ({slider.shape}): {plan}, heights not at hand"
    return f"slider ({slider.shape}): {plan}"


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
                                 label=f"{short(name, 24)}: {short(material, 24)}, {thickness * 1e6:.4g} µm"))
        height = top
    slider = shape["slider"]
    start, gap, body = numpy.array(shape["start"]) * 1e3, shape["gap"] * 1e3, slider.depth * 1e3
    notes = [f"Thickness of the skin drawn {MAGNIFIED} times", "the slider's height is not part of the model"]
    if slider.sharp:
        half = slider.half_size * 1e3
        box(axes, (*(start - half), height + gap), (*(start + half), height + gap + body), SLIDER_COLOUR, 0.95)
        lowest = start + half * (1, -1)
    else:
        half_body(axes, slider, start, height + gap)
        across, rise = (values[0] for values in slider.lines(0.0))
        middle = numpy.lexsort((numpy.abs(across), rise))[0]  # of the lowest places that nearest to the centre
        lowest = start + (1e3 * across[middle], 0.0)
        notes.insert(1, "the slider is cut along its middle")
    handles.append(Rectangle((0, 0), 1, 1, facecolor=SLIDER_COLOUR, edgecolor=style.INK, lw=0.4,
                             label=slider_words(slider)))
    stroke = numpy.array(shape["direction"]) / numpy.linalg.norm(shape["direction"]) * shape["stroke"] * 1e3
    axes.quiver(*start, height + gap + body, *stroke, 0, color=style.INK, linewidth=1.0, arrow_length_ratio=0.06,
                clip_on=False)
    axes.text(*(start + stroke), height + gap + body + 0.25, f"stroke {shape['stroke'] * 1e3:.4g} mm", fontsize=7.5)
    axes.plot([lowest[0]] * 2, [lowest[1]] * 2, [height, height + gap], color=style.INK, lw=0.8, clip_on=False)
    axes.text(lowest[0] + 0.2, lowest[1], height + gap / 2, f"gap {gap:.4g} mm", fontsize=7.5, va="center",
              bbox=style.BEHIND_TEXT)
    axes.text(length / 2, 0, -0.35, f"length {length:.4g} mm (x)", fontsize=7.5, ha="center", va="top")
    axes.text(length + 0.35, width / 2, 0, f"width {width:.4g} mm (y)", fontsize=7.5)
    tall = height + gap + body + 0.5
    axes.set(xlim=(0, length), ylim=(0, width), zlim=(0, tall))
    axes.set_box_aspect((length, width, tall), zoom=1.7)
    axes.view_init(elev=22, azim=-66)
    axes.set_axis_off()
    figure.legend(handles=handles[::-1], loc="upper right", bbox_to_anchor=(0.99, 0.99))
    figure.text(0.01, 0.98, ";\n".join(notes) + ".", fontsize=7, color=style.QUIET, va="top", linespacing=1.4)
    return figure


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


def motion(study):
    """Figure 4: prescribed position and height of the slider over time."""
    results = study.typical.results
    if not results.signals.has("slider_x", "slider_z"):
        return NO_CONTACT
    figure, axes = motion_panels(results, 0.75, (style.BLUE, style.ORANGE))
    style.title(axes[1], "Underside above the undeformed skin")
    name_phases(results, axes[0], 0.0, 1)
    return figure
