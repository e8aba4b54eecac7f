# SPDX-License-Identifier: Apache-2.0
"""Requests as bytes, as no browser sends them: ranges."""

import socket
import unittest

from studio_server import QUICK, StudioTest

RANGES = ("0-200000", "0-", "-200000", "5-200000", "200000-300000", "0-0", "0-18446744073709551615", "-9223372036854775808",
          "9223372036854775807-", "0-10,20-200000", "0-200000,0-200000", "-5,200000-", "5-2", "0-1," * 200 + "0-200000")


class Requests(StudioTest):
    def exchange(self, request):
        """What the server sends until it closes the line."""
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
                            if head.split()[1] == b"416":  # malformed
                                self.assertEqual(body, b"")
                                continue
                            self.assertEqual(body, plain[2])
                            self.assertIn(b"content-length: %d" % len(body), head.lower())
                            self.assertEqual(head.split()[1], plain[0].split()[1])


if __name__ == "__main__":
    unittest.main()
