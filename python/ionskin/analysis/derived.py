# SPDX-License-Identifier: Apache-2.0
"""Quantities derived from the signals of one run: rates over readout intervals,
correlations, the factor between shear and charge."""

import numpy

from ..quantity import si

FARADAY = 96485.33212  # C/mol, exact in the SI


def sampled_rate(results):
    """Mean rate of the mean shear over each readout interval [1/s], on the rows of `sampled`."""
    time = results.sampled["time"]
    edges = numpy.concatenate([[results.signals["time"][0]], time])
    return numpy.diff(results.signals.at("mean_shear", edges)) / numpy.diff(edges)


def sampled_moment_rate(results):
    """Mean rate of the first moment of the shear over the thickness, on the rows of `sampled` [1/s]."""
    edges = numpy.concatenate([[results.signals["time"][0]], results.sampled["time"]])
    return numpy.diff(results.signals.at("shear_first_moment", edges)) / numpy.diff(edges)


def correlation(first, second, weights=None):
    """Pearson's correlation coefficient of two arrays, weighted; NaN when one is constant or has no numbers."""
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
    """Correlations of the currents with the rate of the mean shear, as a dict {(current, "resolved" or "sampled"): r}."""
    signals, sampled = results.signals, results.sampled
    steps = numpy.diff(signals["time"])
    rate = sampled_rate(results)
    found = {}
    for name in ("top", "bottom", "difference", "common"):
        column = f"current_{name}"
        found[name, "resolved"] = correlation(signals[column][1:], signals["mean_shear_rate"][1:], steps)
        found[name, "sampled"] = correlation(sampled[column], rate)
    return found


NEUTRAL_LAWS = ("volume-neutral", "column-neutral", "poroelastic")  # the core as a whole keeps its charge: exact physics has no common part

SOUND_AUDIT = 1e-6  # charge identity error up to which a common charge of a neutral law is the solver's rounding


def sampled_rms(results, name):
    """Root mean square of a sampled current over the run [A]."""
    sampled = results.sampled
    steps = numpy.diff(numpy.concatenate([[results.signals["time"][0]], sampled["time"]]))
    values = sampled[f"current_{name}"]
    good = numpy.isfinite(values)
    return float(numpy.sqrt(numpy.average(values[good] ** 2, weights=steps[good]))) if good.any() else 0.0


def common_noise(results):
    """Noise of the sampled common current that the solver's error of the common charge can make [A].

    The run's own audit tells that error, `charge_identity_error`; of a neutral law all common charge is it. Without the audit,
    or where it fails, nothing counts as noise.
    """
    signals = results.signals
    audit = results.metrics.get("charge_identity_error")
    if not signals.has("charge_top", "charge_bottom") or audit is None or not (audit.value or 1.0) < SOUND_AUDIT:
        return 0.0
    charge = numpy.abs(signals["charge_top"] + signals["charge_bottom"])
    largest = float(numpy.nanmax(charge))
    if results.case.get("coupling", {}).get("law", "fixed-charge") not in NEUTRAL_LAWS:
        largest *= audit.value
    interval = float(numpy.min(numpy.diff(results.sampled["time"]), initial=numpy.inf))
    # Half the sum of both currents, and the error may turn its sign within one interval.
    return largest / interval if numpy.isfinite(interval) else 0.0


def common_is_noise(results):
    """True when the sampled common current is not above the solver's noise."""
    return sampled_rms(results, "common") <= common_noise(results)


def charge_per_shear(results):
    """Factor K = F c0 k V [C], the common charge of both electrodes per mean shear; None when the run does not have it."""
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
