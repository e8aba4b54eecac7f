# SPDX-License-Identifier: Apache-2.0
"""Figure 18: pressure, shear traction, stick and slip under the slider, and the shear of the core below."""

import numpy

from ..page.report_text import has_sharp_edges
from .chart import Axis, Cell, Chart, Map
from .colours import BLUE, DIVERGING, ORANGE, SEQUENCE
from .fields import STUCK, cell_areas, fields_of, mirrored

CLASSES = {"sticks": BLUE, "slips": ORANGE}
SECTION = 0.6  # height of a section
UNDERSHOOT = -0.3  # of the largest shear; what the smoothing of a shear without sign may leave is smaller
AT_LIMIT = 1e-3  # of the friction limit below which a cell sticks


def capped(values, areas, share):
    """Upper end of a colour scale: value below which a share of the area lies; 1 for a map of zeros."""
    order = numpy.argsort(values, axis=None)
    below = numpy.cumsum(numpy.broadcast_to(areas, values.shape).ravel()[order])
    return float(values.ravel()[order][numpy.searchsorted(below, min(share, 1 - 1e-12) * below[-1])]) or 1.0


def within(touching):
    """True [y][x] in touching cells whose neighbours touch, too; pressure at the rim of a contact is known only to one cell."""
    inner = numpy.pad(touching, 1)
    return touching & inner[:-2, 1:-1] & inner[2:, 1:-1] & inner[1:-1, :-2] & inner[1:-1, 2:]


def top_of_scale(values, touching, areas, share):
    """Upper end of the colour scale of a contact map: under a sharp slider the value below which `share` of the touched
    area lies, else the largest value away from the rim."""
    if not touching.any():
        return 1.0
    inner = within(touching)
    if share < 1 or not inner.any():
        return capped(values[touching], areas[touching], share)
    return float(values[inner].max()) or 1.0


def touchdown_state(file):
    """Name in results.h5 of the contact state at the end of the first touchdown; None without any."""
    return max((name for name in file["contact"] if name.startswith("touchdown")), default=None)


def middle_state(file):
    """Name in results.h5 of the state of steady sliding nearest to the middle of the slide, or else that of touchdown."""
    times = {name: group.attrs["parameter"] for name, group in file["contact"].items() if name.startswith("steady_")}
    if not times:
        return touchdown_state(file)
    middle = (min(times.values()) + max(times.values())) / 2
    return min(times, key=lambda name: abs(times[name] - middle))


def contact_maps(results):
    """Pressure and traction under the slider, stuck and slipping cells, and the shear in the core; None without a contact."""
    if fields_of(results) is None:
        return None
    with fields_of(results) as file:
        if "contact" not in file or touchdown_state(file) is None:
            return None
        # Peaks at sharp edges depend on the mesh and must not set the colours.
        share = 0.95 if has_sharp_edges(results.case.get("slider", {})) else 1.0
        landed, middle = (touchdown_state(file), "end of touchdown"), (middle_state(file), "mid-slide")
        columns = [traction_maps(file, *which, share) for which in (landed, middle)]
        friction = results.case.get("contact", {}).get("friction")
        sticking = [stick_map(file, *which, friction) for which in (landed, onset_state(file, friction))]
        rows = [*map(list, zip(*columns)), sticking, core_sections(file, results, 0.99 if share < 1 else 1.0)]
        note = "" if share < 1 else resolution(file, middle[0])
    return Chart(rows, (1.0, 1.0), note=note)


def resolution(file, state):
    """Sentence on the details that a contact map of a round slider does not resolve."""
    pressure = mirrored(file, file["contact"][state]["pressure"][...])[1]
    touching = pressure > 0
    inner = within(touching)
    if not touching.any():
        return ""
    along, across = (int(touching.any(axis=axis).sum()) for axis in (0, 1))
    words = f"The contact is {along} × {across} cells large, and its rim is known to one cell only"
    if not inner.any():
        return f"{words}: its pressure is not resolved. A finer numerics.preset, or numerics.mesh_refinement, has more cells."
    excess = float(pressure[touching].max() / pressure[inner].max())
    if excess > 1:
        words += f": there the pressure, up to {excess:.2g} times the largest within, is not resolved, and the colours end at the largest within"
    return f"{words}. A finer numerics.preset, or numerics.mesh_refinement, has more cells."


def from_above(file, title, values, **look):
    """Cell of a chart that shows a map of the contact cells from above."""
    x, (y, values) = file["contact/grid/x"][...], mirrored(file, values)
    return Cell(title, Axis("x from the slider's centre", "m", x[0], x[-1]), Axis("y", "m", y[0], y[-1]), map=Map(x, y, values, **look),
                equal=True)


def traction_maps(file, state, words, share):
    """Maps of pressure and shear traction of a contact state; `share` of the touched area
    lies below the end of the colour scale."""
    group, areas = file["contact"][state], cell_areas(file)
    pressure, shear = group["pressure"][...], numpy.hypot(group["shear_x"][...], group["shear_y"][...])
    touching, cells = pressure > 0, []
    for values, name in ((pressure, "Pressure"), (shear, "Shear traction")):
        # The half model ends at the middle of the width, which is not a rim.
        whole, all_areas = (mirrored(file, part)[1] for part in (values, areas))
        top = top_of_scale(whole, mirrored(file, touching)[1], all_areas, share)
        cells.append(from_above(file, f"{name}, {words}", numpy.where(touching, values, numpy.nan), high=top, unit="Pa",
                                beyond=bool(touching.any() and values[touching].max() > top)))
    return cells


def touching_and_slipping(file, state, friction):
    """Touching cells, and slipping cells [y][x]: by the limit of Coulomb's law, or by their slip for other friction laws."""
    group = file["contact"][state]
    pressure, slip = group["pressure"][...], group["slip"][...]
    shear = numpy.hypot(group["shear_x"][...], group["shear_y"][...])
    touching = pressure > 0
    limit = (friction or 0.0) * pressure
    if friction and (shear <= limit * (1 + AT_LIMIT)).all():
        return touching, touching & (shear >= limit * (1 - AT_LIMIT))
    return touching, touching & (slip > STUCK * (slip.max() or 1.0))


def onset_state(file, friction):
    """Name of the state at the onset of sliding whose stuck share is nearest to a half, and words for it."""
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


def stick_map(file, state, words, friction):
    """Map of the sticking and the slipping cells, in two colours."""
    touching, slipping = touching_and_slipping(file, state, friction)
    return from_above(file, f"Contact, {words}", numpy.where(touching, slipping.astype(float), numpy.nan), classes=CLASSES)


def core_sections(file, results, share):
    """Shear of the core at the end of touchdown and mid-slide, on the section at mid-width."""
    strain = file["strain"]
    time = strain["time"][...]
    x, z = strain["grid/x"][...], strain["grid/z"][...]
    spans = {span.phase: span for span in reversed(results.phases())}
    slide = spans.get("slide")
    instants = (spans["touchdown"].end, (slide.start + slide.end) / 2) if slide else (time[0], time[-1])
    rides = strain.attrs["frame"] != "skin"  # the grid with the slider
    y = (strain["grid/y"][1:] + strain["grid/y"][:-1]) / 2
    # As far to both sides of the footprint as the core is thick several times over: beyond there is nothing to see.
    reach = float(numpy.abs(file["contact/grid/x"][...]).max()) + 4 * z[-1]
    cells = []
    for instant, words in zip(instants, ("end of touchdown", "mid-slide")):
        place = [0.0 if rides else float(numpy.interp(instant, results.signals["time"], results.signals[f"slider_{axis}"])) for axis in "xy"]
        centres = (x[1:] + x[:-1]) / 2 - place[0]
        shown = numpy.abs(centres) <= reach
        middle = strain["gamma"].shape[2] // 2 if rides else int(numpy.abs(y - place[1]).argmin())
        section = strain["gamma"][int(numpy.abs(time - instant).argmin()), :, middle, :]
        top = capped(numpy.abs(section), numpy.diff(x), share)
        signed = bool(section[:, shown].min() < UNDERSHOOT * section[:, shown].max())
        cells.append(Cell(f"Core shear γ, {words}", Axis("x from the slider's centre", "m", -reach, reach), Axis("z", "m", z[0], z[-1]),
                          map=Map(centres, z, section, -top if signed else 0.0, top, palette=DIVERGING if signed else SEQUENCE,
                                  beyond=share < 1, smooth=True), height=SECTION))
    return cells
