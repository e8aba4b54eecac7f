# SPDX-License-Identifier: Apache-2.0
"""The publication whose case ionskin began with, and which cases are its own."""

from ..quantity import si

CITATION = "Sensors 2026, 26(10), 2930, doi 10.3390/s26102930"
ABOUT = (f"What the article on this case ({CITATION}) says of its results, judged on the data of this folder. The "
         "article's table of parameters is not public: values that it does not state are assumed in cases/paper.toml.")
# What the article states: the skin, the gap and the laws. Friction, times and materials vary with a study of it.
STATED = {("skin", "length"): "15 mm", ("skin", "width"): "2 mm", ("motion", "gap"): "1 mm"}
LAWS = {("slider", "shape"): "flat", ("motion", "kind"): "touch-slide-lift", ("contact", "law"): "coulomb",
        ("coupling", "law"): "fixed-charge", ("coupling", "measure"): "off-diagonal", ("strain", "source"): "contact",
        ("readout", "circuit"): "short"}


def is_own_case(case):
    """True if a case agrees with all values that the article states."""
    def value(place, default=None):
        return case.get(place[0], {}).get(place[1], default)

    try:
        same_lengths = all(abs(si(value(place)) - si(text)) < 1e-9 for place, text in STATED.items())
    except (TypeError, ValueError):
        return False
    roles = [layer.get("role") for layer in case.get("skin", {}).get("layers", [])]
    return (same_lengths and roles == ["electrode", "core", "electrode"] and "taxels" not in case.get("readout", {})
            and all(value(place, default) == default for place, default in LAWS.items()))
