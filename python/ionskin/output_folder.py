# SPDX-License-Identifier: Apache-2.0
"""Files in an output folder of the program: only its own are replaced, and no link is followed."""

import contextlib
import os
import pathlib
import tempfile

from .errors import CaseError
from .reading import files

LIST = ".ionskin-files"
PENDING = ".ionskin-pending"
LARGEST_LIST = 64 << 20  # bytes


@contextlib.contextmanager
def writing(path):
    """Gives a place to write a file of this name; the file appears when it is whole.

    `path` is FOLDER/NAME of an output folder, or FOLDER/figures/NAME. Raises CaseError where a file of the user or a
    link is in the way.
    """
    path = pathlib.Path(path)
    inside = path.parent.name == "figures"
    folder = path.parent.parent if inside else path.parent
    if inside:
        if path.parent.is_symlink():
            raise CaseError(f"{path.parent} is a link, and ionskin writes nothing through a link out of its folder\n"
                            "  = remove the link")
        path.parent.mkdir(exist_ok=True)
    _note(folder, f"figures/{path.name}" if inside else path.name, path)
    handle, pending = tempfile.mkstemp(prefix=f"{path.name}.", suffix=PENDING, dir=path.parent)
    try:
        os.close(handle)
        umask = os.umask(0)
        os.umask(umask)
        os.chmod(pending, 0o666 & ~umask)
        yield pathlib.Path(pending)
        os.replace(pending, path)
    except BaseException:
        with contextlib.suppress(FileNotFoundError):
            os.unlink(pending)
        raise


def save(figure, path, **settings):
    """Saves a figure of matplotlib; the suffix of the path tells the format."""
    path = pathlib.Path(path)
    with writing(path) as pending:
        figure.savefig(pending, format=path.suffix[1:], **settings)


def write_text(path, text):
    """Writes a text into a file, whole or not at all."""
    with writing(path) as pending:
        pending.write_text(text, encoding="utf-8")


def listed(folder):
    """The names in the list of a folder; None where it keeps none, as those of earlier versions."""
    entries = pathlib.Path(folder, LIST)
    if not entries.is_file() or entries.is_symlink():
        return None
    with files.open_ordinary(entries, LARGEST_LIST) as file:
        names = file.read().decode("utf-8", errors="replace").splitlines()
    return [name for name in names if name and not name.startswith("#")]


def _note(folder, name, path):
    """Adds a name to the list of the folder, if it keeps one."""
    names = listed(folder)
    if names is None or name in names:
        return
    if os.path.lexists(path):
        raise CaseError(f"{path} is in the way of a result and was not written by ionskin, which replaces its own files "
                        "only\n  = move it away")
    with open(folder / LIST, "a", encoding="utf-8") as file:
        file.write(f"\n{name}\n")
