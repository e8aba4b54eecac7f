# SPDX-License-Identifier: Apache-2.0
"""Sweeps by Slurm with two nodes: an array of batches, and Dask's workers by srun, one of them killed in mid-task."""

import os
import pathlib
import signal
import subprocess
import unittest

import slurm
from program import PROGRAM, QUICK, ProgramTest
from test_cluster import parent, processes, wait_until

GRID = ("--set", "numerics.mesh_refinement=0.5", "--only", "mechanics", "--no-report", "--over", "contact.friction=0.1,0.2,0.3",
        "--over", "motion.preload=1 um,1.5 um")


def environment(process):
    """Environment of a process; empty once it is gone, and for a moment while it becomes another program."""
    try:
        return pathlib.Path(f"/proc/{process}/environ").read_bytes()
    except OSError:
        return b""


@unittest.skipUnless(slurm.available(), "needs root, slurm-wlm and munge")
class BySlurm(ProgramTest):
    def test_no_point_is_lost(self):
        """Six points in two batches; the tables are the serial sweep's to the last bit."""
        self.run_program("sweep", QUICK, *GRID, "-o", "serial", "--threads", 1)
        table = (self.folder / "serial" / "sweep.csv").read_text()
        with slurm.Slurm(self.folder / "slurm") as queue:
            for way in (self.array, self.workers):
                with self.subTest(way.__name__):
                    out = self.folder / way.__name__
                    way(queue, out)
                    self.assertEqual((out / "sweep.csv").read_text(), table)

    def array(self, queue, out):
        """The batch that is killed is done by the same array once more."""
        self.run_program("sweep", QUICK, *GRID, "-o", out, "--plan")
        job = ("sbatch", "--wait", "--array=0-1", "--output=/dev/null", "--wrap",
               f"exec {PROGRAM} sweep --do-batch $SLURM_ARRAY_TASK_ID -o {out}")
        with subprocess.Popen([slurm.path_of(job[0]), *job[1:]], env=queue.environment, stdout=subprocess.DEVNULL) as first:
            os.kill(wait_until(lambda: processes("--do-batch", "1", out))[0], signal.SIGKILL)
            self.assertNotEqual(first.wait(), 0)
        self.assertIn("3 of 6 points are still to be solved", self.run_program("sweep", "--collect", "-o", out, "--no-report",
                                                                               expect=4).stderr)
        done = queue.run(*job)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.run_program("sweep", "--collect", "-o", out, "--no-report")

    def workers(self, queue, out):
        """Slurm's step outlives the worker that is killed, whose nanny starts another."""
        cluster = self.folder / "cluster"
        self.run_program("cluster", "start", cluster, "--workers", 0)
        self.addCleanup(subprocess.run, [PROGRAM, "cluster", "stop", cluster], capture_output=True, check=False)
        step = [slurm.path_of("srun"), "--nodes=2", "--ntasks=2", "--kill-on-bad-exit=0", PROGRAM, "cluster", "worker", cluster,
                "--threads", "1", "--memory", "1 GB"]
        with subprocess.Popen(step, env=queue.environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL):
            with subprocess.Popen([PROGRAM, "sweep", QUICK, *GRID, "-o", out, "--on", cluster / "scheduler.json", "--quiet"],
                                  cwd=self.folder) as sweep:
                program, variables = wait_until(lambda: [(one, known) for one in processes("--do-batch", out)
                                                         if (known := environment(one))])[0]
                self.assertIn(b"SLURMD_NODENAME", variables)
                os.kill(parent(program), signal.SIGKILL)
                self.assertEqual(sweep.wait(), 0)
            self.run_program("cluster", "stop", cluster)


if __name__ == "__main__":
    unittest.main()
