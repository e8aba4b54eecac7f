# SPDX-License-Identifier: Apache-2.0
"""Figure files of a folder: draws each figure once, in as many processes as there are processors."""

import concurrent.futures
import gc
import multiprocessing
import os
from typing import Callable, NamedTuple

from .. import figures, output_folder
from ..charts import numbered
from . import draw_chart

DPI = 300  # of PNG files
FAST = {"compress_level": 2}
ALL = ("png", "svg", "pdf")
OF_PAGE = ("png", "svg")
# Figures of the page of a run that are numbered ones too.
SAME = {"fig01_model": "model", "fig04_motion": "motion", "fig18_contact_maps": "contact", "fig19_ions": "ions"}


class Job(NamedTuple):
    """Figure to draw: its name, the files to write (dict of file name to kinds such as "png"), and the function that
    makes its Chart or returns the reason why there is none."""

    name: str
    files: dict
    build: Callable


class Made(NamedTuple):
    """Outcome of a Job: name of the figure, and the reason why it was not drawn, "" when it was."""

    name: str
    reason: str


def numbered_jobs(study, only=()):
    """Jobs for the numbered figures of a Study; only those with the names in `only`, if it is not empty."""
    of_run = not only and study.sweep is None
    return [Job(entry.name, {entry.name: ALL, **({SAME[entry.name]: OF_PAGE} if of_run and entry.name in SAME else {})},
                lambda entry=entry: entry.chart(study)) for entry in numbered.ENTRIES if not only or entry.name in only]


def of_page(results):
    """Jobs for the figures on the page of a run (Results) that are not numbered figures, too."""
    return [Job(entry.name, {entry.name: OF_PAGE}, lambda entry=entry: entry.draw(results) or "") for entry in figures.FIGURES
            if entry.name not in SAME.values()]


def make(jobs, folder, progress=None):
    """Draws the figures of a list of Job and returns a Made for each, in order.

    folder    folder of the files
    progress  called with the finished part, from 0 to 1; None for no calls
    """
    _work.update(jobs=jobs, folder=folder)
    found, count = [], min(len(jobs), len(os.sched_getaffinity(0)))
    if count <= 1:
        results = map(_do, range(len(jobs)))
        pool = None
    else:
        # What a process draws it gives back at its end: looking for what can be freed costs a tenth of the time.
        pool = concurrent.futures.ProcessPoolExecutor(count, multiprocessing.get_context("fork"), gc.disable)
        results = pool.map(_do, range(len(jobs)))
    try:
        for made in results:
            found.append(made)
            if progress is not None:
                progress(len(found) / len(jobs))
    finally:
        if pool is not None:
            pool.shutdown(cancel_futures=True)
    return found


_work = {}  # of this process and of those that it starts, which inherit it


def _do(place):
    job = _work["jobs"][place]
    chart = job.build()
    if isinstance(chart, str):
        return Made(job.name, chart)
    save(draw_chart.draw(chart), _work["folder"], job.files)
    return Made(job.name, "")


def save(figure, folder, files):
    """Writes a figure into a folder, for each name in `files` in each of its kinds."""
    figure.set_dpi(DPI)
    for name, kinds in files.items():
        for kind in kinds:
            more = {"pil_kwargs": FAST} if kind == "png" else {"metadata": {"Date": None} if kind == "svg" else {"CreationDate": None}}
            output_folder.save(figure, folder / f"{name}.{kind}", **more)
