# SPDX-License-Identifier: Apache-2.0
"""Sweeps on a cluster of this machine: killed workers, lost schedulers, who may connect, what cannot be done."""

import contextlib
import json
import os
import pathlib
import shutil
import signal
import socket
import ssl
import stat
import subprocess
import sys
import time
import unittest
from urllib.parse import urlsplit

from program import PROGRAM, QUICK, ROOT, SMALL, ProgramTest
from tiers import long_test

GRID = (*SMALL, "--over", "contact.friction=0.1,0.2", "--over", "motion.preload=1 um,1.5 um", "--no-report")
LOST = 5


def processes(*words):
    """Ids of the processes whose command line holds all these words."""
    found = []
    for path in pathlib.Path("/proc").glob("[0-9]*/cmdline"):
        try:
            line = path.read_bytes().split(b"\0")
        except OSError:
            continue
        if all(os.fsencode(str(word)) in line for word in words):
            found.append(int(path.parent.name))
    return found


def parent(process):
    """Id of the parent of a process."""
    return int(pathlib.Path(f"/proc/{process}/stat").read_text().rsplit(")", maxsplit=1)[1].split()[1])


def is_stopped(process):
    """True if a process stands still by SIGSTOP."""
    try:
        return pathlib.Path(f"/proc/{process}/stat").read_text().rsplit(")", maxsplit=1)[1].split()[0] == "T"
    except OSError:
        return False


def stopped(*words):
    """Ids of those of `processes` that stand still."""
    return [process for process in processes(*words) if is_stopped(process)]


def children(process):
    """Ids of the processes that a process started."""
    return [int(one) for path in pathlib.Path(f"/proc/{process}/task").glob("*/children") for one in path.read_text().split()]


def listening(process):
    """Addresses, in hexadecimal, at which a process waits for connections of IPv4."""
    sockets = set()
    with contextlib.suppress(FileNotFoundError):  # the process has ended meanwhile
        for link in pathlib.Path(f"/proc/{process}/fd").iterdir():
            with contextlib.suppress(OSError):  # closed meanwhile
                sockets.add(os.readlink(link))
    rows = [row.split() for row in pathlib.Path("/proc/net/tcp").read_text().splitlines()[1:]]
    return [row[1].split(":")[0] for row in rows if row[3] == "0A" and f"socket:[{row[9]}]" in sockets]


def wait_until(holds, seconds=600):
    """Returns what `holds` returned when it first held, which a second call may not: /proc shows no command line of a process
    during execve. Raises TimeoutError."""
    deadline = time.monotonic() + seconds
    while not (found := holds()):
        if time.monotonic() > deadline:
            raise TimeoutError
        time.sleep(0.02)
    return found


def gone(*words):
    """True if no program with these words is seen for a second: one look may fall into an execve."""
    for _ in range(10):
        if processes(*words):
            return False
        time.sleep(0.1)
    return True


class Cluster(ProgramTest):
    def start(self, name="cluster", *arguments, workers=2, **settings):
        """A cluster of this machine, stopped with the test; returns its scheduler.json."""
        self.run_program("cluster", "start", name, "--workers", workers, "--threads", 1, "--memory", "1 GB", *arguments, **settings)
        self.addCleanup(subprocess.run, [PROGRAM, "cluster", "stop", name], cwd=self.folder, capture_output=True, check=False)
        return self.folder / name / "scheduler.json"

    def serial(self):
        self.run_program("sweep", QUICK, *GRID, "-o", "serial")
        return (self.folder / "serial" / "sweep.csv").read_text()

    def test_a_killed_worker_and_a_lost_scheduler_lose_no_point(self):
        """A worker killed in mid-task takes its program along, and its batch is done again. Of each sweep one program stands
        before it names its second file, so that the sweep cannot end first."""
        once = self.folder / "once"
        scheduler = self.start(env=self.observed(call="rename", folder=self.folder / "out", number=2, once=once, signal=int(signal.SIGSTOP)))
        out = self.folder / "out"
        with subprocess.Popen([PROGRAM, "sweep", QUICK, *GRID, "-o", "out", "--on", scheduler, "--quiet"],
                              cwd=self.folder) as sweep:
            program = wait_until(lambda: stopped("--do-batch", out))[0]
            os.kill(parent(program), signal.SIGKILL)
            wait_until(lambda: program not in processes("--do-batch", out))
            self.assertEqual(sweep.wait(), 0)
        table = self.serial()
        self.assertEqual((out / "sweep.csv").read_text(), table)
        lost = self.folder / "out_lost"
        once.unlink()
        with subprocess.Popen([PROGRAM, "sweep", QUICK, *GRID, "-o", lost, "--on", scheduler], cwd=self.folder,
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as sweep:
            wait_until(lambda: stopped("--do-batch", lost))
            os.kill(json.loads(scheduler.read_text())["pid"], signal.SIGKILL)
            _, errors = sweep.communicate()
        self.assertEqual(sweep.returncode, LOST, errors)
        self.assertIn("--resume", errors)
        wait_until(lambda: gone("--do-batch", lost))
        self.run_program("sweep", QUICK, *GRID, "-o", lost, "--resume")
        self.assertEqual((lost / "sweep.csv").read_text(), table)

    def test_tls_lets_in_holders_of_the_key_only(self):
        scheduler = self.start("cluster", "--tls", workers=1)
        address = urlsplit(json.loads(scheduler.read_text())["address"])
        self.assertEqual(address.scheme, "tls")
        for name in ("key.pem", "certificate.pem"):
            self.assertEqual(stat.S_IMODE((scheduler.parent / name).stat().st_mode), 0o600)
        sweep = ("sweep", QUICK, *SMALL, "--only", "mechanics", "--over", "motion.preload=1 um", "--no-report", "-o", "out", "--on",
                 scheduler)
        self.run_program(*sweep)
        self.run_program(*sweep, "--overwrite")
        self.assertIn("finished", (self.folder / "out" / "sweep.csv").read_text())
        foreign = self.folder / "foreign"
        shutil.copytree(scheduler.parent, foreign)
        for name in ("key.pem", "certificate.pem"):
            (foreign / name).unlink()
        process = self.run_program("sweep", QUICK, *GRID, "-o", "no", "--on", foreign / "scheduler.json", expect=2)
        self.assertIn("certificate.pem is missing", process.stderr)
        subprocess.run(["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes",
                        "-subj", "/CN=ionskin cluster", "-keyout", foreign / "key.pem", "-out", foreign / "certificate.pem"],
                       check=True, capture_output=True)
        context = ssl.create_default_context(cafile=scheduler.parent / "certificate.pem")
        context.check_hostname = False
        context.load_cert_chain(foreign / "certificate.pem", foreign / "key.pem")
        with self.assertRaises((ssl.SSLError, ConnectionError)):
            with socket.create_connection((address.hostname, address.port), timeout=120) as plain:
                with context.wrap_socket(plain) as encrypted:
                    self.assertEqual(encrypted.recv(1), b"")
                    raise ConnectionError
        with socket.create_connection((address.hostname, address.port), timeout=120) as plain:
            plain.sendall(b"x" * 64)
            try:
                self.assertNotIn(b"compression", plain.recv(4096))  # of Dask's greeting
            except ConnectionError:
                pass
        (foreign / "key.pem").chmod(0o644)
        process = self.run_program("sweep", QUICK, *GRID, "-o", "no", "--on", foreign / "scheduler.json", "--overwrite",
                                   expect=2)
        self.assertIn("can be read by others", process.stderr)

    def test_nobody_else_is_served(self):
        """Scheduler, workers, and the pages /info and /metrics of all of them wait on 127.0.0.1."""
        scheduler = self.start(workers=1)
        served = 5  # the scheduler, the nanny and its worker, and a page of scheduler and worker each

        def addresses():
            """Where all of them listen, once each does: a worker opens its page after it has told the scheduler that it is there."""
            nannies = processes("ionskin.cluster", "worker", "cluster")
            workers = [one for nanny in nannies for one in children(nanny)]
            found = [address for process in [json.loads(scheduler.read_text())["pid"], *nannies, *workers]
                     for address in listening(process)]
            return found if len(found) >= served else []

        self.assertEqual(set(wait_until(addresses)), {"0100007F"})

    @long_test
    def test_studies(self):
        """Runs of a study go to the workers too: the store is that of this machine, though a worker was killed."""
        subprocess.run([sys.executable, ROOT / "cases" / "make_strain.py", self.folder / "strain.h5"], check=True)
        shutil.copy(ROOT / "cases" / "strain_file.toml", self.folder)
        study = ("generate", "strain_file.toml", "--set", "numerics.preset=coarse", "--touches", 6, "--vary",
                 "coupling.coefficient=uniform(0.05, 0.15)", "--quiet")
        self.run_program(*study, "-o", "here")
        scheduler = self.start()
        with subprocess.Popen([PROGRAM, *map(str, study), "-o", "out", "--on", scheduler], cwd=self.folder) as process:
            child = wait_until(lambda: processes("ionskin.evaluation.worker"))[0]
            os.kill(parent(child), signal.SIGKILL)
            wait_until(lambda: child not in processes("ionskin.evaluation.worker"))
            self.assertEqual(process.wait(), 0)
        self.assertEqual(*((self.folder / name / "touches.h5").read_bytes() for name in ("here", "out")))
        refused = self.run_program(*study, "-o", "no", "--on", scheduler, "--threads", 2, expect=2)
        self.assertIn("one thread", refused.stderr)
        self.run_program("cluster", "stop", "cluster")
        refused = self.run_program(*study, "-o", "no", "--on", scheduler, expect=2)
        self.assertIn("not a file of a scheduler", refused.stderr)
        self.assertFalse((self.folder / "no").exists())

    def test_refusals(self):
        process = self.run_program("cluster", "start", "open", "--address", "0.0.0.0", expect=2)
        self.assertIn("--tls", process.stderr)
        plain = self.write("scheduler.json", json.dumps({"address": "tcp://192.0.2.1:8786"}))
        process = self.run_program("sweep", QUICK, *GRID, "-o", "out", "--on", plain, expect=2)
        self.assertIn("without encryption", process.stderr)
        process = self.run_program("sweep", QUICK, *GRID, "-o", "out", "--on", "nowhere.json", "--resume", expect=2)
        self.assertIn("not a file of a scheduler", process.stderr)
        scheduler = self.start(workers=1)
        process = self.run_program("sweep", QUICK, *GRID, "-o", "out", "--on", scheduler, "--threads", 2, "--resume", expect=2)
        self.assertIn("needs 2 threads", process.stderr)
        self.assertFalse(list(self.folder.glob("out/staging/*")), "nothing was submitted")
        self.run_program("cluster", "start", "small", "--workers", 1, "--threads", 1, "--memory", "50 MB")
        self.addCleanup(subprocess.run, [PROGRAM, "cluster", "stop", "small"], cwd=self.folder, capture_output=True, check=False)
        process = self.run_program("sweep", QUICK, *GRID, "-o", "out", "--on", "small/scheduler.json", "--resume", expect=2)
        self.assertIn("the largest have 1 threads and 0.05 GB", process.stderr)
        self.assertIn("has a running cluster", self.run_program("cluster", "start", "cluster", expect=2).stderr)


if __name__ == "__main__":
    unittest.main()
