# SPDX-License-Identifier: Apache-2.0
"""Contact of a recorded finger with the skin, found by a normal force [N] that has noise about zero."""

import numpy

FEW = 20  # rows, which tell no noise
FLAT = 5  # successive rows, through which a force with noise is not constant


def noise(force):
    """Standard deviation of the noise of a force [rows] [N], by its second differences,
    most of which are noise; 0 for few rows.

    Rows at the limit of a sensor, which repeat the largest force, have no noise and are left out.
    """
    if len(force) < FEW:
        return 0.0
    differences = numpy.abs(numpy.diff(force, 2))
    flat = numpy.convolve(_flat(force), numpy.ones(3), mode="valid") > 0
    if (~flat).sum() >= FEW:
        differences = differences[~flat]
    return 1.4826 * float(numpy.median(differences)) / numpy.sqrt(6)


def _flat(force):
    """True in rows [rows] that have the largest force, as one of the rows beside them has, too."""
    top = numpy.pad(force == force.max(), 1)
    return top[1:-1] & (top[:-2] | top[2:])


def saturated(force):
    """True in rows [rows] that repeat the largest force in several successive rows, in spite of noise, as at the limit of a
    sensor."""
    flat = numpy.zeros(len(force), dtype=bool)
    for first, behind in parts(_flat(force)) if noise(force) > 0 else []:
        flat[first:behind] = behind - first >= FLAT
    return flat


def steady(force):
    """Force without the rows that stand alone, as a spike of a sensor does: medians of three rows, array [rows] [N].

    It is the force itself where nothing but noise would be left, as with taps that last one row each.
    """
    if len(force) < 3:
        return force
    around = numpy.pad(force, 1, mode="reflect")
    middle = numpy.median([around[:-2], around[1:-1], around[2:]], axis=0)
    return middle if numpy.ptp(middle) > 10 * noise(force) else force


def rest_level(force):
    """Force at rest [N]: median of the rows with the least force, in which the finger is off the skin."""
    return float(numpy.median(force[force <= numpy.quantile(force, 0.1) + 3 * noise(force)]))


def threshold(force, share=1.0):
    """Force above the level at rest from which the finger touches [N].

    It is the larger of five standard deviations of the noise and 1/50 of the largest steady force above the level at
    rest.

    force  array [rows] as the sensor recorded it, neither resampled nor filtered [N]
    share  share of the noise that a later filter leaves
    """
    return max(5 * share * noise(force), 0.02 * (float(steady(force).max()) - rest_level(force)))


def spikes(force, above):
    """Rows that stand alone, as an array: those that depart from the force at rest, to either side, more than three times as
    far as the steady force, and those that lift the finger between two rows in which it presses.

    above  force above the level at rest from which the finger touches [N]
    """
    level = rest_level(force)
    far = numpy.abs(force - level) > 3 * numpy.abs(steady(force) - level).max() + 5 * noise(force)
    presses = numpy.pad(force - level > 2 * above, 1)
    lifts = (force - level <= 0.5 * above) & presses[:-2] & presses[2:]
    return numpy.flatnonzero(far | lifts)


def compresses(force, zeroed):
    """True if compression is positive in a recorded force, which the largest departure from the level at rest decides.

    The level is 0, or where the force begins and ends far from 0, as with the weight of a tool, the value there.

    zeroed  True if 0 is known to mean no force
    """
    force = steady(force)
    most, ends = numpy.abs(force).max(), max(1, len(force) // 20)
    first, last = float(numpy.median(force[:ends])), float(numpy.median(force[-ends:]))
    offset = not zeroed and min(abs(first), abs(last)) > 0.2 * most and abs(first - last) < 0.2 * most
    level = first if offset else 0.0
    return force.max() - level >= level - force.min()


def touching(force, above):
    """True in rows [rows] in which the finger touches: from a force larger than `above` [N] until it falls below half
    of it.

    force  array [rows] of the force above the level at rest [N]
    """
    high, low = force > above, force > 0.5 * above
    state, result = False, numpy.empty(len(force), dtype=bool)
    for row, (is_high, is_low) in enumerate(zip(high.tolist(), low.tolist())):
        state = is_low if state else is_high
        result[row] = state
    return result


def parts(touches):
    """Spans of contact, as a list of (first row, row behind the last); `touches` is an array [rows] of booleans."""
    edges = numpy.flatnonzero(numpy.diff(numpy.concatenate(([False], touches, [False])).astype(int)))
    return list(zip(edges[::2].tolist(), edges[1::2].tolist()))
