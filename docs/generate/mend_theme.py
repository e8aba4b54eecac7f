# SPDX-License-Identifier: Apache-2.0
"""Debian's Furo expects a bundler and a web server: its script imports another as a module, its style sheet another from
an address of the server. Pages that are opened as files get both in one piece each."""

import pathlib
import re

MODULE = re.compile(r'import\s+\w+\s+from\s+"\./([\w.-]+)";\s*')
SHEET = re.compile(r'@import\s+url\("?/(javascript/[\w./-]+)"?\);?')
SERVED = pathlib.Path("/usr/share")  # what Debian's web servers show at /javascript


def mend_theme(pages):
    """Changes the theme's files in the folder of built pages; does nothing where they need no mending."""
    for script in pages.glob("_static/scripts/furo.js"):
        text = script.read_text(encoding="utf-8")
        imported = [(script.parent / name).read_text(encoding="utf-8") for name in MODULE.findall(text)]
        script.write_text("\n".join([*imported, MODULE.sub("", text)]), encoding="utf-8")
    for sheet in pages.glob("_static/styles/*.css"):
        text = sheet.read_text(encoding="utf-8")
        sheet.write_text(SHEET.sub(lambda found: served(found[1]), text), encoding="utf-8")


def served(path):
    """A style sheet of the system, or nothing: the theme stands without it."""
    file = SERVED / path
    return file.read_text(encoding="utf-8") if file.exists() else ""
