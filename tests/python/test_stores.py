# SPDX-License-Identifier: Apache-2.0
"""Stores of studies that were damaged or planted: every file in every way is made anew or refused with a remedy, and nothing
outside the folder is touched."""

import contextlib
import io
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import unittest
from unittest import mock

import numpy

import ionskin
from ionskin.design import __main__ as design
from ionskin.evaluation import Outcome, StudyFolder
from ionskin.generation import __main__ as generation
from ionskin.reading.hdf5 import open_hdf5
from ionskin.results import Results
from ionskin.uncertainty import __main__ as uncertainty
from package import CASES, PackageTest
from tiers import long_test

K, D = "coupling.coefficient", "electrochemistry.diffusivity"
STUDIES = {
    "uncertainty": (uncertainty, {"samples": 16, "design": "sobol", "metrics": [], "least_q2": 0.95,
                                  "vary": [f"{K}=uniform(0.05, 0.15)", f"{D}=uniform(6e-11 m2/s, 8e-11 m2/s)"]}),
    "design": (design, {"budget": 10, "free": [f"{K}=0.05:0.15"], "maximise": "peak_mean_shear", "minimise": "",
                        "subject_to": ["normal_force_slide < 30 N"]}),
    "generate": (generation, {"touches": 3, "vary": [f"{K}=uniform(0.05, 0.15)"]}),
}
DEEP = "[" * 100_000 + "]" * 100_000
TEXTS = {"empty": "", "a bracket": "[", "deep": DEEP, "deep within": '{"study": ' + DEEP + "}", "without end": "[" * 100_000, "a number": "3", "null": "null",
         "a list": "[]", "an object": "{}", "a text": '"study"', "true": "true", "wrong types": '{"study": 3, "case": [], "vary": 1}',
         "not a number": '{"study": NaN}', "infinite": '{"study": 1e999}', "huge": '{"seed": 1' + "0" * 5000 + "}",
         "of a list": '{"study": {"study": {"study": [[[]]]}}}', "cut off": '{"study": "uncert', "commas": "{,,,}",
         "zeros": "\0" * 4096, "lines": "\n" * 10_000, "names": "../../victim\n/etc/passwd\n..\n.\npoints\nfigures\nstudy.json\n"}
LONGEST = 600  # of one call, so that what waits for ever ends [s]
SHAPES = ("pipe", "folder", "folder with a file", "loop", "link to nothing", "link to a device", "link to a file")


class Instant:
    """An engine whose runs take no time."""

    workers = 1

    def evaluate(self, case, trials, folder, on_result):
        """Evaluates as LocalEngine.evaluate does."""
        for trial in trials:
            path = folder / f"{trial.number:06}.npz"
            outcome_of(trial).write(path)
            on_result(trial, Outcome.read_back(path))


def outcome_of(trial):
    """A smooth function of the values in the place of a run."""
    value = 1 + sum(trial.values.values())
    time = numpy.linspace(0, 0.01, 11)
    metrics = {"peak_mean_shear": value, "normal_force_slide": 2 + 1e-3 * value}
    columns = {f"{table}/{name}": time if name == "time" else value * numpy.sin(300 * time) for table in ("signals", "sampled")
               for name in ("time", "mean_shear", "normal_force", "current_top", "slider_x")}
    units = {"peak_mean_shear": "1", "normal_force_slide": "N"} | {name: "1" for name in columns}
    return Outcome(metrics, units, columns)


def damage(path, way, victim):
    """Puts a text, bytes, or something that is not an ordinary file in the place of a file."""
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path)
    elif os.path.lexists(path):
        path.unlink()
    if way == "pipe":
        os.mkfifo(path)
    elif way in ("folder", "folder with a file"):
        path.mkdir()
        if way != "folder":
            (path / "file").write_text("the user's")
    elif way in ("loop", "link to nothing", "link to a device", "link to a file"):
        path.symlink_to({"loop": path, "link to nothing": path.parent / "nothing", "link to a device": "/dev/zero"}.get(way, victim))
    elif isinstance(way, bytes):
        path.write_bytes(way)
    else:
        path.write_text(way)


class Stores(PackageTest):
    def setUp(self):
        super().setUp()
        self.out, self.victim = self.folder / "out", self.folder / "victim"
        self.victim.write_text("untouched")
        subprocess.run([sys.executable, CASES / "make_strain.py", self.folder / "strain.h5"], check=True)
        self.case = pathlib.Path(shutil.copy(CASES / "strain_file.toml", self.folder))
        signal.signal(signal.SIGALRM, lambda *_: self.fail("it hangs"))
        signal.alarm(LONGEST)
        self.addCleanup(signal.alarm, 0)

    def main(self, study, *more):
        """Runs a study and returns its exit code and what it said on standard error."""
        signal.alarm(LONGEST)  # anew: a test makes hundreds of calls
        module, arguments = STUDIES[study]
        said, locks = io.StringIO(), []

        class Kept(StudyFolder):
            """A study folder whose lock goes with this call, as it goes with a process."""

            def _lock(self):
                super()._lock()
                locks.append(self)

        options = {"case_path": os.fspath(self.case), "output": os.fspath(self.out), "set_edits": [], "threads": 0, "on": "", "seed": 1,
                   "balance": 0, "quiet": True, **{flag: flag in more for flag in ("resume", "overwrite")}, **arguments}
        with mock.patch.object(sys, "argv", [study, json.dumps(options)]), mock.patch.object(module, "engine", lambda *_, **__: Instant()), \
                mock.patch.object(module, "StudyFolder", Kept), contextlib.redirect_stderr(said), \
                contextlib.redirect_stdout(io.StringIO()):
            try:
                with uncertainty.guarded():
                    code = module.main()
            except SystemExit as end:
                code = end.code
            finally:
                for one in locks:
                    one.close()
        return code, said.getvalue()

    def assert_answered(self, study, option):
        """A tampered store is taken up, or refused with a remedy and without the words of Python."""
        code, said = self.main(study, option)
        self.assertIn(code, (0, 2), said)
        if code == 2:
            self.assertRegex(said, r"^error: (.|\n)*\n  = ")
            self.assertNotRegex(said, r"Traceback|Errno|[A-Z][A-Za-z]*Error")
        self.assertEqual(self.victim.read_text(), "untouched")

    @long_test
    def test_every_file_in_every_way(self):
        """Every file of `generate` is tried in every way; of the others, those that they alone read."""
        for study in STUDIES:
            self.assertEqual(self.main(study)[0], 0)
            whole = self.folder / f"whole-{study}"
            self.out.rename(whole)
            names = ("study.json", "points/000001.npz", ".ionskin-files", "case.toml", "points", "figures")
            for name in names if study == "generate" else names[:2]:
                texts = name in names[:3]
                for what, way in {**(self.texts(whole / name) if texts else {}), **{shape: shape for shape in SHAPES}}.items():
                    if study == "generate" or what in ("half", "deep", "null", "pipe", "folder", "loop"):
                        with self.subTest(study=study, name=name, way=what):
                            self.tamper(study, whole, name, way)

    @staticmethod
    def texts(path):
        """Texts that may stand in the place of a file."""
        content = path.read_bytes()
        return {**TEXTS, "half": content[:len(content) // 2], "changed": content[::-1]}

    def tamper(self, study, whole, name, way):
        """A copy of a whole study with one file changed is taken up or refused; --overwrite touches nothing outside."""
        shutil.copytree(whole, self.out, symlinks=True)
        self.addCleanup(shutil.rmtree, self.out, ignore_errors=True)
        damage(self.out / name, way, self.victim)
        with mock.patch.object(uncertainty.output, "write"):
            self.assert_answered(study, "resume")
            if way in SHAPES:
                self.assert_answered(study, "overwrite")
        shutil.rmtree(self.out)

    @long_test
    def test_outcomes_that_are_none(self):
        """Each is read as missing, so that its trial is run again; the numbers of the study are then those of a whole one."""
        with mock.patch.object(uncertainty.output, "indices_figure", lambda *_: None), \
                mock.patch.object(uncertainty.output, "bands_figure", lambda *_: None):
            self.take_up_damaged_outcomes()

    def take_up_damaged_outcomes(self):
        """Without the figures, which take longer than all else."""
        self.assertEqual(self.main("uncertainty")[0], 0)
        wanted = (self.out / "uncertainty.json").read_text()
        path = self.out / "points" / "000003.npz"
        whole = Outcome.read(path)
        time = whole.columns["signals/time"]

        def head(**parts):
            return json.dumps({"metrics": whole.metrics, "units": whole.units, "reason": ""} | parts)

        def other(**columns):
            return dict(whole.columns, **{name.replace("__", "/"): values for name, values in columns.items()})

        tampered = [
            *((text, whole.columns) for text in TEXTS.values()),
            *((head(metrics=metrics), whole.columns) for metrics in (
                3, [], None, "metrics", {"peak_mean_shear": "1"}, {"peak_mean_shear": None}, {"peak_mean_shear": True},
                {"peak_mean_shear": float("nan")}, {"peak_mean_shear": float("inf")}, {"peak_mean_shear": 1e300},
                {"peak_mean_shear": 10**400}, {"peak_mean_shear": [1]}, {"of no unit": 1.0})),
            (head(units=3), whole.columns), (head(units={"peak_mean_shear": 3}), whole.columns), (head(reason=3), whole.columns),
            (head(), other(signals__time=time[::-1])), (head(), other(signals__time=time * numpy.nan)),
            (head(), other(signals__mean_shear=time[:3])), (head(), other(signals__mean_shear=numpy.full(11, numpy.inf))),
            (head(), other(signals__mean_shear=numpy.full(11, 1e300))), (head(), other(signals__mean_shear=numpy.arange(11))),
            (head(), other(signals__mean_shear=numpy.ones((11, 11)))), (head(), other(signals__mean_shear=numpy.array(["a"] * 11))),
            (head(), other(others__time=time)), (head(), other(alone=time)), (head(), other(signals__bomb=numpy.zeros(1 << 28))),
            (head(), {name: values for name, values in whole.columns.items() if name != "signals/time"})]
        for number, (text, columns) in enumerate(tampered):
            with open(path, "wb") as file:
                numpy.savez_compressed(file, head=numpy.array(text), **columns)
            self.assertIsNone(Outcome.read(path), number)
        with open(path, "wb") as file:
            numpy.savez(file, head=numpy.array([{"metrics": {}}], dtype=object))  # a pickle
        self.assertIsNone(Outcome.read(path))
        self.assertEqual(self.main("uncertainty", "resume")[0], 0)
        self.assertEqual((self.out / "uncertainty.json").read_text(), wanted)

    def test_what_a_list_names_outside_stays(self):
        outside = self.folder / "pictures"
        outside.mkdir()
        (outside / "mine.png").write_text("mine")
        self.assertEqual(self.main("generate")[0], 0)
        with open(self.out / ".ionskin-files", "a", encoding="utf-8") as file:
            file.write("../victim\nfigures/mine.png\nfigures/../../victim\n..\n")
        (self.out / "figures").symlink_to(outside)
        self.assertEqual(self.main("generate", "overwrite")[0], 2)
        self.assertEqual((self.victim.read_text(), (outside / "mine.png").read_text()), ("untouched", "mine"))
        (self.out / "figures").unlink()
        self.assertEqual(self.main("generate", "overwrite")[0], 0)
        self.assertEqual(self.victim.read_text(), "untouched")

    def test_a_study_that_still_runs_is_not_overwritten(self):
        self.assertEqual(self.main("generate")[0], 0)
        before = sorted(os.listdir(self.out))
        running = StudyFolder(self.out, json.loads((self.out / "study.json").read_text()), resume=True)
        code, said = self.main("generate", "overwrite")
        self.assertEqual((code, sorted(os.listdir(self.out))), (2, before))
        self.assertIn("another process works in", said)
        running.close()
        self.assertEqual(self.main("generate", "overwrite")[0], 0)

    def test_a_pipe_as_case_is_refused(self):
        os.mkfifo(self.folder / "case.toml")
        with self.assertRaisesRegex(ionskin.CaseError, "a pipe"):
            ionskin.Case.from_file(self.folder / "case.toml")

    def test_disks_that_are_too_small_are_reported_before_any_work(self):
        self.case = CASES / "paper" / "coarse.toml"  # a strain file tells how long it lasts when it is read
        with mock.patch.dict(os.environ, {"IONSKIN_DISK_LIMIT": "1 kB"}):
            for study in STUDIES:
                code, said = self.main(study)
                self.assertEqual((code, self.out.exists()), (2, False), said)
                self.assertIn("IONSKIN_DISK_LIMIT", said)


class Folders(PackageTest):
    def test_runs_whose_records_are_none(self):
        """A run that has not ended is recognised by its manifest, whatever stands there."""
        for text in ("[]", "3", "null", '{"state": 1, "stages": 3}', '{"state": 1, "stages": {"ions": 3}}', '{"state": NaN}', DEEP, ""):
            (self.folder / "manifest.json").write_text(text)
            for more in ({}, {"unfinished": True}):
                with self.subTest(text[:40], **more), self.assertRaises(ionskin.CaseError):
                    Results(self.folder, **more)
        (self.folder / "manifest.json").unlink()
        (self.folder / "results.h5").symlink_to(self.folder / "results.h5")
        with self.assertRaises(FileNotFoundError):
            Results(self.folder, unfinished=True)
        with self.assertRaisesRegex(ionskin.CaseError, "cannot be read"):
            open_hdf5(self.folder / "results.h5")


class Sweeps(PackageTest):
    def test_tables_that_are_none(self):
        """sweep.csv and the manifest of a sweep's folder, and a point that leads out of it."""
        header = "point,folder,contact.friction [1],status,reason,peak [1]\n"
        row = "1,points/0001_friction=0.1,0.1,finished,,2\n"
        path = self.folder / "sweep.csv"
        path.write_text(header + row)
        self.assertEqual(ionskin.open_results(self.folder).points[0].metrics, {"peak": 2.0})
        for text in ("", "x", header + "1\n", header + row.replace("points/", "../"), header + row.replace("points/0001", "/etc/0001"), header + row.replace("points/0001_friction=0.1", "points/.."),
                     header + row.replace("0.1,finished", "high,finished"), header + row.replace("1,points", "one,points"),
                     header + row.replace("points/0001", "points/0001/../../x"), "\0" * 100, header + '"' + row):
            path.write_text(text)
            with self.assertRaisesRegex(ionskin.CaseError, "is damaged"):
                ionskin.open_results(self.folder)
        path.unlink()
        os.mkfifo(path)
        with self.assertRaisesRegex(ionskin.CaseError, "a pipe"):
            ionskin.open_results(self.folder)
        path.unlink()
        path.write_text(header + row)
        (self.folder / "manifest.json").write_text(DEEP)
        with self.assertRaisesRegex(ionskin.CaseError, "is damaged"):
            ionskin.open_results(self.folder)


if __name__ == "__main__":
    unittest.main()
