# SPDX-License-Identifier: Apache-2.0
"""Makes the figures of a folder, each drawn once, in as many processes as there are processors."""

import concurrent.futures
import gc
import io
import multiprocessing
import os
from typing import Callable, NamedTuple

import numpy
from PIL import Image

from .. import figures, output_folder
from . import draw_chart, gallery

DPI = 300  # of PNG files
HALF = 2  # pixels of a file beside each other that are one of the page's picture
FAST = {"compress_level": 2}
ALL = ("png", "svg", "pdf")
OF_PAGE = ("png", "svg")
# Figures of the page of a run that are numbered ones too.
SAME = {"fig01_model": "model", "fig04_motion": "motion", "fig18_contact_maps": "contact", "fig19_ions": "ions"}


class Job(NamedTuple):
    """A figure to draw. files: kinds by name; draw: returns a Figure or the reason for none."""

    name: str
    files: dict
    draw: Callable


class Made(NamedTuple):
    """What became of a job: the reason for which it was left out, or "", and the picture for a page as PNG, if wanted."""

    name: str
    reason: str
    picture: bytes


def numbered(study, only=(), files=True):
    """Jobs for the numbered figures of a run or a sweep, or for those named; without files for their pictures alone."""
    of_run = not only and study.sweep is None
    return [Job(entry.name, {entry.name: ALL, **({SAME[entry.name]: OF_PAGE} if of_run and entry.name in SAME else {})} if files else {},
                lambda entry=entry: entry.draw(study)) for entry in gallery.ENTRIES if not only or entry.name in only]


def of_page(results):
    """Jobs for the files of a run's page that are no numbered figures."""
    return [Job(entry.name, {entry.name: OF_PAGE}, lambda entry=entry: drawn(entry.draw(results))) for entry in figures.FIGURES
            if entry.name not in SAME.values()]


def drawn(chart):
    """A Chart as a figure; otherwise the reason for none, "" where the run has nothing of the kind."""
    return chart or "" if chart is None or isinstance(chart, str) else draw_chart.draw(chart)


def make(jobs, folder, wanted=False, progress=None):
    """Does the jobs and returns a Made for each, in order.

    folder    of the files; wanted: a picture of each for a page; progress: called with the finished part
    """
    _work.update(jobs=jobs, folder=folder, wanted=wanted)
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
    figure = job.draw()
    if isinstance(figure, str):
        return Made(job.name, figure, b"")
    picture = b""
    if _work["wanted"] or job.files:
        picture = save(figure, _work["folder"], job.files, _work["wanted"])
    return Made(job.name, "", picture)


def save(figure, folder, files, wanted=False):
    """Writes the kinds of each name in `files`; returns the picture for a page as PNG if it is wanted."""
    for name, kinds in files.items():
        for kind in kinds:
            if kind != "png":
                output_folder.save(figure, folder / f"{name}.{kind}", metadata={"Date": None} if kind == "svg" else {"CreationDate": None})
    figure.set_dpi(DPI if files else DPI // HALF)
    figure.canvas.draw()
    pixels = numpy.asarray(figure.canvas.buffer_rgba())[..., :3]
    for name, kinds in files.items():
        if "png" in kinds:
            with output_folder.writing(folder / f"{name}.png") as pending:
                Image.fromarray(pixels).save(pending, format="png", dpi=(DPI, DPI), **FAST)
    if not wanted:
        return b""
    if files:
        high, wide = (size // HALF * HALF for size in pixels.shape[:2])
        pixels = pixels[:high, :wide].reshape(high // HALF, HALF, wide // HALF, HALF, 3).mean(axis=(1, 3)).round().astype(numpy.uint8)
    file = io.BytesIO()
    Image.fromarray(pixels).save(file, format="png", compress_level=6)
    return file.getvalue()
