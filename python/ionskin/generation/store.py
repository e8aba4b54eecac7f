# SPDX-License-Identifier: Apache-2.0
"""HDF5 file of all touches, written in their order and without dates, so that equal touches make equal bytes."""

import os
import pathlib

import numpy

from .. import output_folder
from ..evaluation import Outcome
from ..evaluation.libraries import need
from .rows import AT_REST, KINDS, RowChoice, kinds

SIGNALS = ("current_top", "current_bottom", "current_difference", "charge_top", "charge_bottom")
# Voltages and currents of circuits where taxels have their own, then currents and charges of all.
OF_TAXELS = ("voltage_", "current_circuit_", "current_top_", "current_bottom_", "charge_top_", "charge_bottom_")
LABELS = ("slider_x", "slider_z", "normal_force", "tangential_force", "mean_shear", "p99_shear", "slider_y",
          "contact_area", "stick_share", "slip")
WRENCH = ("tangential_force_x", "tangential_force_y", "moment_x", "moment_y", "moment_z")  # with normal_force, on the skin
ANGLES = ("roll", "pitch", "yaw")  # where the slider is tilted or turned [rad]
CONTACT_METRICS = ("stick_fraction_touchdown", "contact_area_slide", "mean_pressure_slide")
TOUCHING = 1e-9  # of the largest normal force


def taxel_signals(outcome: Outcome):
    """Names of the readings of taxels in an outcome, one kind after another."""
    names = [name.removeprefix("sampled_taxels/") for name in outcome.columns if name.startswith("sampled_taxels/")]
    return tuple(name for kind in OF_TAXELS for name in names if name.startswith(kind))


def tables(outcome: Outcome, rate: float):
    """Samples an outcome at a rate [1/s]: time [row] [s], signals [row, channel], labels [row, label]; NaN where it
    lacks a column.

    Readings come from the sampled tables where these have them, labels from the time steps of the solver.
    """
    columns = outcome.columns
    clock = columns["sampled/time"]
    time = numpy.arange(1, int(numpy.floor(clock[-1] * rate + 1e-6)) + 1) / rate

    def at(name):
        for table in ("sampled", "signals", "sampled_taxels"):
            if f"{table}/{name}" in columns:
                return numpy.interp(time, columns[f"{table}/time"], columns[f"{table}/{name}"])
        return numpy.full(len(time), numpy.nan)

    def label(name):
        if f"signals/{name}" in columns:
            return numpy.interp(time, columns["signals/time"], columns[f"signals/{name}"])
        return numpy.full(len(time), numpy.nan)

    labels = [label(name) for name in LABELS]
    force = labels[LABELS.index("normal_force")]
    touching = numpy.where(numpy.isfinite(force), force > TOUCHING * numpy.nanmax(force, initial=1e-30), numpy.nan)
    speed = numpy.hypot(*(numpy.gradient(labels[LABELS.index(name)], time) for name in ("slider_x", "slider_y")))
    speed[speed <= AT_REST] = 0  # of the rounding of places
    return (time, numpy.column_stack([at(name) for name in (*SIGNALS, *taxel_signals(outcome))]),
            numpy.column_stack([*labels, touching, speed, *map(label, (*WRENCH, *angles(outcome)))]))


def angles(outcome: Outcome):
    """Names of the angles that an outcome holds."""
    return tuple(name for name in ANGLES if f"signals/{name}" in outcome.columns)


COLUMNS = (*LABELS, "touching", "slider_speed", *WRENCH)
UNITS = {"slider_x": "m", "slider_y": "m", "contact_area": "m2", "slip": "m", "slider_z": "m", "normal_force": "N", "tangential_force": "N",
         "slider_speed": "m/s", "roll": "rad", "pitch": "rad", "yaw": "rad",
         "tangential_force_x": "N", "tangential_force_y": "N", "moment_x": "N m", "moment_y": "N m", "moment_z": "N m",
         "charge_top": "C", "charge_bottom": "C"}


def unit_of(name):
    """Unit of a column that is not in UNITS."""
    return {"current": "A", "voltage": "V", "charge": "C"}.get(name.partition("_")[0], "1")


def finished(touches, points: pathlib.Path):
    """Yields the outcomes of the touches that have a solution, in their order; `points` is the folder of outcomes."""
    for trial in touches.trials:
        outcome = Outcome.read(points / f"{trial.number:06}.npz")
        if outcome is not None and not outcome.reason:
            yield outcome


def write(path: pathlib.Path, touches, points: pathlib.Path, *, balance: int = 0):
    """Writes the HDF5 file of all touches. Returns its size [bytes] and the RowChoice of its rows.

    touches  Touches or LiveTouches
    points   folder of their outcomes
    balance  number of rows that are chosen at most of each kind of moving contact; 0: none

    Raises CaseError without h5py.
    """
    h5py = need("h5py", "ionskin generate")
    from .touches import RATE

    count = len(touches.trials)
    with output_folder.writing(path) as pending, h5py.File(pending, "w") as file:
        for name, value in {**touches.identity, "seed": touches.seed, "made_by": "ionskin generate", "rate_hz": RATE}.items():
            file.attrs[name] = value
        text = h5py.string_dtype()
        first = next(finished(touches, points), Outcome({}, {}))
        signals, labels = (*SIGNALS, *taxel_signals(first)), (*COLUMNS, *angles(first))
        for name, columns in (("signals", signals), ("labels", labels)):
            file.create_dataset(f"columns/{name}", data=list(columns), dtype=text, track_times=False)
            file.create_dataset(f"columns/{name}_units", dtype=text, track_times=False,
                                data=[UNITS.get(one, unit_of(one)) for one in columns])
        values = numpy.array([list(trial.values.values()) for trial in touches.trials])
        file.create_dataset("touches/values", data=values, track_times=False)
        file.create_dataset("touches/keys", data=[one.key for one in touches.parameters], dtype=text, track_times=False)
        file.create_dataset("touches/units", data=[one.unit for one in touches.parameters], dtype=text, track_times=False)
        file.create_dataset("touches/distributions", data=[one.written for one in touches.parameters], dtype=text,
                            track_times=False)
        choice = RowChoice(balance, touches.seed)
        reasons, metrics = [], numpy.full((count, len(CONTACT_METRICS)), numpy.nan)
        for trial in touches.trials:
            outcome = Outcome.read(points / f"{trial.number:06}.npz")
            reasons.append("not run" if outcome is None else outcome.reason)
            if outcome is None or outcome.reason:
                continue
            metrics[trial.number] = [outcome.metrics.get(name, numpy.nan) for name in CONTACT_METRICS]
            _, of_signals, of_labels = tables(outcome, RATE)
            kind = kinds(of_labels, labels)
            choice.add(trial.number, kind)
            for name, data in (("signals", of_signals.astype(numpy.float32)), ("labels", of_labels.astype(numpy.float32)),
                               ("kind", kind)):
                file.create_dataset(f"touch/{trial.number:06}/{name}", data=data, compression="gzip", compression_opts=4,
                                    shuffle=True, track_times=False)
        file.create_dataset("touches/reason", data=reasons, dtype=text, track_times=False)
        file.create_dataset("touches/contact", data=metrics, track_times=False)
        file.create_dataset("touches/contact_names", data=list(CONTACT_METRICS), dtype=text, track_times=False)
        file.create_dataset("columns/kinds", data=list(KINDS), dtype=text, track_times=False)
        if balance:
            file.create_dataset("balanced/rows", data=choice.chosen(), track_times=False)
        if touches.errors:
            names = [(event, name) for event, name, _ in touches.errors]
            file.create_dataset("errors/names", data=names, dtype=text, track_times=False)
            file.create_dataset("errors/values", data=[(one.rms, one.worst, one.largest) for _, _, one in touches.errors],
                                track_times=False)
    return os.stat(path).st_size, choice
