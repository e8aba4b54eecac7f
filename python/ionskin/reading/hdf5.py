# SPDX-License-Identifier: Apache-2.0
"""Safe opening of results.h5 in a folder that may come from elsewhere."""

import os
import stat

from ..errors import CaseError


_found_plain = set()  # what tells a file from any other, and from itself once it is written again


def open_hdf5(path):
    """Opens an HDF5 file to read, as an h5py.File, and requires that all its values are in the file itself.

    Raises FileNotFoundError when it is missing, and CaseError when it is no ordinary file, is damaged, or has links or
    datasets that refer to other files; none of these is followed.
    """
    import h5py  # costs a quarter of a second that most readers need not pay

    try:
        about = os.stat(path)
    except FileNotFoundError:
        raise
    except OSError as error:  # a link to itself
        raise CaseError(f"{path} cannot be read: {error.strerror}\n  = name the folder of a run") from error
    if not stat.S_ISREG(about.st_mode):
        raise CaseError(f"{path} is not a regular file\n  = name the folder of a run")
    try:
        file = h5py.File(path, "r")
    except OSError as error:
        raise _damaged(path, error) from error
    same = (about.st_dev, about.st_ino, about.st_size, about.st_mtime_ns, about.st_ctime_ns)
    if same in _found_plain:  # as a report opens it for each of its figures
        return file
    try:
        _require_plain(file, h5py, path)
    except BaseException:
        file.close()
        raise
    _found_plain.add(same)
    return file


def _damaged(path, error):
    return CaseError(f"{path} is damaged: {error}\n  = run the case again")


def _require_plain(root, h5py, path):
    groups, seen = [root], set()
    try:
        while groups:
            group = groups.pop()
            for name in group:
                place = f"{group.name.rstrip('/')}/{name}"
                link = group.get(name, getlink=True)
                if not isinstance(link, h5py.HardLink):
                    raise CaseError(f"{path}: {place} is a link to elsewhere, which is not followed\n"
                                    "  = copy what it leads to into the file itself")
                member = group[name]
                if isinstance(member, h5py.Dataset):
                    if member.is_virtual or member.external:
                        raise CaseError(f"{path}: {place} keeps its values in another file, which is not opened\n"
                                        "  = write its values into the file itself")
                elif member.id not in seen:  # a group may hold itself
                    seen.add(member.id)
                    groups.append(member)
    except (OSError, RuntimeError, KeyError) as error:
        raise _damaged(path, error) from error
