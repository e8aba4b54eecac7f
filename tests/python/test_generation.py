# SPDX-License-Identifier: Apache-2.0
"""Training data: touches follow from seed and number, stores from any number of workers are equal."""

import subprocess
import sys
import unittest

import h5py
import numpy

import ionskin
from ionskin.evaluation import Outcome
from ionskin.generation import Touches
from ionskin.generation.__main__ import announcement, of_rows
from ionskin.generation.rows import KINDS, RowChoice, kinds
from ionskin.generation.store import COLUMNS, SIGNALS, tables, taxel_signals, unit_of
from package import CASES, PROGRAM, PackageTest, small_case


class Generation(PackageTest):
    def test_touches(self):
        touches = Touches(small_case(), 12, seed=7, vary=["contact.friction=uniform(0.2, 0.3)"])
        keys = [one.key for one in touches.parameters]
        self.assertEqual(keys, ["contact.friction", "motion.preload", "motion.stroke", "slider.start[0]", "slider.start[1]"])
        values = [trial.values for trial in touches.trials]
        self.assertTrue(all(0.2 < one["contact.friction"] < 0.3 and 3e-3 < one["motion.stroke"] < 6e-3 for one in values))
        for trial in touches.trials:
            self.assertEqual({key: trial.case[key] for key in keys}, trial.values)
        longer = Touches(small_case(), 14, seed=7, vary=["contact.friction=uniform(0.2, 0.3)"])
        self.assertEqual(values, [trial.values for trial in longer.trials[:12]])
        self.assertNotEqual(values, [trial.values for trial in Touches(small_case(), 12, seed=8).trials])
        self.assertEqual(touches.case["output.fields"], [])
        with self.assertRaises(ionskin.CaseError) as raised:
            Touches(small_case(), 1, vary=["slider.start[0]=uniform(14 mm, 14.5 mm)"])
        self.assertIn("no valid case", str(raised.exception))

    def test_what_varies_and_what_stays_is_told(self):
        case = ionskin.Case.from_file(CASES / "finger.toml")
        lines = "\n".join(announcement(Touches(case, 1), "data"))
        self.assertIn("the same in all touches: motion.direction, motion.touchdown, motion.slide, motion.lift, and every other key", lines)
        self.assertIn('--vary "KEY=DISTRIBUTION"', lines)
        self.assertIn("no errors are stated for these touches", lines)
        self.assertIn("ionskin run data/case.toml", lines)
        wider = Touches(case, 1, vary=["slider.start[0]=uniform(4 mm, 9 mm)", "slider.start[1]=uniform(2 mm, 4 mm)",
                                       "motion.slide=uniform(0.4 s, 1.5 s)", "motion.touchdown=uniform(0.3 s, 0.8 s)"])
        self.assertIn("the same in all touches: motion.direction, motion.lift,", "\n".join(announcement(wider, "data")))

    def test_signals_and_labels(self):
        case = small_case()
        case["readout.sample_interval"] = 1e-3
        result = ionskin.run(case)
        time, signals, labels = tables(Outcome.of(result), 1000.0)
        self.assertEqual(signals.shape, (len(time), len(SIGNALS)))
        self.assertEqual(labels.shape, (len(time), len(COLUMNS)))
        self.assertTrue(numpy.isfinite(signals).all() and numpy.isfinite(labels).all())
        numpy.testing.assert_allclose(numpy.diff(time), 1e-3)
        numpy.testing.assert_allclose(signals[:, 2], result.sampled["current_difference"][-len(time):], rtol=1e-6, atol=1e-12)
        touching = labels[:, COLUMNS.index("touching")]
        self.assertEqual((touching[0], touching[len(time) // 3], touching[-1]), (0, 1, 0))
        area, stick, slip = (labels[:, COLUMNS.index(name)] for name in ("contact_area", "stick_share", "slip"))
        self.assertTrue((area[touching > 0] > 0).all() and (stick >= 0).all() and (stick <= 1).all())
        self.assertAlmostEqual(slip.max() / case["motion.stroke"], 1, delta=0.1)
        speed = labels[:, COLUMNS.index("slider_speed")]
        self.assertAlmostEqual(speed[len(time) // 3] * case["motion.slide"] / case["motion.stroke"], 1, delta=1e-6)
        aslant = Outcome.of(result)
        aslant.columns["signals/slider_y"] = -aslant.columns["signals/slider_x"]
        numpy.testing.assert_allclose(tables(aslant, 1000.0)[2][:, COLUMNS.index("slider_speed")], numpy.sqrt(2) * speed, atol=1e-12)

    def test_taxels(self):
        case = small_case()
        case["readout.sample_interval"] = 1e-3
        case["readout.taxels"] = {"rows": 1, "columns": 2}
        outcome = Outcome.of(ionskin.run(case))
        names = taxel_signals(outcome)
        self.assertEqual(names, ("current_top_r1c1", "current_top_r1c2", "charge_top_r1c1", "charge_top_r1c2"))
        _, signals, _ = tables(outcome, 1000.0)
        self.assertEqual(signals.shape[1], len(SIGNALS) + 4)
        self.assertEqual([unit_of(name) for name in names], ["A", "A", "C", "C"])
        whole, parts = signals[:, SIGNALS.index("current_top")], signals[:, len(SIGNALS):len(SIGNALS) + 2].sum(axis=1)
        self.assertGreater(numpy.abs(whole).max(), 0)
        numpy.testing.assert_allclose(parts, whole, atol=1e-3 * numpy.abs(whole).max())

    def test_taxels_with_circuits_of_their_own(self):
        case = small_case()
        case["readout.sample_interval"] = 1e-3
        case["readout.taxels"] = {"rows": 1, "columns": 2}
        case["readout.taxel_circuit"] = "open"
        outcome = Outcome.of(ionskin.run(case))
        names = taxel_signals(outcome)
        self.assertEqual(names[:4], ("voltage_r1c1", "voltage_r1c2", "current_circuit_r1c1", "current_circuit_r1c2"))
        _, signals, _ = tables(outcome, 1000.0)
        self.assertEqual(signals.shape[1], len(SIGNALS) + 8)
        self.assertGreater(numpy.abs(signals[:, len(SIGNALS)]).max(), 0)
        self.assertFalse(signals[:, len(SIGNALS) + 2].any())

    def test_kinds_of_rows(self):
        columns = ("touching", "slider_speed", "stick_share")
        labels = numpy.array([[0, 0, 0], [0, 1e-3, 0], [1, 0, 0], [1, 1e-3, 1], [1, 1e-3, 0.5], [1, 1e-3, 0]])
        self.assertEqual([KINDS[i] for i in kinds(labels, columns)],
                         ["no contact", "no contact", "rest", "stick", "partial slip", "full slip"])

    def test_a_balanced_choice_of_rows(self):
        generator = numpy.random.default_rng(5)
        touches = [generator.choice(len(KINDS), 400, p=[0.3, 0.1, 0.05, 0.15, 0.4]).astype(numpy.uint8) for _ in range(50)]

        def chosen(most, seed=1):
            choice = RowChoice(most, seed)
            for number, kind in enumerate(touches):
                choice.add(number, kind)
            self.assertEqual(sum(choice.counts.values()), 50 * 400)
            return choice.chosen()

        rows = chosen(300)
        self.assertEqual(numpy.bincount(rows[:, 2]).tolist(), [0, 0, 300, 300, 300])
        self.assertEqual(len({tuple(row) for row in rows[:, :2].tolist()}), 900)
        for touch, row, kind in rows:
            self.assertEqual(touches[touch][row], kind)
        self.assertEqual(len(numpy.unique(rows[rows[:, 2] == 4, 0])), 50)  # of all touches, not of the first
        numpy.testing.assert_array_equal(rows, chosen(300))
        self.assertFalse(numpy.array_equal(rows, chosen(300, seed=2)))
        rarest = sum(int((kind == 2).sum()) for kind in touches)
        self.assertEqual(len(chosen(100000)), 3 * rarest)

    def test_a_kind_without_rows_is_named(self):
        choice = RowChoice(300, 1)
        choice.add(0, numpy.array([KINDS.index("full slip")] * 5 + [KINDS.index("partial slip")], dtype=numpy.uint8))
        self.assertEqual(len(choice.chosen()), 0)
        told = of_rows(choice, 300)[-1]
        self.assertTrue(told.startswith("warning: balanced: no rows are chosen, because none is of the kind stick, and"), told)
        self.assertEqual(len(of_rows(choice, 0)), 1)
        choice.add(1, numpy.array([KINDS.index("stick")], dtype=numpy.uint8))
        self.assertIn("balanced: 1 rows each of stick, partial slip, full slip; there are no more of", of_rows(choice, 300)[-1])

    def test_equal_stores(self):
        subprocess.run([sys.executable, CASES / "make_strain.py", self.folder / "strain.h5"], check=True)
        (self.folder / "case.toml").write_text((CASES / "strain_file.toml").read_text())

        def generate(folder, *more):
            words = [PROGRAM, "generate", self.folder / "case.toml", "--output", self.folder / folder,
                     "--set=numerics.preset=coarse", "--vary=coupling.coefficient=uniform(0.05, 0.15)", *more]
            return subprocess.run(words, capture_output=True, text=True, check=False)

        one = generate("one", "--touches=5", "--threads=1")
        self.assertEqual(one.returncode, 0, one.stderr)
        self.assertIn("coupling.coefficient = uniform(0.05, 0.15)", one.stdout)
        self.assertEqual(generate("two", "--touches=3", "--threads=2").returncode, 0)
        self.assertEqual(generate("two", "--touches=5", "--threads=2", "--resume").returncode, 0)
        stores = [(self.folder / name / "touches.h5").read_bytes() for name in ("one", "two")]
        self.assertEqual(*stores)
        with h5py.File(self.folder / "one" / "touches.h5") as file:
            self.assertEqual(len(file["touch"]), 5)
            self.assertEqual(file["touches/values"].shape, (5, 1))
        self.assertEqual(generate("one", "--touches=5").returncode, 2)


if __name__ == "__main__":
    unittest.main()
