# SPDX-License-Identifier: Apache-2.0
"""Kinds of the rows of touches (without contact, at rest, sticking, partly or wholly slipping), and a balanced choice of rows."""

import numpy

KINDS = ("no contact", "rest", "stick", "partial slip", "full slip")
MOVING = ("stick", "partial slip", "full slip")  # between which a choice is balanced
AT_REST = 1e-9  # speed [m/s]
ALL, NONE = 0.99, 0.01  # stick shares from which on all sticks, and up to which nothing does


def kinds(labels, columns) -> numpy.ndarray:
    """Kind of each row, as indices into KINDS, an array [row] of uint8.

    labels   array [row, label]
    columns  names of the labels

    At rest, a row is no stick and no slip: cells at their friction limit count as slipping there although nothing moves.
    """
    touching, speed, stick = (labels[:, columns.index(name)] for name in ("touching", "slider_speed", "stick_share"))
    moving = numpy.where(stick >= ALL, KINDS.index("stick"),
                         numpy.where(stick <= NONE, KINDS.index("full slip"), KINDS.index("partial slip")))
    kind = numpy.where(speed <= AT_REST, KINDS.index("rest"), moving)
    return numpy.where(touching > 0, kind, KINDS.index("no contact")).astype(numpy.uint8)


class RowChoice:
    """Counts rows by kind, and chooses at random equally many of each of MOVING, without keeping all rows.

    most  number of rows of each kind that are chosen at most; 0: none
    seed  seed of the choice; it depends on the rows in their order alone
    """

    def __init__(self, most: int, seed: int) -> None:
        self._most, self._random = most, numpy.random.default_rng([seed, 2])
        self.counts = dict.fromkeys(KINDS, 0)
        self._kept = {name: numpy.empty((0, 3)) for name in MOVING}  # ticket, touch, row: the smallest tickets stay

    def add(self, touch: int, kind: numpy.ndarray) -> None:
        """Takes the rows of a touch. `kind` is an array [row] as `kinds` returns it."""
        for index, name in enumerate(KINDS):
            rows = numpy.flatnonzero(kind == index)
            self.counts[name] += len(rows)
            if name in self._kept and self._most and len(rows):
                tickets = self._random.random(len(rows))
                kept = numpy.vstack([self._kept[name], numpy.column_stack([tickets, numpy.full(len(rows), touch), rows])])
                if len(kept) > self._most:
                    kept = kept[numpy.argpartition(kept[:, 0], self._most)[:self._most]]
                self._kept[name] = kept

    def chosen(self) -> numpy.ndarray:
        """The choice as an array [row, 3] of int64: number of the touch, its row, and the index into KINDS; ascending.

        The rarest kind sets how many rows of each kind there are.
        """
        each = min(len(kept) for kept in self._kept.values())
        parts = [numpy.column_stack([kept[numpy.argsort(kept[:, 0])[:each], 1:].astype(numpy.int64),
                                     numpy.full(each, KINDS.index(name))]) for name, kept in self._kept.items()]
        rows = numpy.vstack(parts)
        return rows[numpy.lexsort((rows[:, 1], rows[:, 0]))]
