# SPDX-License-Identifier: Apache-2.0
"""Cases in Python: reading, changing, messages."""

import copy
import pickle
import unittest

import numpy

import ionskin
from package import CASES, PackageTest


class Case(PackageTest):
    def setUp(self):
        super().setUp()
        self.case = ionskin.Case.from_file(CASES / "paper" / "coarse.toml")

    def test_reads_back_in_si(self):
        self.assertEqual(self.case["contact.friction"], 0.3)
        self.assertAlmostEqual(self.case["skin.layers[1].thickness"], 180e-6, delta=1e-18)
        self.assertEqual(self.case["slider.size"], [3e-3, 1.5e-3])
        self.assertEqual(self.case["skin.layers[1].material"], "nafion")
        self.assertEqual(self.case["motion.cycles"], 1)
        self.assertEqual(self.case.value("materials.nafion.youngs_modulus"), (249e6, "Pa", "preset", '"249 MPa"'))
        self.assertEqual(self.case.value("coupling.law").origin, "default")
        self.assertIn("contact.friction", self.case)
        self.assertEqual(set(self.case), set(self.case.values()))

    def test_takes_numbers_texts_and_arrays(self):
        for key, value, expected in (("contact.friction", 0.2, 0.2), ("motion.preload", "0.5 um", 5e-7),
                                     ("motion.preload", 0.7e-6, 0.7e-6), ("motion.cycles", 2, 2),
                                     ("slider.size", numpy.array([2e-3, 1e-3]), [2e-3, 1e-3]),
                                     ("slider.size", ("2.5 mm", 1e-3), [2.5e-3, 1e-3]),
                                     ("coupling.law", "volume-neutral", "volume-neutral"),
                                     ("electrochemistry.temperature", numpy.float64(300), 300.0)):
            with self.subTest(key, value=value):
                self.case[key] = value
                read = self.case[key]
                self.assertEqual(read, expected) if isinstance(expected, str) else numpy.testing.assert_allclose(
                    read, expected, rtol=1e-12)
        self.assertIn("# a guess", self.case.text)
        again = ionskin.Case.from_text(self.case.text)
        self.assertEqual({key: value.value for key, value in again.values().items()},
                         {key: value.value for key, value in self.case.values().items()})

    def test_a_number_keeps_the_dimension_of_the_value_that_stands_there(self):
        self.case["motion.preload"] = "2 N"
        self.case["motion.preload"] = 0.5
        self.assertEqual(self.case.value("motion.preload")[:2], (0.5, "N"))
        self.case["motion.preload"] = "0.5 um"
        self.case["motion.preload"] = 0.7e-6
        self.assertEqual(self.case.value("motion.preload")[:2], (0.7e-6, "m"))
        pinch = ionskin.Case.from_file(CASES / "pinch.toml")
        pinch["slider[1].motion.preload"] = 0.25
        self.assertEqual(pinch.value("slider[1].motion.preload").unit, "N")
        unknown = ionskin.Case("\n".join(line for line in self.case.text.splitlines() if not line.startswith("preload")))
        with self.assertRaisesRegex(ionskin.CaseError, "may be an indentation or a force"):
            unknown["motion.preload"] = 0.5
        unknown["motion.preload"] = "0.5 um"
        with self.assertRaisesRegex(ionskin.CaseError, "may be an indentation or a force"):
            ionskin.sweep(ionskin.Case("[skin]\n"), {"motion.preload": [0.5, 1.0]})

    def test_one_entry_of_a_list(self):
        self.case["slider.start[0]"] = 0.0047
        self.assertEqual(self.case["slider.start[0]"], 0.0047)
        self.assertEqual(self.case["slider.start"], [0.0047, 1e-3])
        self.case["slider.start[0]"] = "4.8 mm"
        self.assertAlmostEqual(self.case["slider.start[0]"], 0.0048, delta=1e-15)
        self.assertEqual(self.case.value("slider.start[1]").unit, "m")
        self.assertIn("slider.start[1]", self.case)
        for key in ("slider.start[2]", "contact.friction[0]", "slider.start[x]"):
            self.assertNotIn(key, self.case)
            with self.assertRaises(ionskin.CaseError):
                self.case[key]

    def test_tables(self):
        self.case["readout.taxels"] = {"rows": 2, "columns": 3, "gap": 1e-4}
        self.case.check()
        self.assertEqual((self.case["readout.taxels.columns"], self.case["readout.taxels.gap"]), (3, 1e-4))
        self.case["readout.taxels"] = [{"name": "left", "lower": [0.0, 0.0], "upper": [5e-3, 2e-3]},
                                       {"name": "right", "lower": [0.005, 0.0], "upper": ["10 mm", "2 mm"]}]
        self.case.check()
        self.assertEqual(self.case["readout.taxels[1].upper"], [0.01, 2e-3])
        with self.assertRaisesRegex(ionskin.CaseError, "readout.taxels"):
            self.case["readout.taxels"] = {"rows": 2, "colums": 3}

    def test_mistakes_have_the_messages_of_the_program_and_change_nothing(self):
        for key, value, words in (("contact.friction", 7, "at most 2"), ("contact.fricton", 1, "did you mean contact.friction"),
                                  ("motion.preload", "3 kg", "got a mass"), ("motion.cycles", 1.5, "not an integer"),
                                  ("coupling.law", "fixed", "known:"), ("contact.friction", float("nan"), "friction")):
            with self.subTest(key, value=value):
                with self.assertRaises(ionskin.CaseError) as raised:
                    self.case[key] = value
                self.assertIn(words, str(raised.exception))
        with self.assertRaises(TypeError):
            self.case["contact.friction"] = None
        self.assertEqual(self.case.text, (CASES / "paper" / "coarse.toml").read_text())
        for key, words in (("contact.fricton", "contact.friction"), ("strain.file", "no value")):
            with self.assertRaises(ionskin.CaseError) as raised:
                self.case[key]
            self.assertIn(words, str(raised.exception))

    def test_values_that_do_not_fit_together_are_found_at_use(self):
        self.case["motion.stroke"] = "14 mm"
        with self.assertRaises(ionskin.CaseError) as raised:
            self.case.check()
        self.assertIn("not inside the skin", str(raised.exception))
        self.case["motion.stroke"] = 6e-3
        self.case.check()

    def test_bad_texts_and_files(self):
        for text, words in (("[skin", "case.toml"), ("", "missing")):
            with self.assertRaises(ionskin.CaseError) as raised:
                ionskin.Case.from_text(text)
            self.assertIn(words, str(raised.exception))
        with self.assertRaises(ionskin.CaseError):
            ionskin.Case.from_file(self.folder / "none.toml")

    def test_copies_are_cases_of_their_own(self):
        twins = [self.case.copy(), copy.deepcopy(self.case), pickle.loads(pickle.dumps(self.case))]
        self.case["contact.friction"] = 0.1
        for twin in twins:
            self.assertEqual(twin["contact.friction"], 0.3)

    def test_errors_can_cross_processes(self):
        error = pickle.loads(pickle.dumps(ionskin.SolverError("gave up", "try less")))
        self.assertEqual((str(error), error.remedy), ("gave up\nremedy: try less", "try less"))


if __name__ == "__main__":
    unittest.main()
