# SPDX-License-Identifier: Apache-2.0
"""Figure 1: the skin and the slider above it, in an oblique view and from above."""

import numpy

from ..quantity import si
from ..words import short
from .chart import Axis, Cell, Chart, Note, Shape
from ..reading.sliders import suffix
from .colours import BLUE, GREEN, INK, PURPLE
from .underside import Underside, read_heights

ROLE_COLOURS = {"electrode": "#a9b1bd", "core": "#7fc4b0"}
SLIDER_COLOUR = "#e3a27c"
SLIDER_SHADES = {"top": "#ecbda1", "cut": SLIDER_COLOUR, "side": "#cf8a62"}
SLIDER_COLOURS = (SLIDER_SHADES["side"], BLUE, PURPLE, GREEN)  # of several, seen from above
MAGNIFIED = 5  # the skin's thickness in the view of the model
ELEVATION, AZIMUTH = numpy.radians((22.0, -66.0))  # of the eye, which is far away
ARROW = 0.35  # length of the head [mm]


def geometries(results):
    """Geometry of every slider; empty without a contact, or with a slider that cannot be drawn."""
    found = [geometry(results, number) for number in range(len(results.sliders))]
    return [] if None in found else found


def geometry(results, number=0):
    """Skin, slider and motion in metres, or None without a contact. `number` is the slider's place in the list of the case."""
    case, end = results.sliders[number], suffix(number)
    if case.get("strain", {}).get("source") == "file" or "slider" not in case:
        return None
    try:
        skin, slider, motion = case["skin"], case["slider"], case["motion"]
        if motion.get("kind") == "waypoints":
            signals = results.signals
            way = {"start": [float(signals[f"slider_{axis}{end}"][0]) for axis in "xy"],
                   "gap": max(0.0, float(signals[f"slider_z{end}"][0])), "stroke": 0.0, "direction": [1, 0],
                   "path": numpy.column_stack([signals[f"slider_x{end}"], signals[f"slider_y{end}"]])}
        else:
            way = {"start": si(slider["start"]), "gap": si(motion["gap"]), "stroke": si(motion["stroke"]),
                   "direction": motion.get("direction", [1, 0]), "path": None}
        return {"length": si(skin["length"]), "width": si(skin["width"]), "slider": Underside(slider, read_heights(results, end)), **way,
                "layers": [(layer["name"], layer["role"], layer["material"], si(layer["thickness"]))
                           for layer in skin["layers"]]}
    except (KeyError, ValueError):
        return None


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


def seen(points):
    """Projects points [..., (x, y, z)] to the plane of the oblique view: to the right and up."""
    right = numpy.array([-numpy.sin(AZIMUTH), numpy.cos(AZIMUTH), 0.0])
    up = numpy.array([-numpy.cos(AZIMUTH) * numpy.sin(ELEVATION), -numpy.sin(AZIMUTH) * numpy.sin(ELEVATION), numpy.cos(ELEVATION)])
    return numpy.asarray(points, float) @ numpy.array([right, up]).T


def box(low, high, colour, label):
    """Shapes of the three visible faces of a box between two corners."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    faces = [[(x0, y0, z0), (x1, y0, z0), (x1, y0, z1), (x0, y0, z1)], [(x1, y0, z0), (x1, y1, z0), (x1, y1, z1), (x1, y0, z1)],
             [(x0, y0, z1), (x1, y0, z1), (x1, y1, z1), (x0, y1, z1)]]
    return Shape([seen(face) for face in faces], colour, label=label)


def half_body(slider, centre, lowest, label):
    """The half of a slider behind its middle, whose cut shows the underside; centre and height in mm."""
    y = slider.half_size[1] * numpy.sin(numpy.linspace(0, numpy.pi / 2, 17))  # denser where a round edge is steep
    x, heights = slider.lines(y, 41)
    points = numpy.stack([1e3 * x + centre[0], numpy.broadcast_to(1e3 * y[:, None] + centre[1], x.shape),
                          1e3 * heights + lowest], axis=-1)
    top = lowest + 1e3 * slider.depth

    def raised(line):
        return numpy.column_stack([line[:, :2], numpy.full(len(line), top)])

    flat = seen(points)
    strips = [numpy.concatenate([near, far[::-1]]) for near, far in zip(flat, flat[1:])]
    cut = numpy.concatenate([points[0], raised(points[0, [-1, 0]])])
    parts = {"side": [*strips, seen(numpy.concatenate([points[:, -1], raised(points[:, -1])[::-1]]))],
             "top": [seen(raised(numpy.concatenate([points[:, 0], points[::-1, -1]])))], "cut": [seen(cut)]}
    return [Shape(outlines, SLIDER_SHADES[part], INK if part != "side" else SLIDER_SHADES[part], label=label if part == "cut" else "")
            for part, outlines in parts.items()]


def arrow(begin, way):
    """Shape of an arrow in the plane of the skin [mm]."""
    tip, ahead = begin + way, way / numpy.linalg.norm(way)
    aside = numpy.array([-ahead[1], ahead[0], 0.0])
    head = [tip - ARROW * (ahead - 0.35 * aside), tip, tip - ARROW * (ahead + 0.35 * aside)]
    return [Shape([seen([begin, tip])], None, width=1.0), Shape([seen(head)], None, width=1.0)]


def skin(shape):
    """The layers from below, and the height of the surface [mm]."""
    height, found = 0.0, []
    for name, role, material, thickness in shape["layers"]:
        top = height + MAGNIFIED * thickness * 1e3
        label = f"{short(name, 24)}: {short(material, 24)}, {thickness * 1e6:.4g} µm"
        found.append(box((0, 0, height), (shape["length"] * 1e3, shape["width"] * 1e3, top), ROLE_COLOURS[role], label))
        height = top
    return found, height


def body(shape, height, name):
    """Outlines of a slider with its way, words beside it, and a note on how it is drawn, above a surface at a height [mm]."""
    slider, start, gap, deep = shape["slider"], numpy.array(shape["start"]) * 1e3, shape["gap"] * 1e3, shape["slider"].depth * 1e3
    label = slider_words(slider).replace("slider", name, 1)
    note = ""
    if slider.sharp:
        half = slider.half_size * 1e3
        shapes = [box((*(start - half), height + gap), (*(start + half), height + gap + deep), SLIDER_COLOUR, label)]
        lowest = start + half * (1, -1)
    else:
        shapes = half_body(slider, start, height + gap, label)
        across, rise = (values[0] for values in slider.lines(0.0))
        middle = numpy.lexsort((numpy.abs(across), rise))[0]  # of the lowest places that nearest to the centre
        lowest = start + (1e3 * across[middle], 0.0)
        note = "the slider is cut along its middle"
    way = numpy.array([*(numpy.array(shape["direction"]) / numpy.linalg.norm(shape["direction"]) * shape["stroke"] * 1e3), 0.0])
    above = numpy.array([*start, height + gap + deep])
    if way.any():
        shapes += arrow(above, way)
    if shape["path"] is not None:
        path = numpy.column_stack([shape["path"] * 1e3, numpy.full(len(shape["path"]), height)])
        shapes.append(Shape([seen(path[~numpy.isnan(path).any(axis=1)])], None, width=1.2, look="dashed", label=f"way of the {name}'s centre"))
    shapes.append(Shape([seen([(*lowest, height), (*lowest, height + gap)])], None, width=0.8))
    words = [*([Note(*seen(above + way + (0, 0, 0.25)), f"stroke {shape['stroke'] * 1e3:.4g} mm")] if way.any() else []),
             Note(*seen((lowest[0] + 0.2, lowest[1], height + gap / 2)), f"gap {gap:.4g} mm", boxed=True)]
    return shapes, words, note


def model(results):
    """The skin and the sliders above it; None without a slider that can be drawn."""
    found = geometries(results)
    if not found:
        return None
    shapes, height = skin(found[0])
    words, remarks = [], [f"Thickness of the skin drawn {MAGNIFIED} times"]
    for number, shape in enumerate(found):
        own, beside, remark = body(shape, height, f"slider {number + 1}" if len(found) > 1 else "slider")
        shapes += own
        words += [note for note in beside if note.words not in {other.words for other in words}]  # each measure once
        remarks += [remark] if remark and remark not in remarks else []
    remarks.append("the slider's height is not part of the model")
    length, width = found[0]["length"] * 1e3, found[0]["width"] * 1e3
    words += [Note(*seen((length / 2, 0, -0.35)), f"length {length:.4g} mm (x)", "end"),
              Note(*seen((length + 0.35, width / 2, 0)), f"width {width:.4g} mm (y)")]
    corners = numpy.concatenate([outline for each in shapes for outline in each.outlines])
    low, high = corners.min(axis=0) - (0.3, 0.8), corners.max(axis=0) + (2.5, 0.5)
    return Chart([[Cell("", Axis("", "1", low[0], high[0]), Axis("", "1", low[1], high[1]), shapes=tuple(shapes), notes=tuple(words),
                        equal=True, bare=True)]], note="; ".join(remarks) + ".")


def moves_across(results, end=""):
    """True if the centre of a slider leaves a line along the skin; `end` is the suffix of the slider's signals."""
    signals = results.signals
    name = f"slider_y{end}"
    return bool(signals.has(name) and numpy.nanmax(signals[name]) - numpy.nanmin(signals[name]) > 1e-9)


def outline(slider, centre):
    """The drawn part of a slider from above [m]."""
    half = slider.half_size
    if slider.shape == "sphere":
        angle = numpy.linspace(0, 2 * numpy.pi, 61)
        return centre + half * numpy.column_stack([numpy.cos(angle), numpy.sin(angle)])
    return centre + half * numpy.array([(-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1)])


def plan(results):
    """Skin, sliders and paths from above, for several sliders and for paths that leave
    a line along the skin; None for others."""
    found = geometries(results)
    ends = [suffix(number) for number in range(len(found))]
    if not found or not results.signals.has("slider_x") or not (len(found) > 1 or moves_across(results)):
        return None
    skin_edge = numpy.array([(0, 0), (1, 0), (1, 1), (0, 1)]) * (found[0]["length"], found[0]["width"])
    shapes, notes = [Shape([skin_edge], ROLE_COLOURS["electrode"], INK, label="skin")], []
    for number, (shape, end) in enumerate(zip(found, ends)):
        name = f"slider {number + 1}" if len(found) > 1 else "slider"
        way = numpy.column_stack([results.signals[f"slider_{axis}{end}"] for axis in "xy"])
        way = way[~numpy.isnan(way).any(axis=1)]
        shapes += [Shape([outline(shape["slider"], way[0])], None, SLIDER_COLOURS[number], 1.4, label=name),
                   Shape([way], None, INK, 1.2, "dashed", "" if number else "way of its centre")]
        drawn = shape["slider"]
        if drawn.radius is not None:
            notes.append(f"Of the {drawn.shape} its lowest {drawn.depth * 1e3:.2g} mm are drawn.")
    corners = numpy.concatenate([part for each in shapes for part in each.outlines])
    low, high = corners.min(axis=0), corners.max(axis=0)
    room = 0.03 * (high - low).max()
    return Chart([[Cell("", Axis("x", "m", low[0] - room, high[0] + room), Axis("y", "m", low[1] - room, high[1] + room),
                        shapes=tuple(shapes), equal=True)]], note=" ".join(dict.fromkeys(notes)))
