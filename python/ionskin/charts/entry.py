# SPDX-License-Identifier: Apache-2.0
"""One numbered figure: its caption, and how it is drawn of a run or a sweep."""

from typing import Callable, NamedTuple

from . import fields, sketches
from .chart import with_coincidence_noted


class Entry(NamedTuple):
    """One numbered figure; `build` takes a Study and returns a Chart, or the reason for none."""

    name: str
    heading: str
    caption: str
    build: Callable

    @property
    def number(self):
        """Number by which papers cite the figure: 7 of "fig07_peaks"."""
        return int(self.name[3:5])

    def chart(self, study):
        """The Chart, or the reason for none."""
        chart = self.build(study)
        return chart if isinstance(chart, str) else with_coincidence_noted(chart)


def of_run(build, lacks, named=True):
    """A figure of the typical run from its Chart. lacks: words for its absence, of the Results; named: says which run it is"""
    def drawn(study):
        results = study.typical.results
        chart = build(results)
        if chart is None or isinstance(chart, str):
            return chart or lacks(results)
        member = "" if study.single or not named else f"{study.label(study.typical)}."
        return chart._replace(note=f"{member} {chart.note}".strip())

    return drawn


def no_slider(_):
    """Reason why a run has no figure of its slider."""
    return sketches.NO_CONTACT


def no_fields(results):
    """Reason why a run has no figure of the contents of results.h5."""
    return fields.NO_CONTACT if (results.folder / "results.h5").exists() else fields.NO_FIELDS
