# SPDX-License-Identifier: Apache-2.0
"""Results of workers that do not see the folder of the sweep, and sweeps on a cluster that is not there."""

import contextlib
import io
import os
import subprocess
import unittest
from unittest import mock

import ionskin
from ionskin.cluster import running as cluster_running
from ionskin.cluster import task as cluster_task
from ionskin.cluster.progress import BatchProgress
from package import CASES, PackageTest

SWEEP = ("--set", "numerics.mesh_refinement=0.5", "--only", "mechanics", "--over", "contact.friction=0.1,0.2", "--no-report")


class ClusterTasks(PackageTest):
    def run_program(self, *arguments):
        return subprocess.run([cluster_running.program(), *map(str, arguments)], capture_output=True, check=True)

    def test_points_travel_as_an_archive(self):
        out, serial = self.folder / "out", self.folder / "serial"
        self.run_program("sweep", CASES / "quick.toml", *SWEEP, "-o", serial)
        self.run_program("sweep", CASES / "quick.toml", *SWEEP, "-o", out, "--plan")
        with mock.patch.object(cluster_task, "_local_folder", lambda: self.folder), \
                mock.patch.dict(os.environ, {"IONSKIN_FRONT": cluster_running.program()}):
            result = cluster_task.do_batch(0, str(out), "absent", (out / "plan.json").read_bytes(), 1, False)
        self.assertEqual((result["code"], result["message"]), (0, ""))
        cluster_task.unpack(result["archive"], out / "staging" / "received-0000")
        self.run_program("sweep", "--collect", "-o", out, "--no-report")
        self.assertEqual((out / "sweep.csv").read_text(), (serial / "sweep.csv").read_text())
        self.assertFalse((out / "staging").exists())

    def test_progress(self):
        """Batches done, running and failed, workers, and the time left by the estimated work that is done."""
        progress, said = BatchProgress("lines", {0: 30.0, 1: 10.0, 2: 10.0}), io.StringIO()
        with contextlib.redirect_stderr(said):
            progress.show(2, 2)
            progress.show(2, 2)
            progress.done.add(0)
            progress.failed.add(1)
            progress.start -= 60
            progress.show(1, 1)
        self.assertEqual(said.getvalue(), "batches: 0 of 3 done, 2 running, 0 failed; 2 workers\n"
                         "batches: 1 of 3 done, 1 running, 1 failed; 1 worker; about 40 s left\n")

    def test_no_cluster(self):
        case = ionskin.Case.from_file(CASES / "quick.toml")
        with self.assertRaisesRegex(ionskin.CaseError, "no file of a scheduler"):
            ionskin.sweep(case, {"contact.friction": [0.1, 0.2]}, self.folder / "out", on=self.folder / "scheduler.json")


if __name__ == "__main__":
    unittest.main()
