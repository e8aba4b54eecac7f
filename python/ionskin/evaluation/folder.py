# SPDX-License-Identifier: Apache-2.0
"""Folder of a study of many trials: the definition of the study, and the outcomes of its trials."""

import fcntl
import json
import os
import pathlib
import re
import stat

from .. import output_folder
from ..errors import CaseError
from ..reading import files
from ..words import short
from .trial import Outcome

QUESTION = "study.json"
OUTCOME = re.compile(r"\d{6}\.npz", re.ASCII)
INNER = re.compile(r"(figures/)?(?!\.{1,2}$)[^/\0]+")  # name of a file of the folder


class StudyFolder:
    """Folder of a study, which stores the outcomes of its trials in FOLDER/points. One process may use it at a time.

    question   dict that defines the trials, stored as study.json; a folder is resumed only with an equal one
    resume     True to continue the study that the folder holds
    overwrite  True to remove an earlier study's files first
    free       names in the question that may change when a study is resumed, such as the number of samples

    Raises CaseError when the folder holds something else, or another process uses it.
    """

    def __init__(self, folder, question: dict, *, resume: bool = False, overwrite: bool = False, free=()) -> None:
        if resume and overwrite:
            raise CaseError("overwrite and resume exclude each other")
        self.folder, self._points = pathlib.Path(folder), pathlib.Path(folder) / "points"
        if os.path.lexists(self.folder) and not self.folder.is_dir():
            raise CaseError(f"{folder} is not a folder\n  = give another one to --output")
        for inner in (self._points, self.folder / "figures"):
            if inner.is_symlink():
                raise CaseError(f"{inner} is a link, and ionskin writes nothing through a link\n  = remove the link")
            if inner.exists() and not inner.is_dir():
                raise CaseError(f"{inner} is not a folder, which a study keeps there\n  = move it away")
        self._held = None
        if overwrite and self._points.is_dir():
            self._lock()  # before anything of a study that still runs is removed
        former = {} if overwrite else _former(self.folder / QUESTION)
        if overwrite:
            self._remove()
        elif former and not resume:
            raise CaseError(f"{folder} holds a study\n  = --resume continues it, --overwrite begins anew")
        elif resume and not former:
            raise CaseError(f"{folder} holds no study to go on with\n  = leave --resume out")
        elif former:
            _require_same(former, question, free, folder)
        elif self.folder.exists() and any(self.folder.iterdir()):
            raise CaseError(f"{folder} holds other files\n  = give a new folder to --output")
        self._points.mkdir(parents=True, exist_ok=True)
        if self._held is None:
            self._lock()
        entries = self.folder / output_folder.LIST
        if os.path.lexists(entries):
            _require_ordinary(entries)
        else:
            entries.write_text("# What ionskin wrote here: --overwrite removes these files and no others.\n",
                               encoding="utf-8")
        self.write(QUESTION, question)

    @property
    def points(self) -> pathlib.Path:
        """Folder into which an engine writes outcomes."""
        return self._points

    def finished(self) -> dict[int, Outcome]:
        """Reads the finished outcomes, as a dict of trial number to Outcome; failed trials and damaged files are left out.

        Raises CaseError where an outcome is not an ordinary file.
        """
        return dict(self._each_finished())

    def finished_numbers(self) -> set[int]:
        """Numbers of the trials in `finished`, whose outcomes are read one at a time."""
        return {number for number, _ in self._each_finished()}

    def _each_finished(self):
        for path in sorted(path for path in self._points.iterdir() if OUTCOME.fullmatch(path.name)):
            _require_ordinary(path)
            outcome = Outcome.read(path)
            if outcome is not None and not outcome.reason:
                yield int(path.stem), outcome

    def write(self, name: str, content) -> None:
        """Writes a file of the folder: `content` if it is a text, else its JSON."""
        text = content if isinstance(content, str) else json.dumps(content, indent=1, ensure_ascii=False) + "\n"
        output_folder.write_text(self.folder / name, text)

    def _lock(self) -> None:
        self._held = os.open(self._points, os.O_RDONLY)
        try:
            fcntl.flock(self._held, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as error:
            os.close(self._held)
            raise CaseError(f"another process works in {self.folder}\n  = wait for it, or give another folder") from error

    def close(self) -> None:
        """Releases the folder for other processes."""
        os.close(self._held)

    def _remove(self) -> None:
        names = output_folder.listed(self.folder)
        if names is None:
            if self.folder.exists() and any(self.folder.iterdir()):
                raise CaseError(f"{self.folder} was not written by ionskin, which removes its own files only\n"
                                "  = give a new folder to --output")
            return
        ours = [self.folder / name for name in names if INNER.fullmatch(name)]
        if self._points.is_dir():
            ours += [path for path in self._points.iterdir() if OUTCOME.fullmatch(path.name) or path.name.endswith(".pending")]
        for path in ours:
            if os.path.lexists(path) and stat.S_ISDIR(os.lstat(path).st_mode):
                raise CaseError(f"{path} is a folder, where ionskin writes a file\n  = move it away")
        for path in ours:
            path.unlink(missing_ok=True)
        (self.folder / output_folder.LIST).unlink()


def _former(path) -> dict:
    """Reads the question of the study that a folder holds; {} where it holds none. Raises CaseError when it is damaged."""
    remedy = "--overwrite begins anew, or give another folder to --output"
    try:
        found = files.read_json(path, remedy=remedy)
    except FileNotFoundError:
        return {}
    if not isinstance(found, dict):
        raise CaseError(f"{path} is damaged: it is not a JSON object\n  = {remedy}")
    return found


def _require_ordinary(path) -> None:
    """Raises CaseError when a path is not an ordinary file; a link is none, since it leads elsewhere."""
    if not stat.S_ISREG(os.lstat(path).st_mode):
        raise CaseError(f"{path} is not an ordinary file, where ionskin writes one\n  = move it away")


def _require_same(former: dict, question: dict, free, folder) -> None:
    """Raises CaseError with the first difference between the questions of a former and this study, except in `free` names."""
    question = json.loads(json.dumps(question))
    for name in dict.fromkeys([*former, *question]):
        if name not in free and former.get(name) != question.get(name):
            if name == "case":
                raise CaseError(f"{folder} holds a study of another case\n  = give the same case, or another folder")
            raise CaseError(f"{folder} holds a study with {name} = {short(former.get(name))}, not {short(question.get(name))}\n"
                            "  = give the same, or another folder")
