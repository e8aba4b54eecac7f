# SPDX-License-Identifier: Apache-2.0
"""A Studio in a scratch workspace, and a client that speaks to it; shared by the tests of its calls."""

import http.client
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PROGRAM = pathlib.Path(os.environ.get("IONSKIN_PROGRAM", ROOT / "build" / "ionskin"))
QUICK = (ROOT / "cases" / "paper" / "coarse.toml").read_text()


def resident_bytes(process):
    text = pathlib.Path(f"/proc/{process.pid}/status").read_text()
    return int(text.split("VmRSS:")[1].split()[0]) * 1024


class Studio:
    """A running server; `call` sends one request with the cookie of its link, which is redeemed unless told otherwise."""

    def __init__(self, workspace, state, browser=None, redeem=True, program=PROGRAM, **more):
        environment = {**os.environ, "XDG_STATE_HOME": str(state),
                       "BROWSER": str(browser), **more}
        words = [program, "studio", workspace] + ([] if browser else ["--no-browser"])
        self.process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment)
        line = self.process.stdout.readline()
        match = re.search(r"http://127\.0\.0\.1:(\d+)(/\S+)", line)
        if not match:
            raise AssertionError(f"no link: {line!r} {self.process.stderr.read()!r}")
        self.port, self.link, self.cookie = int(match[1]), match[2], ""
        if redeem:
            self.redeem()

    def redeem(self):
        status, headers, _ = self.call("GET", self.link, cookie="")
        assert status == 303, status
        self.set_cookie = headers["Set-Cookie"]
        self.cookie = self.set_cookie.split(";")[0]

    def call(self, method, path, body=None, cookie=None, headers=None):
        """Status, headers and body of an answer."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=120)
        all_headers = {"Cookie": self.cookie if cookie is None else cookie, **(headers or {})}
        if body is not None and not isinstance(body, bytes):
            body = json.dumps(body).encode()
            all_headers.setdefault("Content-Type", "application/json")
        try:
            connection.request(method, path, body, all_headers)
            response = connection.getresponse()
            return response.status, response.headers, response.read()
        finally:
            connection.close()

    def json(self, method, path, body=None, expect=200):
        status, _, text = self.call(method, path, body)
        if status != expect:
            raise AssertionError(f"{path}: {status} {text[:400]}")
        return json.loads(text)

    def run(self, name, case=QUICK, **more):
        return self.json("POST", "/api/jobs", {"kind": "run", "name": name, "case": case, **more}, expect=201)

    def job(self, folder):
        return next(job for job in self.json("GET", "/api/jobs") if job["folder"] == folder)

    def wait(self, folder, when, seconds=300):
        """The job once `when(job)` holds."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            job = self.job(folder)
            if when(job):
                return job
            time.sleep(0.05)
        raise AssertionError(f"{folder}: {self.job(folder)}")

    def end(self, how=signal.SIGINT):
        if self.process.poll() is None:
            self.process.send_signal(how)
        self.process.wait(timeout=60)
        errors = self.process.stderr.read()
        self.process.stdout.close()
        self.process.stderr.close()
        if "Sanitizer" in errors or "runtime error" in errors:
            raise AssertionError(errors)
        return self.process.returncode


class StudioTest(unittest.TestCase):
    """A test with a workspace in `self.folder` and a Studio in it."""

    program = PROGRAM

    def setUp(self):
        scratch = pathlib.Path(tempfile.mkdtemp(prefix="ionskin-studio-"))
        self.addCleanup(shutil.rmtree, scratch, ignore_errors=True)
        self.scratch, self.folder, self.state = scratch, scratch / "workspace", scratch / "state"
        self.folder.mkdir()
        self.environment = {"XDG_STATE_HOME": str(self.state), **self.more_environment()}
        self.studio = self.start()

    def more_environment(self):
        """Further variables of the environment of the Studio."""
        return {}

    def start(self):
        studio = Studio(self.folder, self.state, program=self.program, **self.environment)
        self.addCleanup(lambda: studio.end() if studio.process.returncode is None else None)
        return studio
