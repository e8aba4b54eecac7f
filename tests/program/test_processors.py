# SPDX-License-Identifier: Apache-2.0
"""Elementary functions round otherwise on other processors, as libm has kernels with and without fused multiplication: figures
agree within the bound of docs/sweeps.md."""

import csv
import json
import os
import pathlib
import re
import subprocess
import unittest

from program import PROGRAM, QUICK, SMALL, ProgramTest

SWEEP = ("sweep", QUICK, "--no-report", *SMALL, "--over", "contact.friction=0.1,0.4")
OLDER = "glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2"
# Relative bounds; steps follow the rounding. What differs between the electrodes is left of terms that cancel: its bound is over
# what both have in common.
BOUND, REMAINDER_BOUND = 1e-7, 1e-8


class Processors(ProgramTest):
    def sweep(self, out, **environment):
        """Signals of the first point, and rows of the table."""
        self.run_program(*SWEEP, "-o", out, env={**os.environ, **environment})
        with open(self.folder / out / "sweep.csv", newline="", encoding="utf-8") as file:
            return (self.folder / out / "points" / "0001_friction=0.1" / "signals.csv").read_bytes(), list(csv.DictReader(file))

    def test_kernels_of_elementary_functions_agree(self):
        (signals, rows), (others, other_rows) = self.sweep("own"), self.sweep("older", GLIBC_TUNABLES=OLDER)
        if " fma " in pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8"):
            self.assertNotEqual(signals, others, "the same kernels were taken twice")
        for row, reference in zip(other_rows, rows, strict=True):
            for name in reference:
                with self.subTest(name):
                    self.compare(name, reference, row)

    def test_what_uses_eigen_is_compiled_alike(self):
        """The linker keeps one copy of a template that two sources compile, which must serve both: otherwise the
        program multiplies without vector instructions, and not as the library does."""
        build = PROGRAM.parent
        told = [entry["command"] for entry in json.loads((build / "compile_commands.json").read_text())]
        commands = {re.search(r" -o (\S+)", command)[1]: command for command in told}
        told = subprocess.run(["ninja", "-C", build, "-t", "deps"], capture_output=True, text=True, check=True).stdout
        objects = {block.split(":")[0] for block in told.split("\n\n") if "/eigen3/" in block} & set(commands)
        self.assertGreater(len(objects), 5)
        instructions = {tuple(re.findall(r" -march=\S+", commands[name])[-1:]) for name in objects}
        self.assertEqual(len(instructions), 1, {name: re.findall(r" -march=\S+", commands[name]) for name in objects})
        for name in objects:
            self.assertNotEqual(re.findall(r" -O\S", commands[name])[-1:], [" -O0"], name)

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
        if name.startswith("signal_to_noise"):  # of the difference current
            share = float(reference["peak_sampled_current_common [A]"]) / float(reference["peak_sampled_current_difference [A]"])
            bound = REMAINDER_BOUND * abs(share * expected)
        self.assertLessEqual(abs(value - expected), bound)


if __name__ == "__main__":
    unittest.main()
