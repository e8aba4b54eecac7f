#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Checks the rule of the house: includes point one way only, and special libraries stay in their rooms."""

import pathlib
import re
import sys

FOLDERS = [
    "base", "units", "case", "mesh", "linear_algebra", "mechanics", "strain", "poroelasticity",
    "electrochemistry", "readout", "results", "study",
]
# header prefix -> the folders that may include it
LIBRARIES = {
    "toml": {"units", "case"},
    "udunits2": {"units"},
    "hdf5": {"results"},
    "cholmod": {"linear_algebra"},
    "CLI/": set(),
    "iostream": set(),
}
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')


def violations(source_root):
    """Yields one message for each include that breaks the rule."""
    rank = {folder: index for index, folder in enumerate(FOLDERS)}
    for path in sorted(source_root.rglob("*.[ch]pp")):
        folder = path.relative_to(source_root).parts[0]
        if folder not in rank:
            yield f"{path}: folder '{folder}' is not in the list of folders"
            continue
        for number, line in enumerate(path.read_text().splitlines(), 1):
            match = INCLUDE.match(line)
            if not match:
                continue
            header = match.group(1)
            place = f"{path}:{number}"
            if header.startswith("ionskin/"):
                target = header.split("/")[1]
                if target not in rank:
                    yield f"{place}: includes unknown folder '{target}'"
                elif rank[target] > rank[folder]:
                    yield f"{place}: '{folder}' must not include '{target}'"
                elif folder == "electrochemistry" and target == "mechanics":
                    yield f"{place}: the two physics must not include each other"
            for prefix, allowed in LIBRARIES.items():
                if header.startswith(prefix) and folder not in allowed:
                    yield f"{place}: '{folder}' must not include <{header}>"


def main():
    source_root = pathlib.Path(__file__).resolve().parent.parent / "src" / "ionskin"
    found = list(violations(source_root))
    for message in found:
        print(message)
    print(f"includes: {len(found)} violations")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
