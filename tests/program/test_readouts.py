# SPDX-License-Identifier: Apache-2.0
"""One strain history read out in every circuit, and the impedance spectrum."""

import json
import unittest

import h5py
import numpy

from program import QUICK, ROLLERS, SMALL, ProgramTest, metric, signals, summary, write_strain_file

# Half the mesh of the case, without the free sides: currents are compared with one another.
LIGHT = (*ROLLERS, "--set", "numerics.mesh_refinement=0.5", "--set", "numerics.error_estimate=off")
TAXELS = ('[{name="a", lower=["0 mm", "0 mm"], upper=["4 mm", "2 mm"]},'
          ' {name="b", lower=["4 mm", "0 mm"], upper=["9.3 mm", "0.7 mm"]}]')


class Readouts(ProgramTest):
    def setUp(self):
        super().setUp()
        # Shear that grows towards the top, more so on the left, and relaxes again.
        shape = numpy.array([[[0.2, 0.1]], [[1.0, 0.4]]])
        self.strain = self.folder / "strain.h5"
        write_strain_file(self.strain, 1e-3 * numpy.array([0.0, 1.0, 0.3])[:, None, None, None] * shape,
                          [0.0, 0.02, 0.5], x=(0, 6e-3, 15e-3))

    def read_out(self, name, *edits):
        options = [option for edit in edits for option in ("--set", edit)]
        self.run_case(QUICK, "-o", name, "--set", "strain.source=file", "--set",
                         f'strain.file="{self.strain}"', *options)
        out = self.folder / name
        self.assertLess(metric(out, "charge_identity_error"), 1e-9)
        return signals(out), out

    def test_open_circuit_and_taxels(self):
        whole, out = self.read_out("open", "readout.circuit=open", f"readout.taxels={TAXELS}")
        peak = numpy.abs(whole["charge_top"]).max()
        numpy.testing.assert_allclose(whole["charge_top"], whole["charge_bottom"], atol=1e-12 * peak, rtol=0)
        self.assertGreater(numpy.abs(signals(out, "circuit")["voltage"]).max(), 1e-4)

        taxels = signals(out, "taxels")
        self.assertEqual([name for name in taxels if name.startswith("current")],
                         ["current_top_a", "current_top_b", "current_top_rest"])
        total = sum(taxels[name] for name in taxels if name.startswith("charge"))
        numpy.testing.assert_allclose(total, whole["charge_top"], atol=1e-15 * peak, rtol=0)
        # Currents are differences of charges over short steps, which enlarge the rounding of the sums.
        self.assertLess(metric(out, "taxel_balance_error"), 1e-11)
        # The left taxel lies where the shear is largest.
        self.assertGreater(numpy.abs(taxels["charge_top_a"]).max() / 8,
                           1.5 * numpy.abs(taxels["charge_top_b"]).max() / (5.3 * 0.7))

    def test_open_taxels_over_all_of_the_electrode_have_no_balance(self):
        _, out = self.read_out("all_open", "readout.taxels={rows = 2, columns = 2}", "readout.taxel_circuit=open",
                               "coupling.law=column-neutral", "coupling.coefficient=1")
        self.assertNotIn("taxel_balance_error", summary(out)["metrics"])

    def test_taxels_with_circuits_of_their_own(self):
        neutral, law = ("coupling.law=column-neutral", "coupling.coefficient=1")
        whole, out = self.read_out("own", f"readout.taxels={TAXELS}", "readout.taxel_circuit=open", neutral, law)
        taxels, sampled = signals(out, "taxels"), signals(out, "sampled_taxels")
        for name in ("a", "b"):
            self.assertFalse(taxels[f"charge_circuit_{name}"].any())
            self.assertGreater(numpy.abs(taxels[f"voltage_{name}"]).max(), 1e-5)
            self.assertEqual(len(sampled[f"voltage_{name}"]), len(sampled["time"]))
        # What no taxel covers is a guard at the ground.
        self.assertFalse(taxels["voltage_rest"].any())
        self.assertNotIn("charge_circuit_rest", taxels)
        self.assertFalse((out / "circuit.csv").exists())
        # Beside a guard at the ground the charges on the wall, and their sum, are known to the solver's tolerance.
        self.assertLess(metric(out, "taxel_balance_error"), 1e-4)
        self.assertEqual(metric(out, "peak_taxel_voltage"),
                         max(numpy.abs(taxels[f"voltage_{name}"]).max() for name in ("a", "b")))
        self.assertTrue(0 < metric(out, "taxel_crosstalk") < 1)
        self.assertGreater(metric(out, "signal_to_noise"), 0)

        # One taxel behind a load, the other one shorted with its instrument.
        own = TAXELS.replace('"a",', '"a", circuit="load", load_resistance="100 Ohm",').replace('"b",', '"b", circuit="amplifier",')
        _, out = self.read_out("mixed", f"readout.taxels={own}", neutral, law)
        taxels = signals(out, "taxels")
        numpy.testing.assert_allclose(taxels["charge_circuit_a"], taxels["charge_top_a"], rtol=0,
                                      atol=1e-12 * numpy.abs(taxels["charge_top_a"]).max())
        self.assertFalse(taxels["voltage_b"].any())
        self.assertIn("reading_b", taxels)

    def test_electrodes_and_taxels_compare_their_largest_reading_with_its_noise(self):
        whole, off = "readout.taxels={rows = 1, columns = 1}", "numerics.error_estimate=off"
        amplifier = ("readout.amplifier_bandwidth=10 Hz", "readout.amplifier_range=20 uA")
        for circuit, column, edits in (("open", "voltage", ()), ("load", "voltage", ("readout.load_resistance=100 Ohm",)),
                                       ("amplifier", "current", amplifier)):
            with self.subTest(circuit):
                _, out = self.read_out(circuit, off, f"readout.circuit={circuit}", *edits)
                peak = numpy.abs(signals(out, "sampled_circuit")[column]).max()
                self.assertAlmostEqual(metric(out, "signal_to_noise") * metric(out, "sample_noise") / peak, 1, 9)
                _, taxel = self.read_out(f"{circuit}_taxel", off, whole, f"readout.taxel_circuit={circuit}", *edits)
                self.assertAlmostEqual(metric(taxel, "signal_to_noise") / metric(out, "signal_to_noise"), 1, 3)
                self.assertAlmostEqual(metric(taxel, "sample_noise_quantisation") / metric(out, "sample_noise_quantisation"), 1, 9)
        self.assertGreater(metric(out, "amplifier_clipped_time"), 0)
        self.assertLess(peak, 0.5 * metric(out, "peak_sampled_current_difference"))
        # Noise that the amplifier draws is no signal.
        _, noisy = self.read_out("noisy", off, "readout.circuit=amplifier", *amplifier, "readout.amplifier_noise_density=10 uA/sqrt(Hz)")
        self.assertAlmostEqual(metric(noisy, "signal_to_noise") * metric(noisy, "sample_noise") / peak, 1, 9)

    def test_lines_that_cross(self):
        grid, load = 'readout.taxels={rows = 2, columns = 2, wiring = "crossbar"}', ("readout.taxel_circuit=load", "readout.load_resistance=300 Ohm")
        scan = ("readout.scan.dwell=50 ms", "readout.scan.others=open")
        _, out = self.read_out("crossed", grid, *load, *scan, 'coupling.law="column-neutral"')
        taxels, sampled = signals(out, "taxels"), signals(out, "sampled_taxels")
        lines = sum(taxels[f"charge_circuit_{name}"] for name in ("c1", "c2", "r1", "r2"))
        peak = numpy.abs(taxels["charge_circuit_c1"]).max()
        self.assertLess(numpy.abs(lines).max(), 1e-12 * peak)
        for column in ("c1", "c2"):  # what an instrument knows of the crossings is what their column passes in turns
            numpy.testing.assert_allclose(taxels[f"charge_circuit_r1{column}"] + taxels[f"charge_circuit_r2{column}"],
                                          taxels[f"charge_circuit_{column}"], rtol=0, atol=1e-12 * peak)
        self.assertGreater(numpy.abs(sampled["voltage_r2"]).max(), 0)
        self.assertNotIn("current_top_c1", taxels)
        self.assertLess(metric(out, "taxel_balance_error"), 1e-9)
        self.assertTrue(0 < metric(out, "taxel_crosstalk") < 1)
        self.assertEqual(metric(out, "peak_taxel_voltage"),
                         max(numpy.abs(taxels[f"voltage_r{row}c{column}"]).max() for row in (1, 2) for column in (1, 2)))
        own = [word for edit in (grid, *load, *scan) for word in ("--set", edit)]
        self.run_case(QUICK, "-o", "truth", *SMALL, *own)
        for column in ("voltage_c1", "charge_circuit_r1c2", "current_circuit_r1"):
            self.run_program("fit", QUICK, *SMALL, *own, "--set", "coupling.coefficient=0.12", "--data", self.folder / "truth" / "taxels.csv",
                             "--column", column, "--free", "coupling.coefficient", "-o", "fit", "--overwrite", "--threads", "1")
            fit = json.loads((self.folder / "fit" / "fit.json").read_text())
            self.assertAlmostEqual(fit["parameters"]["coupling.coefficient"]["value"] / 0.1, 1, delta=2e-3, msg=column)
        error = self.run_program("live", QUICK, "-o", "skin.live", "--set", grid, expect=2).stderr
        self.assertIn("remove readout.taxels.wiring", error)

    def test_fits_take_the_signals_of_a_taxel(self):
        own = [word for edit in ("readout.taxels.rows=1", "readout.taxels.columns=2", "readout.taxel_circuit=load",
                                 "readout.load_resistance=300 Ohm") for word in ("--set", edit)]
        self.run_case(QUICK, "-o", "truth", *SMALL, *own)
        for column, table in (("voltage_r1c1", "taxels"), ("voltage_r1c1", "sampled_taxels"), ("current_circuit_r1c2", "sampled_taxels")):
            self.run_program("fit", QUICK, *SMALL, *own, "--set", "coupling.coefficient=0.12", "--data", self.folder / "truth" / f"{table}.csv",
                             "--column", column, "--free", "coupling.coefficient", "-o", "fit", "--overwrite", "--threads", "1")
            fit = json.loads((self.folder / "fit" / "fit.json").read_text())
            self.assertAlmostEqual(fit["parameters"]["coupling.coefficient"]["value"] / 0.1, 1, delta=2e-3, msg=column)
            self.assertEqual(fit["column"], column)

    def test_fits_name_the_voltages_of_taxels_and_live_skins_refuse_them(self):
        data = self.write("data.csv", "time [s],voltage [V]\n1,1e-6\n2,1e-6\n3,2e-6\n")
        own = [word for edit in ("readout.taxels.rows=1", "readout.taxels.columns=2", "readout.taxel_circuit=open")
               for word in ("--set", edit)]
        error = self.run_program("fit", QUICK, "--data", data, "--free", "coupling.coefficient", "-o", "fit", *own, expect=2).stderr
        self.assertIn("such as voltage_r1c1", error)
        error = self.run_program("live", QUICK, "-o", "skin.live", *own, expect=2).stderr
        self.assertIn('set readout.taxel_circuit = "shared"', error)

    def test_grid_of_taxels_and_sampled_tables(self):
        whole, out = self.read_out("grid", "readout.circuit=load", "readout.load_resistance=20 Ohm",
                                   "readout.taxels={rows = 2, columns = 3}", "readout.sample_interval=5 ms")
        taxels, sampled = signals(out, "taxels"), signals(out, "sampled_taxels")
        names = [f"r{row}c{column}" for row in (1, 2) for column in (1, 2, 3)]
        self.assertEqual(list(sampled), ["time", *(f"current_top_{name}" for name in names),
                                         *(f"charge_top_{name}" for name in names)])
        total = sum(taxels[f"charge_top_{name}"] for name in names)
        numpy.testing.assert_allclose(total, whole["charge_top"], atol=1e-12 * numpy.abs(total).max(), rtol=0)
        # Sampled: charge gained over each interval; with the first charge the current sums up to the last one.
        self.assertEqual(len(sampled["time"]), 100)
        for name in names:
            charge = numpy.concatenate([taxels[f"charge_top_{name}"][:1], sampled[f"charge_top_{name}"]])
            numpy.testing.assert_allclose(sampled[f"current_top_{name}"], numpy.diff(charge) / 5e-3,
                                          atol=1e-9 * numpy.abs(charge).max() / 5e-3, rtol=0)
        circuit, resolved = signals(out, "sampled_circuit"), signals(out, "circuit")
        self.assertEqual(list(circuit), ["time", "voltage", "current", "charge"])
        mean = numpy.trapezoid if hasattr(numpy, "trapezoid") else numpy.trapz
        self.assertAlmostEqual(circuit["voltage"].mean() * 0.5 / mean(resolved["voltage"], resolved["time"]), 1, 6)
        with h5py.File(out / "results.h5") as file:
            numpy.testing.assert_array_equal(file["sampled_circuit/voltage"][:], circuit["voltage"])
            self.assertIn("sampled_taxels/current_top_r2c3", file)
        self.assertTrue(any("share one resistor" in warning for warning in summary(out)["warnings"]))
        # A later run without taxels leaves none.
        self.run_case(QUICK, "-o", out, "--overwrite", "--only", "mechanics", "--set", "numerics.mesh_refinement=0.5")
        self.assertFalse((out / "sampled_taxels.csv").exists())

    def test_grid_from_single_keys_and_explanation(self):
        edits = [option for edit in ("readout.taxels.rows=4", "readout.taxels.columns=4", "readout.circuit=load",
                                     "readout.load_resistance=1 kOhm") for option in ("--set", edit)]
        explained = self.run_program("check", QUICK, "--explain", *edits).stdout
        self.assertIn("note: All 16 taxels share one resistor of 1000 ohm", explained)
        # eps A / (2 lambda) of 15 mm x 2 mm, a sixteenth of it, and with 1 kOhm.
        for line in (r"capacitance of the cell C +0\.0454\d* F", r"capacitance below taxel r1c1 +0\.002838 F",
                     r"time constant R C +45\.41 s", r"geometric capacitance +0\.0003333 F",
                     r"resistance of the core +18\.\d+ ohm", r"screening within the core +0\.006234 s",
                     r"charging through the core +0\.84\d+ s"):
            self.assertRegex(explained, line)
        for edits, problem in ((("readout.taxels.rows=4",), "missing key readout.taxels.columns"),
                               (("readout.taxels={rows = 0, columns = 2}",), "readout.taxels.rows = 0 is out of range"),
                               (('readout.taxels={rows = 3, columns = 2, gap = "1 mm"}',), "no room for the taxels along y"),
                               (("readout.taxels={rows = 3, colums = 2}",), "did you mean readout.taxels.columns?")):
            error = self.run_program("check", QUICK, *(option for edit in edits for option in ("--set", edit)), expect=2)
            self.assertIn(problem, error.stderr)

    def test_metal_with_a_sheet_resistance(self):
        def metal(resistance, *edits):
            return [option for edit in (f"skin.layers[0].sheet_resistance={resistance}", f"skin.layers[2].sheet_resistance={resistance}",
                                        *edits) for option in ("--set", edit)]
        explained = self.run_program("check", QUICK, "--explain").stdout
        self.assertRegex(explained, r"charging along the metal +0\.276\d s +if each metal had 1 ohm a square")
        self.assertIn("warning: thin metal would delay and lower the current", " ".join(explained.split()))
        explained = self.run_program("check", QUICK, "--explain", *metal("0.5 ohm", "readout.contact=both ends")).stdout
        self.assertRegex(explained, r"resistance of the metal +7\.5 ohm")
        self.assertRegex(explained, r"charging along the metal +0\.0345\d* s")
        self.assertNotIn("thin metal", explained)

        out, plain, touched = (self.folder / name for name in ("metal", "plain", "touched"))
        self.run_case(QUICK, "-o", out, *LIGHT, *metal("3 ohm"))
        self.run_case(QUICK, "-o", plain, *LIGHT)
        self.assertGreater(metric(out, "peak_metal_drop"), 0)
        self.assertLess(metric(out, "rms_current_difference"), 0.9 * metric(plain, "rms_current_difference"))
        self.run_case(QUICK, "-o", touched, *LIGHT, *metal("3 ohm", "readout.contact=everywhere"))
        self.assertEqual(metric(touched, "rms_current_difference"), metric(plain, "rms_current_difference"))
        self.assertTrue(any("leads hold the metal at one potential" in warning for warning in summary(touched)["warnings"]))

        for edits, problem in ((metal("1 ohm", "readout.taxels={rows = 1, columns = 2}"), "taxels have leads of their own"),
                               (["--set", "skin.layers[1].sheet_resistance=1 ohm"], "which is that of an electrode"),
                               (metal("-1 ohm"), "is out of range"),
                               (metal("1 ohm", "readout.contact=middle"), "one end")):
            self.assertIn(problem, self.run_program("check", QUICK, *edits, expect=2).stderr)

    def test_interface_apart_from_bulk(self):
        def cell(*edits):
            return [option for edit in ("coupling.law=column-neutral", "electrochemistry.permittivity=1.8e-10 F/m",
                                        "electrochemistry.interface_capacitance=30 F/m2", "coupling.coefficient=1e-3",
                                        *edits) for option in ("--set", edit)]
        explained = self.run_program("check", QUICK, "--explain", *cell()).stdout
        for line in (r"capacitance of the cell C +0\.00045 F", r"geometric capacitance +3e-11 F",
                     r"charging through the core +0\.00841\d* s"):
            self.assertRegex(explained, line)
        out = self.folder / "interface"
        self.run_case(QUICK, "-o", out, *LIGHT, *cell())
        self.assertGreater(metric(out, "rms_current_difference"), 0)
        self.assertGreater(metric(out, "min_concentration_ratio"), 0.5)
        for edits, problem in ((["coupling.law=fixed-charge"], "makes net charge"),
                               (["electrochemistry.interface_capacitance=0.3 F/m2"], "of the projected area alone"),
                               (["electrochemistry.permittivity=1e-3 F/m", "electrochemistry.interface_capacitance=1e4 F/m2"],
                                "would change its resistance"),
                               (["electrochemistry.interface_capacitance=30 F"], "expected a capacitance per area")):
            self.assertIn(problem, self.run_program("check", QUICK, *cell(*edits), expect=2).stderr)

    def test_circuits_can_be_swept(self):
        case = self.write("case.toml", QUICK.read_text() + '\n[readout]\ncircuit = "load"\nload_resistance = "1 kOhm"\n')
        note = self.run_program("check", case, "--set", "readout.circuit=short").stdout
        self.assertIn('note: readout.load_resistance is given and not used: the circuit "short" has none, '
                      '"load" or "parallel-rc" has.', note)
        self.run_program("sweep", case, "--over", "readout.circuit=short,load", "-o", "sweep", "--no-report",
                         "--set", "numerics.mesh_refinement=0.5")
        rows = (self.folder / "sweep" / "sweep.csv").read_text().splitlines()
        self.assertEqual([row.split(",")[3] for row in rows[1:]], ["finished", "finished"], rows[:2])

    def test_load_obeys_ohms_law(self):
        _, out = self.read_out("load", "readout.circuit=load", "readout.load_resistance=20 Ohm")
        load = signals(out, "circuit")
        middle = (load["voltage"][1:] + load["voltage"][:-1]) / 2
        passed = -numpy.cumsum(numpy.diff(load["time"]) * middle) / 20
        self.assertLess(numpy.abs(passed - load["charge"][1:]).max(), 0.02 * numpy.abs(load["charge"]).max())

    def test_what_rounding_makes_is_not_reported(self):
        edits = ("strain.source=file", f'strain.file="{self.strain}"', "readout.circuit=load",
                 "readout.load_resistance=1e12 Ohm", "numerics.mesh_refinement=0.5")
        told = self.run_program("run", QUICK, *ROLLERS, *(word for edit in edits for word in ("--set", edit)), "-o", "huge",
                                "--no-report").stdout
        self.assertIn("a voltmeter reads", told)
        self.assertNotIn("through what joins them", told)
        self.assertNotIn("difference current", told)

    def test_resistor_and_capacitor_share_the_current(self):
        _, out = self.read_out("parallel", "readout.circuit=parallel-rc", "readout.load_resistance=20 Ohm",
                               "readout.load_capacitance=10 mF")
        both = signals(out, "circuit")
        middle = (both["voltage"][1:] + both["voltage"][:-1]) / 2
        through_resistor = -numpy.cumsum(numpy.diff(both["time"]) * middle) / 20
        stored = both["charge"] + 10e-3 * both["voltage"]
        self.assertGreater(numpy.abs(10e-3 * both["voltage"]).max(), 0.1 * numpy.abs(both["charge"]).max())
        self.assertLess(numpy.abs(through_resistor - stored[1:]).max(), 0.02 * numpy.abs(stored).max())
        self.assertEqual(summary(out)["circuit"]["words"], "resistor of 20 ohm and capacitor of 0.01 F in parallel")

    def test_amplifier_clips_and_says_so(self):
        whole, out = self.read_out("amplifier", "readout.circuit=amplifier", "readout.amplifier_bandwidth=10 kHz",
                                   "readout.amplifier_range=0.1 mA")
        reading = signals(out, "circuit")
        self.assertEqual(list(reading), ["time", "current", "charge"])
        self.assertGreater(numpy.abs(whole["current_difference"]).max(), 1.1e-4)
        self.assertEqual(numpy.abs(reading["current"]).max(), 1e-4)
        self.assertTrue(any("clips" in warning for warning in summary(out)["warnings"]))
        with h5py.File(out / "results.h5") as file:
            numpy.testing.assert_array_equal(file["circuit/current"][:], reading["current"])

    def test_impedance(self):
        self.run_program("impedance", QUICK, "--from", "0.1Hz", "--to", "1 Hz", "--points", "1", "-o", "cell")
        spectrum = signals(self.folder / "cell", "impedance")
        expected = numpy.array([5.5486e-4 - 1.05351e-3j, 5.5402e-4 - 1.2677e-4j])
        simulated = spectrum["area_impedance_real"] + 1j * spectrum["area_impedance_imaginary"]
        numpy.testing.assert_allclose(simulated, expected, rtol=5e-3)
        for name in ("nyquist", "bode"):
            self.assertTrue((self.folder / "cell" / "figures" / f"{name}.png").exists())
        self.run_program("impedance", QUICK, "--from", "1 Hz", "--to", "1 Hz", "-o", "none", expect=2)
        self.run_program("impedance", QUICK, "--from", "1 s", "--to", "1 Hz", "-o", "none", expect=2)


if __name__ == "__main__":
    unittest.main()
