# SPDX-License-Identifier: Apache-2.0
"""Study 2 alone: on a file that a short script wrote, and on a run's own strain history."""

import subprocess
import unittest

import numpy

from program import QUICK, ROOT, ProgramTest, metric, signals, write_strain_file

FARADAY = 96485.33212
# Constants of the baseline (docs: verification, E3).
Q0 = 76.4835  # F c0 lambda [C/m2]
RATIO = 136.244  # h / (2 lambda)


class StrainFile(ProgramTest):
    def run_on(self, strain, *edits, out="out"):
        options = [option for edit in edits for option in ("--set", edit)]
        self.run_case(QUICK, "-o", out, "--set", "strain.source=file", "--set",
                         f'strain.file="{strain}"', *options)
        return signals(self.folder / out)

    def test_example_script(self):
        subprocess.run(["/usr/bin/python3", ROOT / "cases" / "make_strain.py"], cwd=self.folder, check=True)
        script_case = ROOT / "cases" / "strain_file.toml"
        strain = next(self.folder.glob("*.h5"))
        self.run_case(script_case, "-o", "out", "--set", f'strain.file="{strain}"')
        result = signals(self.folder / "out")
        self.assertGreater(numpy.abs(result["current_difference"]).max(), 0)
        self.assertTrue(numpy.isnan(result["normal_force"]).all())

    def test_explained_with_its_size_and_cost(self):
        write_strain_file(self.folder / "strain.h5", numpy.zeros((3, 2, 1, 1)), [0, 1, 2])
        explained = self.run_program("check", QUICK, "--set", "strain.source=file", "--set",
                                     f'strain.file="{self.folder / "strain.h5"}"', "--explain").stdout
        self.assertRegex(explained, r"Study 2: unknowns +\d+ +over about \d+ time steps\n +memory +[\d.]+ GB")
        self.assertNotIn("Study 1", explained)

    def test_linear_step_matches_the_closed_form(self):
        """Verification E3 through a file, at the standard grid: charge to 0.2 % of the jump, current to 0.5 %
        (1 % within the relaxation time of 6 ms)."""
        amplitude = 0.015  # k = 0.1 makes S1 = 0.0015
        strain = self.folder / "step.h5"
        times = numpy.array([1e-3, 0.01, 0.1, 1, 4])
        samples = numpy.sort(numpy.concatenate([[0.0], 0.95 * times, times, 1.05 * times, [5.0]]))
        write_strain_file(strain, numpy.tile(numpy.array([-amplitude, amplitude])[None, :, None, None],
                                             (len(samples), 1, 1, 1)), samples)
        result = self.run_on(strain, "numerics.preset=standard")
        area = 15e-3 * 2e-3
        charge = (result["charge_top"] - result["charge_bottom"]) / 2 / area
        expected = Q0 * numpy.array([.06809872, .06754910, .06091059, .02200196, .00208097])
        self.assertAlmostEqual(charge[0], Q0 * 0.0015 * RATIO / 3, delta=2e-3 * charge[0])
        simulated = numpy.interp(times, result["time"], charge)
        # Charge in parts of its jump; late values have relaxed to 3 % of it.
        numpy.testing.assert_array_less(numpy.abs(simulated - expected), 2e-3 * expected[0])
        # Means from 0.95 t to 1.05 t of the inverse Laplace transform; steps end on both.
        gained = numpy.interp(1.05 * times, result["time"], charge) - numpy.interp(0.95 * times, result["time"], charge)
        current = gained / (0.1 * times)
        expected_current = numpy.array([-2.610228, -5.541455, -5.370943, -1.855175, -0.05400684])
        error = numpy.abs(current / expected_current - 1)
        numpy.testing.assert_array_less(error, [1e-2, 5e-3, 5e-3, 5e-3, 5e-3])

    def test_own_history_gives_the_same_currents(self):
        self.run_case(QUICK, "-o", "contact")
        contact = signals(self.folder / "contact")
        again = self.run_on(self.folder / "contact" / "results.h5")
        numpy.testing.assert_array_equal(again["time"], contact["time"])
        for name in ("current_top", "current_bottom"):
            scale = numpy.abs(contact[name]).max()
            numpy.testing.assert_allclose(again[name], contact[name], atol=1e-6 * scale, rtol=0)

    def test_charge_identity(self):
        strain = self.folder / "ramp.h5"
        write_strain_file(strain, numpy.array([0, 1e-3, 5e-4])[:, None, None, None] * numpy.ones((1, 2, 1, 1)),
                          [0.0, 0.1, 1.0])
        result = self.run_on(strain)
        volume = 15e-3 * 2e-3 * 180e-6
        total = result["charge_top"] + result["charge_bottom"]
        expected = FARADAY * 1200 * 0.1 * volume * result["mean_shear"]
        numpy.testing.assert_allclose(total, expected, atol=1e-9 * numpy.abs(expected).max(), rtol=0)
        self.assertLess(metric(self.folder / "out", "charge_identity_error"), 1e-9)


if __name__ == "__main__":
    unittest.main()
