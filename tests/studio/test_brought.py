# SPDX-License-Identifier: Apache-2.0
"""A workspace that comes from somebody else: nothing of it is run unasked, and nothing outside it is touched."""

import json
import os
import shutil
import signal
import subprocess
import unittest

from studio_server import PROGRAM, QUICK, StudioTest


def record(name, words, state="queued", **more):
    """A record as the Studio writes it."""
    return {"id": name, "kind": words[0], "folder": words[-1], "words": words, "command": "ionskin run harmless.toml", "python": "import os",
            "memory_bytes": 0, "expected_s": 0, "state": state, "created": 1.0, "started": 1.0, "ended": 0.0, "pid": 0,
            "pid_started": "", "exit_code": 0, "message": "", **more}


class Brought(StudioTest):
    def setUp(self):
        super().setUp()
        self.studio.end()
        self.jobs = self.folder / ".studio" / "jobs"
        self.jobs.mkdir(parents=True, exist_ok=True)
        (self.folder / "brought.toml").write_text(QUICK)

    def plant(self, name, content):
        (self.jobs / name).mkdir()
        text = content if isinstance(content, str) else json.dumps(content)
        (self.jobs / name / "job.json").write_text(text)

    def found(self):
        return [job for job in self.studio.json("GET", "/api/jobs") if job["state"] == "found"]

    def reach_the_end_of_the_queue(self):
        """Waits until the jobs that waited before have run, or never will."""
        self.studio.run("last", QUICK.replace("friction = 0.3", "friction = 0.32"))
        self.studio.wait("last", lambda job: job["state"] in ("finished", "failed"))

    def test_no_record_of_a_folder_is_run_and_each_is_shown_with_what_it_would_run(self):
        outside = self.scratch / "outside"
        for number, state in enumerate(("queued", "running", "stopping", "stopped", "failed")):
            name = str(1700000000000 + number)
            words = ["run", "brought.toml", "-o", str(outside / name), "--no-report"]
            self.plant(name, record(name, words, state, pid=os.getpid(), pid_started="1 0"))
        self.plant("1700000000005", record("1700000000005", ["run", "brought.toml", "-o", "inside"]))
        self.studio = self.start()
        self.assertEqual(len(self.found()), 6)
        for job in self.found():
            self.assertIn("ionskin run brought.toml -o ", job["command"])  # what the record calls its command is none
            self.assertEqual(job["python"], "")
        self.reach_the_end_of_the_queue()
        self.assertFalse(outside.exists())
        self.assertFalse((self.folder / "inside").exists())
        # Asked for, what stays inside is run, and nothing else.
        for job in self.found():
            status = self.studio.call("POST", f"/api/jobs/{job['id']}/resume", {})[0]
            self.assertEqual(status, 200 if job["folder"] == "inside" else 400, job)
        self.studio.wait("inside", lambda job: job["state"] == "finished")
        self.assertFalse(outside.exists())
        self.assertFalse((self.jobs / "1700000000005").exists())

    def test_what_a_record_runs_when_asked_stays_inside(self):
        (self.scratch / "secret.csv").write_text("time [s],current_difference [A]\n0,0\n1,1\n")
        (self.scratch / "results").mkdir()
        (self.folder / "link.csv").symlink_to(self.scratch / "secret.csv")
        (self.folder / "link").symlink_to(self.scratch / "results")
        (self.folder / "reads.toml").write_text(QUICK.replace("[slider]\n", '[slider]\nshape = "profile"\nprofile = "../secret.csv"\n'))
        tried = [["run", "brought.toml", "-o", "../out"], ["run", "brought.toml", "-o", "link"], ["run", "/etc/passwd", "-o", "a"],
                 ["run", "reads.toml", "-o", "a"], ["run", "brought.toml"], ["run", "brought.toml", "-o", "a", "--overwrite"],
                 ["run", "--help"], ["doctor", "brought.toml"], ["cache", "--clear"], ["init", "brought.toml", "-o", "a"], [],
                 ["fit", "brought.toml", "-o", "a", "--data", "link.csv"], ["fit", "brought.toml", "-o", "a", "--data", "../secret.csv"],
                 ["sweep", "brought.toml", "-o", "a", "--over", "slider.profile=../secret.csv"], ["report", "link"], ["report", ".."],
                 ["sweep", "brought.toml", "-o", "a", "--over", 'slider.profile="brought.toml","../secret.csv"'],
                 ["run", "brought.toml", "-o", "a", "-o", "../out"], ["run", "brought.toml", "-o"], ["report", ".studio/jobs"]]
        for number, words in enumerate(tried):
            self.plant(str(number), {"words": words})
        self.studio = self.start()
        found = self.found()
        self.assertEqual(len(found), len(tried))
        for job in found:
            with self.subTest(job["command"]):
                status, _, body = self.studio.call("POST", f"/api/jobs/{job['id']}/resume", {})
                self.assertIn(status, (400, 403, 404, 422), body)
        self.assertEqual(self.found(), found)
        self.assertEqual(os.listdir(self.scratch / "results"), [])

    def test_records_that_name_other_folders_have_nothing_removed(self):
        victim = self.scratch / "victim"
        victim.mkdir()
        (victim / "thesis.tex").write_text("years of work")
        (self.folder / "mine").mkdir()
        (self.folder / "mine" / "data.csv").write_text("1\n")
        names = [str(victim), "../../mine", "../../../victim", "..", ".", "", "x\0y", 7]
        for number in range(600):
            name = str(1600000000000 + number)
            self.plant(name, record(names[number % len(names)], ["run", "a", "-o", "b"], "finished", created=float(number)))
        (self.jobs / "1600000001000").symlink_to(victim)
        self.studio = self.start()
        shown = self.found()
        self.assertLessEqual(len(shown), 100)
        for job in shown:
            self.studio.json("POST", f"/api/jobs/{job['id']}/remove", {})
        self.assertEqual(self.found(), [])
        self.assertEqual((victim / "thesis.tex").read_text(), "years of work")
        self.assertEqual((self.folder / "mine" / "data.csv").read_text(), "1\n")
        self.assertEqual(len(list(self.jobs.iterdir())), 601 - len(shown))

    def test_records_behind_links_are_not_looked_at(self):
        victim = self.scratch / "victim"
        (victim / "1").mkdir(parents=True)
        (victim / "1" / "job.json").write_text(json.dumps(record("1", ["run", "brought.toml", "-o", "a"])))
        for link in (self.jobs, self.folder / ".studio"):
            shutil.rmtree(self.folder / ".studio", ignore_errors=True)
            link.parent.mkdir(exist_ok=True)
            link.symlink_to(victim if link == self.jobs else victim.parent)
            self.studio = self.start()
            self.assertEqual(self.studio.json("GET", "/api/jobs"), [])
            self.studio.end()
            link.unlink()
        self.assertTrue((victim / "1" / "job.json").exists())

    def test_records_that_are_none_do_no_harm(self):
        deep = "[" * 1_000_000
        good = record("1", ["run", "brought.toml", "-o", "a"])
        for number, text in enumerate((deep, '{"words":' + deep, "", "{", "[]", "null", "3", json.dumps({"words": 3}), json.dumps({"words": [3]}),
                                       json.dumps({"words": {"a": "b"}}), json.dumps({**good, "message": "x" * 2_000_000}), "\xff" * 100)):
            self.plant(str(number), text)
        for name, make in (("pipe", os.mkfifo), ("folder", os.mkdir), ("link", lambda path: os.symlink("/dev/zero", path)),
                           ("self", lambda path: os.symlink(path, path))):
            (self.jobs / name).mkdir()
            make(self.jobs / name / "job.json")
        os.mkfifo(self.jobs / "a pipe as the folder")
        (self.scratch / "outside" / "kept").mkdir(parents=True)
        (self.scratch / "outside" / "job.json").write_text(json.dumps(good))
        (self.jobs / "a link as the folder").symlink_to(self.scratch / "outside")
        (self.jobs / "0" / "a link in it").symlink_to(self.scratch / "outside")
        self.studio = self.start()
        found = self.found()
        self.assertEqual(len(found), 18)
        for job in found:
            self.assertEqual(self.studio.call("POST", f"/api/jobs/{job['id']}/resume", {})[0], 422, job)
            self.studio.json("POST", f"/api/jobs/{job['id']}/remove", {})
        self.assertEqual(list(self.jobs.iterdir()), [])
        self.assertEqual(sorted(os.listdir(self.scratch / "outside")), ["job.json", "kept"])

    def test_jobs_that_wait_are_of_this_user_alone(self):
        self.studio = self.start()
        self.studio.run("first", QUICK.replace("friction = 0.3", "friction = 0.33"))
        self.studio.run("waits")
        self.studio.wait("first", lambda job: job["state"] == "running")
        self.studio.end(signal.SIGKILL)
        self.environment["XDG_STATE_HOME"] = str(self.scratch / "of another user")
        self.studio = self.start()
        self.assertEqual([job for job in self.studio.json("GET", "/api/jobs") if job["state"] != "found"], [])
        self.reach_the_end_of_the_queue()
        self.assertEqual(list((self.folder / "waits").iterdir()), [])

    def test_records_lie_where_nobody_else_writes(self):
        state = self.scratch / "state" / "ionskin" / "studio"
        self.assertEqual(state.stat().st_mode & 0o777, 0o700)
        for folder in (state, next(state.iterdir()), next(state.iterdir()) / "jobs"):
            folder.chmod(0o777)
            refused = subprocess.run([PROGRAM, "studio", self.folder, "--no-browser"], capture_output=True, text=True, check=False,
                                     env={**os.environ, **self.environment}, timeout=60)
            folder.chmod(0o700)
            self.assertEqual(refused.returncode, 2)
            self.assertIn("XDG_STATE_HOME", refused.stderr)

    def test_jobs_that_ended_can_be_forgotten(self):
        self.studio = self.start()
        job = self.studio.run("first")
        self.assertEqual(self.studio.call("POST", f"/api/jobs/{job['id']}/remove", {})[0], 409)
        self.studio.json("POST", f"/api/jobs/{job['id']}/cancel", {})
        self.studio.wait("first", lambda one: one["state"] == "stopped")
        self.studio.json("POST", f"/api/jobs/{job['id']}/remove", {})
        self.assertEqual(self.studio.json("GET", "/api/jobs"), [])
        self.assertEqual(self.studio.call("POST", f"/api/jobs/{job['id']}/remove", {})[0], 404)


if __name__ == "__main__":
    unittest.main()
