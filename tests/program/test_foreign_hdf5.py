# SPDX-License-Identifier: Apache-2.0
"""Strain files that are damaged, lead elsewhere or declare absurd sizes are refused at once, with a message."""

import os
import subprocess
import unittest

import h5py
import numpy

from program import PROGRAM, ROOT, ProgramTest, write_strain_file

CASE = ROOT / "cases" / "strain_file.toml"
DAMAGED = ROOT / "fuzz" / "corpus" / "strain_file"
SHEAR = 1e-3 * numpy.ones((2, 2, 1, 1))


class ForeignHdf5(ProgramTest):
    def strain_file(self, name, edit):
        """A valid file that `edit` has changed."""
        path = self.folder / name
        write_strain_file(path, SHEAR, [0.0, 1.0])
        with h5py.File(path, "r+") as file:
            edit(file)
        return path

    def refused(self, path, *words, verb=("check",)):
        process = self.run_program(*verb, CASE, "--set", f'strain.file="{path}"', expect=2, processor_seconds=10)
        for word in words:
            self.assertIn(word, process.stderr)

    def test_a_file_that_crashes_the_library(self):
        self.refused(DAMAGED / "crashes_hdf5.h5", "the HDF5 library crashes on", "write it again", verb=("run", "-o", "out"))
        self.assertFalse((self.folder / "out").exists())

    def test_pipes_are_not_waited_for(self):
        os.mkfifo(self.folder / "fifo")
        self.refused(self.folder / "fifo", "cannot be read", "regular file")

        def link(file):
            del file["gamma"]
            file["gamma"] = h5py.ExternalLink(str(self.folder / "fifo"), "/gamma")

        self.refused(self.strain_file("link.h5", link), "/gamma is an external link")

    def test_sizes_are_judged_before_memory_is_asked_for(self):
        def many_times(file):
            del file["time"]
            file.create_dataset("time", (10**18,), chunks=(1000,), dtype="f8")

        def many_cells(file):
            del file["gamma"], file["grid/x"], file["grid/y"]
            file["grid/x"], file["grid/y"] = numpy.linspace(0, 15e-3, 3001), numpy.linspace(0, 2e-3, 3001)
            gamma = file.create_dataset("gamma", (2, 2, 3000, 3000), chunks=(1, 1, 100, 100), compression="gzip")
            gamma.attrs["unit"] = "1"

        self.refused(self.strain_file("times.h5", many_times), "/time takes 8e+09 GB of memory")
        self.refused(self.strain_file("cells.h5", many_cells), "/gamma was never written completely")

    def test_a_run_without_end(self):
        def long(file):
            file["time"][...] = [0, 1e6]

        self.refused(self.strain_file("long.h5", long), "it must be at least 0.5 s")

    def test_standard_input_is_a_file_or_refused(self):
        path = self.strain_file("whole.h5", lambda file: None)
        with open(path, "rb") as stream:
            process = subprocess.run([PROGRAM, "check", CASE, "--set", 'strain.file="/dev/stdin"'], stdin=stream,
                                     capture_output=True, text=True, cwd=self.folder, check=False)
        self.assertEqual(process.returncode, 0, process.stderr)
        process = subprocess.run([PROGRAM, "check", CASE, "--set", 'strain.file="/dev/stdin"'], input="x",
                                 capture_output=True, text=True, cwd=self.folder, check=False)
        self.assertEqual(process.returncode, 2, process.stderr)


if __name__ == "__main__":
    unittest.main()
