# SPDX-License-Identifier: Apache-2.0
"""Sweeps made by hand: reading, figures, claims, regimes, comparison, and the page in a browser."""

import itertools
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from types import SimpleNamespace
from unittest import mock

import matplotlib.text
import matplotlib.transforms
import numpy

import page_faults
from browser import browser_page, chromium
from ionskin import Results, Study
from ionskin import compare, sweep_results
from ionskin.analysis import sensitivity
from ionskin.article import claims, regimes
from ionskin.charts import contact, numbered
from ionskin.drawing import draw_chart
from ionskin.page import quantities, sweep_page
from ionskin.report import make_gallery, make_report
from report_test import write_run

CUT_LABELS = """[...document.querySelectorAll('.cells svg')].flatMap((svg) => {
  const box = svg.getBoundingClientRect();
  return [...svg.querySelectorAll('text')].filter((text) => {
    const own = text.getBoundingClientRect();
    return own.left < box.left - 1 || own.right > box.right + 1 || own.top < box.top - 1 || own.bottom > box.bottom + 1;
  }).map((text) => text.textContent);
})"""
FRICTIONS = [0.1, 0.2, 0.3, 0.4, 0.5]


def write_sweep(folder, frictions=tuple(FRICTIONS)):
    """A sweep whose shear is the square root of friction below 0.3 and in proportion to it above; one point failed."""
    rows = ["point,folder,contact.friction [1],status,reason,peak_mean_shear [1]"]
    for number, friction in enumerate(frictions, 1):
        point = folder / "points" / f"{number:04}"
        point.mkdir(parents=True)
        write_run(point)
        shear = 0.01 * (friction / 0.3) ** (0.5 if friction < 0.3 else 1.0)
        summary = json.loads((point / "summary.json").read_text())
        summary["metrics"].update({
            "peak_mean_shear": {"value": shear, "unit": "1"}, "time_mean_shear": {"value": shear / 2, "unit": "1"},
            **{f"{kind}_current_{name}": {"value": size * friction, "unit": "A"}
               for kind, size in (("peak", 1.0), ("peak_sampled", 0.05), ("rms", 0.01))
               for name in ("top", "bottom", "difference", "common")}})
        (point / "summary.json").write_text(json.dumps(summary))
        rows.append(f"{number},points/{number:04},{friction},finished,,{shear}")
    rows.append(f'{len(frictions) + 1},points/none,0.9,failed,"it broke, badly",')
    (folder / "sweep.csv").write_text("\n".join(rows) + "\n")


def overlapping_texts(figure):
    """Pairs of texts of a figure that lie over one another; slanted ones are told apart by where they begin."""
    figure.canvas.draw()
    texts = [text for text in figure.findobj(matplotlib.text.Text) if text.get_text().strip() and text.get_visible()]
    boxes = []
    for text in texts:
        box = text.get_window_extent()
        if text.axes is not None and not text.axes.get_visible() or box.width == 0:
            continue
        if text.get_rotation() % 90:
            box = matplotlib.transforms.Bbox.from_extents(box.x1 - text.get_fontsize(), box.y0, box.x1, box.y1)
        boxes.append((text.get_text(), box.padded(-1)))
    return [(a, b) for i, (a, p) in enumerate(boxes) for b, q in boxes[i + 1:] if p.overlaps(q) and a != b]


class SweepTest(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="ionskin-sweep-"))
        self.addCleanup(shutil.rmtree, self.folder)


class Reading(SweepTest):
    def test_members_and_failures(self):
        write_sweep(self.folder)
        study = Study(self.folder)
        self.assertEqual([member.value for member in study.members], FRICTIONS)
        self.assertEqual(study.typical.value, 0.3)
        self.assertEqual(study.label(study.typical), "µ = 0.3")
        self.assertEqual(study.sweep.points[-1].reason, "it broke, badly")
        self.assertEqual(study.sweep.points[0].metrics, {"peak_mean_shear": study.metric("peak_mean_shear")[0]})


class Figures(SweepTest):
    def test_every_figure_as_three_files(self):
        write_sweep(self.folder)
        left_out = dict(make_gallery(self.folder, ["fig05_shear", "fig07_peaks", "fig10_current_map", "fig19_ions"]))
        self.assertEqual(left_out, {"fig19_ions": "the run has no results.h5"})
        names = {f"{name}.{kind}" for name in ("fig05_shear", "fig07_peaks", "fig10_current_map")
                 for kind in ("png", "svg", "pdf")}
        self.assertEqual({path.name for path in (self.folder / "figures").iterdir()}, names)

    def test_one_run_leaves_out_the_maps_with_a_reason(self):
        write_run(self.folder)
        drawn = dict((entry.name, chart) for entry, chart in numbered.charts(Study(self.folder)))
        self.assertEqual(len(drawn), 23)
        for name in ("fig06_shear_map", "fig10_current_map", "fig16_correlation"):
            self.assertIn("several runs", drawn[name])
        self.assertNotIsInstance(drawn["fig13_cycle"], str)

    def test_an_unknown_figure_is_refused(self):
        write_run(self.folder)
        with self.assertRaisesRegex(ValueError, "fig01_model"):
            make_gallery(self.folder, ["fig99"])


class ContactStates(unittest.TestCase):
    def test_a_touchdown_takes_one_step_or_several(self):
        for last, names in (("touchdown", ["onset_01", "touchdown"]), ("touchdown_10", ["touchdown_09", "touchdown_10"])):
            file = {"contact": dict.fromkeys(names)}
            self.assertEqual(contact.touchdown_state(file), last)
            self.assertEqual(contact.middle_state(file), last)
        times = {"touchdown": 0.5, "steady_0": 1, "steady_1": 1.1, "steady_2": 1.9, "steady_10": 3}
        file = {"contact": {name: SimpleNamespace(attrs={"parameter": time}) for name, time in times.items()}}
        self.assertEqual(contact.middle_state(file), "steady_2")

    def test_colours_of_a_round_contact_reach_its_peak(self):
        """Only under sharp edges, where peaks depend on the mesh, does the scale end below the largest value."""
        radius = (numpy.arange(200) + 0.5) / 200
        pressure, areas = 1e6 * numpy.sqrt(1 - radius**2), 2 * numpy.pi * radius
        self.assertEqual(contact.capped(pressure, areas, 1.0), pressure.max())
        self.assertLess(contact.capped(pressure, areas, 0.95), pressure.max())
        self.assertEqual(contact.capped(numpy.zeros(5), numpy.ones(5), 1.0), 1.0)


class Regimes(unittest.TestCase):
    X = numpy.linspace(0.05, 0.5, 10)

    def test_two_laws_are_found(self):
        data = numpy.where(self.X < 0.2, 3 * self.X**0.4, 3 * 0.2**-0.5 * self.X**0.9)
        fit = regimes.fit(self.X, data)
        self.assertTrue(fit.two)
        self.assertAlmostEqual(fit.low, 0.4, places=3)
        self.assertAlmostEqual(fit.high, 0.9, places=3)
        self.assertAlmostEqual(fit.break_at, 0.2, places=3)
        numpy.testing.assert_allclose(fit(self.X), data, rtol=2e-3)

    def test_one_law_stays_one_under_noise(self):
        noise = 1 + 0.01 * numpy.random.default_rng(4).standard_normal(len(self.X))
        fit = regimes.fit(self.X, 2 * self.X**0.7 * noise)
        self.assertFalse(fit.two)
        self.assertAlmostEqual(fit.low, 0.7, delta=4 * fit.low_error)

    def test_too_few_points_are_not_judged(self):
        self.assertIsNone(regimes.fit(self.X[:4], self.X[:4]))


class Claims(SweepTest):
    def test_verdicts_follow_the_data(self):
        write_sweep(self.folder)
        found = {entry.claim: entry for entry in claims.judge(Study(self.folder))}
        rising = next(entry for claim, entry in found.items() if claim.startswith("the peak of the mean shear rises"))
        self.assertEqual(rising.verdict, claims.HOLDS)
        regimes_found = next(entry for claim, entry in found.items() if claim.startswith("two regimes: the peak"))
        self.assertEqual(regimes_found.verdict, claims.HOLDS)
        self.assertIn("exponent 0.50", regimes_found.number)
        # The made-up shear does not vanish in the return, and the common part is as large as the difference.
        self.assertEqual(found["γ is near 0 while the slider is detached"].verdict, claims.FAILS)
        self.assertEqual(found["the electrodes' currents are equal and opposite"].verdict, claims.FAILS)

    def test_noise_of_the_solver_is_no_common_current(self):
        write_run(self.folder)  # of a law that keeps every column neutral
        summary = json.loads((self.folder / "summary.json").read_text())
        opposite = "the electrodes' currents are equal and opposite"

        def verdict(error):
            summary["metrics"]["charge_identity_error"] = {"value": error, "unit": "1"}
            (self.folder / "summary.json").write_text(json.dumps(summary))
            return {entry.claim: entry for entry in claims.judge(Study(self.folder))}

        for error, expected in ((1e-10, claims.HOLDS), (1e-2, claims.FAILS)):
            self.assertEqual(verdict(error)[opposite].verdict, expected)
        self.assertIn("noise of the solver", verdict(1e-10)[opposite].number)
        self.assertEqual(verdict(1e-10)["the common current follows dγ/dt"].verdict, claims.OPEN)

    def test_one_run_cannot_be_monotone(self):
        write_run(self.folder)
        verdicts = [entry.verdict for entry in claims.judge(Study(self.folder))]
        self.assertIn(claims.OPEN, verdicts)


class Compare(SweepTest):
    def test_differences_and_none(self):
        for name in ("a", "b"):
            (self.folder / name).mkdir()
            write_run(self.folder / name)
        first, second = Results(self.folder / "a"), Results(self.folder / "b")
        self.assertEqual(compare.report(first, second, 1e-9), ["no differences above 1e-09"])
        case = self.folder / "b" / "case.toml"
        case.write_text(case.read_text().replace("15 mm", "16 mm"))
        summary = self.folder / "b" / "summary.json"
        summary.write_text(summary.read_text().replace("65.25", "66.0"))
        table = self.folder / "b" / "signals.csv"
        table.write_text(table.read_text().replace("0.008", "0.009"))
        text = "\n".join(compare.report(first, Results(self.folder / "b"), 1e-9))
        self.assertIn("skin.length: '15 mm' | '16 mm'", text)
        self.assertRegex(text, r"\n +a +b +differ by +name in summary\.json\n")
        self.assertRegex(text, r"\n  Normal force, mid-slide +65\.2 N ± 0\.4 % +66 N ± 0\.4 % +1\.1 % +normal_force_slide\n")
        self.assertRegex(text, r"\n  Mean shear +0\.001 +11 % +signals/mean_shear$")
        self.assertNotIn("current_top", text)
        self.assertNotRegex(text, r"\de[-+]\d")

    def test_what_one_run_lacks_is_a_dash(self):
        for name in ("a", "b"):
            (self.folder / name).mkdir()
            write_run(self.folder / name)
        summary = json.loads((self.folder / "b" / "summary.json").read_text())
        del summary["metrics"]["normal_force_slide"]
        (self.folder / "b" / "summary.json").write_text(json.dumps(summary))
        text = "\n".join(compare.report(Results(self.folder / "a"), Results(self.folder / "b"), 1e-9))
        self.assertRegex(text, r"\n  Normal force, mid-slide +65\.2 N ± 0\.4 % +– +– +normal_force_slide$")

    def test_says_what_the_stated_errors_allow(self):
        """Forces 65.25 and 66 N: errors of 0.5 and 0.3 N cover their distance, of 0.3 and 0.3 N they do not."""
        for name, error, value in (("a", 0.5, 65.25), ("b", 0.3, 66.0), ("c", 0.3, 65.25)):
            (self.folder / name).mkdir()
            write_run(self.folder / name)
            path = self.folder / name / "summary.json"
            summary = json.loads(path.read_text())
            summary["metrics"]["normal_force_slide"]["value"] = value
            summary["error_parts"] = {"normal_force_slide": {"mechanics_mesh": error - 0.1, "path": 0.1}}
            summary["error_estimate"] = {"normal_force_slide": error / value}
            path.write_text(json.dumps(summary))
            for table in ("signals", "sampled"):
                shutil.copy(self.folder / name / f"{table}.csv", self.folder / name / f"{table}_error.csv")
        table = self.folder / "b" / "signals.csv"
        table.write_text(table.read_text().replace("0.008", "0.009"))
        first, second, third = (Results(self.folder / name) for name in "abc")
        text = "\n".join(compare.report(first, second, 1e-9))
        force = r"66 N ± 0\.45 % +1\.1 % +{} +normal_force_slide\n"
        self.assertRegex(text, r"65\.2 N ± 0\.77 % +" + force.format("within the stated errors"))
        self.assertRegex(text, r"Mean shear +0\.001 +11 % +within the stated errors +signals/mean_shear")
        self.assertRegex("\n".join(compare.report(third, second, 1e-9)), force.format("beyond the stated errors"))
        second.summary["not_converging"] = {"normal_force_slide": "a reason"}
        self.assertRegex("\n".join(compare.report(first, second, 1e-9)), r"66 N +1\.1 % +does not converge +normal_force_slide")

    def test_every_column_has_a_name_in_words(self):
        axes = [f"{name}_{axis}" for name in ("slider", "tangential_force", "drive", "drive_force") for axis in "xy"]
        for name in ("slider_z", "normal_force", "tangential_force", "mean_shear", "rms_shear", "p99_shear", "shear_first_moment", "mean_shear_rate",
                     "charge_top", "charge_bottom", "contact_area", "stick_share", "slip", "slip_state", *axes):
            self.assertTrue(quantities.known_words(name) or name in quantities.COLUMNS, name)
        self.assertEqual(quantities.column_words("sampled", "current_difference"), "Sampled difference current")
        self.assertEqual(quantities.column_words("signals", "current_top"), "Current, top")


class Page(SweepTest):
    def test_stands_alone_and_says_what_failed(self):
        write_sweep(self.folder)
        page = make_report(self.folder).read_text()
        self.assertEqual(re.findall(r'(?:src|href)="(?!#)([^"]*)"', page), [])
        self.assertNotIn("url(http", page)
        self.assertIn("it broke, badly", page)
        self.assertIn("5 of 6 points finished", page)

    def test_warnings_of_all_points_are_collected(self):
        write_sweep(self.folder)
        path = self.folder / "points" / "0002" / "summary.json"
        summary = json.loads(path.read_text())
        path.write_text(json.dumps(summary | {"warnings": summary["warnings"] + ["It broke at 7 mm."]}))
        page = make_report(self.folder).read_text()
        self.assertIn("<li>Every point: pressure &lt; 5 &amp; &gt; 3</li>", page)
        self.assertIn("<li>µ = 0.2: It broke at 7 mm.</li>", page)

    def test_figures_carry_numbers_and_captions_and_are_drawn_by_the_page(self):
        write_sweep(self.folder)
        page = make_report(self.folder).read_text()
        self.assertRegex(page, r'<h3 id="fig07_peaks">Figure 7\. Peaks</h3>\s*<figure[^>]*>\s*<div class="cells" id="chart-fig07_peaks">')
        self.assertIn("Peak of the mean shear, with power laws", page)
        self.assertIn("Figures 21, 22: left out", page)
        code = (f"import sys; from ionskin.report import make_report; make_report({str(self.folder)!r}); sys.exit('matplotlib' in sys.modules)")
        self.assertEqual(subprocess.run([sys.executable, "-c", code], check=False).returncode, 0)

    def test_opens_with_what_can_be_read_and_where_it_is_largest(self):
        write_sweep(self.folder)
        lead = re.search(r'<p class="lead">(.*)</p>', make_report(self.folder).read_text())[1]
        self.assertEqual(lead, "Peak sampled difference current: from 5 mA at µ = 0.1 to 25 mA at µ = 0.5.")

    def test_curves_that_coincide_are_said_to(self):
        write_sweep(self.folder)
        chart = dict((entry.name, chart) for entry, chart in numbered.charts(Study(self.folder), ["fig08_means"]))["fig08_means"]
        self.assertIn("These curves coincide: top, bottom, difference and common.", chart.note)

    @unittest.skipUnless(chromium(), "no Chromium on this machine: apt-get install chromium to test the page in it")
    def test_has_no_fault_on_a_desktop_and_a_telephone(self):
        write_sweep(self.folder)
        with browser_page(make_report(self.folder)) as page:
            for width in page_faults.WIDTHS:
                self.assertEqual(page_faults.faults(page, width), [])

    @unittest.skipUnless(chromium(), "no Chromium on this machine: apt-get install chromium to test the page in it")
    def test_faults_of_a_page_are_found(self):
        path = self.folder / "faulty.html"
        path.write_text("""<!doctype html><meta name=viewport content="width=device-width"><main><p>One</p><p style="margin-top:-2.2em">Two</p>
          <div style="overflow:auto;width:90px;white-space:nowrap">A line that goes on and on and on</div>
          <div class="chart"><svg viewBox="0 0 100 40" width="100" height="40" style="overflow:hidden"><text class="name" x="60" y="20">Cut at the edge</text></svg></div>
          <figure aria-label="nothing"></figure></main><script>console.error("an error")</script>""")
        with browser_page(path) as page:
            found = " ".join(page_faults.faults(page, 390))
        for words in ('overlap: "Two" and "One"', 'cut off: "Cut at the edge"', "sideways: div A line", "empty: nothing", "empty: Cut at", "console: "):
            self.assertIn(words, found)

    @unittest.skipUnless(chromium(), "no Chromium on this machine: apt-get install chromium to test the page in it")
    def test_clicking_through_the_page(self):
        write_sweep(self.folder)
        with browser_page(make_report(self.folder)) as page:
            self.assertEqual(page.evaluate("document.querySelectorAll('#charts svg').length"), 4)
            self.pick_another_run(page)
            self.hover_and_zoom(page)
            self.choose_another_metric(page)
            self.assert_quiet(page)

    @unittest.skipUnless(chromium(), "no Chromium on this machine: apt-get install chromium to test the page in it")
    def test_clicking_through_the_page_of_a_run(self):
        write_run(self.folder)
        with browser_page(make_report(self.folder)) as page:
            self.assertEqual(page.evaluate("document.querySelectorAll('#charts svg').length"), 4)
            self.assertEqual(page.evaluate("document.querySelectorAll('#explore .picker button').length"), 0)
            self.hover_and_zoom(page, r"t = .*mean shear")
            self.assert_quiet(page)

    @unittest.skipUnless(chromium(), "no Chromium on this machine: apt-get install chromium to test the page in it")
    def test_figures_of_a_run_are_drawn_for_every_width(self):
        write_run(self.folder)
        (self.folder / "circuit.csv").write_text("time [s],current [A],charge [C]\n0,0,0\n4,1e-9,2e-9\n8,-1e-9,0\n")
        with browser_page(make_report(self.folder)) as page:
            for width in (1300, 390):
                page.call("Emulation.setDeviceMetricsOverride", width=width, height=2400, deviceScaleFactor=1, mobile=width < 500)
                page.settle()
                for name, count in (("motion", 2), ("currents", 3), ("answer", 3), ("relaxation", 2)):
                    self.assertEqual(page.evaluate(f"document.querySelectorAll('#{name} .cells svg').length"), count, name)
                self.assertGreater(page.evaluate("document.querySelectorAll('#forces path.curve').length"), 1)
                self.assertEqual(page.overlapping_labels(".cells svg"), [])
                self.assertEqual(page.evaluate(CUT_LABELS), [])
                self.assertLessEqual(page.evaluate("document.documentElement.scrollWidth"), width)
            self.zoom_into_the_forces(page)
            self.assert_quiet(page)

    def zoom_into_the_forces(self, page):
        """A drag enlarges a part of the time, a double click shows all again; the pointer reads values."""
        left, top, width, height = page.box("#forces .cells svg")
        middle, ticks = top + height / 2, "[...document.querySelectorAll('#forces text[text-anchor=middle]')].map(t => t.textContent)"
        whole = page.evaluate(ticks)
        page.mouse("mouseMoved", left + width / 2, middle)
        self.assertRegex(page.evaluate("document.querySelector('#forces .readout').textContent"), "time .* s: normal 65 N, tangential")
        page.mouse("mousePressed", left + 0.3 * width, middle)
        page.mouse("mouseMoved", left + 0.4 * width, middle)
        page.mouse("mouseReleased", left + 0.5 * width, middle)
        self.assertNotEqual(page.evaluate(ticks), whole)
        page.click(left + 0.5 * width, middle, clicks=2)
        self.assertEqual(page.evaluate(ticks), whole)

    def assert_quiet(self, page):
        """No error, nothing asked of the network, no label over another."""
        self.assertEqual(page.overlapping_labels("#charts svg, #trend svg"), [])
        self.assertEqual(page.errors, [])
        self.assertEqual(page.requests, [])

    def pick_another_run(self, page):
        left, top, width, height = page.box("#explore .picker button:nth-child(5)")
        page.click(left + width / 2, top + height / 2)
        self.assertEqual(page.evaluate("document.querySelector('#explore [aria-pressed=true]').textContent"), "µ = 0.5")
        self.assertIn("µ = 0.5", page.evaluate("document.querySelector('#charts .name').textContent"))

    def hover_and_zoom(self, page, told=r"µ = 0.5, t = .*mean shear"):
        left, top, width, height = page.box("#charts .chart:nth-child(2) svg")
        middle = top + height / 2
        page.mouse("mouseMoved", left + width / 2, middle)
        self.assertRegex(page.evaluate("document.querySelector('.readout').textContent"), told)
        last_tick = "[...document.querySelectorAll('#charts .chart:nth-child(2) text[text-anchor=middle]')].at(-2).textContent"
        whole = float(page.evaluate(last_tick))
        page.mouse("mousePressed", left + 0.3 * width, middle)
        page.mouse("mouseMoved", left + 0.4 * width, middle)
        page.mouse("mouseReleased", left + 0.5 * width, middle)
        self.assertLess(float(page.evaluate(last_tick)), 0.7 * whole)
        page.click(left + 0.5 * width, middle, clicks=2)
        self.assertEqual(float(page.evaluate(last_tick)), whole)

    def choose_another_metric(self, page):
        left, top, width, height = page.box("#metrics button:nth-child(3)")
        page.click(left + width / 2, top + height / 2)
        self.assertEqual(page.evaluate("document.querySelector('#trend .name').textContent"), "Peak sampled current, top")
        left, top, width, height = page.box("#trend circle:nth-of-type(1)")
        page.click(left + width / 2, top + height / 2)
        self.assertEqual(page.evaluate("document.querySelector('#explore [aria-pressed=true]').textContent"), "µ = 0.1")


def write_grid(folder, frictions=(0.1, 0.3, 0.5), preloads=(1, 2, 4), missing=()):
    """A grid of two keys whose shear is their product; point (0.5, 4) has a warning of its own; points in `missing` failed."""
    rows = ["point,folder,contact.friction [1],motion.preload [N],status,reason,peak_mean_shear [1]"]
    for number, (friction, preload) in enumerate(itertools.product(frictions, preloads), 1):
        if (friction, preload) in missing:
            rows.append(f"{number},points/{number:04},{friction},{preload},failed,it broke,")
            continue
        point = folder / "points" / f"{number:04}"
        point.mkdir(parents=True)
        write_run(point)
        shear = 1e-3 * friction * preload
        summary = json.loads((point / "summary.json").read_text())
        summary["metrics"] = {"peak_mean_shear": {"value": shear, "unit": "1"}}
        summary["error_estimate"] = {"peak_mean_shear": 0.1}
        summary["warnings"] = ["It broke at 7 mm."] if (friction, preload) == (0.5, 4) else []
        (point / "summary.json").write_text(json.dumps(summary))
        rows.append(f"{number},points/{number:04},{friction},{preload},finished,,{shear}")
    (folder / "sweep.csv").write_text("\n".join(rows) + "\n")


class Grid(SweepTest):
    """The page of a sweep over two keys: every value of both can be chosen."""

    def test_slices_and_the_whole(self):
        write_grid(self.folder, missing=[(0.3, 2)])
        study = Study(self.folder)
        self.assertEqual([each.at for each in study.slices], ["preload = 1 N", "preload = 2 N", "preload = 4 N"])
        self.assertEqual([[member.value for member in each.members] for each in study.slices],
                         [[0.1, 0.3, 0.5], [0.1, 0.5], [0.1, 0.3, 0.5]])
        self.assertEqual(study.slices[1].note, "Shown at motion.preload = 2 N: 2 of 8 finished points.")
        self.assertIs(study.slices[0], study)
        self.assertEqual(len(study.whole.members), 8)
        self.assertEqual(study.whole.label(study.whole.members[-1]), "µ = 0.5, preload = 4 N")
        self.assertEqual((study.label(study.members[-1]), len(study.members), study.scattered), ("µ = 0.5", 3, False))
        self.assertIs(study.whole.whole, study.whole)

    def test_a_grid_of_very_many_points_is_shown_at_one_value_of_the_second_key(self):
        write_grid(self.folder)
        with mock.patch.object(sweep_results, "MOST_EXPLORED", 8):
            study = Study(self.folder)
            self.assertEqual((study.whole, study.slices), (study, [study]))
            self.assertEqual(sweep_page.answer(study)[1], "Shown at motion.preload = 1 N: 3 of 9 finished points.")
            self.assertEqual([choice["texts"] for choice in sweep_page.data(study)["choices"]], [["µ = 0.1", "µ = 0.3", "µ = 0.5"]])

    def test_a_sweep_over_one_key_is_whole(self):
        write_sweep(self.folder)
        study = Study(self.folder)
        self.assertIs(study.whole, study)
        self.assertEqual(study.slices, [study])

    def test_opens_with_every_point_and_says_which_the_figures_show(self):
        write_grid(self.folder)
        page = make_report(self.folder).read_text()
        self.assertEqual(re.search(r'<p class="lead">(.*)</p>', page)[1],
                         "Peak mean shear: from 0.0001 (± 10 %) at µ = 0.1, preload = 1 N to 0.002 (± 10 %) at µ = 0.5, preload = 4 N.")
        self.assertIn("µ = 0.5, preload = 4 N: It broke at 7 mm.", re.findall("<li>(.*)</li>", page))
        self.assertRegex(page, r'<h2[^>]*>Figures</h2>\s*<p class="note">Shown at motion.preload = 1 N: 3 of 9 finished points.</p>')
        curves = sweep_page.trends.reading(Study(self.folder), "peak_mean_shear").rows[0][0].curves
        self.assertEqual([curve.label for curve in curves], ["preload = 1 N", "preload = 2 N", "preload = 4 N"])

    @unittest.skipUnless(chromium(), "no Chromium on this machine: apt-get install chromium to test the page in it")
    def test_both_keys_are_chosen_by_buttons(self):
        write_grid(self.folder, missing=[(0.3, 2)])
        with browser_page(make_report(self.folder)) as page:
            self.assertEqual(page.evaluate("document.querySelectorAll('#explore .picker').length"), 2)
            self.assertEqual(self.pressed(page), ["µ = 0.3", "preload = 1 N"])
            self.click(page, "#explore .picker:nth-of-type(2) button:nth-child(3)")
            self.assertEqual(self.pressed(page), ["µ = 0.3", "preload = 4 N"])
            self.assertIn("µ = 0.3, preload = 4 N", page.evaluate("document.querySelector('#charts .name').textContent"))
            self.assertEqual(page.evaluate("document.querySelectorAll('#trend path.curve').length"), 3)
            self.assertIn("preload = 4 N", self.trend_texts(page))
            self.click(page, "#explore .picker:nth-of-type(2) button:nth-child(2)")  # its run at 0.3 failed
            self.assertIn(self.pressed(page), [["µ = 0.1", "preload = 2 N"], ["µ = 0.5", "preload = 2 N"]])
            self.click(page, "#keys button:nth-child(2)")
            self.assertIn("4 N", self.trend_texts(page))
            self.assertEqual(page.evaluate("document.querySelectorAll('#trend path.curve').length"), 3)
            self.assertEqual(page.evaluate("document.querySelectorAll('#trend circle').length"), 8)
            friction = self.pressed(page)[0]
            self.click(page, "#trend circle:nth-of-type(1)")  # of another curve
            self.assertNotEqual(self.pressed(page)[0], friction)
            for width in page_faults.WIDTHS:
                self.assertEqual(page_faults.faults(page, width), [])

    def pressed(self, page):
        """Texts of the chosen buttons of Explore."""
        return page.evaluate("[...document.querySelectorAll('#explore [aria-pressed=true]')].map((node) => node.textContent)")

    def trend_texts(self, page):
        """Texts of the chart of metrics."""
        return page.evaluate("[...document.querySelectorAll('#trend text')].map((node) => node.textContent)")

    def click(self, page, selector):
        """Clicks into the middle of an element."""
        left, top, width, height = page.box(selector)
        page.click(left + width / 2, top + height / 2)


def write_sampled_sweep(folder, count=12):
    """Points that differ in two keys at once, one of which is an entry of a list; the metric follows friction alone."""
    rows = ["point,folder,slider.start[0] [m],contact.friction [1],status,reason,peak_mean_shear [1]"]
    for number in range(1, count + 1):
        point = folder / "points" / f"{number:04}"
        point.mkdir(parents=True)
        write_run(point)
        friction, start = 0.1 + 0.03 * number, 0.004 + 1e-4 * (7 * number % count)
        summary = json.loads((point / "summary.json").read_text())
        summary["metrics"]["peak_mean_shear"] = {"value": friction**2, "unit": "1"}
        (point / "summary.json").write_text(json.dumps(summary))
        rows.append(f"{number},points/{number:04},{start:.6g},{friction:.6g},finished,,{friction**2}")
    (folder / "sweep.csv").write_text("\n".join(rows) + "\n")


class SampledSweep(SweepTest):
    def setUp(self):
        super().setUp()
        write_sampled_sweep(self.folder)

    def test_every_point_is_a_member_with_units(self):
        study = Study(self.folder)
        self.assertEqual(study.sweep.keys, {"slider.start[0]": "m", "contact.friction": "1"})
        self.assertTrue(study.scattered)
        self.assertEqual(len(study.members), 12)
        self.assertEqual(study.label(study.members[0]), "start[0] = 4.7 mm, µ = 0.13")

    def test_sensitivity_finds_the_key_that_matters(self):
        found = sensitivity.of_study(Study(self.folder), ["peak_mean_shear"])
        at = dict(zip(found.keys, found.rank[0])), dict(zip(found.keys, found.share[0]))
        self.assertAlmostEqual(at[0]["contact.friction"], 1.0)
        self.assertAlmostEqual(at[1]["contact.friction"], 1.0)
        self.assertLess(abs(at[0]["slider.start[0]"]), 0.5)
        self.assertLess(at[1]["slider.start[0]"], 0.3)

    def test_ranks_of_equal_values_are_shared(self):
        self.assertEqual(list(sensitivity.ranks([3, 1, 3, 2])), [2.5, 0, 2.5, 1])
        self.assertTrue(numpy.isnan(sensitivity.rank_correlation([1, 2], [5, 5])))

    def test_figures_are_points_and_maps_are_left_out(self):
        drawn = dict(make_gallery(self.folder, ["fig07_peaks", "fig10_current_map", "fig21_scatter", "fig22_sensitivity"]))
        self.assertEqual(set(drawn), {"fig10_current_map"})
        self.assertIn("vary at once", drawn["fig10_current_map"])

    def test_texts_of_figures_of_three_keys_stand_apart(self):
        table = self.folder / "sweep.csv"
        head, *rows = table.read_text().splitlines()
        rows = [row.replace(",finished,", f",{0.05 + 0.01 * i},finished,") for i, row in enumerate(rows)]
        table.write_text("\n".join([head.replace(",status,", ",coupling.coefficient [1],status,"), *rows]) + "\n")
        for number in range(1, 13):
            path = self.folder / "points" / f"{number:04}" / "summary.json"
            summary = json.loads(path.read_text())
            summary["metrics"] |= {"time_mean_shear": {"value": 1e-3 * number, "unit": "1"},
                                   "peak_sampled_current_top": {"value": 1e-3 * number, "unit": "A"}}
            path.write_text(json.dumps(summary | {"error_estimate": {"peak_mean_shear": 0.5}}))
        names = ["fig05_shear", "fig07_peaks", "fig15_normalised", "fig20_charge", "fig21_scatter", "fig22_sensitivity"]
        for entry, chart in numbered.charts(Study(self.folder), names):
            with self.subTest(entry.name):
                self.assertEqual(overlapping_texts(draw_chart.draw(chart)), [])
            if entry.name == "fig07_peaks":  # the longest error bar ends within its panel
                cell = chart.rows[0][0]
                self.assertGreater(cell.y.high, 1.5 * cell.curves[0].y.max())

    def test_rising_is_judged_by_ranks(self):
        verdict = next(entry for entry in claims.judge(Study(self.folder)) if "peak of the mean shear rises" in entry.claim)
        self.assertEqual(verdict.verdict, claims.CONDITION)
        self.assertIn("rank correlation 1.00 over 12 points", verdict.number)

    @unittest.skipUnless(chromium(), "no Chromium on this machine: apt-get install chromium to test the page in it")
    def test_scatter_along_every_key_on_a_phone(self):
        with browser_page(make_report(self.folder)) as page:
            page.call("Emulation.setDeviceMetricsOverride", width=390, height=800, deviceScaleFactor=2, mobile=True)
            self.assertEqual(page.evaluate("document.querySelectorAll('#trend circle').length"), 12)
            self.assertEqual(page.evaluate("document.querySelectorAll('#trend path.curve').length"), 0)
            left, top, width, height = page.box("#keys button:nth-child(2)")
            page.click(left + width / 2, top + height / 2)
            self.assertIn("mm", page.evaluate("[...document.querySelectorAll('#trend text')].map(t => t.textContent).join()"))
            self.assertLessEqual(page.evaluate("document.documentElement.scrollWidth"), 390)
            page.evaluate("new Promise(done => setTimeout(done, 300))")
            self.assertGreater(page.evaluate("Math.min(...[...document.querySelectorAll('#charts text')].map("
                                             "t => t.getBoundingClientRect().height))"), 9)
            self.assertEqual(page.overlapping_labels("#charts svg, #trend svg"), [])
            covered = page.evaluate("""[...document.querySelectorAll('#charts svg')].flatMap((svg) => {
                const axis = svg.querySelector('.axis').getBBox();
                return [...svg.querySelectorAll('text[style]')].filter((text) => text.getBBox().y < axis.y + axis.height
                    && text.getBBox().y + text.getBBox().height > axis.y + 1).map((text) => text.textContent); })""")
            self.assertEqual(covered, [])  # names of curves stand beside the curves
            self.assertEqual(page.errors, [])
            for width in page_faults.WIDTHS:
                self.assertEqual(page_faults.faults(page, width), [])


if __name__ == "__main__":
    unittest.main()
