# SPDX-License-Identifier: Apache-2.0
"""Text on the terminal while a case runs: the progress, whatever the width and where it goes."""

import fcntl
import html
import json
import os
import pty
import re
import shlex
import struct
import subprocess
import sys
import termios
import unittest

from program import PROGRAM, QUICK, ROOT, SMALL, ProgramTest, summary

sys.path.insert(0, str(ROOT / "python"))
from ionskin.page import quantities  # noqa: E402

FINGER = ROOT / "cases" / "finger.toml"
# A sphere, whose contact is looked for first.
SPHERE = ("run", FINGER, "-o", "out", "--no-report", "--set", "numerics.preset=coarse",
          "--set", "numerics.mesh_refinement=0.5", "--set", "numerics.time_refinement=0.3", "--set", "motion.cycles=1")


class Terminal(ProgramTest):
    def on_terminal(self, columns, *arguments, expect=0):
        """Text that the program writes on a terminal of so many columns."""
        first, second = pty.openpty()
        fcntl.ioctl(second, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
        process = subprocess.Popen([PROGRAM, *map(str, arguments)], stdin=second, stdout=second, stderr=second,
                                   cwd=self.folder, env={**os.environ, "TERM": "xterm"})
        os.close(second)
        text = b""
        while True:
            try:
                part = os.read(first, 65536)
            except OSError:  # the other end is closed
                break
            if not part:
                break
            text += part
        os.close(first)
        self.assertEqual(process.wait(), expect, text.decode())
        return text.decode().replace("\r\n", "\n")

    def assert_progress(self, states):
        """States in order: (activity, percentage); each activity goes forward and reaches 100 %."""
        names = [name for index, (name, _) in enumerate(states) if index == 0 or states[index - 1][0] != name]
        self.assertEqual(len(names), len(set(names)), names)
        self.assertLessEqual({"contact footprint", "mechanics", "strain history", "ion transport"}, set(names))
        for activity in names:
            percentages = [value for name, value in states if name == activity]
            self.assertEqual(percentages, sorted(percentages), activity)
            self.assertEqual(percentages[-1], 100, activity)
        return names

    def test_cost_of_a_sweep_fits_the_terminal(self):
        text = self.on_terminal(80, "sweep", QUICK, *SMALL, "-o", "out", "--explain", "--over", "contact.friction=0.1:0.5", "--over",
                                "motion.preload=0.5:1.5 um", "--samples", 20)
        self.assertIn("about ", text)
        self.assertLessEqual(max(map(len, text.splitlines())), 80, text)

    def test_command_of_a_run_can_be_typed_again(self):
        words = ["run", str(QUICK), "-o", "an out", "--only", "mechanics", "--no-report", "--set", 'motion.preload="1 um"',
                 "--set", "numerics.mesh_refinement=0.3"]
        self.run_program(*words)
        command = json.loads((self.folder / "an out" / "manifest.json").read_text())["command"]
        self.assertEqual(shlex.split(command), ["ionskin", *words])

    def test_bar_fits_the_terminal(self):
        for columns in (80, 40):
            text = self.on_terminal(columns, *SPHERE, "--overwrite")
            pictures = [picture for picture in re.findall(r"\r([^\r\n]*)", text) if " %" in picture]
            self.assertLess(max(map(len, pictures)), columns)
            found = [re.match(r"(.*?) *(?:\[[#.]+\])? +(\d+) %", picture) for picture in pictures]
            names = self.assert_progress([(match[1], int(match[2])) for match in found])
            # One line each, however often it is drawn.
            self.assertEqual(sum("%" in line and line.startswith("\r") for line in text.split("\n")), len(names))
            self.assertEqual("[###" in text, columns == 80)
            self.assertIn("left", text)

    def test_lines_in_a_log(self):
        process = self.run_program(*SPHERE)
        lines = process.stderr.splitlines()
        found = [re.fullmatch(r"(.*): (\d+) % after [\d.]+ s(, about .* left)?", line) for line in lines]
        self.assertTrue(all(found), lines)
        self.assert_progress([(match[1], int(match[2])) for match in found])

    def test_progress_on_request(self):
        process = self.run_case(QUICK, *SMALL, "-o", "json", "--progress", "json")
        states = [json.loads(line) for line in process.stderr.splitlines()]
        self.assertEqual(set(states[0]), {"activity", "fraction", "elapsed_s", "time_left_s"})
        self.assertIsNone(states[0]["time_left_s"])
        self.assertEqual(states[-1]["time_left_s"], 0)
        for activity in {state["activity"] for state in states}:
            fractions = [state["fraction"] for state in states if state["activity"] == activity]
            self.assertEqual(fractions, sorted(fractions))
            self.assertEqual(fractions[-1], 1, activity)
        process = self.run_case(QUICK, *SMALL, "-o", "none", "--progress", "none")
        self.assertEqual(process.stderr, "")
        self.assertIn("results: none", process.stdout)
        self.assertIn("[####", self.run_case(QUICK, *SMALL, "-o", "bar", "--progress", "bar").stderr)
        self.assertIn("100 % after", self.run_case(QUICK, *SMALL, "-o", "lines", "--progress", "lines").stderr)

    def test_warnings_are_shown(self):
        arguments = ("run", QUICK, *SMALL, "-o", "out", "--no-report", "--progress", "none")
        lines = [line for line in self.run_program(*arguments).stdout.splitlines() if line.startswith("warning: ")]
        self.assertEqual([line.removeprefix("warning: ") for line in lines], summary(self.folder / "out")["warnings"])
        text = self.on_terminal(60, *arguments, "--overwrite")
        shown = text[text.index("warning: "):].splitlines()[:-2]
        self.assertLessEqual(max(map(len, shown)), 60)
        self.assertEqual(" ".join(line.strip() for line in shown), " ".join(lines))

    def test_results_are_reported_as_on_the_page(self):
        said = self.run_program("run", QUICK, "-o", "out", "--progress", "none", "--set", "numerics.mesh_refinement=0.3").stdout
        lead = re.search(r'<p class="lead">(.*?)</p>', (self.folder / "out" / "report.html").read_text())[1]
        self.assertEqual(said.splitlines()[0], html.unescape(re.sub("<[^>]*>", "", lead)))
        self.assertRegex(said, r"\nNormal force, mid-slide +6\d(\.\d)? N ± [\d.]+ % +normal_force_slide\n")
        self.assertRegex(said, r"\nPeak sampled difference current +\d{3} µA ± [\d.]+ % +peak_sampled_current_difference\n")
        rows = said[said.index("Normal force"):said.index("warning:")].splitlines()
        self.assertTrue(all(quantities.known_words(row.split()[-1]) == row.split("  ")[0] for row in rows), rows)
        digits = [number.replace(".", "").lstrip("0") for number in re.findall(r"[\d.]+", " ".join(rows))]
        self.assertLessEqual(max(map(len, digits)), 3, rows)
        for edits, words in ((("--only", "mechanics"), "Mean shear, mid-slide"), (("--set", "readout.circuit=open"), "Peak voltage")):
            self.assertIn(words, self.run_program("run", QUICK, *SMALL, "-o", "out", "--overwrite", "--no-report", *edits).stdout)

    def test_without_python_the_file_of_the_numbers_is_named(self):
        said = self.run_program("run", QUICK, *SMALL, "-o", "out", "--no-report", env={**os.environ, "IONSKIN_PYTHON_PATH": "/nowhere"})
        self.assertIn("numbers: out/summary.json\n", said.stdout)

    def test_instants_of_a_long_path_are_summarised(self):
        rows = [f"{1 + i}, {4 + i % 2}, 1, , 1" for i in range(1000)]
        self.write("path.csv", "\n".join(["time [s], x [mm], y [mm], height [um], force [N]", "0, 4, 1, 1000,", *rows,
                                          "1001, 5, 1, 1000,"]))
        case = QUICK.read_text().split("[motion]")[0] + '[motion]\nkind = "waypoints"\nfile = "path.csv"\n'
        case += "\n[contact]" + QUICK.read_text().split("[contact]")[1]
        case = case.replace('start = ["4.5 mm", "1 mm"]\n', "")
        text = self.run_program("check", self.write("case.toml", case), "--explain").stdout
        instants = text[text.index("Instants of each cycle"):text.index("Size and cost")]
        self.assertEqual(instants.count("\n"), 19)
        self.assertRegex(instants, r"\.\.\. +98\d more +9\d\d x slide begins")
        self.assertRegex(instants, r"lift-off begins +1000 s\n")


if __name__ == "__main__":
    unittest.main()
