# SPDX-License-Identifier: Apache-2.0
"""Makes the figures of a folder as files, each drawn once, in as many processes as there are processors."""

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
    """A figure to draw. files: kinds by name; build: returns a Chart, or the reason for none."""

    name: str
    files: dict
    build: Callable


class Made(NamedTuple):
    """Outcome of a job: the reason for which it was left out, or ""."""

    name: str
    reason: str


def numbered_jobs(study, only=()):
    """Jobs for the numbered figures of a run or a sweep, or for those named."""
    of_run = not only and study.sweep is None
    return [Job(entry.name, {entry.name: ALL, **({SAME[entry.name]: OF_PAGE} if of_run and entry.name in SAME else {})},
                lambda entry=entry: entry.chart(study)) for entry in numbered.ENTRIES if not only or entry.name in only]


def of_page(results):
    """Jobs for the files of a run's page that are not numbered figures."""
    return [Job(entry.name, {entry.name: OF_PAGE}, lambda entry=entry: entry.draw(results) or "") for entry in figures.FIGURES
            if entry.name not in SAME.values()]


def make(jobs, folder, progress=None):
    """Does the jobs and returns a Made for each, in order.

    folder    of the files
    progress  called with the finished part
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
    """Writes the kinds of each name in `files`."""
    figure.set_dpi(DPI)
    for name, kinds in files.items():
        for kind in kinds:
            more = {"pil_kwargs": FAST} if kind == "png" else {"metadata": {"Date": None} if kind == "svg" else {"CreationDate": None}}
            output_folder.save(figure, folder / f"{name}.{kind}", **more)
