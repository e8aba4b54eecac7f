# SPDX-License-Identifier: Apache-2.0
"""Sparse polynomial chaos, a surrogate of one quantity that is validated on points that it has not seen; its Sobol'
indices.

Method: Blatman and Sudret (2011, doi 10.1016/j.jcp.2010.12.021): orthogonal matching pursuit chooses the terms; degree and
hyperbolic norm are chosen by the corrected leave-one-out error. Sobol' indices are sums of squared coefficients: Sudret
(2008, doi 10.1016/j.ress.2007.04.002).
"""

from typing import Any, NamedTuple

import numpy

from ..evaluation.libraries import need

FOLDS = 5
NORMS = (0.5, 0.75, 1.0)
HIGHEST_DEGREE = 16
MOST_TERMS = 1000  # of the candidates; the regression's cost grows with them
EXACT = 1e-8  # an error below which no better surrogate is looked for
PATIENCE = 2  # degrees without a better error after which higher ones are not tried
REPLICAS = 400
LEVELS = (0.025, 0.975)


class Chaos(NamedTuple):
    """Surrogate of one quantity: a sum of orthonormal polynomials of the germs (standardised random keys).

    degree, norm     largest degree, and hyperbolic norm, of the candidates among which the terms were chosen
    terms            array [term, key]: degrees of the polynomials
    coefficients     array [term]; the first is the mean
    basis            array [sample, term]: values of the polynomials at the samples
    leave_one_out    corrected leave-one-out error, as a share of the variance
    q2               1 minus the share of the variance that is missed at points left out in five folds, terms chosen anew
    evaluate         function of germs, array [n, keys], that returns an array [n]
    """

    degree: int
    norm: float
    terms: numpy.ndarray
    coefficients: numpy.ndarray
    basis: numpy.ndarray
    leave_one_out: float
    q2: float
    evaluate: Any


def fit(germs, data, distributions) -> Chaos:
    """Fits a polynomial chaos to samples.

    germs          array [n, keys]
    data           array [n], not constant
    distributions  OpenTURNS distribution of the germ of each key

    Raises CaseError without OpenTURNS.
    """
    turns = need("openturns", "ionskin uncertainty")
    basis = _Basis(turns, distributions)
    best, since = None, 0
    for degree in range(1, HIGHEST_DEGREE + 1):
        tried = [found for norm in NORMS if (found := basis.regress(germs, data, degree, norm)) is not None]
        if not tried:
            break
        leader = min(tried, key=lambda found: found.leave_one_out)
        if best is None or leader.leave_one_out < best.leave_one_out:
            best, since = leader, 0
        else:
            since += 1
        if since >= PATIENCE or best.leave_one_out < EXACT:
            break
    return best._replace(q2=_validated(basis, germs, data, best))


def _validated(basis, germs, data, chosen) -> float:
    """Q2 by cross-validation in folds of every fifth point, which are evenly spread in a Sobol' sequence."""
    squares = 0.0
    for fold in range(FOLDS):
        left = numpy.arange(len(data)) % FOLDS == fold
        found = basis.regress(germs[~left], data[~left], chosen.degree, chosen.norm)
        predicted = found.evaluate(germs[left]) if found is not None else data[~left].mean()
        squares += ((data[left] - predicted) ** 2).sum()
    return 1 - squares / ((data - data.mean()) ** 2).sum()


class _Basis:
    """Basis of products of polynomials that are orthonormal with respect to the distribution of each germ."""

    def __init__(self, turns, distributions) -> None:
        self._turns, self._distributions = turns, distributions
        families = [turns.StandardDistributionPolynomialFactory(one) for one in distributions]
        self._polynomials = families
        # Germs of the families' own measures: uniform and normal ones are so already.
        self._measures = [family.getMeasure() for family in families]
        self._known: dict = {}

    def _standard(self, germs):
        columns = []
        for place, (one, measure) in enumerate(zip(self._distributions, self._measures)):
            column = germs[:, place]
            low, high = (measure.computeQuantile(p)[0] for p in (0.25, 0.75))
            first, last = (one.computeQuantile(p)[0] for p in (0.25, 0.75))
            columns.append(low + (column - first) * (high - low) / (last - first))
        return numpy.column_stack(columns)

    def _tables(self, germs, degree):
        """Polynomials of each key at the samples, as a list of arrays [n, degree + 1]."""
        standard = self._standard(germs)
        result = []
        for place, family in enumerate(self._polynomials):
            recurrence = [family.getRecurrenceCoefficients(n) for n in range(degree)]
            table = [numpy.ones(len(germs))]
            for n, (a, b, c) in enumerate(recurrence):
                table.append((a * standard[:, place] + b) * table[n] + (c * table[n - 1] if n else 0.0))
            result.append(numpy.column_stack(table))
        return result

    def _candidates(self, degree, norm):
        if (degree, norm) not in self._known:
            self._known[degree, norm] = _terms(len(self._distributions), degree, norm)
        return self._known[degree, norm]

    def _matrix(self, germs, terms):
        tables = self._tables(germs, int(terms.max(initial=0)))
        result = numpy.ones((len(germs), len(terms)))
        for place, table in enumerate(tables):
            result *= table[:, terms[:, place]]
        return result

    def regress(self, germs, data, degree, norm) -> Chaos | None:
        """Chooses terms up to a degree and norm, and fits their coefficients; None when there are too many candidates.

        The q2 of the Chaos is NaN.
        """
        terms = self._candidates(degree, norm)
        if terms is None:
            return None
        matrix = self._matrix(germs, terms)
        active, error = _select(matrix, data)
        if active is None:
            return None
        chosen, own = terms[active], matrix[:, active]
        coefficients = numpy.linalg.lstsq(own, data, rcond=None)[0]
        return Chaos(degree, norm, chosen, coefficients, own, error, float("nan"),
                     lambda at: self._matrix(numpy.asarray(at, float), chosen) @ coefficients)


def _terms(keys, degree, norm):
    """Multi-indices, as an array [term, key], with (sum of degrees^norm)^(1/norm) <=
    degree, the constant first; None for too many."""
    found, limit = [], degree**norm * (1 + 1e-12)

    def extend(prefix, used):
        if len(found) > MOST_TERMS:
            return
        if len(prefix) == keys:
            found.append(prefix)
            return
        for power in range(degree + 1):
            total = used + (power**norm if power else 0.0)
            if total > limit:
                break
            extend((*prefix, power), total)

    extend((), 0.0)
    if len(found) > MOST_TERMS:
        return None
    return numpy.array(sorted(found, key=lambda term: (sum(term), term)))


def _select(matrix, data):
    """Chooses columns of a matrix [sample, term] by orthogonal matching pursuit, as many as minimise the corrected
    leave-one-out error; returns their indices, None without any, and this error as a share of the variance."""
    count = len(data)
    variance = data.var(ddof=1)
    lengths = numpy.linalg.norm(matrix, axis=0)
    best, error = None, numpy.inf
    active, q = [], numpy.empty((count, 0))  # the columns taken, orthonormal by Gram and Schmidt's method
    r_inverse = numpy.zeros((0, 0))
    residual, hat, inverse_trace = data.copy(), numpy.zeros(count), 0.0
    pick = 0  # the constant comes first
    while len(active) < min(max(2, count // 2), matrix.shape[1]):
        column = matrix[:, pick]
        along = q.T @ column
        rest = column - q @ along
        again = q.T @ rest  # once more, for rounding
        rest, along = rest - q @ again, along + again
        length = numpy.linalg.norm(rest)
        if length < 1e-10 * lengths[pick]:
            break
        unit = rest / length
        grown = numpy.zeros((len(active) + 1,) * 2)
        grown[:-1, :-1], grown[:-1, -1], grown[-1, -1] = r_inverse, -(r_inverse @ along) / length, 1 / length
        r_inverse, q = grown, numpy.column_stack([q, unit])
        inverse_trace += (r_inverse[:, -1] ** 2).sum()
        residual = residual - unit * (unit @ residual)
        hat = hat + unit**2
        active.append(pick)
        if hat.max() > 1 - 1e-9:
            break
        loo = numpy.mean((residual / (1 - hat)) ** 2) / variance
        # Chapelle, Vapnik and Bengio (2002, doi 10.1023/A:1013943418833)
        corrected = loo * count / (count - len(active)) * (1 + inverse_trace)
        if corrected < error:
            best, error = list(active), corrected
        elif len(active) > 1.2 * len(best) + 10:
            break
        if error < EXACT:
            break
        gain = numpy.abs(matrix.T @ residual) / lengths
        gain[active] = 0.0
        pick = int(gain.argmax())
    return best, float(error)


def indices(terms, coefficients):
    """First-order and total Sobol' indices, arrays [key], of the terms and coefficients of a chaos whose variance is not 0."""
    squares = coefficients**2
    varying = terms.sum(axis=1) > 0
    variance = squares[varying].sum()
    alone = (terms > 0) & ((terms > 0).sum(axis=1) == 1)[:, None]
    return squares @ alone / variance, squares @ (terms > 0) / variance


def intervals(chaos: Chaos, data, seed: int):
    """95 % intervals of first-order and total Sobol' indices, arrays [2, key], by
    bootstrap of the samples with the chosen terms."""
    generator = numpy.random.default_rng([seed, 0x50B01])
    count, found = len(data), ([], [])
    for _ in range(REPLICAS):
        rows = generator.integers(count, size=count)
        coefficients = numpy.linalg.lstsq(chaos.basis[rows], data[rows], rcond=None)[0]
        for kept, index in zip(found, indices(chaos.terms, coefficients)):
            kept.append(index)
    return tuple(numpy.quantile(kept, LEVELS, axis=0) for kept in found)
