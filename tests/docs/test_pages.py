# SPDX-License-Identifier: Apache-2.0
"""The built pages in a browser, as files and as wide as a phone: no script fails, nothing widens the page."""

import os
import pathlib
import unittest

from browser import browser_page, chromium

PAGES = pathlib.Path(os.environ.get("IONSKIN_PAGES", "pages"))
LOOKED_AT = ("index", "model", "case_reference", "contributing")


@unittest.skipUnless(chromium(), "no Chromium on this machine: apt-get install chromium to test the pages in it")
class Pages(unittest.TestCase):
    def test_no_script_fails_and_no_page_is_wider_than_a_phone(self):
        for name in LOOKED_AT:
            with self.subTest(name), browser_page(PAGES / f"{name}.html") as page:
                page.call("Emulation.setDeviceMetricsOverride", width=390, height=800, deviceScaleFactor=1, mobile=True)
                page.evaluate("new Promise(done => setTimeout(done, 200))")
                self.assertLessEqual(page.evaluate("document.documentElement.scrollWidth"), 390)
                self.assertEqual(page.errors, [])
                # Charts as wide as the text keep a width at which their letters can be read, and are moved sideways.
                widths = page.evaluate("[...document.querySelectorAll('a.image-reference img[style*=\"%\"]')]"
                                       ".map(image => image.clientWidth)")
                self.assertGreaterEqual(min(widths, default=640), 640)


if __name__ == "__main__":
    unittest.main()
