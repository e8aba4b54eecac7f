# SPDX-License-Identifier: Apache-2.0
"""Series derived from the signals of one run: rates per sample, correlations, the factor between shear and charge."""

import numpy

from .quantity import si

FARADAY = 96485.33212  # C/mol, exact in the SI


def sampled_rate(results):
    """Mean rate of the mean shear over each readout interval [1/s], on the rows of `sampled`."""
    time = results.sampled["time"]
    edges = numpy.concatenate([[results.signals["time"][0]], time])
    return numpy.diff(results.signals.at("mean_shear", edges)) / numpy.diff(edges)


def sampled_moment_rate(results):
    """The same for the first moment of the shear over the thickness [1/s]."""
    edges = numpy.concatenate([[results.signals["time"][0]], results.sampled["time"]])
    return numpy.diff(results.signals.at("shear_first_moment", edges)) / numpy.diff(edges)


def correlation(first, second, weights=None):
    """Pearson's coefficient, weighted; NaN where a series is constant or has no numbers."""
    first, second = numpy.asarray(first), numpy.asarray(second)
    good = numpy.isfinite(first) & numpy.isfinite(second)
    first, second = first[good], second[good]
    weights = numpy.ones_like(first) if weights is None else numpy.asarray(weights)[good]
    if not weights.sum():
        return float("nan")
    first = first - numpy.average(first, weights=weights)
    second = second - numpy.average(second, weights=weights)
    scale = numpy.sqrt((weights * first**2).sum() * (weights * second**2).sum())
    return float((weights * first * second).sum() / scale) if scale > 0 else float("nan")


def rate_correlations(results):
    """Correlation with the rate of the mean shear: {(current, "resolved" or "sampled"): r}."""
    signals, sampled = results.signals, results.sampled
    steps = numpy.diff(signals["time"])
    rate = sampled_rate(results)
    found = {}
    for name in ("top", "bottom", "difference", "common"):
        column = f"current_{name}"
        found[name, "resolved"] = correlation(signals[column][1:], signals["mean_shear_rate"][1:], steps)
        found[name, "sampled"] = correlation(sampled[column], rate)
    return found


def charge_per_shear(results):
    """K = F c0 k V in coulomb: the common charge of both electrodes per mean shear, or None when unknown."""
    case = results.case
    try:
        skin, ions, coupling = case["skin"], case["electrochemistry"], case["coupling"]
        core = next(si(layer["thickness"]) for layer in skin["layers"] if layer["role"] == "core")
        value, unit = str(ions["fixed_charge_concentration"]).split()
        if unit not in ("mol/m3", "mM", "mmol/l"):
            return None
        return FARADAY * float(value) * float(coupling["coefficient"]) * si(skin["length"]) * si(skin["width"]) * core
    except (KeyError, ValueError, StopIteration):
        return None
