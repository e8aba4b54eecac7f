# SPDX-License-Identifier: Apache-2.0
"""Acts of a host program around a run: call it from a callback, fork, name files in any encoding, damage them."""

import os
import shutil
import signal
import subprocess
import sys
import threading
import unittest

import h5py

import ionskin
from package import PackageTest, small_case


def exit_code(process):
    """Exit code of a forked process; it is killed when it has not ended within a minute."""
    timer = threading.Timer(60, os.kill, (process, signal.SIGKILL))
    timer.start()
    code = os.waitstatus_to_exitcode(os.waitpid(process, 0)[1])
    timer.cancel()
    return code


class Embedding(PackageTest):
    def test_a_run_inside_a_progress_callable_is_refused(self):
        def begin_another(activity, fraction):
            ionskin.run(small_case(), only="mechanics")

        with self.assertRaisesRegex(ionskin.CaseError, "cannot begin another one"):
            ionskin.run(small_case(), only="mechanics", progress=begin_another)
        self.assertTrue(ionskin.run(small_case(), only="mechanics").metrics)

    def test_a_fork_during_a_run(self):
        """The copy is told why it cannot solve; the run goes on."""
        codes = []

        def fork(activity, fraction):
            if codes:
                return
            codes.append(None)

            def in_another_thread():
                process = os.fork()
                if process == 0:
                    try:
                        ionskin.run(small_case(), only="mechanics")
                    except ionskin.CaseError as error:
                        os._exit(7 if "was forked while" in str(error) else 8)
                    os._exit(9)
                codes.append(exit_code(process))

            other = threading.Thread(target=in_another_thread)
            other.start()
            other.join()

        result = ionskin.run(small_case(), only="mechanics", progress=fork)
        self.assertEqual(codes, [None, 7])
        self.assertTrue(result.metrics)

    def test_a_fork_in_a_progress_callable_ends_at_its_return(self):
        codes = []

        def fork(activity, fraction):
            if codes:
                return
            process = os.fork()
            if process:
                codes.append(exit_code(process))

        self.assertTrue(ionskin.run(small_case(), only="mechanics", progress=fork).metrics)
        self.assertEqual(codes, [2])

    def test_a_fork_before_and_after_runs(self):
        ionskin.run(small_case(), only="mechanics")
        process = os.fork()
        if process == 0:
            os._exit(0 if ionskin.run(small_case(), only="mechanics").metrics else 1)
        self.assertEqual(exit_code(process), 0)

    def test_ctrl_c_ends_the_wait_for_another_run(self):
        script = """
import os, signal, threading, time
import ionskin
from package import small_case
begun, waiting = threading.Event(), threading.Event()
def hold(activity, fraction):
    begun.set()
    waiting.wait(60)
other = threading.Thread(target=lambda: ionskin.run(small_case(), only="mechanics", progress=hold))
other.start()
begun.wait(60)
threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT)).start()
try:
    ionskin.run(small_case(), only="mechanics")
except KeyboardInterrupt:
    print("interrupted")
waiting.set()
other.join()
"""
        done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=120, check=False,
                              cwd=os.path.dirname(os.path.abspath(__file__)))
        self.assertEqual((done.returncode, done.stdout), (0, "interrupted\n"), done.stderr)

    def test_a_folder_whose_name_is_not_utf_8(self):
        folder = os.path.join(os.fsencode(self.folder), b"out\xff")
        name = os.fsdecode(folder)
        result = ionskin.run(small_case(), name, only="mechanics")
        self.assertTrue(result.metrics)
        self.assertTrue(os.path.exists(os.path.join(folder, b"results.h5")))
        with result.open_fields() as file:
            self.assertIn("strain", file)
        self.assertTrue(ionskin.open_results(name).metrics)
        with self.assertRaisesRegex(ionskin.CaseError, r"out\\xff already holds files"):
            ionskin.run(small_case(), name, only="mechanics")

    def test_a_measurement_in_latin_1(self):
        data = self.folder / "data.csv"
        data.write_bytes("time [s],current_top [\u00b5A]\n0,1\n1,2\n".encode("latin-1"))
        with self.assertRaises(ionskin.CaseError) as raised:
            ionskin.fit(small_case(), data, ["coupling.coefficient"], self.folder / "fit")
        self.assertIn("data.csv", str(raised.exception))
        self.assertIn(r"\xb5A", str(raised.exception))


class DamagedResults(PackageTest):
    @classmethod
    def setUpClass(cls):
        cls.whole = ionskin.run(small_case(), only="mechanics")

    def damaged(self):
        return shutil.copytree(self.whole.folder, self.folder / "damaged", dirs_exist_ok=True)

    def test_text_files(self):
        for name, content in (("signals.csv", b"time [s]\n\xb5\n"), ("signals.csv", b""), ("sampled.csv", b"time [s]\nx\n"),
                              ("summary.json", b"{"), ("summary.json", b"[1]"), ("manifest.json", b"\xff"),
                              ("case.toml", b"= 1")):
            folder = self.damaged()
            (folder / name).write_bytes(content)
            with self.subTest(name, content=content), self.assertRaisesRegex(ionskin.CaseError, f"{name} is damaged"):
                ionskin.open_results(folder)

    def test_fields(self):
        folder = self.damaged()
        path, result = folder / "results.h5", ionskin.open_results(folder)
        content = path.read_bytes()
        for damage, words in ((content[:1000], "is damaged"), (b"text", "is damaged")):
            path.write_bytes(damage)
            with self.assertRaisesRegex(ionskin.CaseError, words):
                result.open_fields()
        path.unlink()
        os.mkfifo(path)
        with self.assertRaisesRegex(ionskin.CaseError, "is not a regular file"):
            result.open_fields()

    def test_links_to_other_files_are_not_followed(self):
        folder = self.damaged()
        (folder / "secret").write_bytes(bytes(64))
        traps = {
            "external": lambda file: file.__setitem__("trap", h5py.ExternalLink("other.h5", "/data")),
            "soft": lambda file: file.__setitem__("trap", h5py.SoftLink("/strain")),
            "raw data": lambda file: file.create_dataset("trap", (8,), "f8", external=[(folder / "secret", 0, 64)]),
            "virtual": lambda file: file.create_virtual_dataset("trap", self.layout()),
        }
        for name, trap in traps.items():
            with h5py.File(folder / "results.h5", "r+") as file:
                trap(file)
            with self.subTest(name), self.assertRaisesRegex(ionskin.CaseError, "/trap"):
                ionskin.open_results(folder).open_fields()
            with h5py.File(folder / "results.h5", "r+") as file:
                del file["trap"]

    @staticmethod
    def layout():
        layout = h5py.VirtualLayout((8,), "f8")
        layout[:] = h5py.VirtualSource("missing.h5", "/data", (8,))
        return layout


if __name__ == "__main__":
    unittest.main()
