# SPDX-License-Identifier: Apache-2.0
"""Onset of a slide: where and when each place under the slider slips, and whether the currents tell before all
slips."""

from typing import NamedTuple

import numpy

CURRENTS = ("difference", "common")
STICKS = 1  # of slip_state, in signals.csv and in the contact maps
SEEN = 3  # times the noise floor


class Onset(NamedTuple):
    """Instants of the run [s]; full is None where the slide ends before full slip."""

    begin: float
    micro: float
    full: float | None


def value(results, name):
    """A metric, or None."""
    found = results.metrics.get(name)
    return None if found is None else found.value


def onset(results):
    """Onset of the first slide of a run; None without a slide, or where nothing sticks."""
    begin = next((span.start for span in results.phases() if span.phase == "slide"), None)
    micro, full = value(results, "micro_slip_time"), value(results, "full_slip_time")
    if begin is None or micro is None:
        return None
    return Onset(begin, begin + micro, None if full is None else begin + full)


def onset_states(file):
    """Contact states of the onset of the first slide in results.h5, in the order of time."""
    states = [group for name, group in file["contact"].items() if name.startswith("onset_") and "slip_state" in group]
    return sorted(states, key=lambda group: float(group.attrs["parameter"]))


def release_times(file, begin):
    """Instants [y][x] at which each cell slips for good, since the slide began [s]: 0 where it never stuck, NaN without
    contact.

    Raises ValueError where the file holds no state of an onset.
    """
    states = onset_states(file)
    if not states:
        raise ValueError("results.h5 holds no state of an onset of sliding")
    times = numpy.zeros(states[0]["slip_state"].shape)
    for group, later in zip(states, [*states[1:], states[-1]]):
        times[group["slip_state"][...] == STICKS] = float(later.attrs["parameter"]) - begin
    return numpy.where(states[-1]["slip_state"][...] > 0, times, numpy.nan)


def slip_at(file, instant):
    """The way that the slider slipped over each cell since it touches [m], of the state of the onset nearest an instant."""
    group = min(onset_states(file), key=lambda each: abs(float(each.attrs["parameter"]) - instant))
    return numpy.where(group["slip_state"][...] > 0, group["slip_since_landing"][...], numpy.nan)


def error(results, name):
    """The stated error of a metric in its unit, whether it is marked as not converging or not; 0 where none is stated."""
    return sum(results.summary.get("error_parts", {}).get(name, {}).values())


class Precursor(NamedTuple):
    """A current's answer to whether it shows a slip before the slip happens.

    departure, error, noise  of a reading, its stated error, and the noise floor [A]; NaN where there are none
    lead, lead_error         from where it is seen to full slip [s]; NaN where it is not
    interval                 between two readings [s]
    """

    departure: float
    error: float
    noise: float
    lead: float
    lead_error: float
    interval: float

    @property
    def certain(self):
        """A reading falls for certain between where the current is seen and full slip, and stands above noise and error."""
        return bool(self.lead - self.lead_error >= self.interval and self.departure - self.error > SEEN * self.noise)


def precursor(results, current):
    """Answer of a current, "difference" or "common", to whether it shows the onset of slip of a run beforehand."""
    def number(name):
        found = value(results, name)
        return numpy.nan if found is None else found

    time = results.sampled["time"] if "time" in results.sampled else ()
    interval = float(time[0]) if len(time) else numpy.nan
    name = f"precursor_current_{current}"
    lead = f"precursor_lead_time_{current}"
    return Precursor(number(name), error(results, name), number("precursor_noise_floor"), number(lead), error(results, lead),
                interval)
