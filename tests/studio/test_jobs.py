# SPDX-License-Identifier: Apache-2.0
"""Jobs of the Studio: they outlive it, are taken up again, cancelled, resumed; what ran can be run without it."""

import json
import os
import pathlib
import re
import signal
import subprocess
import time
import unittest

from studio_server import PROGRAM, QUICK, ROOT, StudioTest


def command_of(keeper):
    """The process that a keeper watches."""
    children = pathlib.Path(f"/proc/{keeper}/task/{keeper}/children")
    while not children.read_text():
        time.sleep(0.02)
    return int(children.read_text().split()[0])


class Jobs(StudioTest):
    def test_a_run_goes_on_without_the_server_and_is_taken_up_again(self):
        self.studio.run("first")
        self.studio.run("second")
        self.studio.wait("first", lambda job: job["state"] == "running" and job["progress"])
        self.studio.end(signal.SIGKILL)
        again = self.start()
        self.assertIn(again.job("first")["state"], ("running", "finished"))
        again.wait("first", lambda job: job["state"] == "finished")
        again.wait("second", lambda job: job["state"] == "finished")  # waited when the server was ended
        self.assertIn("first", [run["path"] for run in again.json("GET", "/api/runs")])
        command = again.job("first")["command"].split()
        self.assertEqual(command, ["ionskin", "run", "first.toml", "-o", "first", "--no-report"])
        # The same command by hand, elsewhere: the same currents.
        by_hand = [*command[1:4], str(self.scratch / "by_hand"), *command[5:]]
        subprocess.run([os.environ.get("IONSKIN_FRONT", PROGRAM), *by_hand], cwd=self.folder, check=True, capture_output=True,
                       env={**os.environ, **self.environment})
        self.assertEqual((self.folder / "first" / "signals.csv").read_bytes(), (self.scratch / "by_hand" / "signals.csv").read_bytes())

    def test_a_run_that_was_ended_with_the_server_is_resumed(self):
        self.studio.run("first")
        job = self.studio.wait("first", lambda one: one["state"] == "running" and one["progress"] and one["progress"]["fraction"] > 0)
        self.studio.end(signal.SIGKILL)
        os.killpg(job["pid"], signal.SIGKILL)  # as when the machine goes down
        again = self.start()
        stopped = again.wait("first", lambda one: one["state"] == "stopped")
        self.assertIn("kept", stopped["message"])
        again.json("POST", f"/api/jobs/{stopped['id']}/resume", {})
        resumed = again.wait("first", lambda one: one["state"] in ("finished", "failed"))
        self.assertEqual(resumed["state"], "finished", resumed["message"])

    def test_cancel_stops_the_command_and_resume_ends_it(self):
        case = QUICK.replace("friction = 0.3", "friction = 0.31")
        self.studio.run("first", case)
        job = self.studio.wait("first", lambda one: one["state"] == "running" and one["progress"])
        command = command_of(job["pid"])
        self.studio.json("POST", f"/api/jobs/{job['id']}/cancel", {})
        self.studio.wait("first", lambda one: one["state"] == "stopped")
        self.assertFalse(pathlib.Path(f"/proc/{command}").exists())
        self.assertEqual(self.studio.call("POST", f"/api/jobs/{job['id']}/cancel", {})[0], 409)
        self.studio.json("POST", f"/api/jobs/{job['id']}/resume", {})
        self.studio.wait("first", lambda one: one["state"] == "finished")

    def test_the_queue_is_bounded_and_names_are_never_taken_twice(self):
        first = self.studio.run("first")
        second = self.studio.run("first")
        self.assertEqual((first["folder"], second["folder"]), ("first", "first-2"))
        for job in self.studio.json("GET", "/api/jobs"):
            self.studio.json("POST", f"/api/jobs/{job['id']}/cancel", {})
        self.studio.wait("first", lambda one: one["state"] == "stopped")

    def start_with_records(self, records):
        """Replaces the Studio by one that finds these records of jobs of its own, given by their id."""
        self.studio.end()
        jobs = next((self.state / "ionskin" / "studio").iterdir()) / "jobs"
        usual = {"kind": "report", "folder": "none", "words": ["report", "none"], "command": "ionskin report none", "python": "", "memory_bytes": 0,
                 "expected_s": 0, "state": "finished", "created": 1.0, "started": 1.0, "ended": 1.0, "pid": 0, "pid_started": "", "exit_code": 0,
                 "message": ""}
        for name, record in records.items():
            (jobs / name).mkdir()
            (jobs / name / "job.json").write_text(json.dumps({**usual, "id": name, **record}))
        self.studio = self.start()
        return jobs

    def test_no_more_jobs_wait_than_are_allowed_and_none_runs_without_memory(self):
        waiting = {str(number): {"state": "queued", "created": float(number), "memory_bytes": 1e18} for number in range(100, 500)}
        waiting["100"]["folder"] = "first"
        self.start_with_records(waiting)
        status, _, text = self.studio.call("POST", "/api/jobs", {"kind": "run", "name": "one_more", "case": QUICK})
        self.assertEqual(status, 429, text)
        refused = self.studio.wait("first", lambda one: one["state"] == "failed")
        self.assertIn("1e+09 GB of memory", refused["message"])

    def test_old_and_damaged_records_are_dropped(self):
        ended = {str(number): {"created": float(number)} for number in range(100, 620)}
        jobs = self.start_with_records({**ended, "99": {"id": "98"}})
        shown = [job["id"] for job in self.studio.json("GET", "/api/jobs")]
        self.assertEqual(shown, [str(number) for number in range(619, 119, -1)])
        self.assertFalse((jobs / "100").exists())
        self.assertTrue((jobs / "99").exists())  # left out, and left alone

    def test_a_job_that_cannot_run_fails_with_its_reason(self):
        self.start_with_records({"100": {"state": "queued"}})
        refused = self.studio.wait("none", lambda one: one["state"] == "failed")
        self.assertIn("no such file", refused["message"])
        (self.folder / "none").mkdir()
        self.studio.json("POST", "/api/jobs/100/resume", {})
        failed = self.studio.wait("none", lambda one: one["state"] == "failed")
        self.assertNotIn(failed["message"], ("", refused["message"]))
        self.assertNotEqual(failed["exit_code"], 0)

    def test_a_second_studio_in_the_folder_is_refused(self):
        other = subprocess.run([PROGRAM, "studio", self.folder, "--no-browser"], capture_output=True, text=True, check=False,
                               env={**os.environ, **self.environment})
        self.assertEqual(other.returncode, 2)
        self.assertIn("another Studio", other.stderr)

    def test_mistakes_come_with_line_and_key(self):
        case = QUICK.replace("friction = 0.3", "friction = 33").replace('preload = "1 um"', "preload = 3")
        errors = self.studio.json("POST", "/api/case/check", {"text": case})["errors"]
        lines = case.splitlines()
        self.assertEqual({(tuple(one["keys"]), lines[one["line"] - 1]) for one in errors},
                         {(("contact.friction",), "friction = 33"), (("motion.preload",), "preload = 3")})
        edited = self.studio.json("POST", "/api/case/set", {"text": case, "key": "motion.preload", "value": "2 um"})["text"]
        self.assertIn('preload = "2 um"', edited)

    def test_every_case_that_comes_along_has_a_card_and_a_cost(self):
        starters = self.studio.json("GET", "/api/gallery")
        self.assertEqual({starter["id"] for starter in starters}, {path.stem for path in (ROOT / "cases").glob("*.toml")})
        for starter in starters:
            self.studio.json("POST", "/api/gallery/open", {"id": starter["id"]})  # writes the strain file
            with self.subTest(starter["id"]):
                for newtons in re.findall(r'^(?:preload|force) = "(\d+) N"', starter["text"], re.MULTILINE):
                    self.assertIn(f"{newtons} N", starter["summary"])
                cost = self.studio.json("POST", "/api/case/check", {"text": starter["text"]})["cost"]
                self.assertGreater(cost["memory_bytes"], 1e8)
                self.assertGreater(cost["ion_unknowns"], 0)
                self.assertEqual(cost["contact_cells"] == 0, starter["id"] in ("strain_file", "bending"))

    def test_the_page_names_every_package(self):
        packages = json.loads((ROOT / "studio" / "package.json").read_text())
        page = (ROOT / "docs" / "studio.md").read_text()
        for name, version in (packages["dependencies"] | packages["devDependencies"]).items():
            shown = {"three": "three.js", "uplot": "uPlot", "typescript": "TypeScript"}.get(name, name)
            self.assertRegex(page, rf"\n\| {re.escape(shown)}( \([^|]*)? \| {re.escape(version)} \|")

    def test_ctrl_c_ends_the_server(self):
        self.assertEqual(self.studio.end(), 0)


if __name__ == "__main__":
    unittest.main()
