#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that the equations of docs/model.md are numbered from 1 on, and that the source code names each of them where it
computes it and no other: docs/model.md (13)."""

import pathlib
import re
import sys

BLOCK = re.compile(r"\$\$(.*?)\$\$([^\n]*)", re.DOTALL)
CITED = re.compile(r"docs/model\.md((?:,? \(\d+\))+)")
SOURCES = ("src", "verification")


def mistakes(page, sources):
    """Yields one message for each equation without its number, cited nowhere, or cited and not there.

    `page` is the text of the page, `sources` holds the text of each source file by its name.
    """
    numbers = set()
    for expected, (equation, behind) in enumerate(BLOCK.findall(page), 1):
        numbers.add(expected)
        if behind.strip() != f"({expected})":
            yield f"docs/model.md: ({expected}) must stand behind the equation {' '.join(equation.split())[:60]}"
    cited = set()
    for name, text in sources.items():
        for citation in CITED.findall(text):
            for number in map(int, re.findall(r"\d+", citation)):
                cited.add(number)
                if number not in numbers:
                    yield f"{name}: docs/model.md has no equation ({number})"
    for number in sorted(numbers - cited):
        yield f"docs/model.md: equation ({number}) is named nowhere in {' and '.join(SOURCES)}"


def main():
    root = pathlib.Path(__file__).resolve().parent.parent
    sources = {str(path.relative_to(root)): path.read_text() for source in SOURCES
               for path in sorted((root / source).rglob("*.[ch]pp"))}
    found = list(mistakes((root / "docs" / "model.md").read_text(), sources))
    for message in found:
        print(message)
    print(f"equations: {len(found)} mistakes")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
