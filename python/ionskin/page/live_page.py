# SPDX-License-Identifier: Apache-2.0
"""HTML page that plays a trajectory on a reduced-order skin, without a network: data and script are in the page."""

import pathlib
import tomllib

import numpy

from ..quantity import si
from ..words import quantity
from . import pages

MOST_FRAMES = 1500
DIGITS = 5
FULL_COLOUR = 0.95  # of the frames have a weaker current than that of the fullest colour
SPEEDS = (0.1, 0.25, 0.5, 1, 2, 5)
CHARTS = [("Forces", "N", [("normal_force", "normal", "blue"), ("tangential_force", "tangential", "orange")]),
          ("Electrode currents", "A", [("current_top", "top", "blue"), ("current_bottom", "bottom", "orange")])]
KEYS = "Space plays and pauses, the arrow keys step, Home and End go to the ends, + and − change the speed."


def rounded(values):
    """Rounds values to the digits that the page needs, as a list."""
    return [float(f"{value:.{DIGITS}g}") for value in values]


def mean_current(times, charge, window):
    """Mean currents [A] over the window [s] that ends at each time, or since the first time where that is shorter; 0 at
    the first.

    times, charge  arrays [step] [s], [C]
    """
    begins = numpy.maximum(times - window, times[0])
    lengths = times - begins
    return numpy.divide(charge - numpy.interp(begins, times, charge), lengths, out=numpy.zeros_like(times),
                        where=lengths > 0)


def sample_interval(case):
    """Sampling interval of the readout in a case (nested dict) [s]; 0 where it is missing or has an unknown unit."""
    try:
        return si(case.get("readout", {}).get("sample_interval", "0 s"))
    except ValueError:  # another unit
        return 0.0


def footprint(case):
    """Length and width of a flat slider in a case (nested dict) [m]; None for other shapes, whose contact changes its size."""
    slider = case.get("slider", {})
    if slider.get("shape", "flat") != "flat" or "size" not in slider:
        return None
    try:
        return si(slider["size"])
    except ValueError:  # another unit
        return None


def data(skin, times, signals):
    """Data of the page's script for the Signals of a Skin at `times` [s], at no more than MOST_FRAMES of them."""
    frames = numpy.unique(numpy.linspace(0, len(times) - 1, min(MOST_FRAMES, len(times))).round().astype(int))
    time, case = times[frames], tomllib.loads(skin.case)
    window = max(sample_interval(case), (times[-1] - times[0]) / max(1, len(frames) - 1))

    def series(name):
        if name.startswith("current_"):
            return rounded(mean_current(times, signals[name.replace("current_", "charge_", 1)], window)[frames])
        return rounded(signals[name][frames])

    taxels = skin.taxels
    charts = [{"title": title, "unit": unit,
               "curves": [{"label": label, "colour": colour, "values": series(name)} for name, label, colour in curves]}
              for title, unit, curves in CHARTS]
    if taxels:
        charts.append({"title": "Currents of the taxels", "unit": "A",
                       "curves": [{"label": name, "values": series(f"current_top_{name}")} for name in taxels]})
    regions = taxels or {"top electrode": (0.0, 0.0, *skin.size)}
    # A flag that was up since the frame before is shown.
    flags = numpy.bitwise_or.reduceat(numpy.asarray(signals.flags), numpy.concatenate([[0], frames[:-1] + 1])) \
        if len(frames) > 1 else signals.flags
    currents = charts[2]["curves"] if taxels else charts[1]["curves"][:1]
    strongest = numpy.abs([curve["values"] for curve in currents]).max(axis=0)
    return {"time": [round(float(value), 9) for value in time], "size": list(skin.size),
            "footprint": footprint(case), "window": window, "charts": charts,
            "full": float(numpy.quantile(strongest, FULL_COLOUR)) or float(strongest.max()),
            "regions": [{"name": name, "corners": list(corners)} for name, corners in regions.items()],
            "currents": currents,
            "flags": [int(flag) for flag in flags],
            **{name: rounded(signals[name][frames])
               for name in ("slider_x", "slider_y", "slider_z", "normal_force", "contact_area", "stick_share")}}


def write(path, skin, times, signals):
    """Writes the page for the Signals of a Skin at `times` [s] and returns its path. Raises ValueError without any step."""
    if len(times) == 0:
        raise ValueError("times: there is no step to play")
    content = data(skin, times, signals)
    title = tomllib.loads(skin.case).get("title") or "A live skin"
    shape = "The outline is the face of the slider" if content["footprint"] else \
        "The disc has the area of the contact"
    notes = [f"{shape}, filled as far as it sticks. Currents are means over {quantity(content['window'], 's', 3)}. {KEYS}"]
    section = pages.Section("play", "Seen from above", "player",
                            {"speeds": SPEEDS, "frames": len(content["time"]), "notes": notes})
    subtitle = (f"{quantity(times[-1] - times[0], 's')} in {len(times)} step{'s' * (len(times) != 1)} of a reduced skin · "
                f"ionskin {skin.version}")
    script = pages.chart_script({"DATA": ("live_page.js", content)})
    return pages.write_page(pathlib.Path(path), pages.page(title, subtitle, [section], script=script))
