# SPDX-License-Identifier: Apache-2.0
"""Many reduced skins stepped together from Python, as a learner does."""

import copy
import ctypes
import multiprocessing
import os
import pathlib
import pickle
import subprocess
import sys
import unittest

import numpy

from program import PROGRAM, ROOT, ProgramTest

sys.path.insert(0, str(PROGRAM.parent / "python"))
from ionskin.live import REFUSED, Skin, Skins  # noqa: E402
from ionskin.live.library import Batch  # noqa: E402

COUNT, STEPS = 13, 40


def inputs(step: int):
    """Some slide, some rest, some are lifted and land."""
    i = numpy.arange(COUNT)
    positions = numpy.column_stack([5e-3 + 2e-6 * step * (i % 4), numpy.full(COUNT, 1e-3)])
    return positions, numpy.where((i + step // 10) % 5 == 0, 0.0, 1.0 + 2 * i)


def run(skins: Skins, begin: int = 0, end: int = STEPS) -> numpy.ndarray:
    told = []
    for step in range(begin, end):
        positions, forces = inputs(step)
        told.append(skins.step(1e-3 * step, positions, forces=forces).array)
    return numpy.array(told)


def run_in_process(skins: Skins) -> numpy.ndarray:
    return run(skins, 20)


class Lent:
    """An array of another library, which lends its memory by DLPack and does nothing else."""

    def __init__(self, array):
        self.array = array

    def __dlpack__(self, **options):
        return self.array.__dlpack__(**options)

    def __dlpack_device__(self):
        return self.array.__dlpack_device__()


class LiveBatchTest(ProgramTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.trained = pathlib.Path(os.environ.get("TMPDIR", "/tmp")) / f"ionskin-live-batch-{os.getpid()}.live"
        subprocess.run([PROGRAM, "live", ROOT / "cases" / "taxels.toml", "--set", "numerics.mesh_refinement=0.3", "--set",
                        "motion.stroke=2 mm", "--set", "motion.slide=0.7 s", "--trajectories", "3", "--validation", "1",
                        "--friction", "0.1", "0.4", "-o", cls.trained, "--overwrite", "--quiet"], check=True)
        cls.addClassCleanup(cls.trained.unlink)

    def test_is_the_same_bits_as_single_skins_on_any_number_of_threads(self):
        friction = numpy.linspace(0.1, 0.4, COUNT)
        together = run(Skins(self.trained, COUNT, threads=1, friction=friction))
        for threads in (2, 3):
            numpy.testing.assert_array_equal(run(Skins(self.trained, COUNT, threads=threads, friction=friction)), together)
        times = 1e-3 * numpy.arange(STEPS)
        for i in range(COUNT):
            positions, forces = zip(*((p[i], f[i]) for p, f in map(inputs, range(STEPS))), strict=True)
            signals = Skin(self.trained, friction=friction[i]).run(times, numpy.array(positions), forces=forces)
            numpy.testing.assert_array_equal(signals.array, together[:, i])

    def test_tells_the_stiffness_of_each(self):
        skins, stiffness = Skins(self.trained, COUNT, threads=2), numpy.empty((COUNT, 6, 6))
        alone = Skin(self.trained)
        positions, forces = inputs(1)
        skins.step(0, positions, forces=forces, angles=numpy.zeros((COUNT, 3)), stiffness=stiffness)
        alone.step(0, positions[3], force=forces[3])
        numpy.testing.assert_array_equal(stiffness[3], alone.stiffness())
        for wrong in (numpy.empty((COUNT, 36)), numpy.empty((COUNT, 6, 6), dtype=numpy.float32)):
            with self.assertRaisesRegex(ValueError, "stiffness"):
                skins.step(1, positions, forces=forces, stiffness=wrong)

    def test_copies_pickles_and_processes_go_on_as_it_does(self):
        skins = Skins(self.trained, COUNT, threads=2, friction=numpy.linspace(0.1, 0.4, COUNT), noise=1e-9, seed=3)
        run(skins, 0, 20)
        others = [copy.deepcopy(skins), copy.copy(skins), pickle.loads(pickle.dumps(skins))]
        others.append(Skins(self.trained, COUNT, noise=1e-9, seed=3))
        run(others[-1], 0, 20)  # the noise goes on, and states are restored
        others[-1].set_friction(skins.friction)
        others[-1].restore(skins.save())
        results = [run(other, 20) for other in others]
        for method in ("fork", "spawn"):
            with multiprocessing.get_context(method).Pool(1) as pool:
                results.append(pool.apply(run_in_process, (skins,)))
        expected = run(skins, 20)
        for result in results:
            numpy.testing.assert_array_equal(result, expected)
        single = skins.skin
        single.step(0, (5e-3, 1e-3), force=5)
        self.assertEqual(pickle.loads(pickle.dumps(single)).save(), single.save())
        self.assertEqual(copy.deepcopy(single).save(), single.save())

    def test_a_restored_state_repeats_the_noise(self):
        skins = Skins(self.trained, COUNT, threads=2, noise=1e-7, seed=5)
        run(skins, 0, 20)
        states = skins.save()
        first = run(skins, 20)
        skins.restore(states)
        numpy.testing.assert_array_equal(run(skins, 20), first)
        skins.restore(states[[3]], [3])
        steps = [skins._library.ionskin_live_skins_noise_steps(skins._handle, i) for i in range(COUNT)]
        self.assertEqual(steps, [20 if i == 3 else STEPS for i in range(COUNT)])
        skins.restore(states[:, :-1])  # as earlier versions saved them
        self.assertFalse((run(skins, 20) == first).all())
        alone = Skin(self.trained)
        alone.restore(states[3].tobytes())
        self.assertEqual(alone.save(), states[3, :-1].tobytes())
        for wrong in (numpy.nan, -1.0, numpy.inf):
            states[0, -1] = wrong
            with self.assertRaisesRegex(ValueError, "environment 0 is of a skin from another file, or damaged"):
                skins.restore(states)

    def test_steps_in_a_process_that_was_forked_behind_a_step(self):
        skins = Skins(self.trained, COUNT, threads=3)
        run(skins, 0, 20)
        process = os.fork()
        if process == 0:
            os._exit(0 if run(skins, 20).shape[0] == STEPS - 20 else 1)
        self.assertEqual(os.waitstatus_to_exitcode(os.waitpid(process, 0)[1]), 0)

    def test_resets_and_refuses_environments_by_themselves(self):
        skins, kept = (Skins(self.trained, COUNT, threads=2) for _ in range(2))
        first = run(skins)
        run(kept)
        mask = numpy.zeros(COUNT, dtype=bool)
        mask[[1, 7]] = True
        skins.reset(mask)
        positions, forces = inputs(0)
        times = numpy.where(mask, 0.0, 1e-3 * STEPS)
        signals = skins.step(times, positions, forces=forces)
        expected = kept.step(1e-3 * STEPS, positions, forces=forces)
        numpy.testing.assert_array_equal(signals.array[mask], first[0][mask])
        numpy.testing.assert_array_equal(signals.array[~mask], expected.array[~mask])
        positions = positions.copy()
        positions[2] = numpy.nan
        signals = skins.step(1.0, positions, forces=forces)
        self.assertEqual(numpy.flatnonzero(signals.flags == REFUSED).tolist(), [2])
        self.assertTrue(numpy.isfinite(signals.array).all())

    def test_arrays_are_exchanged_without_a_copy(self):
        names = ["normal_force", "current_top"]
        skins = Skins(self.trained, COUNT, dtype=numpy.float32, signals=names)
        positions, forces = (array.astype(numpy.float32) for array in inputs(3))
        out = numpy.empty((COUNT, len(names)), dtype=numpy.float32)
        signals = skins.step(0.0, Lent(positions), forces=Lent(forces), out=out)
        self.assertIs(signals.array, out)
        self.assertTrue(numpy.shares_memory(numpy.from_dlpack(signals.array), out))
        lent = skins._array("positions", Lent(positions), positions.shape, numpy.dtype(numpy.float32))
        self.assertTrue(numpy.shares_memory(lent, positions))
        wide = Skins(self.trained, COUNT).step(0.0, positions, forces=forces)
        for name in names:
            numpy.testing.assert_array_equal(signals[name], wide[name].astype(numpy.float32))

    def test_mistakes_are_reported(self):
        skins = Skins(self.trained, COUNT)
        positions, forces = inputs(3)
        for match, act in (
                ("environments: a whole number", lambda: Skins(self.trained, 0)),
                ("threads: a whole number", lambda: Skins(self.trained, 2, threads=0.5)),
                ("dtype: float32 or float64", lambda: Skins(self.trained, 2, dtype=int)),
                ("the skin has no pressure", lambda: Skins(self.trained, 2, signals=["pressure"])),
                ("outside the trained range, 0.1 to 0.4", lambda: skins.set_friction(0.5)),
                ("noise: -1", lambda: skins.set_noise(-1)),
                ("threads: a whole number from 1 to 1024 is wanted, not 10000", lambda: Skins(self.trained, 2, threads=10000)),
                (r"signals: a list of names .*\n  = give signals=\['charge_top'\]",
                 lambda: Skins(self.trained, 2, signals="charge_top")),
                (r"friction: the shape is \(3,\), and must be \(2,\), or one number for all",
                 lambda: Skins(self.trained, 2, friction=[0.2, 0.3, 0.2])),
                ("positions: numbers are wanted, not complex ones", lambda: skins.step(0, positions + 0j, forces=forces)),
                ("states: numbers are wanted, not None", lambda: skins.restore(None)),
                ("seed: a whole number from 0 to 4294967295", lambda: skins.set_noise(1, seed=-1)),
                (r"positions: the shape is \(12, 2\)", lambda: skins.step(0, positions[1:], forces=forces)),
                (r"forces: the shape is \(13, 1\)", lambda: skins.step(0, positions, forces=forces[:, None])),
                ("numbers are wanted", lambda: skins.step(0, "here", forces=forces)),
                ("out: a contiguous array", lambda: skins.step(0, positions, forces=forces, out=numpy.empty((COUNT, 2)))),
                ("environments: 13 is outside", lambda: skins.reset([13])),
                ("environments: the mask", lambda: skins.reset([True])),
                ("states: the shape", lambda: skins.restore(numpy.zeros(4))),
                ("from another file, or damaged", lambda: skins.restore(numpy.zeros((1, 3)), [0]))):
            with self.subTest(match), self.assertRaisesRegex(ValueError, match):
                act()
        with self.assertRaisesRegex(TypeError, "either heights or forces"):
            skins.step(0, positions)
        self.assertEqual(Skins(self.trained, 2, threads=1000).__getstate__()["threads"], 2)  # no more than there are skins

    def test_another_file_under_the_same_name_is_refused(self):
        path = self.folder / "skin.live"
        path.write_bytes(self.trained.read_bytes())
        kept = pickle.dumps(Skin(path))
        subprocess.run([PROGRAM, "live", ROOT / "cases" / "quick.toml", "--set", "numerics.mesh_refinement=0.3",
                        "--trajectories", "2", "--validation", "1", "-o", path, "--overwrite", "--quiet"], check=True)
        with self.assertRaisesRegex(ValueError, "another than that of the skin"):
            pickle.loads(kept)

    def test_the_structure_is_that_of_the_header(self):
        """Fields of ionskin_live_batch in the order and with the sizes that Python hands over."""
        program = self.folder / "batch.c"
        program.write_text("#include <ionskin_live.h>\n#include <stdio.h>\nint main(void) {\n" + "".join(
            f'printf("%zu ", offsetof(ionskin_live_batch, {name}));\n' for name, _ in Batch._fields_) +
            'printf("%zu", sizeof(ionskin_live_batch)); }\n')
        subprocess.run(["cc", "-I", ROOT / "src" / "ionskin" / "live" / "interface", program, "-o", self.folder / "batch"], check=True)
        told = subprocess.run([self.folder / "batch"], check=True, capture_output=True, text=True).stdout
        expected = [getattr(Batch, name).offset for name, _ in Batch._fields_]
        self.assertEqual([int(word) for word in told.split()], [*expected, ctypes.sizeof(Batch)])


if __name__ == "__main__":
    unittest.main()
