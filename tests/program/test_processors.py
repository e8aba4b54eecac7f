# SPDX-License-Identifier: Apache-2.0
"""Kernels of the linear algebra for several processors, which round otherwise: each gives the same bits after a kill, and
all agree within the bound of docs/sweeps.md."""

import csv
import os
import pathlib
import unittest
from unittest import mock

from program import QUICK, SMALL, ProgramTest

# Kernel of OpenBLAS and what the processor must be able to do for it.
KERNELS = {"Nehalem": "sse4_2", "Haswell": "avx2", "Zen": "avx2", "SkylakeX": "avx512vl"}
SWEEP = ("sweep", QUICK, "--no-report", *SMALL, "--over", "contact.friction=0.1,0.4")
# Relative bounds; steps follow the rounding. What differs between the electrodes is left of terms that cancel: its bound is over
# what both have in common.
BOUND, REMAINDER_BOUND = 1e-7, 1e-8


def usable():
    """The kernels that this processor can run."""
    flags = pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8").partition("flags")[2].partition("\n")[0].split()
    return [kernel for kernel, needed in KERNELS.items() if needed in flags]


class Processors(ProgramTest):
    def kernels(self, **environment):
        """Kernels that OpenBLAS loads in the solver, as it says itself."""
        said = self.run_program("run", "no-such-case.toml", "-o", "out", expect=2,
                                env={**os.environ, "OPENBLAS_VERBOSE": "2", **environment})
        return [line.removeprefix("Core: ") for line in (said.stdout + said.stderr).splitlines() if line.startswith("Core: ")][-1]

    def test_processors_newer_than_the_library_get_kernels_that_suit_them(self):
        with mock.patch.dict(os.environ):
            os.environ.pop("OPENBLAS_CORETYPE", None)
            self.assertNotEqual(self.kernels() == "Prescott", "Haswell" in usable())
            self.assertEqual(self.kernels(OPENBLAS_CORETYPE="Prescott"), "Prescott", "the user's choice is kept")

    def table(self, out):
        """Bytes of the sweep's table."""
        return (self.folder / out / "sweep.csv").read_bytes()

    def test_killed_sweeps_end_with_the_same_bits_and_kernels_agree(self):
        metrics = {}
        for kernel in usable():
            with self.subTest(kernel), mock.patch.dict(os.environ, {"OPENBLAS_CORETYPE": kernel}):
                whole, killed, single = f"whole_{kernel}", f"killed_{kernel}", f"single_{kernel}"
                self.run_program(*SWEEP, "-o", whole, "--threads", 1)
                # Once the first point is whole, and the second is about to be.
                self.end_at_file(2, *SWEEP, "-o", killed, below=f"{killed}/points")
                self.run_program(*SWEEP, "-o", killed, "--resume")
                self.assertEqual(self.table(killed), self.table(whole))
                point = self.folder / whole / "points" / "0002_friction=0.4"
                self.run_case(point / "case.toml", "-o", single)
                for name in ("signals.csv", "sampled.csv"):
                    self.assertEqual((point / name).read_bytes(), (self.folder / single / name).read_bytes())
                with open(self.folder / whole / "sweep.csv", newline="", encoding="utf-8") as file:
                    metrics[kernel] = list(csv.DictReader(file))
        self.assertGreaterEqual(len(metrics), 3 if "Haswell" in usable() else 1)
        first, *others = metrics.items()
        for kernel, rows in others:
            for row, reference in zip(rows, first[1], strict=True):
                for name in reference:
                    with self.subTest(f"{kernel} against {first[0]}: {name}"):
                        self.compare(name, reference, row)

    def compare(self, name, reference, row):
        """Residuals consist of rounding alone, and stated errors are differences of near numbers."""
        if "residual" in name or "error" in name or "seconds" in name:
            return
        try:
            expected, value = float(reference[name]), float(row[name])
        except ValueError:
            self.assertEqual(reference[name], row[name])
            return
        bound = BOUND * abs(expected)
        if "difference" in name:
            common = reference.get(name.replace("difference", "common"), reference["peak_sampled_current_common [A]"])
            bound = REMAINDER_BOUND * abs(float(common))
        self.assertLessEqual(abs(value - expected), bound)


if __name__ == "__main__":
    unittest.main()
