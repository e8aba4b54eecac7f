# SPDX-License-Identifier: Apache-2.0
"""A run folder that was damaged in any way is resumed to the same result, or answered with a clear message."""

import json
import random
import shutil
import signal
import unittest

from program import QUICK, SMALL, ProgramTest, signals, summary

SEED = 20261122
DAMAGED = 12  # folders


def flip(content, dice):
    """A few bytes, other than they were."""
    content = bytearray(content)
    for _ in range(dice.randint(1, 4)):
        content[dice.randrange(len(content))] ^= 1 << dice.randrange(8)
    return bytes(content)


def cut(content, dice):
    return content[: dice.randrange(len(content))]


def blank(content, dice):
    """A block of zeros, as a power cut leaves it."""
    start = dice.randrange(len(content))
    length = min(len(content) - start, dice.choice((16, 512, 4096)))
    return content[:start] + bytes(length) + content[start + length:]


def lengthen(content, dice):
    return content + dice.randbytes(dice.randint(1, 600))


class CorruptFolders(ProgramTest):
    def setUp(self):
        super().setUp()
        self.run_case(QUICK, "-o", "whole", *SMALL)
        self.run_case(QUICK, "-o", "other", *SMALL, "--set", "contact.friction=0.1")
        self.expected = (self.folder / "whole" / "signals.csv").read_bytes()
        self.metrics = summary(self.folder / "whole")["metrics"]
        self.unfinished()

    def unfinished(self):
        """A folder whose run ended in Study 2, with a checkpoint."""
        self.end_at_progress("ion transport", "run", QUICK, "--no-report", "-o", "begun", *SMALL, how=signal.SIGTERM)
        self.assertTrue((self.folder / "begun" / "checkpoint.h5").exists())

    def damage(self, folder, dice):
        """Spoils one file of a folder; returns what was done."""
        names = [name for name in ("results.h5", "checkpoint.h5", "manifest.json", "summary.json", "signals.csv")
                 if (folder / name).exists()]
        path = folder / dice.choice(names)
        way = dice.choice((flip, flip, cut, blank, lengthen, "swap", "remove", "edit"))
        if way == "swap" and path.name == "manifest.json":
            way = "remove"  # that of another case is refused
        if way == "swap":
            shutil.copy(self.folder / "other" / ("results.h5" if path.suffix == ".h5" else path.name), path)
        elif way == "remove":
            path.unlink()
        elif way == "edit":
            path = folder / "manifest.json"
            manifest = json.loads(path.read_text())
            for stage in ("mechanics", "strain", "electrochemistry", "output"):
                manifest["stages"][stage] = {"state": "finished", "wall_time_s": 1.0, "peak_memory_bytes": 1.0}
            manifest["state"] = "finished"
            path.write_text(json.dumps(manifest))
        else:
            path.write_bytes(way(path.read_bytes(), dice))
        return f"{folder.name}: {getattr(way, '__name__', way)} {path.name}"

    def test_resumed_result_is_the_clean_one(self):
        dice = random.Random(SEED)
        for number in range(DAMAGED):
            out = self.folder / "damaged"
            shutil.copytree(self.folder / ("whole" if number % 2 else "begun"), out)
            done = f"{number}, {self.damage(out, dice)}"
            with self.subTest(done):
                process = self.run_program("run", QUICK, "--no-report", "-o", "damaged", *SMALL, "--resume")
                self.assertEqual((out / "signals.csv").read_bytes(), self.expected, done + process.stderr)
                self.assertEqual(summary(out)["metrics"], self.metrics, done)
            shutil.rmtree(out)

    def test_damage_is_reported(self):
        out = self.folder / "begun"
        for name in ("results.h5", "checkpoint.h5"):
            content = bytearray((out / name).read_bytes())
            content[len(content) // 2] ^= 1
            (out / name).write_bytes(content)
        self.run_case(QUICK, "-o", "begun", *SMALL, "--resume")
        warnings = " ".join(summary(out)["warnings"])
        for name in ("results.h5", "checkpoint.h5"):
            self.assertIn(f"{name} was damaged", warnings)
        self.assertEqual(sorted(signals(out)), sorted(signals(self.folder / "whole")))


if __name__ == "__main__":
    unittest.main()
