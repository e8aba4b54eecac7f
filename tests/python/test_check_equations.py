# SPDX-License-Identifier: Apache-2.0
"""The check that pages and code agree on the numbers of equations."""

import importlib.util
import pathlib
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts" / "check_equations.py"


class CheckEquations(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        spec = importlib.util.spec_from_file_location("check_equations", SCRIPT)
        cls.check = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(cls.check)

    def told(self, page, text):
        return list(self.check.mistakes(page, {"a.hpp": text}))

    def test_numbered_and_cited(self):
        self.assertEqual(self.told("$$ a = b $$ (1)\n\n$$ c\n= d $$ (2)\n", "/// docs/model.md (2), (1)."), [])

    def test_mistakes(self):
        page = "$$ a = b $$ (1)\n\n$$ c = d $$\n"
        told = self.told(page, "/// docs/model.md (1) and docs/model.md (7)")
        self.assertEqual(told, ["docs/model.md: (2) must stand behind the equation c = d",
                                "a.hpp: docs/model.md has no equation (7)",
                                "docs/model.md: equation (2) is named nowhere in src and verification"])


if __name__ == "__main__":
    unittest.main()
