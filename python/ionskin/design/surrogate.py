# SPDX-License-Identifier: Apache-2.0
"""Choice of the next point to evaluate: optimum of interpolants of all results within a trust region."""

import warnings

import numpy

from ..evaluation.libraries import need

STARTS = 6
TRUSTED = 1e-6  # how far a constraint may be missed by the interpolants, in its own scale


def next_place(places, objective, constraints, equal, centre, radius, generator):
    """Finds the point [keys] at which the interpolated objective is least and the interpolated constraints hold.

    places          array [n, keys]: evaluated points within the unit cube
    objective       array [n]
    constraints     array [n, m]: margins, at least 0 where a constraint holds
    equal           [m] booleans: True for an equality, whose margin must be 0
    centre, radius  centre [keys] and half the edge of the trust region
    generator       random generator of numpy, for the starts of the search

    The search goes by SLSQP (Kraft, 1988), from several starts. Raises CaseError when scipy is missing.
    """
    interpolate = need("scipy.interpolate", "ionskin design")
    optimize = need("scipy.optimize", "ionskin design")
    data = numpy.column_stack([objective, constraints])
    scale = numpy.maximum(data.std(axis=0), 1e-300)
    # The cubic kernel with a quadratic: the interpolant of Wendland (2005, doi 10.1017/CBO9780511617539), exact for parabolas.
    keys = places.shape[1]
    degree = 2 if len(places) > (keys + 1) * (keys + 2) // 2 else 1
    model = interpolate.RBFInterpolator((places - centre) / radius, data / scale, kernel="cubic", degree=degree)
    low, high = numpy.maximum(-1, -centre / radius), numpy.minimum(1, (1 - centre) / radius)

    def value(column):
        return lambda at: float(model(at[None])[0, column])

    conditions = [{"type": "eq" if same else "ineq", "fun": value(1 + i)} for i, same in enumerate(equal)]
    best, least = centre, numpy.inf
    for start in [numpy.zeros(keys), *generator.uniform(low, high, (STARTS - 1, keys))]:
        with warnings.catch_warnings():  # a step that SLSQP clips to the bounds
            warnings.simplefilter("ignore", RuntimeWarning)
            found = optimize.minimize(value(0), start, method="SLSQP", bounds=list(zip(low, high)), constraints=conditions,
                                      options={"maxiter": 60, "ftol": 1e-10})
        at = numpy.clip(found.x, low, high)
        row = model(at[None])[0]
        missed = sum(abs(g) if same else max(0.0, -g) for g, same in zip(row[1:], equal))
        merit = row[0] + 1e3 * max(0.0, missed - TRUSTED)
        if merit < least:
            best, least = centre + at * radius, merit
    return numpy.clip(best, 0, 1)
