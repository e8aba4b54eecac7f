# SPDX-License-Identifier: Apache-2.0
"""A host with decimal commas, as Qt programs set them, reads and writes the same numbers."""

import os
import subprocess
import sys
import unittest

from package import CASES, PackageTest

HOST = """
import locale, sys
import ionskin
locale.setlocale(locale.LC_ALL, "de_DE.UTF-8")
assert locale.localeconv()["decimal_point"] == ","
case = ionskin.Case.from_file(sys.argv[1])
case["motion.preload"] = "1.5 um"
case["coupling.coefficient"] = 0.25
print(case["motion.preload"], case["coupling.coefficient"], case["electrochemistry.temperature"])
"""


class Locale(PackageTest):
    def test_decimal_commas_of_the_host(self):
        made = subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", self.folder / "de_DE.UTF-8"], check=False,
                              capture_output=True, text=True)
        self.assertTrue((self.folder / "de_DE.UTF-8" / "LC_NUMERIC").exists(), made.stderr)
        host = subprocess.run([sys.executable, "-c", HOST, CASES / "paper" / "coarse.toml"], check=False, capture_output=True, text=True,
                              env=os.environ | {"LOCPATH": str(self.folder)})
        self.assertEqual(host.stderr, "")
        self.assertEqual(host.stdout.splitlines()[0], "1.5e-06 0.25 293.15")


if __name__ == "__main__":
    unittest.main()
