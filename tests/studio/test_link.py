# SPDX-License-Identifier: Apache-2.0
"""Delivery of the one-time link to the browser: no other user of the computer sees it."""

import pathlib
import stat
import time
import unittest

from studio_server import Studio, StudioTest

BROWSER = """#!/bin/sh
printf '%s\\n' "$@" > "$0.words.part" && mv "$0.words.part" "$0.words"
"""


class Link(StudioTest):
    def start(self):
        browser = self.scratch / "browser"
        browser.write_text(BROWSER)
        browser.chmod(0o700)
        runtime = self.scratch / "runtime"
        runtime.mkdir()
        studio = Studio(self.folder, self.state, browser=browser, redeem=False, XDG_RUNTIME_DIR=str(runtime))
        self.addCleanup(lambda: studio.end() if studio.process.returncode is None else None)
        words = pathlib.Path(f"{browser}.words")
        while not words.exists():
            time.sleep(0.02)
        self.words = words.read_text().splitlines()
        return studio

    def leftovers(self):
        return list((self.scratch / "runtime").iterdir())

    def test_the_browser_gets_a_page_that_only_the_user_reads(self):
        self.assertEqual(len(self.words), 1)
        page = pathlib.Path(self.words[0])
        self.assertEqual(page.suffix, ".html")
        self.assertEqual(stat.S_IMODE(page.stat().st_mode), 0o600)
        self.assertEqual(stat.S_IMODE(page.parent.stat().st_mode), 0o700)
        self.assertIn(f'content="0; url=http://127.0.0.1:{self.studio.port}{self.studio.link}"', page.read_text())
        token = self.studio.link.split("/")[-1].encode()
        for process in pathlib.Path("/proc").glob("[0-9]*"):
            for name in ("cmdline", "environ"):
                try:
                    self.assertNotIn(token, (process / name).read_bytes())
                except OSError:
                    pass
        # A browser that a file led here says so, and keeps a new cookie back along a redirection.
        status, headers, body = self.studio.call("GET", self.studio.link, cookie="", headers={"Sec-Fetch-Site": "cross-site"})
        self.assertEqual(status, 200)
        self.assertIn(b'content="0; url=/"', body)
        self.assertEqual(self.leftovers(), [])
        self.studio.cookie = headers["Set-Cookie"].split(";")[0]
        self.assertEqual(self.studio.call("GET", "/")[0], 200)
        self.assertEqual(self.studio.call("GET", self.studio.link, cookie="", headers={"Sec-Fetch-Site": "cross-site"})[0], 403)

    def test_the_page_goes_with_the_link_and_with_the_server(self):
        for site in ("cross-site", "same-site"):  # of another page, which does not know the link
            self.assertEqual(self.studio.call("GET", "/open/0", cookie="", headers={"Sec-Fetch-Site": site})[0], 403)
        self.assertEqual(self.studio.call("HEAD", self.studio.link, cookie="")[0], 403)
        self.assertEqual(len(self.leftovers()), 1)
        self.assertEqual(self.studio.end(), 0)
        self.assertEqual(self.leftovers(), [])

    def test_another_host_or_page_cannot_redeem_the_link(self):
        for headers in ({"Host": "evil.example"}, {"Origin": "http://evil.example"}):
            self.assertEqual(self.studio.call("GET", self.studio.link, cookie="", headers=headers)[0], 403)
        self.assertEqual(self.studio.call("GET", self.studio.link, cookie="")[0], 303)
        self.assertEqual(self.leftovers(), [])


if __name__ == "__main__":
    unittest.main()
