# SPDX-License-Identifier: Apache-2.0
"""Treatment of the user's files by the program: it removes its own only, follows no link, and survives disks that are
full."""

import json
import os
import resource
import shutil
import signal
import subprocess
import unittest

from program import PROGRAM, QUICK, ROOT, SMALL, ProgramTest, signals, summary


class UsersFiles(ProgramTest):
    def small(self, out, *arguments, expect=0):
        return self.run_case(QUICK, "-o", out, *SMALL, *arguments, expect=expect)

    def test_overwrite_leaves_what_is_the_users(self):
        self.run_program("run", QUICK, "-o", "out", *SMALL)
        self.run_program("report", "out", "--figure", "fig02_layers")
        out, pictures = self.folder / "out", self.folder / "Pictures"
        drawn = sorted((out / "figures").iterdir())
        self.assertTrue(drawn)
        for name in ("notes.txt", "figures/own.png", "fields/view.pvsm"):
            self.write(f"out/{name}", "mine")
        pictures.mkdir()
        self.write("Pictures/holiday.png", "mine")
        self.small("out", "--overwrite")
        for name in ("notes.txt", "figures/own.png", "fields/view.pvsm"):
            self.assertEqual((out / name).read_text(), "mine")
        self.assertFalse(any(path.exists() for path in drawn))
        (out / "figures" / "own.png").unlink()
        (out / "figures").rmdir()
        (out / "figures").symlink_to(pictures)
        before = (out / "signals.csv").read_text()
        for option in ("--overwrite", "--resume"):
            self.assertIn("is a link", self.small("out", option, expect=2).stderr)
        self.assertEqual((out / "signals.csv").read_text(), before)
        self.assertIn("is a link", self.run_program("report", "out", "--figures", expect=2).stderr)
        self.assertEqual([path.name for path in pictures.iterdir()], ["holiday.png"])

    def test_overwrite_of_a_sweep(self):
        sweep = ("sweep", QUICK, "-o", "out", "--only", "mechanics", "--no-report", *SMALL, "--over")
        self.run_program(*sweep, "contact.friction=0.1,0.2")
        first, second = sorted((self.folder / "out" / "points").iterdir())
        (second / "notes.txt").write_text("mine")
        self.run_program(*sweep, "contact.friction=0.1,0.3", "--overwrite")
        self.assertTrue((first / "summary.json").exists())
        self.assertEqual([path.name for path in second.iterdir() if path.name[0] != "."], ["notes.txt"])

    def test_two_runs_in_one_folder(self):
        with self.stopped_at_file(2, "run", QUICK, "-o", "out", "--no-report", "--quiet", below="out/manifest.json"):
            for option in ("--resume", "--overwrite"):
                process = self.run_case(QUICK, "-o", "out", option, expect=2)
                self.assertIn("another ionskin is writing", process.stderr)
        self.small("out", "--overwrite")

    def test_finished_run_is_not_solved_again(self):
        self.small("out")
        before = (self.folder / "out" / "results.h5").stat()
        self.run_program("run", QUICK, "-o", "out", *SMALL, "--resume")
        after = (self.folder / "out" / "results.h5").stat()
        self.assertEqual(before.st_mtime_ns, after.st_mtime_ns)
        self.assertTrue((self.folder / "out" / "report.html").exists())
        # What is missing is made again.
        table = (self.folder / "out" / "signals.csv").read_bytes()
        (self.folder / "out" / "signals.csv").unlink()
        self.small("out", "--resume")
        self.assertEqual((self.folder / "out" / "signals.csv").read_bytes(), table)

    def test_material_preset_belongs_to_the_case(self):
        data = self.folder / "data"
        for name in ("cases", "materials"):
            shutil.copytree(ROOT / name, data / name)
        os.environ["IONSKIN_DATA"] = str(data)
        self.addCleanup(os.environ.pop, "IONSKIN_DATA")
        self.small("out")
        preset = data / "materials" / "platinum.toml"
        text = preset.read_text()
        preset.write_text(text.replace('youngs_modulus = "', 'youngs_modulus = "1', 1))
        self.assertNotEqual(preset.read_text(), text)
        self.assertIn("material preset", self.small("out", "--resume", expect=2).stderr)


class Disks(ProgramTest):
    def limited(self, out, size, *arguments):
        """A run whose files may not grow beyond a size."""
        return subprocess.run([PROGRAM, "run", QUICK, "-o", out, "--no-report", *SMALL, *arguments], cwd=self.folder,
                              capture_output=True, text=True, check=False,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)))

    def test_limit_on_file_sizes(self):
        self.run_case(QUICK, "-o", "whole", *SMALL)
        largest = max((path.stat().st_size, path.name) for path in (self.folder / "whole").rglob("*") if path.is_file())
        sizes = sorted({path.stat().st_size - 1 for path in (self.folder / "whole").rglob("*") if path.is_file()})
        self.assertGreater(len(sizes), 5, largest)
        expected = signals(self.folder / "whole")
        for number, size in enumerate(sizes[:: len(sizes) // 4]):
            out = f"limited{number}"
            process = self.limited(out, size)
            self.assertIn(process.returncode, (0, 2), process.stderr)
            if process.returncode == 2:
                self.assertIn("File too large", process.stderr)
                self.assertNotIn("unknown reason", process.stderr)
                self.run_case(QUICK, "-o", out, "--resume", *SMALL)
            for name, values in signals(self.folder / out).items():
                self.assertEqual(values.tobytes(), expected[name].tobytes(), name)

    def test_output_that_cannot_be_written(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            for arguments in (("keys",), ("cite",), ("run", QUICK, "-o", "out", "--no-report", *SMALL)):
                process = subprocess.run([PROGRAM, *arguments], stdout=full, stderr=subprocess.PIPE, text=True,
                                         cwd=self.folder, check=False)
                self.assertEqual(process.returncode, 2, process.stderr)
                self.assertIn("No space left", process.stderr)
        self.assertTrue(summary(self.folder / "out")["metrics"])

    def test_closed_terminal(self):
        self.end_at_progress("mechanics", "run", QUICK, *SMALL, "--no-report", "-o", "out", how=signal.SIGHUP)
        manifest = json.loads((self.folder / "out" / "manifest.json").read_text())
        self.assertEqual(manifest["state"], "interrupted")


if __name__ == "__main__":
    unittest.main()
