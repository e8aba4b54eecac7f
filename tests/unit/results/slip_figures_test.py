# SPDX-License-Identifier: Apache-2.0
"""Figures of the onset of a slide, read from hand-made runs and sweeps."""

import json
import pathlib
import shutil
import tempfile
import unittest

import h5py
import numpy

from ionskin import CaseError, Results, Study
from ionskin.analysis import slip
from ionskin.charts import onset, trends
from ionskin.drawing import draw_chart
from report_test import write_run
from sweep_report_test import FRICTIONS, overlapping_texts, write_sweep

BEGIN = 1.0  # of the slide of a hand-made run [s]
METRICS = {"micro_slip_time": (0.02, "s"), "full_slip_time": (0.1, "s"), "slip_lead_time": (0.08, "s"),
           "precursor_noise_floor": (1e-9, "A"), "precursor_current_difference": (2e-6, "A"),
           "precursor_lead_time_difference": (0.05, "s"), "precursor_correlation_difference": (0.94, "1")}


def add_metrics(folder, metrics, errors=None):
    """Metrics, name to value and unit, and stated errors into the summary of a run."""
    summary = json.loads((folder / "summary.json").read_text())
    summary["metrics"].update({name: {"value": value, "unit": unit} for name, (value, unit) in metrics.items()})
    summary["error_parts"] = {name: {"path": error} for name, error in (errors or {}).items()}
    (folder / "summary.json").write_text(json.dumps(summary))


def crowded_words(figure):
    """Texts over one another, ticks left out: matplotlib keeps those beyond the limits, unseen."""
    return [pair for pair in overlapping_texts(figure) if all(any(letter.isalpha() for letter in text) and "$" not in text
                                                              for text in pair)]


def write_onset(folder):
    """A half model of 2 x 3 cells: the rim slips from the start, one cell after 40 ms, one after 100 ms; one never touches."""
    with h5py.File(folder / "results.h5", "w") as file:
        file["contact/grid/x"] = numpy.array([-1.5, -0.5, 0.5, 1.5]) * 1e-3
        file["contact/grid/y"] = numpy.array([-1.0, -0.5, 0.0]) * 1e-3
        # Ten states, whose names do not stand in the order of time.
        for number, since in ((9, 0.02), (10, 0.04), (11, 0.1)):
            group = file.create_group(f"contact/onset_{number}")
            group.attrs["parameter"] = BEGIN + since
            group["slip_state"] = [[0, 3, 3], [3, 1 if since < 0.04 else 3, 1 if since < 0.1 else 3]]
            group["slip_since_landing"] = numpy.full((2, 3), since * 1e-4)
    head, *rows = (folder / "signals.csv").read_text().splitlines()
    rest = ",0.001,1e-6,0.5,1e-6,2"  # slider_y and the columns of the contact
    (folder / "signals.csv").write_text("\n".join([head, *(row + rest for row in rows)]) + "\n")


class SlipTest(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="ionskin-slip-"))
        self.addCleanup(shutil.rmtree, self.folder)


class Onset(SlipTest):
    def test_instants_of_the_run(self):
        write_run(self.folder)
        self.assertIsNone(slip.onset(Results(self.folder)))
        add_metrics(self.folder, METRICS)
        found = slip.onset(Results(self.folder))
        self.assertEqual((found.begin, found.micro, found.full), (BEGIN, 1.02, 1.1))
        short = {"micro_slip_time": METRICS["micro_slip_time"], "full_slip_time": (None, "s")}
        add_metrics(self.folder, short)
        self.assertIsNone(slip.onset(Results(self.folder)).full)

    def test_when_and_how_far_cells_slip(self):
        write_run(self.folder)
        write_onset(self.folder)
        with h5py.File(self.folder / "results.h5") as file:
            times = slip.release_times(file, BEGIN)
            numpy.testing.assert_allclose(times, [[numpy.nan, 0, 0], [0, 0.04, 0.1]])
            way = slip.slip_at(file, BEGIN + 0.05)
            numpy.testing.assert_allclose(way, [[numpy.nan, 4e-6, 4e-6], [4e-6, 4e-6, 4e-6]])

    def test_a_run_has_a_figure_of_its_onset(self):
        write_run(self.folder)
        self.assertIsNone(onset.onset(Results(self.folder)))
        add_metrics(self.folder, METRICS)
        write_onset(self.folder)
        figure = draw_chart.draw(onset.onset(Results(self.folder)))
        titles = [axes.get_title(loc="left") for axes in figure.axes]
        for words in ("When it slips", "Slipped by full slip", "Part of the contact that sticks",
                      "Difference current, correlation with the stuck share 0.94", "Common current"):
            self.assertIn(words, titles)
        self.assertEqual(crowded_words(figure), [])


class Fields(SlipTest):
    def test_a_file_that_was_found_plain_is_looked_at_again_once_it_is_another(self):
        write_run(self.folder)
        write_onset(self.folder)
        results = Results(self.folder)
        for _ in range(2):
            results.open_fields().close()
        with h5py.File(self.folder / "results.h5", "a") as file:
            file["elsewhere"] = h5py.ExternalLink("/etc/hostname", "/")
        with self.assertRaisesRegex(CaseError, "link to elsewhere"):
            results.open_fields()


class Window(SlipTest):
    def write(self, lead=0.05, noise=1e-9, error=1e-7, lead_error=0.0):
        """A sweep whose difference current is seen above µ = 0.25 only."""
        write_sweep(self.folder)
        for number, friction in enumerate(FRICTIONS, 1):
            metrics = dict(METRICS, precursor_noise_floor=(noise, "A"))
            if friction < 0.25:
                del metrics["precursor_lead_time_difference"]
            else:
                metrics["precursor_lead_time_difference"] = (lead, "s")
            point = self.folder / "points" / f"{number:04}"
            add_metrics(point, metrics, {"precursor_current_difference": error, "precursor_lead_time_difference": lead_error})
            (point / "sampled.csv").write_text("time [s],current_difference [A]\n0.01,1e-6\n0.02,1e-6\n")
        return Study(self.folder)

    def words(self, **what):
        study = self.write(**what)
        precursors = {current: [slip.precursor(member.results, current) for member in study.members] for current in slip.CURRENTS}
        words = trends.window_words(study, precursors)
        shutil.rmtree(self.folder)
        self.folder.mkdir()
        return words

    def test_is_where_a_reading_falls_between_and_stands_out(self):
        self.assertEqual(self.words(), "recognised at 0.3–0.5")
        self.assertEqual(self.words(lead_error=0.0401), "no window", "the lead may be shorter than the interval")
        self.assertEqual(self.words(lead=0.009), "no window", "shorter than the interval between readings")
        self.assertEqual(self.words(noise=1e-6), "no window", "within three times the noise")
        self.assertEqual(self.words(error=1.9999e-6), "no window", "within the stated error")

    def test_names_each_part_of_a_window(self):
        study = self.write()
        yes, no = (slip.Precursor(1.0, 0.0, 0.1, lead, 0.0, 0.5) for lead in (1.0, 0.1))
        self.assertEqual(trends.window_words(study, {"difference": [yes, yes, no, no, yes]}), "recognised at 0.1–0.2, 0.5")

    def test_is_drawn_of_a_sweep_alone(self):
        chart = trends.friction_window(self.write())
        self.assertEqual(crowded_words(draw_chart.draw(chart)), [])
        self.assertEqual(chart.note, "Recognised at 0.3–0.5.")
        self.assertIn("sweep contact.friction", trends.friction_window(Study(self.folder / "points" / "0001")))

    def test_shows_a_departure_below_the_noise_or_says_that_there_is_none(self):
        cell = trends.friction_window(self.write(noise=1e-3)).rows[0][1]
        self.assertEqual([curve.label for curve in cell.curves], ["difference", "3 × noise floor"])
        for number in range(1, len(FRICTIONS) + 1):
            path = self.folder / "points" / f"{number:04}" / "summary.json"
            summary = json.loads(path.read_text())
            del summary["metrics"]["precursor_current_difference"]
            path.write_text(json.dumps(summary))
        cell = trends.friction_window(Study(self.folder)).rows[0][1]
        self.assertEqual((cell.curves, [note.words for note in cell.notes]), ((), ["no reading falls before full slip"]))


if __name__ == "__main__":
    unittest.main()
