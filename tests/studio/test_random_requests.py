# SPDX-License-Identifier: Apache-2.0
"""Hostile requests from a seeded generator: no secret leaves without the cookie, and the Studio goes on.

    IONSKIN_RANDOM_REQUESTS=5000 python3 -m unittest test_random_requests    # more than the usual 400
"""

import collections
import concurrent.futures
import json
import os
import random
import re
import socket
import unittest

from studio_server import QUICK, StudioTest, resident_bytes

REQUESTS = int(os.environ.get("IONSKIN_RANDOM_REQUESTS", "400"))
CANARY = "canary-of-a-case-0123456789"
PATHS = ("/", "/app.js", "/app.css", "/open/", "/open/0", "/api/runs", "/api/result?path=run", "/api/table?path=run&name=signals",
         "/api/fields?path=run", "/api/field?path=run&group=ions&frame=0&name=c", "/api/compare?first=run&second=run", "/api/keys",
         "/api/gallery", "/api/files", "/api/text?path=case.toml", "/api/download?path=case.toml", "/api/events", "/api/jobs",
         "/api/case/check", "/api/case/set", "/api/gallery/open", "/api/jobs/1/cancel", "/api/jobs/99999999999999999999999/resume",
         "/api/upload?name=a.csv", "/nowhere", "*", "http://127.0.0.1/", "//", "/%2e%2e/%2e%2e/etc/passwd", "/api/text?path=../../etc/passwd")
NUMBERS = ("0", "1", "5", "-1", "", "1000", "200000", "4194305", "99999999999", "18446744073709551615", "18446744073709551616", "9" * 400, "0x10", "+3", " 7")
WITHOUT_COOKIE = {400, 401, 403, 431}
WITH_COOKIE = WITHOUT_COOKIE | {200, 201, 303, 404, 405, 409, 411, 413, 415, 422, 429, 503}


def some_bytes(chance, most):
    return bytes(chance.randrange(256) for _ in range(chance.randrange(most)))


def some_headers(chance):
    """Lines that a server may stumble over."""
    number = lambda: chance.choice(NUMBERS)
    choices = (lambda: f"Range: bytes={number()}-{number()}", lambda: f"Range: bytes=-{number()},{number()}-{number()},0-",
               lambda: "Range: bytes=" + "0-1," * chance.randrange(2000), lambda: f"If-Range: {number()}",
               lambda: f"Content-Length: {number()}", lambda: "Transfer-Encoding: chunked", lambda: "Content-Encoding: gzip",
               lambda: "Expect: 100-continue", lambda: "Connection: keep-alive, upgrade", lambda: "Upgrade: h2c", lambda: " folded",
               lambda: "Content-Type: " + chance.choice(("application/json", "text/csv", "multipart/form-data; boundary=b", "a" * 9000)),
               lambda: "Origin: " + chance.choice(("null", "http://evil.example")), lambda: "Sec-Fetch-Site: " + chance.choice(("cross-site", "none")),
               lambda: "Accept-Encoding: gzip, br", lambda: "X" * chance.randrange(40_000) + ": 1", lambda: ":", lambda: "a\tb: c",
               lambda: "Cookie: " + "; ".join(f"ionskin_studio_{chance.randrange(65536)}={chance.randrange(10)}" for _ in range(chance.randrange(300))),
               lambda: "Host: evil.example", lambda: "A: " + some_bytes(chance, 20).decode("latin-1"))
    return [chance.choice(choices)() for _ in range(chance.choice((0, 1, 2, 4, 8, 150)))]


def some_body(chance):
    return chance.choice((lambda: b"", lambda: some_bytes(chance, 3000), lambda: b"[" * chance.randrange(100_000),
                          lambda: json.dumps({"text": QUICK[:chance.randrange(len(QUICK))]}).encode(),
                          lambda: json.dumps({"text": "a=1", "key": "b", "value": "[" * chance.randrange(3000), "id": "quick", "kind": "run"}).encode(),
                          lambda: json.dumps({"kind": chance.choice(("run", "sweep", "fit", 3)), "name": "../x", "case": "x", "dry": True}).encode(),
                          lambda: b"time [s],a [A]\n0,1\n" * chance.randrange(2000)))()


def some_request(chance, port, cookie):
    hostile = chance.random() < 0.5
    path = chance.choice(PATHS)
    method = "GET" if any(word in path for word in ("?", ".")) or chance.random() < 0.4 else "POST"
    if hostile:
        method = chance.choice((method,) * 9 + ("HEAD", "PUT", "DELETE", "OPTIONS", "TRACE", "get", ""))
    if hostile and chance.random() < 0.3:
        path += chance.choice(("%00", "%", "?" + "a=b&" * 3000, "/" * 9000, "#x", " x", "\x7f", "\r\nA: b", "?path=" + "%ff" * 200))
    version = chance.choice(("HTTP/1.1",) * 8 + ("HTTP/1.0", "HTTP/2.0", "HTTP/1.1 ", "")) if hostile else "HTTP/1.1"
    headers = [f"Host: {chance.choice(('127.0.0.1', 'localhost'))}:{port}"] if not hostile or chance.random() < 0.9 else []
    headers += [f"Cookie: {cookie}"] if cookie else []
    body = some_body(chance) if method != "GET" or chance.random() < 0.1 else b""
    if body and (not hostile or chance.random() < 0.7):
        headers += [f"Content-Length: {len(body)}", "Content-Type: " + ("text/csv" if "upload" in path else "application/json")]
    headers += some_headers(chance) if hostile else [f"Range: bytes={chance.choice(NUMBERS)}-{chance.choice(NUMBERS)}"]
    chance.shuffle(headers)
    end = chance.choice(("\r\n",) * 12 + ("\n", "\r")) if hostile else "\r\n"
    request = bytearray((end.join([f"{method} {path} {version}", *headers]) + end * 2).encode("latin-1") + body)
    if hostile and chance.random() < 0.2:
        for _ in range(chance.randrange(1, 6)):
            place = chance.randrange(len(request))
            request[place:place + chance.randrange(3)] = some_bytes(chance, 4)
    return bytes(request)


class RandomRequests(StudioTest):
    def exchange(self, request, chance):
        """Bytes that came back until the server closed the line, or the beginning of a stream."""
        answer = b""
        with socket.create_connection(("127.0.0.1", self.studio.port), timeout=120) as line:
            try:
                cuts = sorted(chance.randrange(len(request) + 1) for _ in range(chance.choice((0, 0, 1, 4))))
                for begin, end in zip([0, *cuts], [*cuts, len(request)]):
                    line.sendall(request[begin:end])
                if chance.random() < 0.03:
                    return None  # gone without a word
                if chance.random() < 0.97:  # the others wait until the server's patience ends
                    line.shutdown(socket.SHUT_WR)
                while b"text/event-stream" not in answer and (more := line.recv(1 << 20)):
                    answer += more
            except ConnectionError:
                pass
        return answer

    def test_no_secret_leaves_and_the_studio_goes_on(self):
        (self.folder / "case.toml").write_text(f'title = "{CANARY}"\n')
        (self.folder / "run").mkdir()
        (self.folder / "run" / "signals.csv").write_text(f"time [s],{CANARY}\n0,1\n")
        (self.folder / "run" / "manifest.json").write_text(json.dumps({"state": CANARY}))
        secrets = [CANARY.encode(), self.studio.cookie.split("=")[1].encode(), self.studio.link.split("/")[-1].encode(), str(self.folder).encode()]
        counts = collections.Counter()

        def one(seed):
            chance = random.Random(seed)
            known = chance.random() < 0.5
            request = some_request(chance, self.studio.port, self.studio.cookie if known else "")
            answer = self.exchange(request, chance)
            with self.subTest(seed=seed):
                if not answer:
                    return "none"
                head, _, body = answer.removeprefix(b"HTTP/1.1 100 Continue\r\n\r\n").partition(b"\r\n\r\n")
                self.assertRegex(head, rb"^HTTP/1\.1 \d\d\d ")
                status = int(head.split()[1])
                self.assertIn(status, WITH_COOKIE if known else WITHOUT_COOKIE, request[:300])
                self.assertEqual([secret for secret in secrets[0 if not known else 1:3] if secret in answer], [])
                length = re.search(rb"\r\nContent-Length: (\d+)", head)
                if length and not request.startswith(b"HEAD"):
                    self.assertEqual(int(length[1]), len(body))
                return status

        self.studio.call("GET", "/api/runs")
        before = resident_bytes(self.studio.process)
        with concurrent.futures.ThreadPoolExecutor(24) as pool:
            for outcome in pool.map(one, range(REQUESTS)):
                counts[outcome] += 1
        print(f"{REQUESTS} requests: {dict(sorted(counts.items(), key=str))}, memory grew by {(resident_bytes(self.studio.process) - before) >> 20} MiB")
        self.assertGreaterEqual(len(counts), 8)
        self.assertEqual(self.studio.call("GET", "/api/runs")[0], 200)
        self.assertLess(resident_bytes(self.studio.process) - before, 300_000_000)
        self.assertEqual(self.studio.end(), 0)


if __name__ == "__main__":
    unittest.main()
