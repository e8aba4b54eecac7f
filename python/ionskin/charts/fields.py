# SPDX-License-Identifier: Apache-2.0
"""Reading of the fields in results.h5 that figures show."""

import numpy

STUCK = 1e-6  # speed of slip over the largest one below which a cell sticks
NO_FIELDS = "the run has no results.h5"
NO_CONTACT = "the run has no contact"


def fields_of(results):
    """The open file results.h5 of a run, or None where the run has none."""
    return results.open_fields() if (results.folder / "results.h5").exists() else None


def cell_areas(file):
    """Areas of the contact cells [y][x] [m2], from an open results.h5."""
    return numpy.outer(numpy.diff(file["contact/grid/y"][...]), numpy.diff(file["contact/grid/x"][...]))


def mirrored(file, values):
    """Completes a map of contact cells of a half model by its mirror image; returns edges in y [m] and values [y][x].

    Maps of a full model are returned as they are.
    """
    edges = file["contact/grid/y"][...]
    if edges[-1] > 1e-9:
        return edges, values
    return numpy.concatenate([edges, -edges[-2::-1]]), numpy.concatenate([values, values[::-1]])
