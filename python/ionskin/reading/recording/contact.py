# SPDX-License-Identifier: Apache-2.0
"""When a recorded finger touches, by a force with noise about zero."""

import numpy

FEW = 20  # rows, which tell no noise


def noise(force):
    """Deviation of the noise of one row [N]: of the bends between neighbours, most of which are nothing else; 0 for few."""
    return 1.4826 * float(numpy.median(numpy.abs(numpy.diff(force, 2)))) / numpy.sqrt(6) if len(force) >= FEW else 0.0


def rest_level(force):
    """Force at rest: that of the rows with the least force, which a finger off the skin has [N]."""
    return float(numpy.median(force[force <= numpy.quantile(force, 0.1) + 3 * noise(force)]))


def threshold(force):
    """Above the level at rest, beyond its noise: five deviations, or a fiftieth of the largest force [N]."""
    level = rest_level(force)
    return max(5 * noise(force), 0.02 * (float(force.max()) - level))


def compresses(force, zeroed):
    """True where the force counts compression as positive: by its largest value, or, where it begins and ends at one
    level far from 0, as with the weight of a tool, by what departs most from there.

    zeroed  whether 0 is known to be no force
    """
    most, ends = numpy.abs(force).max(), max(1, len(force) // 20)
    first, last = float(numpy.median(force[:ends])), float(numpy.median(force[-ends:]))
    offset = not zeroed and min(abs(first), abs(last)) > 0.2 * most and abs(first - last) < 0.2 * most
    level = first if offset else 0.0
    return force.max() - level >= level - force.min()


def touching(force, above):
    """Array of truths [rows]: from where the force rises above `above` until it falls below half of it.

    force  above the level at rest [N]
    """
    high, low = force > above, force > 0.5 * above
    state, result = False, numpy.empty(len(force), dtype=bool)
    for row, (is_high, is_low) in enumerate(zip(high.tolist(), low.tolist())):
        state = is_low if state else is_high
        result[row] = state
    return result


def parts(touches):
    """(first, behind the last) of each run of rows that touches."""
    edges = numpy.flatnonzero(numpy.diff(numpy.concatenate(([False], touches, [False])).astype(int)))
    return list(zip(edges[::2].tolist(), edges[1::2].tolist()))
