# SPDX-License-Identifier: Apache-2.0
"""Requests as bytes, as no browser sends them: ranges, heads without end, bodies that never come; and tables without end."""

import json
import math
import os
import pathlib
import socket
import struct
import threading
import unittest

from studio_server import QUICK, StudioTest, resident_bytes

RANGES = ("0-200000", "0-", "-200000", "5-200000", "200000-300000", "0-0", "0-18446744073709551615", "-9223372036854775808",
          "9223372036854775807-", "0-10,20-200000", "0-200000,0-200000", "-5,200000-", "5-2", "0-1," * 200 + "0-200000")


class Requests(StudioTest):
    def exchange(self, request):
        """Bytes that the server sends until it closes the line."""
        with socket.create_connection(("127.0.0.1", self.studio.port), timeout=60) as line:
            line.sendall(request)
            answer = b""
            while more := line.recv(65536):
                answer += more
            return answer

    def ask(self, method, path, headers="", cookie=""):
        return self.exchange((f"{method} {path} HTTP/1.1\r\nHost: 127.0.0.1:{self.studio.port}\r\nCookie: {cookie}\r\n"
                              f"{headers}\r\n").encode())

    def test_a_range_gives_the_whole_answer_and_nothing_else(self):
        (self.folder / "a.csv").write_text("time [s],a [A]\n0,1\n")
        (self.folder / "case.toml").write_text(QUICK)
        calls = [(path, "") for path in ("/", "/nowhere", "/open/0", "/api/runs")]
        calls += [(path, self.studio.cookie) for path in ("/app.css", "/nowhere", "/api/runs", "/api/text?path=case.toml",
                                                          "/api/text?path=/etc/passwd", "/api/download?path=a.csv")]
        for path, cookie in calls:
            plain = self.ask("GET", path, cookie=cookie).partition(b"\r\n\r\n")
            for name in ("Range", "range", "If-Range: x\r\nRange"):
                for one in RANGES:
                    for unit in ("bytes=", "bytes = ", "rows="):
                        with self.subTest(path=path, cookie=bool(cookie), range=name + ": " + unit + one[:30]):
                            head, _, body = self.ask("GET", path, f"{name}: {unit}{one}\r\n", cookie).partition(b"\r\n\r\n")
                            self.assertEqual(body, plain[2])
                            self.assertIn(b"content-length: %d" % len(body), head.lower())
                            self.assertEqual(head.split()[1], plain[0].split()[1])

    def head(self, cookie="", method="GET", more=""):
        return f"{method} /api/runs HTTP/1.1\r\nHost: 127.0.0.1:{self.studio.port}\r\nCookie: {cookie}\r\n{more}".encode()

    def flood(self, first, rest, most=1_000_000_000):
        """Bytes that the server took of a request that goes on for ever, and what it answered."""
        with socket.create_connection(("127.0.0.1", self.studio.port), timeout=60) as line:
            sent = line.send(first)
            try:
                while sent < most:
                    sent += line.send(rest)
            except OSError:
                pass
            try:
                return sent, line.recv(65536)
            except OSError:
                return sent, b""

    def test_a_head_without_end_takes_no_memory(self):
        before = resident_bytes(self.studio.process)
        for cookie in ("", self.studio.cookie):
            for first, rest in ((self.head(cookie), b"a: b\r\n" * 10_000), (self.head(cookie) + b"a: ", b"b" * 65536),
                                (b"GET /", b"a" * 65536), (b"", b"\r\n" * 10_000), (b"", b"\0" * 65536), (b"GET / HTTP/1.1\n", b"a: b\n" * 10_000)):
                with self.subTest(first=first[:30], rest=rest[:6], cookie=bool(cookie)):
                    sent, answer = self.flood(first, rest)
                    self.assertLess(sent, 100_000_000)
                    self.assertIn(answer.split(b"\r\n")[0].split(b" ")[1:2], ([b"400"], [b"431"], []))
        many = self.ask("GET", "/api/runs", "a: b\r\n" * 200, self.studio.cookie)
        self.assertEqual(many.split()[1], b"431")
        self.assertLess(resident_bytes(self.studio.process) - before, 30_000_000)
        self.assertEqual(self.studio.call("GET", "/api/runs")[0], 200)

    def test_strict_heads_are_answered_and_others_refused(self):
        host = f"Host: 127.0.0.1:{self.studio.port}\r\nCookie: {self.studio.cookie}\r\n"
        for first, more, status in (("GET /api/runs HTTP/1.1", "", 200), ("GET /api/runs HTTP/1.0", "", 200), ("HEAD /api/runs HTTP/1.1", "", 200),
                                    ("GET /api/runs HTTP/2.0", "", 400), ("GET http://a/ HTTP/1.1", "", 400), ("GET /api/runs", "", 400),
                                    ("GET  /api/runs HTTP/1.1", "", 400), ("DELETE /api/runs HTTP/1.1", "Content-Length: 0\r\nContent-Type: application/json\r\n", 405),
                                    ("GET /api/runs HTTP/1.1", "a : b\r\n", 400), ("GET /api/runs HTTP/1.1", " folded\r\n", 400),
                                    ("GET /api/runs HTTP/1.1", "a: b\nc: d\r\n", 400), ("GET /api/runs HTTP/1.1", "a: \0\r\n", 400),
                                    ("GET /api/runs HTTP/1.1", "Host: evil.example\r\n", 403), ("GET /api/runs HTTP/1.1", "Content-Length: 0\r\n", 400),
                                    ("HEAD /api/events HTTP/1.1", "", 200), ("HEAD /api/runs HTTP/1.1", "Origin: null\r\n", 403), ("GET /api/jobs/1/cancel HTTP/1.1", "", 405), ("GET /\x7f HTTP/1.1", "", 400)):
            with self.subTest(first=first, more=more):
                head, _, body = self.exchange(f"{first}\r\n{host}{more}\r\n".encode()).partition(b"\r\n\r\n")
                self.assertEqual(int(head.split()[1]), status)
                self.assertEqual(body == b"", first.startswith("HEAD"))

    def test_slow_connections_keep_nobody_waiting_and_are_closed(self):
        post = "Content-Type: application/json\r\nContent-Length: 1000\r\n\r\n"
        kinds = [self.head()] * 200 + [b""] * 100 + [self.head(self.studio.cookie)] * 20 + [self.head(self.studio.cookie, "POST", post)] * 20
        lines = []
        for first in kinds:
            line = socket.create_connection(("127.0.0.1", self.studio.port), timeout=60)
            self.addCleanup(line.close)
            line.sendall(first)
            lines.append(line)
        ended = threading.Event()
        closed = []

        def trickle():  # a byte now and then, so that no single read is late
            while not ended.wait(0.5):
                for line in lines:
                    try:
                        line.send(b"a")
                    except OSError:
                        pass

        thread = threading.Thread(target=trickle)
        thread.start()
        try:
            self.assertEqual(self.studio.call("GET", "/api/runs")[0], 200)
            self.assertEqual(self.studio.call("POST", "/api/case/check", {"text": ""})[0], 200)
            for line in lines:
                try:
                    closed.append(line.recv(1000))
                except ConnectionError:
                    closed.append(b"")
        finally:
            ended.set()
            thread.join()
        self.assertEqual(set(closed), {b""})
        self.assertLess(len(os.listdir(f"/proc/{self.studio.process.pid}/task")), 40)
        self.assertLess(len(os.listdir(f"/proc/{self.studio.process.pid}/fd")), 60)

    def test_only_the_first_request_of_a_line_is_answered(self):
        again = self.head(self.studio.cookie) + b"\r\n"
        self.assertEqual(self.exchange(again + again).count(b"HTTP/1.1 "), 1)
        with socket.create_connection(("127.0.0.1", self.studio.port), timeout=60) as line:
            for byte in again:  # the same, byte by byte
                line.sendall(bytes([byte]))
            self.assertIn(b" 200 ", line.recv(65536))

    def test_bodies_are_awaited_within_a_bound_and_with_100_continue(self):
        def upload(more):
            line = socket.create_connection(("127.0.0.1", self.studio.port), timeout=60)
            self.addCleanup(line.close)
            line.sendall(self.head(self.studio.cookie, "POST", more).replace(b"/api/runs", b"/api/upload?name=a.csv"))
            return line

        large = f"Content-Type: text/csv\r\nContent-Length: {16 << 20}\r\nExpect: 100-continue\r\n\r\n"
        lines = [upload(large) for _ in range(4)]
        for line in lines:
            self.assertEqual(line.recv(100), b"HTTP/1.1 100 Continue\r\n\r\n")
        self.assertIn(b" 503 ", upload(large).recv(65536))
        self.assertEqual(self.studio.call("GET", "/api/runs")[0], 200)
        lines[0].sendall(b"x" * (16 << 20))
        self.assertIn(b" 201 ", lines[0].recv(65536))
        for line in lines:
            line.close()
        again = upload("Content-Type: text/csv\r\nContent-Length: 1\r\nExpect: 100-continue\r\n\r\n")
        self.assertEqual(again.recv(100), b"HTTP/1.1 100 Continue\r\n\r\n")
        again.sendall(b"x")
        self.assertIn(b" 201 ", again.recv(65536))
        self.assertEqual((self.folder / "a.csv").stat().st_size, 16 << 20)

    def test_a_table_without_end_takes_no_memory(self):
        run = self.folder / "run"
        run.mkdir()
        path = "/api/table?path=run&name=signals"
        for text in ("," * 20_000_000, "a,b\n" + "," * 20_000_000, "," * 10_000 + "\n" * 10_000_000, "a\n" + "word\n" * 2_100_000,
                     "a\n" + ("w" * 1_000_000 + "\n") * 34, "a" * 20_000_000, '"' * 20_000_000, "a,b\n" + "1,2\n" * 8_000_001):
            with self.subTest(text=text[:20]):
                (run / "signals.csv").write_text(text)
                status, _, body = self.studio.call("GET", path)
                self.assertEqual(status, 413, body[:100])
                peak = int(pathlib.Path(f"/proc/{self.studio.process.pid}/status").read_text().split("VmHWM:")[1].split()[0]) * 1024
                self.assertLess(peak, 300_000_000)
        (run / "signals.csv").write_text('time [s],"a, ""b"" [A]",state,\r\n0,1,stick,\r\n0.5,,"slip, all"\r\n1,3,stick,7')
        status, _, body = self.studio.call("GET", path)
        self.assertEqual(status, 200)
        size = int.from_bytes(body[:4], "little")
        heading = json.loads(body[4:4 + size])
        self.assertEqual(heading, {"rows": 3, "columns": [
            {"name": "time", "unit": "s", "texts": None}, {"name": 'a, "b"', "unit": "A", "texts": None},
            {"name": "state", "unit": "", "texts": ["stick", "slip, all", "stick"]}, {"name": "", "unit": "", "texts": None}]})
        numbers = struct.unpack("<9d", body[4 + size:])
        self.assertEqual([None if math.isnan(one) else one for one in numbers], [0, 0.5, 1, 1, None, 3, None, None, 7])


if __name__ == "__main__":
    unittest.main()
