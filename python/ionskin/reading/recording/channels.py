# SPDX-License-Identifier: Apache-2.0
"""Channels (recorded signals over one time): removal of unusable rows, resampling, a low-pass without delay."""

import numpy

from ...errors import CaseError

MOST_ROWS = 1_000_000  # waypoints of a path
COARSE = 0.05  # s between time stamps that tell rows apart too badly


class Channels:
    """Channels of a recording: signals over one time.

    time    array [rows]: strictly ascending instants, the first at 0 [s]
    values  dict of name to array [rows], or [rows, parts] for a vector
    """

    def __init__(self, time, values):
        self.time, self.values = time, values

    @classmethod
    def cleaned(cls, time, values, notes, source):
        """Makes channels of raw rows: leaves out rows that lack a number, sorts by time, averages rows of one instant.

        notes   list to which a sentence on each change is added
        source  file and column of the times, for messages

        Raises CaseError when fewer than two instants are left, or when different rows have the same instant because the
        stamps are cut to seconds or tenths.
        """
        known = numpy.isfinite(time)
        for one in values.values():
            known &= numpy.isfinite(one if one.ndim == 1 else one.sum(axis=1))
        if not known.all():
            notes.append(f"{(~known).sum()} of {len(time)} rows lack a number and are left out")
            time, values = time[known], {name: one[known] for name, one in values.items()}
        if len(time) < 2:
            raise CaseError("fewer than two rows of the recording have a time and every value\n  = name other columns")
        if (numpy.diff(time) < 0).any():
            notes.append(f"{(numpy.diff(time) < 0).sum()} stamps go back: the rows are sorted by time")
            order = numpy.argsort(time, kind="stable")
            time, values = time[order], {name: one[order] for name, one in values.items()}
        instants, place = numpy.unique(time, return_inverse=True)
        if len(instants) < 2:
            raise CaseError(f"{source}: all {len(time)} rows have one time stamp\n  = name the column of times with --column "
                            "time=NAME")
        if len(instants) < len(time):
            counts = numpy.bincount(place)
            means = {name: _means(one, place, counts) for name, one in values.items()}
            if len(instants) < 0.5 * len(time):
                _require_fine(instants, len(time), _differ(values, means, place), notes, source)
            else:
                notes.append(f"{len(time) - len(instants)} stamps repeat the one before: their rows are averaged")
            values = means
        steps = numpy.diff(instants)
        if steps.max() > 10 * numpy.median(steps) and steps.max() > 0.1:
            notes.append(f"a gap of {steps.max():.4g} s, where the interval is {numpy.median(steps):.4g} s: straight lines go "
                         "over it")
        return cls(instants - instants[0], values)

    def interval(self):
        """Median interval between the rows [s]."""
        return float(numpy.median(numpy.diff(self.time)))

    def at(self, time):
        """Interpolates the channels linearly at the instants `time` [s] and returns them as Channels."""
        return Channels(time, {name: _interpolated(time, self.time, one) for name, one in self.values.items()})

    def resampled(self, rate):
        """Resamples the channels at equal steps of 1 / rate, from the first row to the last; rate in Hz.

        Raises CaseError when this makes too many rows.
        """
        count = self.time[-1] * rate
        if count > MOST_ROWS:
            raise CaseError(f"--rate {rate:.6g} Hz makes {count:.0f} rows of {self.time[-1]:.6g} s\n"
                            f"  = a path may have {MOST_ROWS}")
        time = numpy.arange(int(count * (1 + 1e-12)) + 1) / rate
        return self.at(time if self.time[-1] - time[-1] < 1e-9 else numpy.append(time, self.time[-1]))

    def filtered(self, frequency):
        """Filters the channels by a Gaussian low-pass without delay, which has half the power at the frequency [Hz].

        Beyond its ends the recording is continued by its end values. Raises CaseError when the frequency is too high or too low
        for the recording.
        """
        step = self.interval()
        deviation = _deviation(frequency) / step
        count = self.time[-1] / step
        if deviation < 0.3:
            raise CaseError(f"--filter {frequency:.6g} Hz is above what rows every {step:.4g} s hold\n"
                            f"  = choose one below {0.44 / step:.3g} Hz, or leave it out")
        if count > 20 * MOST_ROWS or deviation > count:
            raise CaseError(f"--filter {frequency:.6g} Hz is slower than the recording of {self.time[-1]:.4g} s, or that has "
                            "too many rows\n  = choose a higher frequency, or a shorter recording")
        even = self.at(numpy.arange(int(count) + 1) * step)
        kernel = _kernel(deviation)
        smooth = {name: _convolved(one, kernel, len(kernel) // 2) for name, one in even.values.items()}
        return Channels(even.time, smooth).at(self.time)


def noise_share(frequency, interval):
    """Standard deviation of white noise behind the low-pass of Channels.filtered over that before it.

    frequency  of the filter [Hz]
    interval   time between samples of the noise [s]
    """
    return float(numpy.sqrt(numpy.sum(_kernel(_deviation(frequency) / interval) ** 2)))


def _deviation(frequency):
    """Standard deviation of the Gaussian that has half the power at the frequency [Hz], in seconds."""
    return numpy.sqrt(numpy.log(2)) / (2 * numpy.pi * frequency)


def _kernel(deviation):
    """Gaussian [odd number of samples] of a standard deviation in samples, with the sum 1."""
    reach = int(numpy.ceil(4 * deviation))
    kernel = numpy.exp(-0.5 * (numpy.arange(-reach, reach + 1) / deviation) ** 2)
    return kernel / kernel.sum()


def _differ(values, means, place):
    """True if rows of one instant differ from each other."""
    return any(numpy.abs(one - means[name][place]).max() > 1e-9 * numpy.abs(one).max() for name, one in values.items())


def _require_fine(instants, rows, differ, notes, source):
    """Reports that most stamps repeat. Raises CaseError where they are too coarse to tell rows apart that differ."""
    resolution = float(numpy.diff(instants).min())
    note = (f"{source}: the time stamps have a resolution of {resolution:.3g} s: {rows} rows have {len(instants)} different "
            "stamps")
    if differ and resolution > COARSE:
        raise CaseError(f"{note}\n  = write the stamps with the fractions of a second, name a column that has them with --column "
                        "\"time=NAME [unit]\", or keep one row of each stamp")
    notes.append(f"{note}, and the rows of one stamp are averaged" + (": is there a column of finer times?" if differ else ""))


def _columns(one, work):
    return work(one) if one.ndim == 1 else numpy.column_stack([work(part) for part in one.T])


def _means(one, place, counts):
    return _columns(one, lambda part: numpy.bincount(place, weights=part) / counts)


def _interpolated(time, known, one):
    return _columns(one, lambda part: numpy.interp(time, known, part))


def _convolved(one, kernel, reach):
    return _columns(one, lambda part: numpy.convolve(numpy.pad(part, reach, mode="edge"), kernel, mode="valid"))
