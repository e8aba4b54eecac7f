# SPDX-License-Identifier: Apache-2.0
"""Bench loads without a slider: a prescribed pressure or curvature under the law `poroelastic`."""

import json
import subprocess
import sys
import unittest

import h5py
import numpy

from program import QUICK, ROOT, ProgramTest, signals, summary

BENDING = ROOT / "cases" / "bending.toml"
COARSE = ["--set", "numerics.preset=coarse"]


class Prescribed(ProgramTest):
    def test_bent_strip_runs_without_a_slider(self):
        self.run_case(BENDING, "-o", "out", *COARSE)
        voltage = signals(self.folder / "out", "circuit")["voltage"]
        # L_s (1 - 2 nu_u) M_B k h of streaming is 63 uV, of which water takes a quarter while the double layers relax;
        # (p_u/M of the walls) theta V_T is left (docs/model.md).
        self.assertGreater(voltage.max(), 45e-6)
        self.assertLess(voltage.max(), 63e-6)
        self.assertAlmostEqual(voltage[-1] / 8.13e-6, 1, delta=0.01)
        self.assertNotIn("peak_mean_shear", summary(self.folder / "out")["metrics"])

    def test_the_sign_of_the_curvature_is_that_of_the_voltage(self):
        for name, curvature in (("up", "10 1/m"), ("down", "-10 1/m")):
            self.run_case(BENDING, "-o", name, *COARSE, "--set", f"strain.curvature={curvature}",
                          "--set", "strain.waveform=sine", "--set", "strain.frequency=2 Hz", "--set", "strain.duration=1 s")
        up, down = (signals(self.folder / name, "circuit")["voltage"] for name in ("up", "down"))
        self.assertGreater(abs(up).max(), 1e-5)
        numpy.testing.assert_allclose(up, -down, atol=1e-3 * abs(up).max())

    def test_even_pressure_needs_an_open_wall(self):
        pressed = ["--set", "strain.curvature=0 1/m", "--set", "strain.pressure=100 kPa"]
        self.run_case(BENDING, "-o", "sealed", *COARSE, *pressed)
        self.run_case(BENDING, "-o", "open", *COARSE, *pressed, "--set", "water.top_wall=open")
        sealed, drained = (abs(signals(self.folder / name, "circuit")["voltage"]).max() for name in ("sealed", "open"))
        self.assertGreater(drained, 3e-5)
        self.assertLess(sealed, 1e-6 * drained)

    def test_a_held_compression_relaxes(self):
        # M = 2 G (1 - nu)/(1 - 2 nu) of the drained core, M_B = K_u - K_d; water leaves through the top.
        shear = 249e6 / (2 * 1.49)
        drained = 2 * shear * 0.6 / 0.2
        storage = 249e6 / (3 * 0.02) - (drained - 4 / 3 * shear)
        self.run_case(BENDING, "-o", "held", *COARSE, "--set", "strain.curvature=0 1/m", "--set", "strain.compression=100 nm",
                      "--set", "water.top_wall=open", "--set", "strain.duration=60 s")
        pressure = signals(self.folder / "held", "water")["holding_pressure"]
        self.assertAlmostEqual(pressure[0] / ((drained + storage) * 100e-9 / 180e-6), 1, delta=0.03)  # one node of 25 is drained at once
        self.assertAlmostEqual(pressure[-1] / (drained * 100e-9 / 180e-6), 1, delta=1e-3)
        self.assertTrue((numpy.diff(pressure) <= 0).all())

    def test_water_under_pressure_permeates(self):
        flow = {}
        for name, more in (("open", []), ("tight", ["water.top_wall=permeable", "water.top_conductance=2.7777777777777777e-13 m/(Pa s)"])):
            edits = ["strain.curvature=0 1/m", "water.bottom_wall=open", "water.top_wall=open", "water.bottom_pressure=100 kPa",
                     "strain.duration=40 s", *more]
            self.run_case(BENDING, "-o", name, *COARSE, *[word for edit in edits for word in ("--set", edit)])
            water = signals(self.folder / name, "water")
            flow[name] = (water["water_outflow_top"][-1] - water["water_outflow_top"][-2]) / (water["time"][-1] - water["time"][-2])
            balance = water["water_outflow_top"] + water["water_outflow_bottom"]
            self.assertLess(abs(balance[-1] - balance[-2]), 1e-6 * abs(water["water_outflow_top"][-1]))
        steady = 5e-17 * 100e3 / 180e-6 * 30e-3 * 5e-3  # K p/h over the area
        self.assertAlmostEqual(flow["open"] / steady, 1, delta=1e-3)
        self.assertAlmostEqual(flow["tight"] / steady, 0.5, delta=1e-3)  # the wall conducts as much as the core
        voltage = signals(self.folder / "open", "water")["streaming_voltage"][-1]
        self.assertAlmostEqual(voltage / (2.5 * 1.8e-5 / 96485 * 100e3), 1, delta=0.01)

    def test_loads_that_exclude_each_other_are_reported(self):
        for edits, words in ((["strain.pressure=1 kPa"], "more than one load"),
                             (["strain.curvature=0 1/m"], "no load is prescribed"),
                             (["strain.curvature=0 1/m", "strain.compression=20 um"], "more than a tenth of the core"),
                             (["strain.curvature=0 1/m", "strain.compression=1 um", "water.top_wall=open", "water.top_pressure=1 kPa"],
                              "beside a pressure of the water outside")):
            with self.subTest(edits=edits):
                process = self.run_program("check", BENDING, *[word for edit in edits for word in ("--set", edit)], expect=2)
                self.assertIn(words, process.stderr)

    def test_cases_of_the_page_on_measurements_are_valid(self):
        cases = sorted((ROOT / "cases" / "evidence").glob("*.toml"))
        self.assertGreaterEqual(len(cases), 5)
        for case in cases:
            with self.subTest(case=case.name):
                self.assertNotIn("warning", self.run_program("check", case).stderr)

    def test_a_prediction_that_was_changed_is_found_out(self):
        script, file = ROOT / "benchmarks" / "prediction.py", ROOT / "docs" / "prediction.json"
        subprocess.run([sys.executable, script, "--check", file], check=True)
        content = json.loads(file.read_text())
        content["strips"][0]["peak_V_m"]["highest"] *= 2
        changed = self.write("prediction.json", json.dumps(content))
        process = subprocess.run([sys.executable, script, "--check", self.folder / changed], capture_output=True, text=True, check=False)
        self.assertEqual(process.returncode, 1)
        self.assertIn(f"changed since {content['date']}", process.stderr)

    def test_humidity_chooses_the_constants_and_has_a_range(self):
        case = ROOT / "cases" / "evidence" / "bent_strip_air.toml"
        peaks = []
        for humidity in (0.5, 0.75, 1):
            self.run_case(case, "-o", f"at{humidity}", "--set", f"skin.humidity={humidity}", "--set", "numerics.error_estimate=off")
            peaks.append(max(signals(self.folder / f"at{humidity}", "water")["streaming_voltage"]))
        # Drag number times modulus, as the law has it before water moves.
        products = [0.40 * 249, (0.61 + 0.82) / 2 * (235 + 222) / 2, 1.59 * 172]
        for peak, product in zip(peaks, products):
            self.assertAlmostEqual(peak / peaks[0], product / products[0], delta=0.01 * product / products[0])
        error = self.run_program("check", case, "--set", "skin.humidity=0.4", expect=2).stderr
        self.assertIn("from 0.5 to 1", error)

    def test_a_polymer_that_relaxes_gives_the_voltage_away_at_its_own_time(self):
        polymer = ["--set", 'materials.nafion_wet.relaxation_times=["2 s"]', "--set", "materials.nafion_wet.relaxation_shares=[0.5]"]
        still = ["--set", "water.mobility=1e-24 m2/(Pa s)", "--set", "numerics.error_estimate=off"]
        self.run_case(ROOT / "cases" / "evidence" / "bent_strip.toml", "-o", "out", *still, *polymer)
        water = signals(self.folder / "out", "water")
        left = numpy.interp(2, water["time"], water["streaming_voltage"]) / max(water["streaming_voltage"])
        self.assertAlmostEqual(left, 0.5 + 0.5 * numpy.exp(-1), delta=0.01)  # K_u is fifty times G
        self.run_program("check", QUICK, "--set", 'materials.nafion.relaxation_times=["2 s"]', "--set",
                         "materials.nafion.relaxation_shares=[0.5]", expect=2)

    def test_only_mechanics_has_nothing_to_do(self):
        process = self.run_case(BENDING, "-o", "out", "--only", "mechanics", expect=2)
        self.assertIn('strain.source = "prescribed"', process.stderr)

    def test_check_says_which_poissons_ratio_is_which_and_what_is_unsound(self):
        process = self.run_program("check", ROOT / "cases" / "paper" / "water.toml", "--explain",
                                   "--set", "water.mobility=1.3e-17 m2/(Pa s)")
        for words in ("undrained Poisson's ratio          0.49", "drained Poisson's ratio            0.4",
                      "holds an indentation", "motion.preload = "):
            self.assertIn(words, process.stdout)

    def test_figures_of_the_water_are_drawn(self):
        x, y, z = numpy.linspace(0, 30e-3, 13), [0, 2e-3, 5e-3], [0, 180e-6]
        with h5py.File(self.folder / "pressure.h5", "w") as file:
            file["grid/x"], file["grid/y"], file["grid/z"], file["time"] = x, y, z, [0.0, 0.1, 0.3]
            pressure = numpy.zeros((3, 2, 2, 12))
            pressure[1:, 1, 0, 4:7] = 1e5
            file["channels/undrained_pressure"] = pressure
            file["channels/undrained_pressure"].attrs["unit"] = "Pa"
            file.attrs.update({"format": "ionskin-strain", "version": 2, "measure": "given", "frame": "skin"})
        text = BENDING.read_text()
        start = text.index("[strain]")
        case = self.write("wet.toml", text[:start] + """[strain]
source = "file"
file = "pressure.h5"
[numerics]
preset = "coarse"
mesh_refinement = 0.5
[output]
fields = ["0.1 s", "0.3 s"]
""")
        self.run_program("run", case, "-o", "out", "--figures")
        for name in ("water_voltage", "water_section", "water_walls"):
            self.assertTrue((self.folder / "out" / "figures" / f"{name}.png").exists(), name)
        with h5py.File(self.folder / "out" / "results.h5") as file:
            self.assertEqual(file["ions/0.3/pore_pressure"].attrs["unit"], "Pa")
            self.assertGreater(abs(file["ions/0.3/swelling"][...]).max(), 0)
            self.assertIn("water", file)

    def test_sweeps(self):
        self.run_program("sweep", BENDING, "-o", "sweep", *COARSE, "--over", "strain.curvature=5 1/m,10 1/m", "--no-report")
        table = (self.folder / "sweep" / "sweep.csv").read_text().splitlines()
        self.assertEqual(len(table), 3)


if __name__ == "__main__":
    unittest.main()
