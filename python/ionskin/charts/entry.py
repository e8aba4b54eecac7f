# SPDX-License-Identifier: Apache-2.0
"""Numbered figure: its caption, and the function that makes its chart for a run or a sweep."""

from typing import Callable, NamedTuple

from . import fields, sketches
from .chart import with_coincidence_noted


class Entry(NamedTuple):
    """Numbered figure; `build` is a function of a Study that returns a Chart, or a text that says why there is none."""

    name: str
    heading: str
    caption: str
    build: Callable

    @property
    def number(self):
        """Number by which papers cite the figure: 7 of "fig07_peaks"."""
        return int(self.name[3:5])

    def chart(self, study):
        """Chart of the figure for a Study, or a text that says why there is none."""
        chart = self.build(study)
        return chart if isinstance(chart, str) else with_coincidence_noted(chart)


def of_run(build, lacks, named=True):
    """Makes the `build` of a figure that shows the typical run of a Study.

    build  function of Results that returns a Chart, or None
    lacks  function of Results that returns the reason why there is none
    named  True to say in the figure which run it shows
    """
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
