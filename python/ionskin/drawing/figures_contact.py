# SPDX-License-Identifier: Apache-2.0
"""Figure 18: pressure, shear traction, stick and slip under the slider, and the shear of the core below."""

import numpy
from matplotlib.colors import ListedColormap
from matplotlib.patches import Patch

from ..page.report_text import has_sharp_edges
from . import style
from .figures_fields import NO_CONTACT, NO_FIELDS, STUCK, cell_areas, fields_of
from .panels import scaled_label

STICK, SLIP = (style.BLUE, "sticks"), (style.ORANGE, "slips")
MAP = 2.2  # width of a map [inch]
SECTION = 0.85  # height of a section [inch]
UNDERSHOOT = -0.3  # of the largest shear; what the smoothing of a shear without sign may leave is smaller
AT_LIMIT = 1e-3  # of the friction limit below which a cell sticks


def mirrored(file, values):
    """A map of the half model completed to the full footprint, with its y edges."""
    edges = file["contact/grid/y"][...]
    if edges[-1] > 1e-9:
        return edges, values
    return numpy.concatenate([edges, -edges[-2::-1]]), numpy.concatenate([values, values[::-1]])


def capped(values, areas, share):
    """Upper end of a colour scale: what `share` of the area stays below, or 1 for maps of zeros."""
    order = numpy.argsort(values, axis=None)
    below = numpy.cumsum(numpy.broadcast_to(areas, values.shape).ravel()[order])
    return float(values.ravel()[order][numpy.searchsorted(below, min(share, 1 - 1e-12) * below[-1])]) or 1.0


def touchdown_state(file):
    """Name of the state at the end of the first touchdown, which takes one step or several; None without any."""
    return max((name for name in file["contact"] if name.startswith("touchdown")), default=None)


def middle_state(file):
    """Name of the state of steady sliding nearest the middle of the slide, or of touchdown."""
    times = {name: group.attrs["parameter"] for name, group in file["contact"].items() if name.startswith("steady_")}
    if not times:
        return touchdown_state(file)
    middle = (min(times.values()) + max(times.values())) / 2
    return min(times, key=lambda name: abs(times[name] - middle))


def contact_maps(study):
    """Figure 18: pressure and traction under the slider, what sticks and slips, and the shear in the core."""
    results = study.typical.results
    if fields_of(results) is None:
        return NO_FIELDS
    with fields_of(results) as file:
        if "contact" not in file or touchdown_state(file) is None:
            return NO_CONTACT
        figure, panels = empty_maps(file)
        # Peaks at sharp edges depend on the mesh and must not set the colours.
        share = 0.95 if has_sharp_edges(results.case.get("slider", {})) else 1.0
        for column, (state, words) in enumerate(((touchdown_state(file), "end of touchdown"),
                                                 (middle_state(file), "mid-slide"))):
            traction_maps(figure, panels[:2, column], file, state, words, share)
        friction = results.case.get("contact", {}).get("friction")
        for panel, (state, words) in zip(panels[2], ((touchdown_state(file), "end of touchdown"),
                                                     onset_state(file, friction))):
            stick_map(panel, file, state, friction, words)
        for panel in panels[:3].ravel():
            panel.set_aspect("equal")
            panel.grid(False)
        core_sections(figure, panels[3], file, results, 0.99 if share < 1 else 1.0)
    return figure


def empty_maps(file):
    """A figure with three rows of maps in the shape of the footprint and one of sections."""
    x, (y, _) = file["contact/grid/x"][...], mirrored(file, file["contact"][touchdown_state(file)]["pressure"][...])
    tall = MAP * float(numpy.clip((y[-1] - y[0]) / (x[-1] - x[0]), 0.2, 0.9))
    heights = [tall, tall, tall, SECTION]
    height = sum(heights) + 2.3
    figure = style.canvas(height=height, left=0.085, right=0.90, top=1 - 0.28 / height, bottom=0.45 / height,
                          hspace=0.52 / (sum(heights) / 4), wspace=0.42)
    panels = figure.subplots(4, 2, gridspec_kw={"height_ratios": heights})
    for row in panels[:3]:
        row[0].set_ylabel("y [mm]")
    for panel in panels[3]:
        panel.set_xlabel("x from the slider's centre [mm]")
    return figure, panels


def traction_maps(figure, panels, file, state, words, share):
    """Pressure and shear traction of a state; the colour scale ends where `share` of the touched area lies below."""
    group, x = file["contact"][state], file["contact/grid/x"][...] * 1e3
    y, pressure = mirrored(file, group["pressure"][...])
    shear = mirrored(file, numpy.hypot(group["shear_x"][...], group["shear_y"][...]))[1]
    areas = mirrored(file, cell_areas(file))[1]
    touching = pressure > 0
    for panel, values, name in ((panels[0], pressure, "Pressure"), (panels[1], shear, "Shear traction")):
        top = capped(values[touching], areas[touching], share) if touching.any() else 1.0
        divisor, prefix = style.si_scale(top)
        image = panel.pcolormesh(x, y * 1e3, numpy.where(touching, values, numpy.nan) / divisor, cmap=style.SEQUENCE, vmin=0,
                                 vmax=top / divisor, rasterized=True)
        style.title(panel, f"{name}, {words}")
        # Beside the map itself, whose place follows from its equal scales.
        bar = figure.colorbar(image, cax=panel.inset_axes((1.03, 0, 0.04, 1)), extend="max" if share < 1 else "neither")
        bar.set_label(f"{prefix}Pa", fontsize=7)


def touching_and_slipping(file, state, friction):
    """Cells that touch, and those of them whose traction is at the limit of Coulomb's law; by their slip for other laws."""
    group = file["contact"][state]
    pressure, slip = group["pressure"][...], group["slip"][...]
    shear = numpy.hypot(group["shear_x"][...], group["shear_y"][...])
    touching = pressure > 0
    limit = (friction or 0.0) * pressure
    if friction and (shear <= limit * (1 + AT_LIMIT)).all():
        return touching, touching & (shear >= limit * (1 - AT_LIMIT))
    return touching, touching & (slip > STUCK * (slip.max() or 1.0))


def onset_state(file, friction):
    """The state of the onset of sliding whose stuck part is nearest a half, and words for it."""
    names = sorted(name for name in file["contact"] if name.startswith("onset_"))
    if not names:
        return middle_state(file), "mid-slide"
    areas = cell_areas(file)

    def stuck(name):
        touching, slipping = touching_and_slipping(file, name, friction)
        return (areas * (touching & ~slipping)).sum() / max((areas * touching).sum(), 1e-300)

    name = min(names, key=lambda each: abs(stuck(each) - 0.5))
    since = float(file["contact"][name].attrs["parameter"]) - float(file["path/onset_begin"][0])
    return name, f"{since * 1e3:.2g} ms into the slide"


def stick_map(panel, file, state, friction, words):
    """What sticks and what slips, in two colours."""
    touching, slipping = touching_and_slipping(file, state, friction)
    y, values = mirrored(file, numpy.where(touching, slipping.astype(float), numpy.nan))
    panel.pcolormesh(file["contact/grid/x"][...] * 1e3, y * 1e3, values, vmin=0, vmax=1,
                     cmap=ListedColormap([STICK[0], SLIP[0]]), rasterized=True)
    style.title(panel, f"Contact, {words}")
    panel.legend(handles=[Patch(color=colour, label=name) for colour, name in (STICK, SLIP)], loc="center left",
                 bbox_to_anchor=(1.01, 0.5), fontsize=6.5, handlelength=0.9)


def core_sections(figure, panels, file, results, share):
    """Shear of the core at the end of touchdown and mid-slide, on the section at mid-width."""
    strain = file["strain"]
    time = strain["time"][...]
    x, z = strain["grid/x"][...] * 1e3, strain["grid/z"][...] * 1e6
    spans = {span.phase: span for span in reversed(results.phases())}
    slide = spans.get("slide")
    instants = (spans["touchdown"].end, (slide.start + slide.end) / 2) if slide else (time[0], time[-1])
    middle = strain["gamma"].shape[2] // 2
    sections = [strain["gamma"][int(numpy.abs(time - instant).argmin()), :, middle, :] for instant in instants]
    centres = (x[1:] + x[:-1]) / 2
    # As far to both sides of the footprint as the core is thick several times over: beyond there is nothing to see.
    reach = 1e3 * float(numpy.abs(file["contact/grid/x"][...]).max()) + 4e-3 * z[-1]
    shown = numpy.abs(centres) <= reach
    for panel, section, words in zip(panels, sections, ("end of touchdown", "mid-slide")):
        top = capped(numpy.abs(section), numpy.diff(x), share)
        divisor, label = scaled_label("γ", "1", top)
        signed = bool(section[:, shown].min() < UNDERSHOOT * section[:, shown].max())
        image = panel.pcolormesh(centres, z, section / divisor, cmap=style.DIVERGING if signed else style.SEQUENCE,
                                 vmin=-top / divisor if signed else 0, vmax=top / divisor, shading="gouraud", rasterized=True)
        panel.set_xlim(-reach, reach)
        panel.grid(False)
        style.title(panel, f"Core shear {label}, {words}")
        figure.colorbar(image, cax=panel.inset_axes((1.03, 0, 0.04, 1)), extend="max" if share < 1 else "neither")
    panels[0].set_ylabel("z [µm]")
