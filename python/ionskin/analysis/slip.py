# SPDX-License-Identifier: Apache-2.0
"""Onset of a slide: where and when the skin under the slider begins to slip, and
whether the currents show it before full slip."""

from typing import NamedTuple

import numpy

CURRENTS = ("difference", "common")
STICKS = 1  # of slip_state, in signals.csv and in the contact maps
SEEN = 3  # times the noise floor


class Onset(NamedTuple):
    """Instants of the first slide of a run [s]: its begin, the first micro-slip, and
    full slip, None where it is not reached."""

    begin: float
    micro: float
    full: float | None


def value(results, name):
    """Value of a metric of Results in its SI unit; None where the run has no such metric."""
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
    """HDF5 groups of the contact states at the onset of the first slide in results.h5, in the order of time."""
    states = [group for name, group in file["contact"].items() if name.startswith("onset_") and "slip_state" in group]
    return sorted(states, key=lambda group: float(group.attrs["parameter"]))


def release_times(file, begin):
    """Time [y][x] from the begin of the slide until each contact cell slips for good [s]; 0 where it never stuck, NaN
    without contact.

    file   results.h5, open
    begin  begin of the slide [s]

    Raises ValueError when the file holds no state of an onset.
    """
    states = onset_states(file)
    if not states:
        raise ValueError("results.h5 holds no state of an onset of sliding")
    times = numpy.zeros(states[0]["slip_state"].shape)
    for group, later in zip(states, [*states[1:], states[-1]]):
        times[group["slip_state"][...] == STICKS] = float(later.attrs["parameter"]) - begin
    return numpy.where(states[-1]["slip_state"][...] > 0, times, numpy.nan)


def slip_at(file, instant):
    """Slip [y][x] of the slider over each contact cell since the cell touches [m], in the onset state nearest to an
    instant [s].

    NaN without contact.
    """
    group = min(onset_states(file), key=lambda each: abs(float(each.attrs["parameter"]) - instant))
    return numpy.where(group["slip_state"][...] > 0, group["slip_since_landing"][...], numpy.nan)


def error(results, name):
    """Reported error estimate of a metric in its SI unit, also where the metric does not converge; 0 without an estimate."""
    return sum(results.summary.get("error_parts", {}).get(name, {}).values())


class Precursor(NamedTuple):
    """Data that decide whether a current shows the onset of slip before full slip.

    departure         change of a reading by the onset [A]
    error             reported error estimate of the change [A]
    noise             noise floor of a reading [A]
    lead, lead_error  time from when the change is seen to full slip, and its error estimate [s]
    interval          time between two readings [s]

    NaN stands for values that the run does not have.
    """

    departure: float
    error: float
    noise: float
    lead: float
    lead_error: float
    interval: float

    @property
    def certain(self):
        """True if at least one reading falls between the visible change and full slip,
        and the change exceeds noise and error."""
        return bool(self.lead - self.lead_error >= self.interval and self.departure - self.error > SEEN * self.noise)


def precursor(results, current):
    """Precursor of a run (Results) for a current, "difference" or "common"."""
    def number(name):
        found = value(results, name)
        return numpy.nan if found is None else found

    time = results.sampled["time"] if "time" in results.sampled else ()
    interval = float(time[0]) if len(time) else numpy.nan
    name = f"precursor_current_{current}"
    lead = f"precursor_lead_time_{current}"
    return Precursor(number(name), error(results, name), number("precursor_noise_floor"), number(lead), error(results, lead),
                interval)
