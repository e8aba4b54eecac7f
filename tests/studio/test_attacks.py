# SPDX-License-Identifier: Apache-2.0
"""Attacks that a stranger may try on the Studio: other hosts and pages, paths out, scripts, floods."""

import concurrent.futures
import json
import os
import pathlib
import shutil
import socket
import unittest

import h5py

from studio_server import QUICK, ROOT, StudioTest, resident_bytes


class Attacks(StudioTest):
    def test_only_its_own_host_and_pages_are_answered(self):
        own = f"127.0.0.1:{self.studio.port}"
        for headers in ({"Host": "evil.example"}, {"Host": f"evil.example:{self.studio.port}"}, {"Host": "127.0.0.1"},
                        {"Origin": "http://evil.example"}, {"Origin": "null"}, {"Origin": "http://127.0.0.1:1"},
                        {"Sec-Fetch-Site": "cross-site"}):
            with self.subTest(headers=headers):
                status, answer, _ = self.studio.call("GET", "/api/runs", headers=headers)
                self.assertEqual(status, 403)
                self.assertNotIn("Access-Control-Allow-Origin", answer)
                self.assertEqual(self.studio.call("POST", "/api/jobs", {"kind": "run"}, headers=headers)[0], 403)
        self.assertEqual(self.studio.call("GET", "/api/runs", headers={"Origin": f"http://{own}"})[0], 200)

    def test_without_the_cookie_nothing_is_answered(self):
        for path in ("/", "/app.js", "/api/runs", "/api/keys", "/api/events", "/nowhere"):
            for cookie in ("", "ionskin_studio=1", self.studio.cookie[:-1], self.studio.cookie + "0"):
                self.assertEqual(self.studio.call("GET", path, cookie=cookie)[0], 401, path)
        self.assertEqual(self.studio.call("POST", "/api/jobs", {"kind": "run"}, cookie="")[0], 401)

    def test_the_link_works_once(self):
        self.assertEqual(self.studio.call("GET", self.studio.link, cookie="")[0], 403)
        self.assertEqual(self.studio.call("GET", "/open/0000", cookie="")[0], 403)
        for word in ("HttpOnly", "SameSite=Strict"):
            self.assertIn(word, self.studio.set_cookie)

    def test_it_listens_on_the_loopback_alone(self):
        lines = pathlib.Path("/proc/net/tcp").read_text().splitlines()[1:]
        hosts = [line.split()[1].split(":")[0] for line in lines
                 if line.split()[3] == "0A" and int(line.split()[1].split(":")[1], 16) == self.studio.port]
        self.assertEqual(hosts, ["0100007F"])

    def test_paths_stay_inside_the_workspace(self):
        (self.scratch / "secret.csv").write_text("time [s],a [A]\n0,1\n")
        (self.scratch / "outside").mkdir()
        (self.scratch / "outside" / "signals.csv").write_text("time [s]\n0\n")
        (self.folder / "link.csv").symlink_to(self.scratch / "secret.csv")
        (self.folder / "folder").symlink_to(self.scratch / "outside")
        for path in ("../secret.csv", "%2e%2e/secret.csv", "a/../../secret.csv", "/etc/passwd", "link.csv",
                     "folder/signals.csv", ".studio/lock", "..", "x%00y"):
            for call in ("text", "download", "result"):
                status, _, body = self.studio.call("GET", f"/api/{call}?path={path}")
                self.assertEqual(status, 403, f"{call} {path} {body[:100]}")
        self.assertEqual(self.studio.call("GET", "/api/table?path=folder&name=signals")[0], 403)
        self.assertEqual(self.studio.call("GET", "/api/table?path=.&name=../../secret")[0], 404)
        self.assertEqual(self.studio.json("GET", "/api/runs"), [])
        self.assertEqual(self.studio.json("GET", "/api/files")["data"], [])

    def test_names_of_results_are_plain(self):
        for name in ("../out", "a/b", "-o", ".hidden", "a b", "$(id)", "<script>", "a\0b", "x" * 200):
            body = {"kind": "run", "name": name, "case": QUICK, "dry": True}
            self.assertEqual(self.studio.call("POST", "/api/jobs", body)[0], 400, name)
            quoted = name.encode().hex()
            status, _, _ = self.studio.call("POST", "/api/upload?name=" + "".join(f"%{quoted[i:i + 2]}" for i in
                                            range(0, len(quoted), 2)) + ".csv", b"time [s]\n", headers={"Content-Type": "text/csv"})
            self.assertEqual(status, 400, name)

    def test_a_case_may_not_name_files_outside(self):
        case = QUICK.replace('[slider]\n', '[slider]\nshape = "profile"\nprofile = "/etc/passwd"\n')
        verdict = self.studio.json("POST", "/api/case/check", {"text": case})
        self.assertFalse(verdict["valid"])
        self.assertEqual(self.studio.call("POST", "/api/jobs", {"kind": "run", "name": "a", "case": case})[0], 422)

    def test_no_word_of_a_request_is_an_option_or_a_shell_command(self):
        (self.folder / "--overwrite.csv").write_text("time [s],current_difference [A]\n0,0\n1,1e-6\n")
        body = {"kind": "fit", "name": "a", "case": QUICK, "data": "--overwrite.csv", "column": "current_difference",
                "free": ["coupling.coefficient"], "dry": True}
        self.assertIn("--data ./--overwrite.csv", self.studio.json("POST", "/api/jobs", body)["command"])
        for values in (["0.1;id"], ["0.1,0.2"], ["0.1\n"], [""]):
            body = {"kind": "sweep", "name": "a", "case": QUICK, "over": [{"key": "contact.friction", "values": values}]}
            status, _, text = self.studio.call("POST", "/api/jobs", {**body, "dry": True})
            if status == 200:  # kept as one word
                self.assertIn("'contact.friction=0.1;id'", json.loads(text)["command"])
            else:
                self.assertEqual(status, 400)
        body["over"] = [{"key": "contact.friction=1 -o /tmp", "values": ["1"]}]
        self.assertEqual(self.studio.call("POST", "/api/jobs", body)[0], 400)

    def test_texts_of_cases_and_files_come_as_data(self):
        script = "<script>alert(1)</script>"
        folder = self.folder / script.replace("/", "_")
        folder.mkdir()
        (folder / "manifest.json").write_text(json.dumps({"state": script}))
        (folder / "case.toml").write_text(f'title = "{script}"\n')
        (self.folder / f"{script.replace('/', '_')}.csv").write_text(f"{script}\n")
        for path in ("/api/runs", "/api/files"):
            _, headers, body = self.studio.call("GET", path)
            self.assertTrue(headers["Content-Type"].startswith("application/json"))
            self.assertIn(b"<script>", body)
            self.assertEqual(headers["X-Content-Type-Options"], "nosniff")
            self.assertIn("default-src 'self'", headers["Content-Security-Policy"])
            self.assertNotIn("unsafe", headers["Content-Security-Policy"])
        (self.folder / "page.html").write_text("<script>alert(1)</script>")
        _, headers, _ = self.studio.call("GET", "/api/download?path=page.html")
        self.assertEqual((headers["Content-Disposition"], headers["Content-Type"]), ("attachment", "application/octet-stream"))
        case = QUICK.replace('material = "nafion"', f'material = "{script}"')
        verdict = self.studio.json("POST", "/api/case/check", {"text": case})
        self.assertIn(script, json.dumps(verdict))

    def test_a_results_file_that_crashes_the_library_is_refused(self):
        (self.folder / "run").mkdir()
        results = self.folder / "run" / "results.h5"
        shutil.copy(ROOT / "fuzz" / "corpus" / "strain_file" / "crashes_hdf5.h5", results)
        with h5py.File(results, "r+") as file:
            file["strain"] = file["/"]  # an attribute of this group crashes the library
        for call in ("fields?path=run", "field?path=run&group=strain&frame=0&name=gamma"):
            status, _, body = self.studio.call("GET", f"/api/{call}")
            self.assertEqual(status, 422, body)
            self.assertIn(b"write the file again", body)
        results.unlink()
        os.mkfifo(results)
        self.assertIn(self.studio.call("GET", "/api/fields?path=run")[0], (403, 404, 422))
        self.assertEqual(self.studio.json("GET", "/api/runs"), [])

    def test_a_large_body_is_refused_before_it_is_read(self):
        head = (f"POST /api/jobs HTTP/1.1\r\nHost: 127.0.0.1:{self.studio.port}\r\nCookie: {self.studio.cookie}\r\n"
                "Content-Type: application/json\r\n")
        before = resident_bytes(self.studio.process)
        for more, status in (("Content-Length: 1000000000\r\n", b"413"), ("Transfer-Encoding: chunked\r\n", b"411"), ("", b"411"),
                             ("Content-Length: 1000000000\r\nExpect: 100-continue\r\n", b"413"),
                             ("Content-Length: 5\r\nContent-Length: 1000000000\r\n", b"411"), ("Content-Length: -1\r\n", b"413"),
                             ("Content-Length: 100\r\nContent-Encoding: gzip\r\n", b"411")):
            with self.subTest(more=more), socket.create_connection(("127.0.0.1", self.studio.port), timeout=30) as line:
                line.sendall((head + more + "\r\n").encode())
                self.assertIn(status, line.recv(4096).split(b"\r\n")[0])
        # Streamed: the server closes the line long before a gigabyte went through it.
        with socket.create_connection(("127.0.0.1", self.studio.port), timeout=30) as line:
            line.sendall((head + "Content-Length: 1000000000\r\n\r\n").encode())
            sent = 0
            try:
                while sent < 1_000_000_000:
                    sent += line.send(b"x" * 65536)
            except OSError:
                pass
            self.assertLess(sent, 100_000_000)
        self.assertLess(resident_bytes(self.studio.process) - before, 50_000_000)
        self.assertEqual(self.studio.call("GET", "/api/runs")[0], 200)

    def test_a_measurement_has_16_mib_at_most_and_deep_json_does_no_harm(self):
        for size, expect in ((8 << 20, 201), (17 << 20, 413)):
            try:
                status = self.studio.call("POST", "/api/upload?name=a.csv", b"x" * size, headers={"Content-Type": "text/csv"})[0]
            except OSError:  # closed while it was sent
                status = 413
            self.assertEqual(status, expect)
        deep = b'{"text":' + b"[" * 1_000_000
        self.assertEqual(self.studio.call("POST", "/api/case/check", deep, headers={"Content-Type": "application/json"})[0], 400)
        nested = "a = " + "[" * 100_000
        self.assertFalse(self.studio.json("POST", "/api/case/check", {"text": nested})["valid"])
        self.assertEqual(self.studio.call("GET", "/api/runs")[0], 200)

    def test_other_types_of_values_are_refused(self):
        for body in ([], {"kind": 3}, {"kind": "run", "case": 4}, {"kind": "sweep", "case": QUICK, "over": {}, "name": "a"},
                     {"kind": "run", "case": QUICK, "name": "a", "dry": "yes"}, {"kind": "fit", "case": QUICK, "name": "a", "free": [1]}):
            self.assertIn(self.studio.call("POST", "/api/jobs", body)[0], (400, 403, 404), body)
        body = json.dumps({"text": ""}).encode()
        self.assertEqual(self.studio.call("POST", "/api/case/check", body, headers={"Content-Type": "text/plain"})[0], 415)

    def test_a_thousand_requests_at_once_are_answered(self):
        with concurrent.futures.ThreadPoolExecutor(1000) as pool:
            answers = list(pool.map(lambda _: self.studio.call("GET", "/api/jobs")[0], range(1000)))
        self.assertEqual(set(answers), {200})
        threads = len(os.listdir(f"/proc/{self.studio.process.pid}/task"))
        self.assertLess(threads, 40)
        self.assertLess(resident_bytes(self.studio.process), 300_000_000)

    def test_a_run_that_needs_more_memory_than_there_is_is_refused(self):
        case = QUICK.replace('preset = "coarse"', 'preset = "fine"\nmesh_refinement = 4')
        status, _, body = self.studio.call("POST", "/api/jobs", {"kind": "run", "name": "large", "case": case})
        self.assertEqual(status, 409, body[:300])
        self.assertIn(b"memory", body)
        self.assertFalse((self.folder / "large").exists())
        self.assertEqual(self.studio.json("GET", "/api/jobs"), [])


if __name__ == "__main__":
    unittest.main()
