# SPDX-License-Identifier: Apache-2.0
"""Bench loads without a slider: a prescribed pressure or curvature under the law `poroelastic`."""

import unittest

import h5py
import numpy

from program import ROOT, ProgramTest, signals, summary

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

    def test_only_mechanics_has_nothing_to_do(self):
        process = self.run_case(BENDING, "-o", "out", "--only", "mechanics", expect=2)
        self.assertIn('strain.source = "prescribed"', process.stderr)

    def test_check_says_which_poissons_ratio_is_which_and_what_is_unsound(self):
        process = self.run_program("check", ROOT / "cases" / "poroelastic.toml", "--explain",
                                   "--set", "water.mobility=1.3e-17 m2/(Pa s)")
        for words in ("undrained Poisson's ratio          0.49", "drained Poisson's ratio            0.4",
                      "holds an indentation", "motion.preload_force"):
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
