# SPDX-License-Identifier: Apache-2.0
"""The article's claims (see paper.py), judged on the data: each with its verdict and its number."""

from typing import NamedTuple

import numpy

from ..analysis import derived, sensitivity
from ..charts.spans import peak_of
from ..words import quantity
from . import regimes

HOLDS, CONDITION, FAILS, OPEN = "holds", "holds under a condition", "does not hold", "cannot be judged"
DETACHED = 1e-3  # shear of the return over the peak that still counts as none
FOLLOWS = 0.9  # correlation from which one series is said to follow another
OPPOSITE = 0.1  # part of the common current in both that still counts as equal and opposite


class Verdict(NamedTuple):
    """Verdict on one claim of the article: the claim, the verdict, and the number on which it rests, as texts."""

    claim: str
    verdict: str
    number: str


def detached(study):
    """Verdict on the claim that the shear γ is near 0 while the slider is detached."""
    claim = "γ is near 0 while the slider is detached"
    worst = 0.0
    for member in study.members:
        signals = member.results.signals
        spans = [span for span in member.results.phases() if span.phase == "return"]
        if not spans or not signals.has("mean_shear"):
            return Verdict(claim, OPEN, "the run has no detached phase")
        rows = numpy.any([(signals["time"] > span.start) & (signals["time"] <= span.end) for span in spans], axis=0)
        worst = max(worst, peak_of(signals["mean_shear"][rows]) / (peak_of(signals["mean_shear"]) or 1))
    return Verdict(claim, HOLDS if worst < DETACHED else FAILS,
                   f"largest mean γ during the return: {worst:.2g} of its peak")


def monotone(study, metric, words):
    """Verdict on the claim that a metric, called `words`, rises with the swept key."""
    claim = f"{words} rises with {study.name}"
    values = numpy.array(study.metric(metric))
    if study.single:
        return Verdict(claim, OPEN, "it needs several finished runs")
    if not numpy.isfinite(values).all():
        return Verdict(claim, OPEN, "not every run has it")
    if study.scattered:
        return rising_rank(study, claim, values)
    unit = study.typical.results.metrics[metric].unit
    ends = f"from {quantity(values[0], unit, 3)} to {quantity(values[-1], unit, 3)}"
    steps = numpy.diff(values)
    if (steps > 0).all():
        return Verdict(claim, HOLDS, f"{ends}, rising at every step")
    if (steps < 0).all():
        return Verdict(claim, FAILS, f"it falls at every step, {ends}")
    at = study.members[int(numpy.argmax(steps <= 0))]
    return Verdict(claim, FAILS, f"not monotone: {int((steps <= 0).sum())} of {len(steps)} steps fall, the first "
                                 f"after {study.label(at)}")


def rising_rank(study, claim, values):
    """Verdict on a claim that values rise with a key, by ranks, since other keys vary too."""
    rank = sensitivity.rank_correlation([member.value for member in study.members], values)
    number = f"rank correlation {rank:.2f} over {len(values)} points, whose other keys vary too"
    return Verdict(claim, CONDITION if rank >= FOLLOWS else FAILS if rank <= 0 else OPEN, number)


def two_regimes(study, metric, words):
    """Verdict on the claim that a metric has a weak and a strong regime along the swept key."""
    claim = f"two regimes: {words} rises faster at high {study.name}"
    if study.scattered:
        return Verdict(claim, OPEN, "several keys vary at once: a sweep along one key would decide it")
    fit = regimes.fit([member.value for member in study.members], study.metric(metric))
    if fit is None:
        return Verdict(claim, OPEN, f"it needs {regimes.FEWEST} points or more")
    if not fit.two:
        return Verdict(claim, FAILS, f"one power law serves: exponent {fit.low:.2f} ± {fit.low_error:.2f}")
    number = (f"exponent {fit.low:.2f} ± {fit.low_error:.2f} below {fit.break_at:.2g}, {fit.high:.2f} ± "
              f"{fit.high_error:.2f} above (information criterion better by {fit.gain:.0f})")
    if fit.high <= fit.low:
        return Verdict(claim, FAILS, number)
    error, bend = fit_error(study, metric, fit), smooth_law(study, metric)
    if bend is not None and bend[0] < error:
        return Verdict(claim, CONDITION, f"{number}; but {bend[1]} fits better than the two laws ({error:.2%}): the "
                                         "change is gradual, without a break")
    return Verdict(claim, HOLDS, number)


def fit_error(study, metric, fit):
    """Root mean square of the relative residuals of a fit of a metric over the members of a study."""
    values = numpy.array([member.value for member in study.members])
    data = numpy.array(study.metric(metric))
    kept = (values > 0) & (data > 0)
    return float(numpy.sqrt(numpy.mean((fit(values[kept]) / data[kept] - 1) ** 2)))


def smooth_law(study, metric):
    """Relative residual and words of y² = a + b x + c x²: a hyperbola, which bends without a break."""
    values = numpy.array([member.value for member in study.members])
    data = numpy.array(study.metric(metric))
    if len(values) < 5 or not (data > 0).all():
        return None
    matrix = numpy.stack([numpy.ones_like(values), values, values**2], axis=1) / data[:, None] ** 2
    coefficients, *_ = numpy.linalg.lstsq(matrix, numpy.ones_like(data), rcond=None)
    squares = coefficients @ numpy.array([numpy.ones_like(values), values, values**2])
    if (squares <= 0).any():
        return None
    error = float(numpy.sqrt(numpy.mean((numpy.sqrt(squares) / data - 1) ** 2)))
    return error, f"a smooth hyperbola with one parameter less (residual {error:.2%})"


def follows_rate(study, part, words):
    """Verdict on the claim that a part of the current follows the rate of the mean shear."""
    claim = f"the {words} follows dγ/dt"
    if not study.typical.results.sampled.has("current_top"):
        return Verdict(claim, OPEN, "the runs have no currents")
    if part == "common" and all(derived.common_is_noise(member.results) for member in study.members):
        return Verdict(claim, OPEN, "there is no common current: what is left of it is noise of the solver")
    found = [derived.rate_correlations(member.results) for member in study.members]
    sampled = [entry[part, "sampled"] for entry in found]
    resolved = [entry[part, "resolved"] for entry in found]
    worst = min(sampled + resolved)
    number = (f"correlation {span_of(sampled)} sampled, {span_of(resolved)} resolved")
    return Verdict(claim, HOLDS if worst >= FOLLOWS else FAILS, number)


def span_of(values):
    """Text of the range of some numbers."""
    low, high = min(values), max(values)
    return f"{low:.3f}" if high - low < 5e-4 else f"{low:.3f} to {high:.3f}"


def opposite(study):
    """Verdict on the claim that the currents of the electrodes are equal and opposite."""
    claim = "the electrodes' currents are equal and opposite"
    if not study.typical.results.sampled.has("current_common", "current_difference"):
        return Verdict(claim, OPEN, "the runs have no currents")
    if not any(derived.sampled_rms(member.results, "difference") for member in study.members):
        return Verdict(claim, OPEN, "no current flows between the electrodes")
    shares = []
    for member in study.members:
        common, difference = (derived.sampled_rms(member.results, name) for name in ("common", "difference"))
        if derived.common_is_noise(member.results):
            common = 0.0
        shares.append(common / (numpy.hypot(common, difference) or 1.0))
    law = study.typical.results.case.get("coupling", {}).get("law", "fixed-charge")
    if not any(shares):
        noise = quantity(max(derived.common_noise(member.results) for member in study.members), "A", 2)
        return Verdict(claim, HOLDS, f"the common current is not above the noise of the solver, {noise} (law {law})")
    number = f"the common part has {span_of([100 * share for share in shares])} % of the sampled rms (law {law})"
    return Verdict(claim, HOLDS if max(shares) < OPPOSITE else FAILS, number)


def transient(study):
    """Verdict on the claim that the current is concentrated at the contact events."""
    claim = "the current is transient: it is concentrated at contact, onset and separation"
    results = study.typical.results
    if not results.sampled.has("current_top"):
        return Verdict(claim, OPEN, "the runs have no currents")
    time, number = results.sampled["time"], []
    shares = []
    for name in ("top", "difference"):
        charge = numpy.abs(results.sampled[f"current_{name}"])
        steps = numpy.diff(numpy.concatenate([[0.0], time]))
        events = numpy.zeros(len(time), bool)
        for span in results.phases():
            if span.phase in ("slide", "lift"):
                events |= numpy.abs(time - span.start) < 0.03
        shares.append(float((charge * steps)[events].sum() / max((charge * steps).sum(), 1e-300)))
        number.append(f"{shares[-1]:.0%} of the {name} charge moves within 30 ms of an event")
    return Verdict(claim, HOLDS if min(shares) > 0.8 else CONDITION if max(shares) > 0.8 else FAILS, "; ".join(number))


def shear_signals(study):
    """Verdict on the claim that shear itself makes the signal, by the coupling law of the runs."""
    claim = "shear itself makes the signal"
    law = study.typical.results.case.get("coupling", {}).get("law", "fixed-charge")
    if law == "poroelastic":
        return Verdict(claim, FAILS, "pure shear changes no volume: at linear order it gives exactly none (ionskin verify "
                                     "poroelasticity, P6); pressure that differs between the walls does")
    return Verdict(claim, CONDITION, f"it is the assumption of the law {law}: its coefficient k is fitted to no measurement")


def more(study, count):
    """A sentence on the claims that this study cannot judge, and how they can be."""
    some = f"{count} more claim{'s' * (count > 1)}"
    if study.single:
        return (f"{some} are on how results change with friction, which several runs show: "
                "ionskin sweep CASE.toml --over contact.friction=0.05:0.05:0.5 -o DIR.")
    return f"{some} cannot be judged by these runs: ionskin report DIR --claims says why."


def judge(study):
    """Judges all claims of the article on a study, as a list of Verdict in the order of the article."""
    return [
        detached(study),
        monotone(study, "peak_mean_shear", "the peak of the mean shear"),
        monotone(study, "time_mean_shear", "the time mean of the mean shear"),
        two_regimes(study, "peak_mean_shear", "the peak of the mean shear"),
        two_regimes(study, "time_mean_shear", "the time mean of the mean shear"),
        monotone(study, "peak_sampled_current_top", "the peak of the sampled top current"),
        monotone(study, "peak_sampled_current_difference", "the peak of the sampled difference current"),
        transient(study),
        follows_rate(study, "top", "top electrode's current"),
        follows_rate(study, "common", "common current"),
        follows_rate(study, "difference", "difference current, which an ammeter sees,"),
        opposite(study),
        shear_signals(study),
    ]
