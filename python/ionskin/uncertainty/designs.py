# SPDX-License-Identifier: Apache-2.0
"""Points that fill the unit cube evenly."""

import warnings

import numpy

from ..errors import CaseError
from ..evaluation.libraries import need

DESIGNS = ("sobol", "lhs")
MOST_KEYS = 50


def points(design: str, count: int, keys: int, seed: int) -> numpy.ndarray:
    """Points that fill the unit cube evenly, as an array [count, keys] within (0, 1).

    design  "sobol": Sobol' sequence, scrambled by the seed, of which a larger `count` continues a smaller one; "lhs": Latin
            hypercube
    """
    if design not in DESIGNS:
        raise CaseError(f"design {design} is unknown\n  = choose one of {', '.join(DESIGNS)}")
    if not 1 <= keys <= MOST_KEYS:
        raise CaseError(f"{keys} keys vary\n  = at most {MOST_KEYS}")
    qmc = need("scipy.stats", "ionskin uncertainty").qmc
    if design == "lhs":
        return qmc.LatinHypercube(keys, seed=seed).random(count)
    with warnings.catch_warnings():  # any number of points serves a regression
        warnings.simplefilter("ignore", UserWarning)
        return numpy.clip(qmc.Sobol(keys, scramble=True, seed=seed).random(count), 1e-9, 1 - 1e-9)
