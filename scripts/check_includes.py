#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Checks the rules of the house: includes point one way only, special libraries stay in their rooms, no folder is
crowded, and the table of folders in docs/house-rules.md is that of the tree."""

import pathlib
import re
import sys

# Rooms, each with its subfolders; "." are the files of the room itself. Both lists are in the order of includes: a file
# includes only what stands before it, or beside it in its own folder.
ROOMS = {
    "base": [".", "system", "files"],
    "parallel": ["."],
    "units": ["."],
    "laws": [".", "friction", "coupling", "shear"],
    "circuits": ["."],
    "shapes": ["."],
    "case": ["text", ".", "schema", "document", "checks", "reading"],
    "finite_layers": ["thickness", "plane", "faces", "fields", "skin"],
    "mesh": ["."],
    "history": ["."],
    "mechanics": ["output", "surface", "slider", "skin", "path", "engine", "."],
    "handover": ["measures", ".", "sliders"],
    "poroelasticity": ["."],
    "electrochemistry": ["output", "grid", "coupling", "circuit", "equations", "solver", "time", "."],
    "planning": ["."],
    "readout": ["."],
    "results": ["hdf5", "strain_file", "."],
    "live": ["data", "products", "contact", ".", "errors", "batch", "touches", "interface", "fmu", "reduction", "training"],
    "study": ["store", "metrics", "errors", "run", "impedance", "sweep", "fit"],
}
# header prefix -> the folders that may include it
LIBRARIES = {
    "toml": {"units", "case"},
    "udunits2": {"units"},
    "hdf5": {"results"},
    "minizip": {"live"},
    "CLI/": set(),
    "iostream": set(),
}
# The physics know nothing of each other.
APART = {(room, other) for room in ("electrochemistry", "poroelasticity") for other in ("mechanics", "handover")}
MOST_ENTRIES = 30  # files and folders in one folder
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')


def room_and_folder(parts):
    """The room of a path below src/ionskin, and its subfolder."""
    return parts[0], "/".join(parts[1:-1]) or "."


def violations(source_root):
    """Yields one message for each include that breaks the rule."""
    room_rank = {room: index for index, room in enumerate(ROOMS)}
    for path in sorted(source_root.rglob("*.[ch]pp")):
        room, folder = room_and_folder(path.relative_to(source_root).parts)
        if room not in ROOMS or folder not in ROOMS[room]:
            yield f"{path}: folder '{room}/{folder}' is not in the list of folders"
            continue
        for number, line in enumerate(path.read_text().splitlines(), 1):
            match = INCLUDE.match(line)
            if not match:
                continue
            header = match.group(1)
            place = f"{path}:{number}"
            if header.startswith("ionskin/"):
                target, inner = room_and_folder(header.split("/")[1:])
                if target not in ROOMS or inner not in ROOMS[target]:
                    yield f"{place}: includes from unknown folder '{target}/{inner}'"
                elif room_rank[target] > room_rank[room]:
                    yield f"{place}: '{room}' must not include '{target}'"
                elif (room, target) in APART:
                    yield f"{place}: '{room}' must not include '{target}': the history is all that passes between them"
                elif target == room and ROOMS[room].index(inner) > ROOMS[room].index(folder):
                    yield f"{place}: '{room}/{folder}' must not include '{room}/{inner}'"
            for prefix, allowed in LIBRARIES.items():
                if header.startswith(prefix) and room not in allowed:
                    yield f"{place}: '{room}' must not include <{header}>"


def table_mistakes(source_root, page):
    """Yields one message for each folder that the table lacks, names wrongly or has out of order."""
    listed = re.findall(r"^\| `([a-z0-9_/]+)` \| \S", page.read_text(), re.MULTILINE)
    known = [room if folder == "." else f"{room}/{folder}" for room, folders in ROOMS.items() for folder in folders]
    there = {str(path.parent.relative_to(source_root)) for path in source_root.rglob("*.[ch]pp")}
    for name in sorted(there ^ set(listed)):
        yield f"{page}: the table of folders and the tree differ in '{name}'"
    if not there ^ set(listed) and listed != [name for name in known if name in there]:
        yield f"{page}: the folders of the table are not in the order of includes"


def crowded(root):
    """Yields one message for each folder of the sources with too many entries."""
    for source in (root / "src" / "ionskin", root / "python" / "ionskin"):
        for folder in [source, *(path for path in sorted(source.rglob("*")) if path.is_dir())]:
            count = sum(1 for entry in folder.iterdir() if entry.name != "__pycache__")
            if count > MOST_ENTRIES:
                yield f"{folder}: {count} entries, more than {MOST_ENTRIES}: divide it by subject"


def main():
    root = pathlib.Path(__file__).resolve().parent.parent
    source_root = root / "src" / "ionskin"
    found = [*violations(source_root), *table_mistakes(source_root, root / "docs" / "house-rules.md"), *crowded(root)]
    for message in found:
        print(message)
    print(f"house rules: {len(found)} violations")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
