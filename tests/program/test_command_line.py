# SPDX-License-Identifier: Apache-2.0
"""A mistyped command line is answered with what would be right."""

import json
import pathlib
import sys
import unittest

from program import QUICK, ProgramTest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "benchmarks"))
import physical_cases  # noqa: E402

MISTAKES = (
    (("runn", "x"), '"runn" is not a verb of ionskin', "did you mean run?"),
    (("new", "x.toml"), '"new" is not a verb of ionskin', "did you mean init?"),
    (("nonsense",), '"nonsense" is not a verb of ionskin', "verbs: init, check, run"),
    (("help",), '"help" is not a verb of ionskin', "write ionskin --help"),
    (("init", "x.toml", "--from"), "--from lacks its value", "choose one of paper, quick, finger"),
    (("my.toml",), '"my.toml" is not a verb of ionskin', "ionskin run my.toml --output DIR"),
    (("--verson",), "ionskin has no option --verson", "did you mean --version?"),
    (("run", QUICK, "--friction", "0.2", "-o", "out"), "ionskin run has no option --friction",
     "write --set contact.friction=0.2"),
    (("run", QUICK, "--stroke=3 mm", "-o", "out"), "ionskin run has no option --stroke", '--set "motion.stroke=3 mm"'),
    (("check", QUICK, "--explian"), "ionskin check has no option --explian", "did you mean --explain?"),
    (("--explain", "check", QUICK), "--explain comes before the verb", "ionskin check --explain"),
    (("report", "out", "--explain"), "ionskin report has no option --explain", "it is an option of ionskin check"),
    (("run",), "ionskin run lacks CASE.toml and --output DIR", "write ionskin run CASE.toml --output DIR"),
    (("run", QUICK, "--set", "motion.stroke=3", "mm", "-o", "out"), '"mm" is one word too many for ionskin run', "quotes"),
    (("run", QUICK, "-o", "out", "--only", "mech"), "--only mech is unknown", "did you mean mechanics?"),
    (("run", QUICK, "-o", "out", "--threads", "two"), "--threads: two is not a whole number of at least 1", "--help"),
    (("fit", QUICK, "--data", "semicolons.csv", "--free", "k", "-o", "out"), "--free k: unknown key",
     "did you mean coupling.coefficient?"),
    (("fit", QUICK, "--data", "semicolons.csv", "--free", "friction", "-o", "out"), "unknown key", "contact.friction?"),
    (("fit", QUICK, "--data", "semicolons.csv", "--free", "coupling.coefficient", "-o", "out"),
     "decimal commas and decimal points stand in one file, in lines 2 and 3", "write decimal points"),
)


class CommandLine(ProgramTest):
    def test_mistakes(self):
        self.write("semicolons.csv", "time [s];current_difference [A]\n0;1,5e-6\n1;2.5e-6\n")
        for arguments, problem, remedy in MISTAKES:
            with self.subTest(arguments):
                process = self.run_program(*arguments, expect=2)
                self.assertEqual(process.stdout, "")
                self.assertRegex(process.stderr, r"\Aerror: ")
                error, told = process.stderr.rstrip().split("\n  = ")
                self.assertIn(problem, error)
                self.assertIn(remedy, told)

    def test_random_cases_draw_every_key(self):
        """benchmarks/random_cases.py is run by hand: a key that it does not know would be found out then."""
        keys = json.loads(self.run_program("keys", "--json").stdout)
        self.assertEqual(physical_cases.undrawn_keys(keys), [])

    def test_semicolons_in_a_path_of_waypoints(self):
        case = QUICK.read_text().split("[motion]")[0].replace('start = ["4.5 mm", "1 mm"]\n', "")
        case += '[motion]\nkind = "waypoints"\nfile = "path.csv"\n\n[contact]' + QUICK.read_text().split("[contact]")[1]
        self.write("case.toml", case)
        header = "\ufefftime [s]; x [mm]; y [mm]; height [mm]\r\n0; 4,5; 1; 1\r\n"
        self.write("path.csv", header + "1; 4,5; 1; -0,001\r\n2; 4,5; 1; 1\r\n")
        self.run_program("check", "case.toml")
        self.write("path.csv", header + "1; 4.5; 1; -0,001\r\n2; 4,5; 1; 1\r\n")
        error = self.run_program("check", "case.toml", expect=2).stderr
        self.assertIn("in lines 2 and 3", error)
        self.assertIn("path.csv:3", error)


if __name__ == "__main__":
    unittest.main()
