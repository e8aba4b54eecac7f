# SPDX-License-Identifier: Apache-2.0
"""A private Slurm with two nodes on loopback, run by root without touching what the machine has installed."""

import contextlib
import os
import pathlib
import random
import shutil
import socket
import subprocess
import time
import unittest

NODES = ("n1", "n2")
PROGRAMS = ("munged", "slurmctld", "slurmd", "sinfo", "srun", "sbatch", "scancel", "squeue")
CONFIGURATION = """ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge/socket
CredType=cred/munge
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
SlurmctldPort={port}
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.%n.log
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool/%n
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
SlurmdParameters=config_overrides
ReturnToService=2
SchedulerParameters=batch_sched_delay=0,sched_min_interval=0
KillWait=2
"""


def path_of(program):
    """Path of a program, also where only root looks."""
    return shutil.which(program, path=os.environ.get("PATH", "") + ":/usr/sbin:/sbin")


def available():
    """True if this process can run a Slurm of its own."""
    return os.getuid() == 0 and all(path_of(program) for program in PROGRAMS)


def free_ports(count):
    """The first of so many neighbouring ports that nobody uses."""
    while True:
        first = random.randrange(20000, 30000)
        with contextlib.suppress(OSError), contextlib.ExitStack() as sockets:
            for port in range(first, first + count):
                sockets.enter_context(socket.socket()).bind(("127.0.0.1", port))
            return first


class Slurm:
    """Use as a context. `environment` is that of the commands which talk to it."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.environment = {**os.environ, "SLURM_CONF": str(self.folder / "slurm.conf")}
        self.daemons = []

    def __enter__(self):
        try:
            self._begin()
        except (OSError, TimeoutError) as failure:
            self._end()
            raise unittest.SkipTest(f"Slurm's own daemons do not run here: {failure}") from failure
        return self

    def _begin(self):
        for name in ("state", "munge", *(f"spool/{node}" for node in NODES)):
            (self.folder / name).mkdir(parents=True)
        # munged wants no folder on the way that others may write to, and lets others find its socket.
        for name in ("", "state", "munge", "spool"):
            (self.folder / name).chmod(0o755)
        munge = self.folder / "munge"
        (munge / "key").write_bytes(os.urandom(128))
        (munge / "key").chmod(0o400)
        self._start("munged", "--foreground", "--force", "--num-threads=1", *(
            f"--{name}={munge / file}" for name, file in (("socket", "socket"), ("key-file", "key"), ("pid-file", "pid"),
                                                          ("log-file", "log"), ("seed-file", "seed"))))
        self._wait((munge / "socket").is_socket)
        host, port = socket.gethostname().split(".")[0], free_ports(1 + len(NODES))
        text = CONFIGURATION.format(host=host, folder=self.folder, port=port)
        for i, node in enumerate(NODES):
            text += (f"NodeName={node} NodeHostname={host} NodeAddr=127.0.0.1 Port={port + 1 + i} CPUs=1 RealMemory=2000 "
                     "State=UNKNOWN\n")
        text += "PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP\n"
        (self.folder / "slurm.conf").write_text(text)
        self._start("slurmctld", "-D", "-c")
        for node in NODES:
            self._start("slurmd", "-D", "-N", node)
        self._wait(lambda: self.run("sinfo", "-h", "-N", "-o", "%t").stdout.split().count("idle") == len(NODES))

    def __exit__(self, *unused):
        jobs = self.run("squeue", "-h", "-o", "%A").stdout.split()
        if jobs:
            self.run("scancel", "--full", *jobs)
            with contextlib.suppress(TimeoutError):
                self._wait(lambda: not self.run("squeue", "-h").stdout.strip())
        self._end()

    def _end(self):
        for daemon in reversed(self.daemons):
            daemon.terminate()
        for daemon in self.daemons:
            try:
                daemon.wait(60)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()

    def run(self, program, *arguments):
        """A command of Slurm; returns the finished process."""
        return subprocess.run([path_of(program), *map(str, arguments)], env=self.environment, capture_output=True, text=True,
                              cwd=self.folder, timeout=300, check=False)

    def _start(self, program, *arguments):
        with open(self.folder / f"{program}.out", "ab") as out:
            self.daemons.append(subprocess.Popen([path_of(program), *map(str, arguments)], env=self.environment,
                                                 stdin=subprocess.DEVNULL, stdout=out, stderr=out))

    def _wait(self, holds, seconds=300):
        deadline = time.monotonic() + seconds
        while not holds():
            if time.monotonic() > deadline:
                said = "".join(path.read_text(errors="replace")[-500:] for path in self.folder.glob("*.out"))
                raise TimeoutError(f"Slurm does not come up or go down: {said}")
            time.sleep(0.1)
