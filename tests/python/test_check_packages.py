# SPDX-License-Identifier: Apache-2.0
"""scripts/check_packages.py finds packages that are missing, in the wrong tier or there for nothing."""

import pathlib
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))

import check_packages  # noqa: E402

TEXT = (ROOT / "packages.txt").read_text()


class CheckPackages(unittest.TestCase):
    def messages(self, text):
        packages, found = check_packages.read_packages(text)
        return found + [*check_packages.misplaced(packages), *check_packages.unused(packages)]

    def without(self, package):
        kept = [line for line in TEXT.splitlines() if not line.startswith(package + " ")]
        self.assertLess(len(kept), len(TEXT.splitlines()))
        return "\n".join(kept)

    def moved(self, package, tier):
        line = next(line for line in TEXT.splitlines() if line.startswith(package + " "))
        heading = next(line for line in TEXT.splitlines() if line.startswith(f"[{tier}]"))
        return self.without(package).replace(heading, f"{heading}\n{line}")

    def test_this_tree(self):
        self.assertEqual(self.messages(TEXT), [])

    def test_missing(self):
        for package, sought in (("libudunits2-dev", "udunits2"), ("libceres-dev", "ceres"), ("libfmt-dev", "fmt"),
                                ("python3-h5py", "h5py"), ("libgtest-dev", "gtest/gtest.h"), ("libmujoco-dev", "mujoco")):
            found = self.messages(self.without(package))
            self.assertTrue(any(sought in message and "no package" in message for message in found), (package, found))

    def test_wrong_tier(self):
        for package, tier, said in (("libhdf5-dev", "tests", "requires hdf5-serial"), ("libceres-dev", "program", "does without"),
                                    ("nlohmann-json3-dev", "tests", "which it cannot count on"),
                                    ("pybind11-dev", "tests", "which it cannot count on")):
            found = self.messages(self.moved(package, tier))
            self.assertTrue(any(said in message for message in found), (package, found))

    def test_unused(self):
        program = "pov" + "ray"  # in two, for this file is searched, too
        for words in ("include:zmq.h", "cmake:Qt6", "import:pandas", f"run:{program}", f"named:{program}", f"needs:{program}"):
            found = self.messages(f"{TEXT}\nsome-package {words} Of no use.")
            self.assertEqual(len(found), 1, found)
            self.assertIn("some-package", found[0])

    def test_unreadable(self):
        for line in ("some-package", "some-package include:fmt", "some-package Without a search.", "npm run:npm Told twice."):
            self.assertTrue(any("packages.txt:" in message for message in self.messages(f"{TEXT}\n{line}")), line)


if __name__ == "__main__":
    unittest.main()
