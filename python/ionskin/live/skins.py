# SPDX-License-Identifier: Apache-2.0
"""Many reduced-order skins that are stepped together, as the environments of a reinforcement learner."""

import ctypes
import os
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor

import numpy

from .checks import finite, numbers, one_load, whole
from .library import Batch, load, pointer
from .signals import Signals
from .skin import Skin

_LARGEST_SEED = 2**32 - 1
_MOST_STEPS = 2**53  # which a number of a state holds exactly
_BLOCK = 64  # environments that a thread takes at a time
_MOST_THREADS = 1024


class Skins:
    """Batch of reduced-order skins of one file that are stepped together, each with its own state, friction and noise.

    Each skin is one environment. Its signals depend neither on other environments nor on the number of threads.

    skin          a Skin, whose state and friction every environment starts with, or the path of a skin's file
    environments  number of environments
    signals       names of the signals that a step returns; None for all
    dtype         type of positions, loads and signals: float32 or float64; times are float64
    threads       number of threads, up to 1024; None: one for each processor. There are no more threads than environments
    friction      coefficient or coefficients, as `set_friction` takes them; None for the skin's own
    noise, seed   standard deviation of the noise of currents [A] and seed, as `set_noise` takes them

    Raises ValueError for arguments that cannot be used, MemoryError when memory does not suffice, and CaseError when the file
    cannot be read.
    """

    def __init__(self, skin: Skin | str | os.PathLike, environments: int, *, signals: Sequence[str] | None = None,
                 dtype=numpy.float64, threads: int | None = None, friction=None, noise=0.0, seed: int = 0) -> None:
        self._skin = skin.copy() if isinstance(skin, Skin) else Skin(skin)
        self._count = whole("environments", environments, 1)
        threads = len(os.sched_getaffinity(0)) if threads is None else whole("threads", threads, 1, _MOST_THREADS)
        self._threads = min(threads, self._count)
        self._dtype = numpy.dtype(dtype)
        if self._dtype not in (numpy.float32, numpy.float64):
            raise ValueError(f"dtype: float32 or float64 is wanted, not {self._dtype}")
        if isinstance(signals, str):
            raise ValueError(f"signals: a list of names is wanted, not the text {signals!r}\n  = give signals=[{signals!r}]")
        self._names = tuple(self._skin.names if signals is None else signals)
        unknown = [name for name in self._names if name not in self._skin.names]
        if unknown:
            raise ValueError(f"signals: the skin has no {unknown[0]}; it has {', '.join(self._skin.names)}")
        self._columns = {name: i for i, name in enumerate(self._names)}
        self._told = numpy.array([self._skin.names.index(name) for name in self._names], dtype=numpy.uint32)
        self._library = load()
        self._handle = self._library.ionskin_live_skins_open(self._skin._handle, self._count, self._threads)
        if not self._handle:
            raise MemoryError(f"no memory for {self._count} skins")
        self._pool, self._process = None, None
        self.set_noise(noise, seed)
        if friction is not None:
            self.set_friction(friction)

    def __del__(self) -> None:
        if getattr(self, "_handle", None):
            self._library.ionskin_live_skins_close(self._handle)
            self._handle = None

    def __len__(self) -> int:
        """Number of environments."""
        return self._count

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the signals that a step returns, in the order of `Signals.array`."""
        return self._names

    @property
    def skin(self) -> Skin:
        """Skin of the same file, which has its trained range, taxels and errors; stepping it does not move the environments."""
        return self._skin

    def step(self, times, positions, *, heights=None, forces=None, angles=None, out: numpy.ndarray | None = None,
             stiffness: numpy.ndarray | None = None) -> Signals:
        """Steps all environments to their next times and returns the Signals, whose `array` is [environment, signal].

        An environment whose inputs are not finite, or whose time goes back, does not move: its flag is REFUSED, and its signals
        are those of its step before.

        times      one time for all environments, or an array [environment] [s]
        positions  array [environment, 2]: x and y of the slider's centre [m]
        heights    array [environment], or one number: height of the slider's underside above the undeformed top face [m],
                   negative when it indents
        forces     array [environment], or one number: normal force [N]; exactly one of heights and forces is given
        angles     array [environment, 3]: roll, pitch and yaw [rad]; None for an upright slider
        out        array [environment, signal] of the dtype, contiguous, into which signals are written; None: a new array
        stiffness  array [environment, 6, 6], float64, contiguous, into which the derivatives of `Skin.stiffness` are written,
                   NaN where there are none; None to leave them out

        Arrays of numpy, torch or jax that are contiguous, of the dtype and in the processor's memory are read without a copy.

        Raises ValueError for arrays of another shape and for anything but numbers, TypeError when both or neither of heights
        and forces are given.
        """
        kind, loads = one_load(heights, forces, "s")
        times = self._array("times", times, (self._count,), numpy.dtype(numpy.float64))
        positions = self._array("positions", positions, (self._count, 2), self._dtype)
        loads = self._array("forces" if kind else "heights", loads, (self._count,), self._dtype)
        if angles is not None:
            angles = self._array("angles", angles, (self._count, 3), self._dtype)
        wanted = (self._count, 6, 6)
        if stiffness is not None and not (isinstance(stiffness, numpy.ndarray) and stiffness.shape == wanted
                                          and stiffness.dtype == numpy.float64 and stiffness.flags.c_contiguous
                                          and stiffness.flags.writeable):
            raise ValueError(f"stiffness: a contiguous array of float64 with the shape {wanted} is wanted")
        shape = (self._count, len(self._names))
        if out is None:
            out = numpy.empty(shape, dtype=self._dtype)
        elif not (isinstance(out, numpy.ndarray) and out.shape == shape and out.dtype == self._dtype
                  and out.flags.c_contiguous and out.flags.writeable):
            raise ValueError(f"out: a contiguous array of {self._dtype} with the shape {shape} is wanted")
        flags = numpy.empty(self._count, dtype=numpy.uint32)
        batch = Batch(times.ctypes.data, positions.ctypes.data, loads.ctypes.data, out.ctypes.data, flags.ctypes.data,
                      self._told.ctypes.data, len(self._told), kind, self._dtype == numpy.float32)
        self._step(batch, *(None if more is None else more.ctypes.data for more in (angles, stiffness)))
        return Signals(self._columns, out, flags)

    def _step(self, batch: Batch, angles, stiffness) -> None:
        share = -(-self._count // (4 * self._threads))
        block = min(_BLOCK, -(-share // 4) * 4)  # four share what is read
        begins = iter(range(0, self._count, block))

        def work(worker: int) -> None:
            for begin in begins:  # each thread takes the next
                self._library.ionskin_live_skins_step_posed(self._handle, worker, begin, min(begin + block, self._count),
                                                            ctypes.byref(batch), angles, stiffness)

        workers = min(self._threads, -(-self._count // block))
        others = [self._threads_of_process().submit(work, worker) for worker in range(1, workers)]
        work(0)
        for other in others:
            other.result()

    def _threads_of_process(self) -> ThreadPoolExecutor:
        if self._process != os.getpid():  # the threads of another process did not follow a fork
            self._pool, self._process = ThreadPoolExecutor(self._threads), os.getpid()
        return self._pool

    def _array(self, name: str, values, shape: tuple, dtype: numpy.dtype) -> numpy.ndarray:
        if not isinstance(values, numpy.ndarray) and hasattr(values, "__dlpack__"):
            try:
                values = numpy.from_dlpack(values)
            except (BufferError, RuntimeError, TypeError) as wrong:
                raise ValueError(f"{name}: the array cannot be read in place: {wrong}; detach it, and move it to the "
                                 "memory of the processor") from wrong
        array = numbers(name, values, dtype)
        if numpy.ndim(values) == 0 and len(shape) == 1:
            array = numpy.full(shape, array.reshape(())[()], dtype=dtype)
        if array.shape != shape:
            raise ValueError(f"{name}: the shape is {array.shape}, and must be {shape}")
        return array

    def _chosen(self, environments) -> numpy.ndarray:
        if environments is None:
            return numpy.arange(self._count)
        chosen = numpy.atleast_1d(numpy.asarray(environments))
        if chosen.dtype == bool:
            if chosen.shape != (self._count,):
                raise ValueError(f"environments: the mask has the shape {chosen.shape}, and must have {(self._count,)}")
            return numpy.flatnonzero(chosen)
        if chosen.size == 0:
            return numpy.empty(0, dtype=int)
        if chosen.ndim != 1 or chosen.dtype.kind not in "iu":
            raise ValueError("environments: indices or a mask are wanted")
        outside = chosen[(chosen < 0) | (chosen >= self._count)]
        if outside.size:
            raise ValueError(f"environments: {outside[0]} is outside 0 to {self._count - 1}")
        return chosen

    def reset(self, environments=None) -> None:
        """Resets environments to a detached slider and a skin at rest. Friction and noise stay.

        environments  mask [environment] of booleans, or indices; None for all
        """
        for environment in self._chosen(environments):
            self._library.ionskin_live_skins_reset(self._handle, int(environment))

    @property
    def friction(self) -> numpy.ndarray:
        """Coefficients of friction, as an array [environment] [1]."""
        return numpy.array([self._library.ionskin_live_skins_friction(self._handle, i) for i in range(self._count)])

    def set_friction(self, coefficients, environments=None) -> None:
        """Sets the coefficient of friction of environments.

        coefficients  one coefficient [1], or one for each of the chosen environments
        environments  mask or indices, as `reset` takes them; None for all

        Raises ValueError for coefficients outside the trained range, and changes nothing then.
        """
        chosen = self._chosen(environments)
        values = _one_or_each("friction", coefficients, chosen.shape)
        low, high = self._skin.range.friction
        outside = values[(values < low) | (values > high)]
        if outside.size:
            raise ValueError(f"friction: {outside[0]:g} is outside the trained range, {low:g} to {high:g}; train a wider "
                             "one by ionskin live --friction LOW HIGH")
        for environment, value in zip(chosen.tolist(), values.tolist(), strict=True):
            if not self._library.ionskin_live_skins_set_friction(self._handle, environment, value):
                raise MemoryError("no memory for another friction")

    def set_noise(self, deviations, seed: int = 0) -> None:
        """Sets the white noise that each step adds to every current; charges have no noise.

        deviations  standard deviation [A], one for all or one for each environment; 0 for no noise
        seed        whole number below 2**32, from which each environment gets its own sequence; the sequences begin anew

        Raises ValueError for negative deviations and other seeds.
        """
        deviations = _one_or_each("noise", deviations, (self._count,))
        if (deviations < 0).any():
            raise ValueError(f"noise: {deviations.min():g} A is below 0")
        self._noise, self._seed = deviations.copy(), whole("seed", seed, 0, _LARGEST_SEED)
        for environment in range(self._count):
            self._take_noise(environment, 0)

    def _take_noise(self, environment: int, steps: int) -> None:
        self._library.ionskin_live_skins_set_noise(self._handle, environment, float(self._noise[environment]),
                                                   (self._seed << 32) + environment, steps)

    def save(self, environments=None) -> numpy.ndarray:
        """Saves the states of environments, as an array [environment, number] that `restore` of skins of the same file
        takes. The last number of a state is the number of steps that the environment has taken with noise.

        environments  mask or indices, as `reset` takes them; None for all
        """
        chosen = self._chosen(environments)
        states = numpy.empty((len(chosen), self._library.ionskin_live_state_size(self._skin._handle) + 1))
        for state, environment in zip(states, chosen.tolist(), strict=True):
            self._library.ionskin_live_skins_save(self._handle, environment, pointer(state))
            state[-1] = self._library.ionskin_live_skins_noise_steps(self._handle, environment)
        return states

    def restore(self, states, environments=None) -> None:
        """Restores saved states; the time of an environment may go back by this. Its sequence of noise goes back, too, so that
        equal steps after it have equal noise. Friction, and deviation and seed of the noise, are not part of a state.

        states        array [environment, number], as `save` returns it, with one row for each chosen environment; rows without
                      the number of steps, of earlier versions or of a `Skin`, leave the sequence of noise as it is
        environments  mask or indices, as `reset` takes them; None for all

        Raises ValueError when a state is of a skin from another file or damaged; environments before it are restored then.
        """
        chosen = self._chosen(environments)
        states = numbers("states", states)
        if states.ndim != 2 or len(states) != len(chosen):
            raise ValueError(f"states: the shape is {states.shape}, and must be ({len(chosen)}, size of a state)")
        size = self._library.ionskin_live_state_size(self._skin._handle)
        with_noise = states.shape[1] == size + 1
        for state, environment in zip(states, chosen.tolist(), strict=True):
            if (with_noise and not 0 <= state[-1] < _MOST_STEPS or not self._library.ionskin_live_skins_restore(
                    self._handle, environment, pointer(state), size if with_noise else len(state))):
                raise ValueError(f"states: that for environment {environment} is of a skin from another file, or damaged")
            if with_noise:
                self._take_noise(environment, int(state[-1]))

    def copy(self) -> "Skins":
        """Makes an independent batch with the same states, friction and noise."""
        other = Skins(self._skin, self._count, signals=self._names, dtype=self._dtype, threads=self._threads)
        other.__setstate__({**self.__getstate__(), "made": True})
        return other

    __copy__ = copy

    def __deepcopy__(self, memo) -> "Skins":
        return self.copy()

    def __getstate__(self) -> dict:
        steps = [self._library.ionskin_live_skins_noise_steps(self._handle, i) for i in range(self._count)]
        return {"made": False, "skin": self._skin, "environments": self._count, "signals": self._names,
                "dtype": self._dtype, "threads": self._threads, "states": self.save(), "friction": self.friction,
                "noise": self._noise, "seed": self._seed, "steps": numpy.array(steps, dtype=numpy.uint64)}

    def __setstate__(self, kept: dict) -> None:
        if not kept["made"]:
            self.__init__(kept["skin"], kept["environments"], signals=kept["signals"], dtype=kept["dtype"],
                          threads=kept["threads"])
        self.restore(kept["states"])
        self.set_friction(kept["friction"])
        self._noise, self._seed = kept["noise"].copy(), kept["seed"]
        for environment, steps in enumerate(kept["steps"].tolist()):
            self._take_noise(environment, steps)


def _one_or_each(name: str, values, shape: tuple) -> numpy.ndarray:
    """Array [environment] of finite numbers, of one for all or one for each. Raises ValueError for another number of them."""
    given = numbers(name, values)
    if given.size == 1 and given.ndim <= 1:
        given = numpy.broadcast_to(given, shape)
    if given.shape != shape:
        raise ValueError(f"{name}: the shape is {given.shape}, and must be {shape}, or one number for all")
    return finite(name, given, shape)
