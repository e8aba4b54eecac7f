# SPDX-License-Identifier: Apache-2.0
"""Confinement: files that the Studio starts to write stay in the workspace, though names may have become links since
the Studio looked at them."""

import ctypes
import json
import os
import shutil
import subprocess
import unittest

from studio_server import PROGRAM, QUICK, ROOT, StudioTest

SECRET = "secret_of_this_user"
FRONT = os.environ.get("IONSKIN_FRONT", str(PROGRAM))
CREATE_RULESET, VERSION, WITH_MOVES = 444, 1, 2  # of Landlock
MOTION = "time [s],x [mm],y [mm],height [mm]\n0,4.5,1,1\n1,4.5,1,-0.001\n2,6,1,-0.001\n3,6,1,1\n"


def has_landlock():
    return ctypes.CDLL(None).syscall(CREATE_RULESET, None, 0, VERSION) >= WITH_MOVES


@unittest.skipUnless(has_landlock(), "the kernel has no Landlock")
class Confinement(StudioTest):
    program = PROGRAM.with_name("ionskin-studio")

    def more_environment(self):
        """The Studio starts a script that is as quick as an attacker can be: it swaps, and becomes ionskin."""
        front = self.scratch / "bin" / "ionskin"
        front.parent.mkdir()
        front.write_text(f'#!/bin/sh\n. {front.parent}/swap\nexec {FRONT} "$@"\n')
        front.chmod(0o755)
        self.swap("none")
        self.outside = self.scratch / "outside"
        self.outside.mkdir()
        return {"IONSKIN_FRONT": str(front)}

    def swap(self, command, name="", target=""):
        """Before this command begins, `name` becomes a link."""
        (self.scratch / "bin" / "swap").write_text(f'[ "$1" = {command} ] && mv "{name}" aside && ln -s "{target}" "{name}"\n')

    def ended(self, folder):
        return self.studio.wait(folder, lambda job: job["state"] not in ("queued", "running"))

    def result(self, name):
        subprocess.run([FRONT, "run", ROOT / "cases" / "paper" / "coarse.toml", "-o", self.folder / name, "--only", "mechanics", "--no-report",
                        "--set", "numerics.mesh_refinement=0.3", "--set", "numerics.error_estimate=off"], check=True, capture_output=True)
        return self.folder / name

    def test_results_are_written_nowhere_else(self):
        self.swap("run", "a", self.outside)
        self.studio.run("a")
        job = self.ended("a")
        self.assertEqual((job["state"], job["exit_code"]), ("failed", 2), job)
        self.assertEqual(os.listdir(self.outside), [])

    def test_no_case_is_read_elsewhere(self):
        secret = self.outside / "secret.toml"
        secret.write_text(QUICK + f'{SECRET} = "1"\n')
        self.swap("run", "a.toml", secret)
        self.studio.run("a")
        job = self.ended("a")
        self.assertEqual((job["state"], job["exit_code"]), ("failed", 2), job)
        self.assertNotIn(SECRET, json.dumps(job))
        self.swap("check", "$2", secret)
        verdict = self.studio.json("POST", "/api/case/check", {"text": QUICK})
        self.assertFalse(verdict["valid"])
        self.assertNotIn(SECRET, json.dumps(verdict))

    def test_no_file_that_a_case_names_is_read_elsewhere(self):
        (self.folder / "way.csv").write_text(MOTION)
        secret = self.outside / "secret.csv"
        secret.write_text(MOTION + f"{SECRET},1,1,1\n")
        before, after = QUICK.split("start = [")[0], "[contact]" + QUICK.split("[contact]")[1].split("[output]")[0]
        self.swap("run", "way.csv", secret)
        self.studio.run("a", before + '[motion]\nkind = "waypoints"\nfile = "way.csv"\n' + after)
        job = self.ended("a")
        self.assertEqual((job["state"], job["exit_code"]), ("failed", 2), job)
        self.assertNotIn(SECRET, json.dumps(job))

    def test_reports_are_drawn_nowhere_else(self):
        shutil.copytree(self.result("a"), self.outside / "a")
        before = os.listdir(self.outside / "a")
        self.swap("report", "a", self.outside / "a")
        self.studio.json("POST", "/api/jobs", {"kind": "report", "path": "a"}, expect=201)
        self.assertEqual(self.ended("a")["state"], "failed")
        self.assertEqual(os.listdir(self.outside / "a"), before)

    def test_no_result_is_compared_from_elsewhere(self):
        shutil.copytree(self.result("a"), self.folder / "b")
        summary = json.loads((self.folder / "a" / "summary.json").read_text())
        summary["metrics"][SECRET] = {"value": 1, "unit": "N"}
        (self.outside / "summary.json").write_text(json.dumps(summary))
        self.swap("compare", "b/summary.json", self.outside / "summary.json")
        status, _, body = self.studio.call("GET", "/api/compare?first=a&second=b")
        self.assertEqual(status, 422, body)
        self.assertNotIn(SECRET.encode(), body)

    def test_what_is_not_swapped_goes_as_ever(self):
        self.studio.run("a")
        self.assertEqual(self.ended("a")["state"], "finished")
        self.studio.json("POST", "/api/jobs", {"kind": "report", "path": "a"}, expect=201)
        job = self.studio.wait("a", lambda one: one["kind"] == "report" and one["state"] not in ("queued", "running"))
        self.assertEqual(job["state"], "finished", job)
        self.assertTrue((self.folder / "a" / "report.html").exists())


if __name__ == "__main__":
    unittest.main()
