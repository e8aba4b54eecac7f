# SPDX-License-Identifier: Apache-2.0
"""Writing of files in an output folder: replaces only files that ionskin wrote, and follows no link."""

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
    """Context that yields a temporary path to write a file to; at its end the file gets the name `path`, whole or not
    at all.

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
    try:
        handle, pending = tempfile.mkstemp(prefix=f"{path.name}.", suffix=PENDING, dir=path.parent)
    except OSError as error:  # names the file of the user, not the pending one
        raise OSError(error.errno, error.strerror, str(path)) from None
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
    """Saves a matplotlib figure in the format that the suffix of the path names; `settings` go
    to savefig. Raises CaseError as `writing`."""
    path = pathlib.Path(path)
    with writing(path) as pending:
        figure.savefig(pending, format=path.suffix[1:], **settings)


def write_text(path, text):
    """Writes a text into a file, whole or not at all. Raises CaseError as `writing`."""
    with writing(path) as pending:
        pending.write_text(text, encoding="utf-8")


def listed(folder):
    """Names of the files that ionskin wrote into a folder; None for a folder without
    such a list, as earlier versions left it."""
    entries = pathlib.Path(folder, LIST)
    if not entries.is_file() or entries.is_symlink():
        return None
    with files.open_ordinary(entries, LARGEST_LIST) as file:
        names = file.read().decode("utf-8", errors="replace").splitlines()
    return [name for name in names if name and not name.startswith("#")]


def _note(folder, name, path):
    """Adds a name to the list of files that ionskin wrote into the folder, if the folder has such a list.

    Raises CaseError when the file exists and is not in the list.
    """
    names = listed(folder)
    if names is None or name in names:
        return
    if os.path.lexists(path):
        raise CaseError(f"{path} is in the way of a result and was not written by ionskin, which replaces its own files "
                        "only\n  = move it away")
    with open(folder / LIST, "a", encoding="utf-8") as file:
        file.write(f"\n{name}\n")
