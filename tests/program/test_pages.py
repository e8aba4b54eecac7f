# SPDX-License-Identifier: Apache-2.0
"""The page of every starter, circuit, friction law, shape, motion and preset, drawn pairwise, opened on a desktop and a telephone."""

import itertools
import json
import re
import subprocess
import sys
import tomllib
import unittest

from program import QUICK, ROOT, SMALL, ProgramTest
from tiers import long_test

sys.path[:0] = [str(ROOT / "python"), str(ROOT / "tests" / "unit" / "results")]
import page_faults  # noqa: E402
from browser import browser_page, chromium  # noqa: E402
from ionskin.page import quantities  # noqa: E402

FACTORS = {
    "starter": ("quick", "finger", "taxels", "reciprocating", "poroelastic", "paper"),
    "circuit": ("amplifier", "short", "open", "load", "parallel-rc"),
    "law": ("coulomb", "saturating", "regularised", "viscous", "stribeck", "anisotropic", "adhesive"),
    "shape": ("flat", "cylinder", "sphere", "profile"),
    "motion": ("touch-slide-lift", "reciprocating", "waypoints"),
    "preset": ("coarse", "standard", "fine"),
}
LAW_KEYS = {"saturating": {"strength": "20 MPa"}, "viscous": {"reference_speed": "3 mm/s"},
            "stribeck": {"kinetic_friction": 0.1, "stribeck_speed": "1 mm/s"}, "anisotropic": {"transverse_friction": 0.1},
            "adhesive": {"work_of_adhesion": "0.5 J/m2", "cohesive_strength": "20 kPa"}}
SHAPE_KEYS = {"flat": {"size": ["1.5 mm", "1 mm"]}, "cylinder": {"size": ["1.5 mm", "1 mm"], "radius": "4 mm"}, "sphere": {"radius": "4 mm"},
              "profile": {"size": ["1.5 mm", "1 mm"], "profile": "heights.csv"}}
REFINEMENT = {"coarse": 0.3, "standard": 0.25, "fine": 0.2}
HEIGHTS = "um,-750,0,750\n-500,40,20,40\n0,20,0,20\n500,40,20,40\n"
FEW = 3  # rows of `make check`


def pairwise(factors):
    """Rows, a value by factor each, in which every pair of values of two factors stands."""
    names = list(factors)
    left = {((a, x), (b, y)) for a, b in itertools.combinations(names, 2) for x in factors[a] for y in factors[b]}
    rows = []
    while left:
        (a, x), (b, y) = min(left)
        row = {a: x, b: y}
        for name in (name for name in names if name not in row):
            def gain(value, name=name):
                return sum(tuple(sorted(((other, taken), (name, value)), key=lambda each: names.index(each[0]))) in left
                           for other, taken in row.items())
            row[name] = max(factors[name], key=gain)
        left -= set(itertools.combinations([(name, row[name]) for name in names], 2))
        rows.append(row)
    return rows


def toml(value):
    """A value as TOML; tables stand in a line."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{json.dumps(name)} = {toml(inner)}" for name, inner in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml, value)) + "]"
    return json.dumps(value)


def case_of(row):
    """The case of a row, small enough to be solved within seconds."""
    case = tomllib.loads((ROOT / "cases" / f"{row['starter']}.toml").read_text())
    case["slider"] = {"shape": row["shape"], **SHAPE_KEYS[row["shape"]]}
    case["contact"] = {"law": row["law"], "friction": 0.15, **LAW_KEYS.get(row["law"], {})}
    middle = float(case["skin"]["width"].split()[0]) / 2
    if row["motion"] == "waypoints":
        ways = (("0 s", 4.5, 0.0, "0.1 mm"), ("0.1 s", 4.5, 0.0, "-0.3 um"), ("0.2 s", 4.8, 0.1, "-0.3 um"), ("0.3 s", 4.8, 0.1, "0.1 mm"))
        case["motion"] = {"kind": "waypoints", "waypoints": [
            {"time": time, "position": [f"{x} mm", f"{middle + y} mm"], "height": height} for time, x, y, height in ways]}
    else:
        case["slider"]["start"] = ["4.5 mm", f"{middle} mm"]
        case["motion"] = {"kind": row["motion"], "gap": "0.1 mm", "preload": "0.3 um", "stroke": "0.5 mm", "touchdown": "0.1 s", "slide": "0.2 s",
                          "lift": "0.1 s", "return": "0.1 s"}
    case.setdefault("readout", {})["circuit"] = row["circuit"]
    finer = 2 if row["law"] == "adhesive" else 1  # its contacts are small
    case["numerics"] = {"preset": row["preset"], "mesh_refinement": finer * REFINEMENT[row["preset"]], "time_refinement": 0.3,
                        "error_estimate": "on" if row["motion"] == "touch-slide-lift" else "off"}
    case["output"] = {"fields": ["0.15 s"]}
    return "".join(f"{json.dumps(name)} = {toml(value)}\n" for name, value in case.items())


class Pages(ProgramTest):
    def draw(self, rows):
        """Runs each row and looks at its page."""
        (self.folder / "heights.csv").write_text(HEIGHTS)
        for row in rows:
            with self.subTest(**row):
                (self.folder / "case.toml").write_text(case_of(row))
                self.run_program("run", "case.toml", "-o", "out", "--overwrite")
                self.look(self.folder / "out" / "report.html")

    def look(self, path):
        """The page opens with what can be read, names every number, and has no fault at any width."""
        text = path.read_text()
        self.assertRegex(text, r'<p class="lead">(An ammeter|An amplifier|A voltmeter|Between the electrodes|The amplifier|Of \d+ taxels) ')
        self.assertNotIn(str(self.folder), text)
        names = re.findall(r"<td><code>([^<]*)</code></td>", text)
        self.assertGreater(len(names), 5)
        self.assertEqual([name for name in names if not quantities.known_words(name)], [])
        if not chromium():
            self.skipTest("no Chromium on this machine: apt-get install chromium to test the pages in it")
        with browser_page(path) as page:
            for width in page_faults.WIDTHS:
                self.assertEqual(page_faults.faults(page, width), [], f"at {width} pixels")

    def test_some(self):
        quick = [row for row in pairwise(FACTORS) if row["preset"] == "coarse" and row["motion"] == "touch-slide-lift"]
        self.draw(quick[:FEW])
        self.draw([row for row in quick if row["starter"] == "poroelastic"][:1])  # whose concentrations have six digits

    @long_test
    def test_all(self):
        self.draw(pairwise(FACTORS))

    @long_test
    def test_starters_without_strokes(self):
        for name, refinement in (("bending", 0.5), ("strain_file", 0.5), ("waypoints", 0.3)):
            with self.subTest(name):
                wrote = self.run_program("init", f"{name}.toml", "--from", name).stdout
                for command in re.findall("First: (.*)", wrote):
                    subprocess.run(command.split(), cwd=self.folder, check=True)
                self.run_program("run", f"{name}.toml", "-o", name, "--set", f"numerics.mesh_refinement={refinement}", "--set",
                                 f"numerics.error_estimate={'off' if name == 'waypoints' else 'on'}")
                self.look(self.folder / name / "report.html")

    def test_taxels_of_their_own_and_resistive_metal(self):
        grid = "readout.taxels={rows = 4, columns = 4}"
        metal = [f"skin.layers[{layer}].sheet_resistance=1 ohm" for layer in (0, 2)]
        for edits in ((grid, "readout.taxel_circuit=open"), (grid, "readout.taxel_circuit=amplifier"), metal):
            with self.subTest(edits[-1]):
                self.run_program("run", QUICK, "-o", "out", "--overwrite", *SMALL, *(word for edit in edits for word in ("--set", edit)))
                self.look(self.folder / "out" / "report.html")

    def test_words_say_what_is_drawn(self):
        """An open circuit has voltages and no currents; a signal that is zero by construction is not above its error."""
        case = ("run", QUICK, "-o", "out", "--overwrite", "--progress", "none", "--set", "numerics.mesh_refinement=0.3", "--set",
                "coupling.law=column-neutral")
        self.run_program(*case, "--set", "readout.circuit=open")
        text = (self.folder / "out" / "report.html").read_text()
        for words, there in (("Voltages are sampled", True), ("Currents are sampled", False), ("no current above rounding", False),
                             ("Prescribed motion", False)):
            self.assertEqual(words in text, there, words)
        said = self.run_program(*case, "--set", "coupling.measure=signed-xz").stdout
        self.assertIn("An ammeter between the electrodes reads nothing", said.splitlines()[0])
        self.assertIn("Currents are sampled", (self.folder / "out" / "report.html").read_text())

    def test_a_page_that_cannot_be_made_is_a_failure_that_is_seen(self):
        (self.folder / "case.toml").write_text(case_of(pairwise(FACTORS)[0]))
        self.run_case("case.toml", "-o", "out")
        signals = self.folder / "out" / "signals.csv"
        signals.write_text(signals.read_text().replace("time [s]", "thyme [s]"))
        failed = self.run_program("report", "out", expect=2)
        self.assertRegex(failed.stderr, "error: .*signals.csv is damaged: it has no column time")
        self.assertNotIn("report.html", failed.stdout)
        self.assertFalse((self.folder / "out" / "report.html").exists())


if __name__ == "__main__":
    unittest.main()
