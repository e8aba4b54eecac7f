# SPDX-License-Identifier: Apache-2.0
"""Results of workers that do not see the folder of the sweep, and sweeps on a cluster that is not there."""

import contextlib
import io
import json
import os
import socket
import subprocess
import unittest
from unittest import mock

import ionskin
from ionskin.cluster import __main__ as cluster_main
from ionskin.cluster import client, security, worker
from ionskin.cluster import running as cluster_running
from ionskin.cluster import task as cluster_task
from ionskin.cluster.client import connected
from ionskin.cluster.progress import BatchProgress
from package import CASES, PackageTest

SWEEP = ("--set", "numerics.mesh_refinement=0.5", "--only", "mechanics", "--over", "contact.friction=0.1,0.2", "--no-report")


class ClusterTasks(PackageTest):
    def run_program(self, *arguments):
        return subprocess.run([cluster_running.program(), *map(str, arguments)], capture_output=True, check=True)

    def test_points_travel_as_an_archive(self):
        out, serial = self.folder / "out", self.folder / "serial"
        self.run_program("sweep", CASES / "paper" / "coarse.toml", *SWEEP, "-o", serial)
        self.run_program("sweep", CASES / "paper" / "coarse.toml", *SWEEP, "-o", out, "--plan")
        with mock.patch.object(cluster_task, "_local_folder", lambda: self.folder), \
                mock.patch.dict(os.environ, {"IONSKIN_FRONT": cluster_running.program()}):
            result = cluster_task.do_batch(0, str(out), "absent", (out / "plan.json").read_bytes(), 1)
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
        case = ionskin.Case.from_file(CASES / "paper" / "coarse.toml")
        with self.assertRaisesRegex(ionskin.CaseError, "not a file of a scheduler"):
            ionskin.sweep(case, {"contact.friction": [0.1, 0.2]}, self.folder / "out", on=self.folder / "scheduler.json")

    def sweep_refused(self, scheduler):
        """Message about a scheduler's file that cannot be used."""
        case = ionskin.Case.from_file(CASES / "paper" / "coarse.toml")
        with self.assertRaises(ionskin.CaseError) as refused:
            ionskin.sweep(case, {"contact.friction": [0.1, 0.2]}, self.folder / "out", on=scheduler, overwrite=True)
        self.assertIn("\n  = ", str(refused.exception))
        return str(refused.exception)

    def test_files_that_are_none_of_a_scheduler(self):
        path = self.folder / "scheduler.json"
        good = "tcp://127.0.0.1:8786"
        for text in ("", "[" * 100_000, "3", "null", "[]", "{}", '{"address": 3}', '{"address": null}', '{"address": {}}',
                     '{"address": ""}', '{"address": "tcp://"}', '{"address": "tcp://127.0.0.1"}', '{"address": "http://a:1"}',
                     '{"address": "tcp://127.0.0.1:99999999"}', '{"address": "tcp://127.0.0.1:-1"}', '{"address": "tcp://[::1"}',
                     '{"address": "inproc://127.0.0.1:1"}', '{"address": ["tcp://127.0.0.1:1"]}', f'{{"address": "{good}"',
                     f'{{"address": "{good}", "pid": NaN}}', f'{{"address": "{good}", "pid": 1e999}}', "\0" * 1000):
            path.write_text(text)
            with self.subTest(text[:40]), self.assertRaisesRegex(ionskin.CaseError, "not a file of a scheduler"):
                security.read_scheduler(path)
        path.write_bytes(b"\xff\xfe\x00")
        with self.assertRaisesRegex(ionskin.CaseError, "not a file of a scheduler"):
            security.read_scheduler(path)
        for make in (os.mkfifo, os.mkdir, lambda place: place.symlink_to(place), lambda place: place.symlink_to("/dev/zero")):
            path.rmdir() if path.is_dir() else path.unlink()
            make(path)
            self.assertIn("not a file of a scheduler", self.sweep_refused(path))
            with self.assertRaises(ionskin.CaseError):
                cluster_main.require_idle(self.folder)

    def test_a_scheduler_that_is_gone_is_reported_at_once(self):
        with socket.socket() as taken:  # bound, but nobody listens
            taken.bind(("127.0.0.1", 0))
            path = self.folder / "scheduler.json"
            path.write_text(json.dumps({"address": f"tcp://127.0.0.1:{taken.getsockname()[1]}"}))
            with mock.patch("distributed.Client", side_effect=AssertionError("it waits for a scheduler that is gone")):
                with self.assertRaisesRegex(ionskin.CaseError, "does not answer: Connection refused"), connected(path):
                    pass
                self.assertIsNone(cluster_main.answering(path))
            with self.assertRaisesRegex(ionskin.CaseError, "does not answer: Connection refused"):
                worker.work(self.folder, 1, 1e9, 60)
            self.assertIn("does not answer", self.sweep_refused(path))

    def test_what_is_waited_for_is_said(self):
        """A scheduler that takes the connection and is silent, as one that is stopped does."""
        said = io.StringIO()
        with socket.create_server(("127.0.0.1", 0)) as silent:
            path = self.folder / "scheduler.json"
            path.write_text(json.dumps({"address": f"tcp://127.0.0.1:{silent.getsockname()[1]}"}))
            with mock.patch.object(client, "AT_ONCE", 0.01), mock.patch.object(client, "CONNECT", 2), \
                    contextlib.redirect_stderr(said), self.assertRaisesRegex(ionskin.CaseError, "does not answer"), connected(path):
                pass
        self.assertRegex(said.getvalue(), r"waiting for the scheduler at tcp://127.0.0.1:\d+, 2 s at most")


if __name__ == "__main__":
    unittest.main()
