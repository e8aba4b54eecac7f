# SPDX-License-Identifier: Apache-2.0
"""The report of small hand-made runs: what it must say, and that it stands alone."""

import base64
import io
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
import types
import unittest

import h5py
import numpy
from PIL import Image

from ionskin import Results, Study, figures
from ionskin.article import paper
from ionskin.charts import readout, sketches, spans
from ionskin.charts.chart import Curve, Map
from ionskin.figures import charts, draw_all
from ionskin.page import answer, chart_data, quantities, report_text, sweep_page, terminal
from ionskin.report import make_gallery, make_report
from ionskin.words import percent, quantity, si_scale

COLUMNS = ["time [s]", "cycle", "phase", "slider_x [m]", "slider_z [m]", "normal_force [N]", "tangential_force [N]",
           "mean_shear [1]", "rms_shear [1]", "p99_shear [1]", "shear_first_moment [1]", "mean_shear_rate [1/s]",
           "charge_top [C]", "charge_bottom [C]", "current_top [A]", "current_bottom [A]", "current_difference [A]",
           "current_common [A]", "slider_y [m]", "contact_area [m2]", "stick_share [1]", "slip [m]", "slip_state [1]"]
PHASES = ["touchdown", "touchdown", "slide", "lift", "return"]


def write_run(folder, cycles=2, contact=True, ions=True):
    """A run with one row per second and made-up numbers."""
    rows = []
    for second in range(4 * cycles + 1):
        cycle, phase = max(1, -(-second // 4)), PHASES[(second - 1) % 4 + 1] if second else PHASES[0]
        motion = [0.004, 1e-3, 65.0, 19.5] if contact else [""] * 4
        charges = [3e-6, 1e-6, 2e-6, -1e-6, 1.5e-6, 5e-7] if ions else [""] * 6
        place = [cycle, phase] if contact else ["", ""]
        rows.append([second, *place, *motion, 0.008, 0.01, 0.03, -1e-4, 0.0, *charges])
    lines = [",".join(COLUMNS)] + [",".join(map(str, row)) for row in rows]
    (folder / "signals.csv").write_text("\n".join(lines) + "\n")
    empty = "2e-6" if ions else ""
    (folder / "sampled.csv").write_text(
        "time [s],current_top [A],current_bottom [A],current_difference [A],current_common [A]\n"
        + "".join(f"{second},{empty},{empty},{empty},{empty}\n" for second in (1, 2, 3)))
    (folder / "summary.json").write_text(json.dumps({
        "metrics": {"normal_force_slide": {"value": 65.25, "unit": "N"}, "nonlinearity": {"value": None, "unit": "1"}},
        "timing": {"mechanics": 7.5, "electrochemistry": 2.5, "total": 11.0},
        "warnings": ["pressure < 5 & > 3"], "error_estimate": {"normal_force_slide": 0.004}}))
    (folder / "case.toml").write_text('title = "A <small> case"\n[skin]\nlength = "15 mm"\n[coupling]\nlaw = "column-neutral"\n')
    (folder / "manifest.json").write_text(json.dumps({
        "program": {"name": "ionskin", "version": "9.9"}, "stages": {"mechanics": {
            "state": "finished", "wall_time_s": 7.5, "peak_memory_bytes": 2.5e9}}, "counters": {"time_steps": 321}}))


def explored(page):
    """Data that the charts to explore of a page draw."""
    return json.JSONDecoder().raw_decode(page, page.index("const DATA=") + len("const DATA="))[0]


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="ionskin-report-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        write_run(cls.folder)
        cls.page = make_report(cls.folder).read_text()

    def test_says_what_the_run_says(self):
        for words in ("A &lt;small&gt; case", "pressure &lt; 5 &amp; &gt; 3", "65.2 N", "± 0.4 %", "<code>normal_force_slide</code>", "Normal force, mid-slide", "10.00 s", "2.50 GB",
                      "321", "15 mm", "column-neutral", "ionskin 9.9"):
            self.assertIn(words, self.page)

    def test_marks_what_does_not_converge_and_shades_the_band(self):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            write_run(folder)
            summary = json.loads((folder / "summary.json").read_text())
            summary["not_converging"] = {"normal_force_slide": "extreme under a sharp edge"}
            (folder / "summary.json").write_text(json.dumps(summary))
            shutil.copy(folder / "sampled.csv", folder / "sampled_error.csv")
            results = Results(folder)
            self.assertEqual(report_text.metric_rows(results)[0][3], "does not converge: extreme under a sharp edge")
            self.assertIn('<td class="error">does not converge: extreme', make_report(folder).read_text())
            self.assertIsNone(results.stated_error("normal_force_slide"))
            lower, upper = results.band("sampled", "current_top")
            self.assertEqual((lower[0], upper[0]), (0.0, 4e-6))
            self.assertIsNone(results.band("signals", "current_top"))

    def test_tells_the_taxels_of_the_case(self):
        grid = {"readout": {"circuit": "short", "taxels": {"rows": 4, "columns": 2}}}
        self.assertIn(("taxels", "4 rows × 2 columns"), dict(report_text.case_groups(grid))["Readout"])
        single = {"readout": {"taxels": [{"name": "a"}, {"name": "b"}]}}
        self.assertEqual(dict(report_text.case_groups(single))["Readout"], [("taxels", "2")])

    def test_metal_with_a_resistance_is_reported_with_its_lead(self):
        case = {"skin": {"layers": [{"name": "bottom", "sheet_resistance": "2 ohm"}, {"name": "ionomer"}, {"name": "top"}]},
                "readout": {"sample_interval": "10 ms"}}
        groups = dict(report_text.case_groups(case))
        self.assertEqual(groups["Skin"], [("sheet resistance, bottom", "2 Ω")])
        self.assertIn(("contact", "one end"), groups["Readout"])
        case["skin"]["layers"][0].pop("sheet_resistance")
        self.assertNotIn("contact", dict(dict(report_text.case_groups(case))["Readout"]))

    def test_the_potential_along_metal_is_drawn_with_its_largest_difference(self):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            write_run(folder)
            drawn = lambda: {entry.name: (entry.words(results), chart) for entry, chart in charts(results) if entry.name == "metal"}
            results = Results(folder)
            self.assertEqual(drawn(), {})
            (folder / "summary.json").write_text(json.dumps({"metrics": {"peak_metal_drop": {"value": 0.0232, "unit": "V"}}}))
            results = Results(folder)
            self.assertIn("set output.fields", drawn()["metal"][1])
            for rows, middle in ((3, [10.0, 11.0]), (2, [5.0, 6.0])):
                with h5py.File(folder / "results.h5", "w") as file:
                    for name, edges in (("x", [0, 1e-3, 3e-3]), ("y", numpy.linspace(0, 2e-3, rows + 1)), ("z", [0, 1e-4])):
                        file[f"ions/grid/{name}"] = edges
                    top = numpy.array([[10.0 * row + column for column in range(2)] for row in range(rows)])
                    for instant, factor in (("0.5", 1.0), ("1.5", 2.0)):
                        file[f"ions/{instant}/potential"] = numpy.array([[-factor * top, factor * top]])
                        file[f"ions/{instant}/concentration"] = numpy.ones((1, 2, rows, 2))
                words, chart = drawn()["metal"]
                self.assertIn("23.2 mV", words)
                (above,), (below,), (seen,) = chart.rows
                for cell, sign in ((above, 1), (below, -1)):
                    self.assertEqual([curve.label for curve in cell.curves], ["0.5 s", "1.5 s"])
                    numpy.testing.assert_allclose(cell.curves[0].y, sign * numpy.array(middle))
                numpy.testing.assert_allclose(above.curves[0].x, [5e-4, 2e-3])
                numpy.testing.assert_allclose(seen.map.values, 2 * top)

    def test_an_open_circuit_opens_with_voltages(self):
        with tempfile.TemporaryDirectory() as folder:
            write_run(pathlib.Path(folder))
            (pathlib.Path(folder) / "summary.json").write_text(json.dumps({
                "metrics": {name: {"value": 1e-3, "unit": unit} for name, unit in
                            (("peak_voltage", "V"), ("rms_voltage", "V"), ("peak_sampled_current_top", "A"))}}))
            words = [word for word, _, _ in report_text.headline(Results(pathlib.Path(folder))).values()]
            self.assertEqual(words, ["Peak sampled current, top"])
            (pathlib.Path(folder) / "case.toml").write_text('[readout]\ncircuit = "open"\n')
            words = [word for word, _, _ in report_text.headline(Results(pathlib.Path(folder))).values()]
            self.assertEqual(words, ["Peak voltage", "Rms of the voltage"])

    def test_an_open_circuit_draws_its_voltage_and_no_rounding(self):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            write_run(folder)
            (folder / "summary.json").write_text(json.dumps({"metrics": {"charge_identity_error": {"value": 1e-12, "unit": "1"}}}))
            (folder / "case.toml").write_text('[readout]\ncircuit = "open"\n[coupling]\nlaw = "poroelastic"\n')
            (folder / "sampled.csv").write_text("time [s],current_top [A],current_bottom [A],current_difference [A],current_common [A]\n"
                                                + "".join(f"{second},1e-14,1e-14,1e-19,1e-14\n" for second in (1, 2, 3)))
            table = "time [s],voltage [V],current [A],charge [C]\n" + "".join(f"{second},5e-5,1e-19,1e-19\n" for second in (1, 2, 3))
            for name in ("circuit", "sampled_circuit"):
                (folder / f"{name}.csv").write_text(table)
            page = make_report(folder).read_text()
            data = explored(page)
            self.assertIn("voltage", data["members"][0]["series"])
            self.assertEqual([name for name in data["members"][0]["series"] if "current" in name], [])
            for reason in ("no current passes between open electrodes", "open electrodes keep their charge"):
                self.assertIn(f"Not drawn: {reason}" if "flows" in reason else reason, page)
            (folder / "case.toml").write_text('[readout]\ncircuit = "open"\n[coupling]\nlaw = "fixed-charge"\n')  # whose common current is one
            data = explored(make_report(folder).read_text())
            self.assertEqual([name for name in data["members"][0]["series"] if "current" in name], ["current_top", "current_bottom", "current_common"])

    def test_warnings_name_numbers_in_words(self):
        self.assertEqual(quantities.in_words("The stated error exceeds 20 % for tail_current_difference (32 %). Raise numerics.mesh_refinement."),
                         "The stated error exceeds 20 % for difference current between the events (32 %). Raise numerics.mesh_refinement.")
        self.assertEqual(quantities.in_words("in current_circuit_NAME of taxels.csv, set slider.edge_radius"),
                         "in current_circuit_NAME of taxels.csv, set slider.edge_radius")

    def test_stands_alone(self):
        self.assertEqual(re.findall(r'(?:src|href)="(?!#)[^"]*"', self.page), [])
        self.assertNotIn("@import", self.page)
        self.assertNotIn("url(http", self.page)

    def test_every_figure_stands_in_the_page_and_is_a_file_where_asked_for(self):
        names = set(self.data()["charts"])
        self.assertEqual(set(re.findall(r'id="chart-([^"]+)"', self.page)), names)
        self.assertLessEqual({"reading", "motion", "shear", "currents", "forces", "charge", "relaxation"}, names)
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            write_run(folder)
            make_report(folder)
            self.assertFalse((folder / "figures").exists())
            parts = []
            self.assertEqual(make_report(folder, files=True, progress=parts.append).read_text(), self.page.replace(self.folder.name, folder.name))
            for kind in ("png", "svg"):
                found = {path.stem for path in (folder / "figures").glob(f"*.{kind}")}
                self.assertLessEqual(names | {"fig04_motion", "fig13_cycle"}, found)
            self.assertTrue((folder / "figures" / "fig04_motion.pdf").exists())
            self.assertEqual(parts, sorted(parts))
            self.assertEqual(parts[-1], 1.0)

    def data(self):
        """Data that the script of the page draws."""
        start = self.page.index("const FIGURES=") + len("const FIGURES=")
        return json.JSONDecoder().raw_decode(self.page[start:])[0]

    def test_the_page_is_made_without_matplotlib(self):
        code = (f"import sys; from ionskin.report import make_report; make_report({str(self.folder)!r}); "
                "sys.exit('matplotlib' in sys.modules)")
        self.assertEqual(subprocess.run([sys.executable, "-c", code], check=False).returncode, 0)

    def test_ids_of_the_page_are_unique(self):
        identifiers = re.findall(r'\bid="([^"]+)"', self.page)
        self.assertEqual(len(identifiers), len(set(identifiers)))

    def test_curves_follow_light_and_dark(self):
        curves = [curve for chart in self.data()["charts"].values() for row in chart["rows"] for cell in row for curve in cell["curves"]]
        self.assertTrue(curves)
        for curve in curves:
            self.assertRegex(curve["colour"], r"^var\(--[a-z-]+\)$")


class OtherRuns(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="ionskin-report-"))
        self.addCleanup(shutil.rmtree, self.folder)

    def figures(self, **run):
        write_run(self.folder, **run)
        return [entry.name for entry, _ in draw_all(Results(self.folder))]

    def test_runs_from_a_strain_file_have_no_motion(self):
        drawn = self.figures(contact=False)
        self.assertLessEqual({"reading", "shear", "currents", "charge"}, set(drawn))
        self.assertFalse({"motion", "contact", "forces"}.intersection(drawn))

    def test_a_path_across_the_skin_shows_its_place_and_the_size_of_its_force(self):
        write_run(self.folder)
        lines = [line.split(",") for line in (self.folder / "signals.csv").read_text().splitlines()]
        y = lines[0].index("slider_y [m]")
        for row, line in enumerate(lines):
            line += [""] * (len(COLUMNS) - len(line))
            line[y] = line[y] if row == 0 else f"{1e-3 * row}"
            line += ["tangential_force_x [N]", "tangential_force_y [N]"] if row == 0 else ["3", "-4"]
        straight = Results(self.folder)
        self.assertNotIn("slider_y", sweep_page.member_data(Study(self.folder), Study(self.folder).typical)["series"])
        self.assertEqual(figures.forces(straight).rows[0][0].curves[1].y[0], 19.5)
        (self.folder / "signals.csv").write_text("\n".join(map(",".join, lines)) + "\n")
        study = Study(self.folder)
        self.assertIn("slider_y", sweep_page.member_data(study, study.typical)["series"])
        self.assertEqual(figures.forces(study.typical.results).rows[0][0].curves[1].y.tolist(), [5.0] * (len(lines) - 1))

    def test_mechanics_alone_has_no_currents(self):
        drawn = self.figures(ions=False)
        self.assertLessEqual({"motion", "shear", "forces"}, set(drawn))
        self.assertFalse({"reading", "currents", "charge", "relaxation"}.intersection(drawn))

    def test_opens_with_what_can_be_read(self):
        write_run(self.folder)
        path = self.folder / "summary.json"
        summary = json.loads(path.read_text())
        summary["metrics"] |= {"peak_sampled_current_difference": {"value": 4.783e-4, "unit": "A"}, "peak_voltage": {"value": 0.01397, "unit": "V"}}
        summary["error_estimate"] |= {"peak_sampled_current_difference": 0.0093, "peak_voltage": 0.037}
        path.write_text(json.dumps(summary))

        def opening():
            text = make_report(self.folder).read_text()
            self.assertLess(text.index('class="lead"'), text.index('id="warnings"'))
            return re.search(r'<p class="lead">(.*)</p>', text)[1]

        self.assertEqual(opening(), "An ammeter between the electrodes reads up to 478 µA (± 0.93 %) at 1 s, as contact begins, the mean over 1 s.")
        (self.folder / "circuit.csv").write_text("time [s],voltage [V]\n0,0\n4,1e-3\n")
        self.assertIn("Between the electrodes a voltmeter reads up to 14 mV (± 3.7 %) at 4 s", opening())
        (self.folder / "circuit.csv").write_text("time [s],current [A],charge [C]\n0,0,0\n4,1e-9,2e-9\n")
        self.assertIn("The amplifier between the electrodes reads up to 1 nA", opening())

    def test_the_noise_is_compared_with_the_largest_sampled_reading(self):
        write_run(self.folder)
        path = self.folder / "summary.json"
        summary = json.loads(path.read_text())
        summary["metrics"] |= {"sample_noise": {"value": 1e-10, "unit": "A"}, "signal_to_noise": {"value": 5, "unit": "1"}}
        path.write_text(json.dumps(summary))
        (self.folder / "circuit.csv").write_text("time [s],current [A],charge [C]\n0,0,0\n4,1e-9,2e-9\n")

        def noise(sampled):
            (self.folder / "sampled_circuit.csv").write_text(f"time [s],current [A],charge [C]\n1,1e-11,1e-11\n2,{sampled},4e-10\n")
            return answer.sentences(Results(self.folder))[1]

        self.assertTrue(noise(-5e-10).endswith("5 times smaller than the largest sampled reading, 500 pA."))
        self.assertTrue(noise(-6e-10).endswith("5 times smaller than the largest sampled reading, 500 pA without noise."))
        self.assertTrue(noise(1e-9).endswith("500 pA without noise."))

    def test_an_event_names_only_what_is_read_from_its_begin_on(self):
        """Contact begins at 0.4 s, sliding at 0.5 s; contact ends at 1.4 s. The readout takes a sample each millisecond."""
        write_run(self.folder)
        times = [0, 0.4, 0.45, 0.5, 0.51, 1.3, 1.35, 1.4, 2.8]
        phases = ["touchdown"] * 4 + ["slide", "slide", "lift", "lift", "return"]
        forces = [0, 0, 0.2, 0.5, 0.5, 0.5, 0.2, 0, 0]
        rows = [",".join(map(str, row)) for row in zip(times, [1] * len(times), phases, forces)]
        (self.folder / "signals.csv").write_text("\n".join(["time [s],cycle,phase,normal_force [N]", *rows]) + "\n")

        def told(peak, **options):
            samples = [f"{1e-3 * i:.3f},{1e-6 if i == peak else 1e-9}" for i in range(1, 2800)]
            (self.folder / "sampled.csv").write_text("\n".join(["time [s],current_difference [A]", *samples]) + "\n")
            return answer.event(Results(self.folder), 1e-3 * peak, mean=True, **options)

        self.assertEqual(told(497), " at 0.497 s, 3 ms before sliding begins, while the slider lands")
        self.assertEqual(told(500), " at 0.5 s, just before sliding begins")
        self.assertEqual(told(501), " at 0.501 s, as sliding begins")
        self.assertEqual(told(507), " at 0.507 s, 7 ms after sliding begins")
        self.assertEqual(told(401), " at 0.401 s, as contact begins")
        self.assertEqual(told(1000), " at 1 s")
        self.assertEqual(told(1390), " at 1.39 s, 10 ms before contact ends, while the slider lifts")
        self.assertEqual(answer.event(Results(self.folder), 0.5), " at 0.5 s, as sliding begins")

    def test_the_largest_taxel_is_named_before_the_electrode(self):
        write_run(self.folder)
        path = self.folder / "summary.json"
        summary = json.loads(path.read_text())
        summary["metrics"] |= {"peak_sampled_taxel_current": {"value": 1.95e-6, "unit": "A"},
                               "peak_sampled_current_difference": {"value": 8.88e-7, "unit": "A"}}
        summary["error_estimate"] |= {"peak_sampled_taxel_current": 0.022, "peak_sampled_current_difference": 0.21}
        path.write_text(json.dumps(summary))
        titles = "time [s],current_top_r1c1 [A],current_top_r1c2 [A],current_top_rest [A]"
        (self.folder / "sampled_taxels.csv").write_text(f"{titles}\n1,1e-6,-1.95e-6,9e-6\n2,0,0,0\n")
        (self.folder / "taxels.csv").write_text("time [s],charge_top_r1c1 [C],charge_top_r1c2 [C]\n0,0,0\n1,1e-9,3e-9\n")
        results = Results(self.folder)
        lead, electrode = answer.readings(results)
        self.assertEqual(lead, "Of 2 taxels r1c2 reads most: up to 1.95 µA (± 2.2 %) at 1 s, as contact begins, the mean over 1 s.")
        self.assertIn("An ammeter between the electrodes reads up to 888 nA (± 21 %)", electrode)
        self.assertEqual(terminal.lines(results)[:2], [lead, electrode])
        self.assertIn("Peak sampled current of a taxel  1.95 µA ± 2.2 %", "\n".join(terminal.lines(results)))
        self.assertEqual(re.search(r'<p class="lead">(.*)</p>', make_report(self.folder).read_text())[1], lead)
        (self.folder / "case.toml").write_text('[readout]\ncircuit = "open"\n')
        self.assertEqual(answer.of_largest_taxel(Results(self.folder)), [])

    def test_a_page_does_not_tell_the_folders_of_its_machine(self):
        write_run(self.folder)
        path = self.folder / "manifest.json"
        command = "ionskin run '/home/ada/my cases/x.toml' --set motion.file=/home/ada/path.csv -o /tmp/out m2/s cases/y.toml"
        path.write_text(json.dumps(json.loads(path.read_text()) | {"command": command}))
        page = make_report(self.folder).read_text()
        self.assertNotIn("/home", page)
        for words in ("…/x.toml", "…/path.csv", "…/out", "m2/s cases/y.toml"):
            self.assertIn(words, page)

    def test_every_circuit_is_drawn(self):
        """An instrument such as the amplifier has no voltage, and its current a logarithmic axis."""
        write_run(self.folder)
        for table in ("time [s],current [A],charge [C]\n0,0,0\n4,1e-9,2e-9\n", "time [s],voltage [V]\n0,0\n4,1e-3\n",
                      "time [s],voltage [V],current [A],charge [C]\n0,0,0,0\n4,1e-3,1e-9,2e-9\n"):
            (self.folder / "circuit.csv").write_text(table)
            with self.subTest(table):
                self.assertIn('id="chart-circuit"', make_report(self.folder).read_text())
                self.assertIn("circuit", {entry.name for entry, _ in draw_all(Results(self.folder))})

    def test_a_folder_without_results_is_named(self):
        with self.assertRaisesRegex(FileNotFoundError, "signals.csv"):
            make_report(self.folder)
        with self.assertRaisesRegex(FileNotFoundError, "there is no folder .*missing"):
            make_report(self.folder / "missing")


class Reading(unittest.TestCase):
    def test_columns_units_and_phases(self):
        folder = pathlib.Path(tempfile.mkdtemp(prefix="ionskin-report-"))
        self.addCleanup(shutil.rmtree, folder)
        write_run(folder)
        results = Results(folder)
        self.assertEqual(results.signals.units["normal_force"], "N")
        self.assertEqual(results.signals["normal_force"][2], 65.0)
        self.assertEqual(results.metrics["normal_force_slide"].value, 65.25)
        self.assertIsNone(results.metrics["nonlinearity"].value)
        spans = results.phases()
        self.assertEqual([span.phase for span in spans], ["touchdown", "slide", "lift", "return"] * 2)
        self.assertEqual(spans[1].start, 1.0)
        self.assertEqual(spans[1].end, 2.0)
        self.assertEqual(spans[4].cycle, 2)

    def test_percent(self):
        self.assertEqual([percent(share) for share in (2.1e-6, 0.0065, 0.28, 1.004, 8.84, 6158.0)],
                         ["below 0.01 %", "0.65 %", "28 %", "100 %", "880 %", "over 1000 %"])

    def test_si_scale(self):
        self.assertEqual(si_scale(0.02), (1e-3, "m"))
        self.assertEqual(si_scale(65.0), (1.0, ""))
        self.assertEqual(si_scale(0.0), (1.0, ""))
        self.assertEqual(si_scale(15.2e6), (1e6, "M"))


class Hostile(unittest.TestCase):
    """Names in a case that are HTML, mathematics of matplotlib, or a book."""

    NAMES = ("<script>alert(1)</script>", r"$\\frac{1}$", "x" * 20000)
    CASE = """title = "</title><script>alert(2)</script>"
[skin]
length = "15 mm"
width = "2 mm"
{layers}
[slider]
size = ["3 mm", "1.5 mm"]
start = ["4.5 mm", "1 mm"]
[motion]
gap = "1 mm"
stroke = "6 mm"
[readout]
circuit = "load"
{taxels}
"""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="ionskin-report-"))
        self.addCleanup(shutil.rmtree, self.folder)
        write_run(self.folder)
        layers = "".join(f'[[skin.layers]]\nname = "{name}"\nrole = "{role}"\nmaterial = "{name}"\nthickness = "10 um"\n'
                         for name, role in zip(self.NAMES, ("electrode", "core", "electrode")))
        taxels = "".join(f'[[readout.taxels]]\nname = "{name}"\nlower = ["{i} mm", "0 mm"]\nupper = ["{i + 1} mm", "2 mm"]\n'
                         for i, name in enumerate(self.NAMES))
        (self.folder / "case.toml").write_text(self.CASE.format(layers=layers, taxels=taxels))
        names = [name.replace("\\\\", "\\") for name in self.NAMES]
        head = ["time [s]", *(f"{kind}_top_{name} [{unit}]" for kind, unit in (("current", "A"), ("charge", "C")) for name in names)]
        (self.folder / "taxels.csv").write_text("\n".join([",".join(head), "0,0,0,0,0,0,0", "4,0,0,0,1e-9,2e-9,3e-9"]) + "\n")
        (self.folder / "circuit.csv").write_text("time [s],voltage [V],current [A],charge [C]\n0,0,0,0\n4,1e-3,1e-9,2e-9\n")

    def test_page_and_figures_are_made_and_nothing_is_run(self):
        page = make_report(self.folder).read_text()
        for heading in ("Skin and slider", "Taxels", "Taxel signals"):
            self.assertIn(f"<h2>{heading}</h2>", page)
        self.assertNotIn("<script>alert", page)
        self.assertEqual(page.count("</title>"), 1)
        layers = make_gallery(self.folder, ["fig01_model", "fig02_layers"])
        self.assertEqual(layers, [])
        self.assertIn(r"$\frac{1}$", (self.folder / "figures" / "fig02_layers.svg").read_text())
        self.assertLess((self.folder / "figures" / "fig01_model.svg").stat().st_size, 200_000)
        self.assertLess(len(page), 300_000)


class TaxelsOfTheirOwn(unittest.TestCase):
    """Two taxels with circuits of their own; the right one is open."""

    CASE = """
[skin]
length = "4 mm"
width = "2 mm"
[readout]
taxel_circuit = "open"
taxels = {rows = 1, columns = 2}
"""
    COLUMNS = ("current_top_r1c1 [A]", "current_top_r1c2 [A]", "charge_top_r1c1 [C]", "charge_top_r1c2 [C]", "voltage_r1c1 [V]", "voltage_r1c2 [V]",
               "current_circuit_r1c1 [A]", "current_circuit_r1c2 [A]", "charge_circuit_r1c1 [C]", "charge_circuit_r1c2 [C]")

    def results(self, last):
        folder = pathlib.Path(tempfile.mkdtemp(prefix="ionskin-report-"))
        self.addCleanup(shutil.rmtree, folder)
        write_run(folder)
        (folder / "case.toml").write_text(self.CASE)
        for name in ("taxels", "sampled_taxels"):
            (folder / f"{name}.csv").write_text("\n".join([",".join(("time [s]", *self.COLUMNS)), ",".join("0" * 11), "4," + last]) + "\n")
        return Results(folder)

    def test_maps_and_panels_of_voltages(self):
        results = self.results("0,0,0,0,1e-3,-4e-3,0,0,0,0")
        self.assertTrue(readout.has_own_circuits(results) and readout.has_voltages(results))
        cell = readout.taxel_voltage_map(results).rows[0][0]
        self.assertEqual((cell.map.unit, cell.map.high), ("V", 4e-3))
        self.assertEqual(len(cell.shapes), 2)
        self.assertEqual([each.title for each in readout.taxel_voltages(results).rows[0]], ["r1c1", "r1c2"])
        self.assertEqual(readout.taxel_map(results), "no charge passes into a taxel")
        low, high = cell.shapes[0].outlines[0][0], cell.shapes[0].outlines[0][2]
        self.assertEqual(cell.notes[0].room, tuple(high - low))  # a page leaves words out that a taxel has no place for
        self.assertTrue(answer.sentences(results)[0].startswith("A voltmeter between the taxel r1c2 and the bottom electrode reads up to 4 mV"))

    def test_what_open_taxels_do_not_pass_is_no_figure(self):
        found = dict((entry.name, chart) for entry, chart in charts(self.results("0,0,0,0,1e-3,-4e-3,0,0,0,0")))
        self.assertEqual(found["relaxation"], readout.OPEN)
        if not isinstance(found["charge"], str):  # the law made net charge
            self.assertNotIn("Difference (top − bottom)/2", [row[0].title for row in found["charge"].rows])
            self.assertNotIn("Difference (top − bottom)/2", [row[0].title for row in found["currents"].rows])
        found = dict((entry.name, chart) for entry, chart in charts(self.results("1e-9,2e-9,3e-9,4e-9,0,1e-3,0,2e-9,0,4e-9")))
        self.assertIn("Difference (top − bottom)/2", [row[0].title for row in found["charge"].rows])
        self.assertEqual(found["relaxation"].rows[0][0].title, "Difference charge")

    def test_grounded_taxels_have_currents_alone(self):
        results = self.results("1e-9,2e-9,3e-9,4e-9,0,0,1e-9,2e-9,3e-9,4e-9")
        self.assertIsNone(readout.taxel_voltage_map(results))
        self.assertIsNone(readout.taxel_voltages(results))
        self.assertEqual(readout.taxel_map(results).rows[0][0].map.high, 4e-9)
        self.assertTrue(answer.sentences(results)[0].startswith("An ammeter between the taxel r1c2 and the bottom electrode reads up to 2 nA"))
        path = results.folder / "summary.json"
        told = json.loads(path.read_text())
        told["metrics"]["peak_sampled_taxel_current"] = {"value": 2e-9, "unit": "A"}
        told["error_estimate"]["peak_sampled_taxel_current"] = 0.08
        path.write_text(json.dumps(told))
        self.assertIn(" reads up to 2 nA (± 8 %)", answer.sentences(Results(results.folder))[0])


class LinesThatCross(unittest.TestCase):
    """Two columns above one row, at which the ground holds both ends of a signal or none."""

    COLUMNS = ("current_top_r1c1 [A]", "current_top_r1c2 [A]", "charge_top_r1c1 [C]", "charge_top_r1c2 [C]", "voltage_r1c1 [V]", "voltage_r1c2 [V]",
               "voltage_c1 [V]", "voltage_c2 [V]", "voltage_r1 [V]", *(f"{kind}_circuit_{name} [{unit}]" for kind, unit in (("current", "A"), ("charge", "C"))
                                                                        for name in ("c1", "c2", "r1")))

    def results(self, last):
        folder = pathlib.Path(tempfile.mkdtemp(prefix="ionskin-report-"))
        self.addCleanup(shutil.rmtree, folder)
        write_run(folder)
        (folder / "case.toml").write_text(TaxelsOfTheirOwn.CASE.replace("columns = 2", 'columns = 2, wiring = "crossbar"'))
        for name in ("taxels", "sampled_taxels"):
            (folder / f"{name}.csv").write_text("\n".join([",".join(("time [s]", *self.COLUMNS)), ",".join("0" * 16), "4," + last]) + "\n")
        return Results(folder)

    def test_an_instrument_is_at_a_line_or_at_a_crossing(self):
        voltages = self.results("0,0,1e-9,2e-9,1e-3,-4e-3,1e-3,-3e-3,1e-3,0,0,0,0,0,0")
        self.assertTrue(answer.sentences(voltages)[0].startswith("A voltmeter between the column c2 and the row r1 of the crossbar reads up to 4 mV"))
        self.assertEqual(len(readout.taxel_voltage_map(voltages).rows[0][0].shapes), 2)  # the crossings
        self.assertEqual([each.title for each in readout.taxel_voltages(voltages).rows[0]], ["r1c1", "r1c2"])
        currents = self.results("0,0,1e-9,2e-9,0,0,0,0,0,1e-9,2e-9,-3e-9,0,0,0")
        self.assertTrue(answer.sentences(currents)[0].startswith("An ammeter between the row r1 of the crossbar and the ground reads up to 3 nA"))


class ChartData(unittest.TestCase):
    def test_an_rms_says_that_it_counts_spikes_which_a_sampled_peak_does_not(self):
        self.assertEqual(quantities.words("rms_current_difference"), "Rms of the resolved difference current")
        self.assertEqual(quantities.words("rms_current_top"), "Rms of the resolved current, top")
        self.assertEqual(quantities.words("peak_sampled_current_top"), "Peak sampled current, top")

    def test_numbers_are_short_and_right(self):
        self.assertEqual(chart_data.rounded([0.0, 1.23456789e-9, -98765.4321, 7e300]), [0.0, 1.2346e-09, -98765.0, 7e300])
        self.assertEqual(chart_data.rounded([1.0, numpy.nan, numpy.inf]), [1.0, None, None])

    def test_long_curves_keep_their_extremes_and_ends(self):
        values = numpy.sin(numpy.linspace(0, 50, 100_001))
        values[[17, 70_000]] = (9.0, -9.0)
        rows = chart_data.kept_rows(Curve(numpy.arange(len(values)), values))
        arrays, where = chart_data.Arrays(), numpy.arange(10.0)
        first, other = ([0, 3, 9], [0, 5, 9])  # as many rows, but others
        self.assertEqual([arrays.place(where, numpy.array(chosen)) for chosen in (first, other, first)], [0, 1, 0])
        self.assertEqual(arrays.series, [first, other])
        self.assertLessEqual(len(rows), chart_data.MOST_POINTS + 2)
        self.assertTrue({0, 17, 70_000, 100_000} <= set(rows))
        self.assertEqual(list(chart_data.kept_rows(Curve(values[:5], values[:5]))), [0, 1, 2, 3, 4])

    def test_a_map_is_a_picture_of_its_values(self):
        edges = numpy.array([0.0, 1.0, 3.0])
        drawn = Map(edges, edges, numpy.array([[0.0, 1.0], [numpy.nan, 0.5]]), palette="viridis")
        address = chart_data.picture(drawn)
        image = Image.open(io.BytesIO(base64.b64decode(address.removeprefix("data:image/png;base64,")))).convert("RGBA")
        self.assertEqual(image.size, (3, 3))  # pixels as wide as the narrowest cell, y upwards
        self.assertEqual(image.getpixel((0, 2)), (0x44, 0x01, 0x54, 255))
        self.assertEqual(image.getpixel((2, 2)), (0xfd, 0xe7, 0x25, 255))
        self.assertEqual(image.getpixel((0, 0))[3], 0)

    def test_a_series_that_several_curves_show_stands_once(self):
        folder = pathlib.Path(tempfile.mkdtemp(prefix="ionskin-report-"))
        self.addCleanup(shutil.rmtree, folder)
        write_run(folder)
        shown = chart_data.chart_data({entry.name: chart for entry, chart in charts(Results(folder))})
        times = {curve["x"] for name in ("shear", "forces", "charge") for row in shown["charts"][name]["rows"]
                 for cell in row for curve in cell["curves"]}
        self.assertEqual(len(times), 1)
        self.assertEqual(shown["arrays"][times.pop()], Results(folder).signals["time"].tolist())


class Words(unittest.TestCase):
    def test_what_is_said_follows_the_case(self):
        for slider, words in (({"shape": "sphere", "radius": "8 mm"}, "Without sharp edges"), ({"size": []}, "edges are sharp"),
                              ({"edge_radius": "0.2 mm"}, "Without sharp edges"), ({"edge_radius": "0 mm"}, "edges are sharp")):
            with self.subTest(slider):
                case = types.SimpleNamespace(case={"slider": slider})
                self.assertIn(words, " ".join(report_text.limits(case)))

    def test_the_circuit_is_named_as_in_the_run(self):
        told = types.SimpleNamespace(case={}, circuit=None, circuit_words={
            "words": "resistor of 1e+06 ohm and capacitor of 1e-10 F in parallel", "top_potential": "φ = U = R I"})
        self.assertEqual(readout.circuit_words(told), "Resistor of 1 MΩ and capacitor of 100 pF in parallel")
        self.assertEqual(sketches.wall_potentials(told)["top"], "φ = U = R I")
        older = types.SimpleNamespace(case={"readout": {"circuit": "open"}}, circuit_words={},
                                      circuit=types.SimpleNamespace(has=lambda *_: True))
        self.assertEqual(readout.circuit_words(older), "Open circuit")
        self.assertEqual(sketches.wall_potentials(older)["top"], "φ = U")
        shorted = types.SimpleNamespace(case={}, circuit_words={}, circuit=None)
        self.assertEqual(readout.circuit_words(shorted), "Short circuit")
        self.assertEqual(sketches.wall_potentials(shorted)["top"], "φ = 0")

    def test_captions_and_limits_follow_slider_and_law(self):
        sharp = types.SimpleNamespace(case={"slider": {"size": []}, "coupling": {"law": "fixed-charge"}}, taxels=None, circuit_words={}, summary={}, sliders=[{}])
        finger = types.SimpleNamespace(case={"slider": {"shape": "sphere"}, "coupling": {"law": "column-neutral"}}, taxels=None, circuit_words={}, summary={}, sliders=[{}])
        water = types.SimpleNamespace(case={"slider": {"size": []}, "coupling": {"law": "poroelastic"}}, taxels=None, circuit_words={}, summary={}, sliders=[{}])
        for caption, word in ((report_text.contact_caption, "sharp"), (report_text.shear_caption, "sharp"),
                              (report_text.charge_caption, "common part")):
            self.assertIn(word, caption(sharp))
            self.assertNotIn(word, caption(finger))
        self.assertIn("coefficient k", " ".join(report_text.limits(finger)))
        self.assertIn("No water flows", " ".join(report_text.limits(finger)))
        self.assertNotIn("coefficient k", " ".join(report_text.limits(water)))
        self.assertNotIn("No water flows", " ".join(report_text.limits(water)))

    def test_a_grid_of_taxels_lies_as_the_program_lays_it(self):
        case = {"skin": {"length": "15 mm", "width": "6 mm"}, "readout": {"taxels": {"rows": 2, "columns": 4, "gap": "1 mm"}}}
        places = readout.rectangles(types.SimpleNamespace(case=case))
        self.assertEqual(len(places), 8)
        numpy.testing.assert_allclose(places["r1c1"], [[0, 0], [3e-3, 2.5e-3]], atol=1e-15)
        numpy.testing.assert_allclose(places["r2c4"], [[12e-3, 3.5e-3], [15e-3, 6e-3]], atol=1e-15)
        for odd in ({"rows": 2}, {"rows": 2, "columns": 4, "gap": "1 furlong"}):
            self.assertEqual(readout.rectangles(types.SimpleNamespace(case={**case, "readout": {"taxels": odd}})), {})

    def test_the_articles_claims_stand_with_its_own_case(self):
        for name, own in (("paper.toml", True), ("paper/coarse.toml", True), ("quick.toml", False), ("finger.toml", False)):
            case = tomllib.loads((pathlib.Path(__file__).parents[3] / "cases" / name).read_text())
            self.assertEqual(paper.is_own_case(case), own, name)
        folder = pathlib.Path(tempfile.mkdtemp(prefix="ionskin-report-"))
        self.addCleanup(shutil.rmtree, folder)
        write_run(folder)
        self.assertNotIn('id="claims"', make_report(folder).read_text())
        self.assertIn("10.3390/s26102930", make_report(folder, with_claims=True).read_text())

    def test_quantities_are_rounded_before_they_get_a_prefix(self):
        self.assertEqual(quantity(0.99999999, "N", 3), "1 N")
        self.assertEqual(quantity(0.00463387, "m"), "4.634 mm")

    def test_bands_show_contact_and_not_the_descent(self):
        folder = pathlib.Path(tempfile.mkdtemp(prefix="ionskin-report-"))
        self.addCleanup(shutil.rmtree, folder)
        write_run(folder, cycles=1)
        results = Results(folder)
        results.signals["normal_force"][:] = [0, 0, 65, 0, 0]  # touchdown ends at 1 s, the slide at 2 s
        found = spans.contact_spans(results)
        self.assertEqual([(span.phase, span.start, span.end) for span in found], [("slide", 1.0, 2.0)])

    def test_events_of_milliseconds_are_enlarged(self):
        folder = pathlib.Path(tempfile.mkdtemp(prefix="ionskin-report-"))
        self.addCleanup(shutil.rmtree, folder)
        write_run(folder, cycles=1)
        results = Results(folder)
        results.signals["normal_force"][:] = [0, 0, 65, 0, 0]  # contact from 1 s to 2 s
        results.sampled["time"][:] = [0.01, 0.02, 0.03]
        windows = spans.windows(results)
        self.assertEqual([(instant, words) for _, _, instant, words in windows], [(1.0, "contact begins"), (2.0, "contact ends")])
        for begin, end, instant, _ in windows:  # twelve readout intervals, and the event among them
            self.assertAlmostEqual(end - begin, 0.12)
            self.assertTrue(begin < instant < end)

    def test_times_say_whether_they_are_wall_or_threads(self):
        timing = {"mechanics": 88.0, "total": 90.0}
        results = types.SimpleNamespace(summary={"timing": timing}, manifest={
            "stages": {"mechanics": {"wall_time_s": 88.0}}, "counters": {"seconds_factorisation": 132.0, "factorisations": 4}})
        self.assertEqual([row[2] for row in report_text.timing_rows(results)], ["88.00 s", "88.00 s"])
        read = {"strain": {"state": "finished", "wall_time_s": 0.1, "source": "cache"}}
        results = types.SimpleNamespace(summary={"timing": {"mechanics": 0.0, "strain": 0.1}}, manifest={
            "stages": read, "counters": results.manifest["counters"]})
        self.assertEqual(report_text.timing_rows(results), [("mechanics", "read from the cache", "", ""),
                                                            ("strain", "read from the cache", "0.10 s", ""), ("sum", "", "0.10 s", "")])
        self.assertEqual(report_text.counter_rows(results),
                         [("factorisation, summed over threads", "132 s"), ("factorisations", "4")])


if __name__ == "__main__":
    unittest.main()
