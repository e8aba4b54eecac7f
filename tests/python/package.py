# SPDX-License-Identifier: Apache-2.0
"""Shared by the tests of the Python package: a small case and a scratch folder."""

import os
import pathlib
import shutil
import tempfile
import unittest

import ionskin

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
CASES = ROOT / "cases"
PROGRAM = pathlib.Path(os.environ.get("IONSKIN_PROGRAM", ROOT / "build" / "ionskin"))


def small_case():
    """A mesh and time steps that serve to test the bookkeeping, not the physics."""
    case = ionskin.Case.from_file(CASES / "paper" / "coarse.toml")
    case["numerics.mesh_refinement"] = 0.5
    case["numerics.time_refinement"] = 0.3
    return case


class PackageTest(unittest.TestCase):
    """A test with a scratch folder of its own in `self.folder`."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="ionskin-python-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
