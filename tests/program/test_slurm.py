# SPDX-License-Identifier: Apache-2.0
"""Sweeps by Slurm with two nodes: an array of batches, and Dask's workers by srun, one of each killed in mid-task."""

import os
import pathlib
import shlex
import signal
import subprocess
import unittest

import slurm
from program import PROGRAM, QUICK, ProgramTest
from test_cluster import parent, stopped, wait_until

GRID = ("--set", "numerics.mesh_refinement=0.5", "--only", "mechanics", "--no-report", "--over", "contact.friction=0.1,0.2,0.3",
        "--over", "motion.preload=1 um,1.5 um")


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

    def fault(self, out, how):
        """Variables with which the first program that names a second file below a folder gets a signal before it does."""
        all_variables = self.observed(call="rename", folder=out, number=2, once=self.folder / f"once_{out.name}", signal=int(how))
        return {name: value for name, value in all_variables.items() if name == "LD_PRELOAD" or name.startswith("IONSKIN_FAULT_")}

    def array(self, queue, out):
        """A batch that is killed before it names its second file is done by the same array once more."""
        self.run_program("sweep", QUICK, *GRID, "-o", out, "--plan")
        words = self.fault(out, signal.SIGKILL)
        script = self.write("batch", f"""#!/bin/sh
[ $SLURM_ARRAY_TASK_ID = 1 ] && export {" ".join(f"{name}={shlex.quote(value)}" for name, value in words.items())}
exec {PROGRAM} sweep --do-batch $SLURM_ARRAY_TASK_ID -o {out}
""")
        job = ("sbatch", "--wait", "--array=0-1", "--output=/dev/null", script)
        self.assertNotEqual(queue.run(*job).returncode, 0)
        self.assertIn("3 of 6 points are still to be solved", self.run_program("sweep", "--collect", "-o", out, "--no-report",
                                                                               expect=4).stderr)
        done = queue.run(*job)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.run_program("sweep", "--collect", "-o", out, "--no-report")

    def workers(self, queue, out):
        """Slurm's step outlives the worker that is killed while its program stands still, and whose nanny starts another."""
        cluster = self.folder / "cluster"
        self.run_program("cluster", "start", cluster, "--workers", 0)
        self.addCleanup(subprocess.run, [PROGRAM, "cluster", "stop", cluster], capture_output=True, check=False)
        step = [slurm.path_of("srun"), "--nodes=2", "--ntasks=2", "--kill-on-bad-exit=0", PROGRAM, "cluster", "worker", cluster,
                "--threads", "1", "--memory", "1 GB"]
        variables = {**queue.environment, **self.fault(out, signal.SIGSTOP)}
        with subprocess.Popen(step, env=variables, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL):
            with subprocess.Popen([PROGRAM, "sweep", QUICK, *GRID, "-o", out, "--on", cluster / "scheduler.json", "--quiet"],
                                  cwd=self.folder) as sweep:
                program = wait_until(lambda: stopped("--do-batch", out))[0]
                self.assertIn(b"SLURMD_NODENAME", pathlib.Path(f"/proc/{program}/environ").read_bytes())
                os.kill(parent(program), signal.SIGKILL)
                self.assertEqual(sweep.wait(), 0)
            self.run_program("cluster", "stop", cluster)


if __name__ == "__main__":
    unittest.main()
