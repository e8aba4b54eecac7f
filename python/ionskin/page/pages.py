# SPDX-License-Identifier: Apache-2.0
"""HTML report pages, made from the templates beside this file, which escape all text that comes from a case or a file."""

import functools
import json
import pathlib
from typing import Any, NamedTuple

from markupsafe import Markup

from .. import output_folder
from ..words import without_folders

FOLDER = pathlib.Path(__file__).parent


class Section(NamedTuple):
    """Section of a page; `part` is the name of the macro of templates/parts.html that shows `data`, which None leaves out."""

    identifier: str
    heading: str
    part: str
    data: Any


class Table(NamedTuple):
    """Table of a page: rows of texts under a head; `numbers` are the indices of columns that are aligned to the right."""

    head: tuple
    rows: list
    numbers: tuple = ()


class Picture(NamedTuple):
    """Figure of a page; `image` is an SVG element, the URL of a picture, or None where the page's script draws it."""

    identifier: str
    heading: str
    caption: str
    image: Any


@functools.cache
def environment():
    """jinja2 environment of the templates, in which every value is escaped."""
    import jinja2  # half of the figures' users never make a page

    return jinja2.Environment(loader=jinja2.FileSystemLoader(FOLDER / "templates"), autoescape=True, trim_blocks=True,
                              lstrip_blocks=True, undefined=jinja2.StrictUndefined, finalize=shown)


def shown(value):
    """Prepares a value for a page: removes folders from texts, since a page may be given
    away and folders tell of a user's machine."""
    if not isinstance(value, str) or isinstance(value, Markup) or value.startswith("data:"):
        return value
    return without_folders(value)


def page(title, subtitle, sections, *, cards=(), script=None, answer=None):
    """Makes the HTML text of a whole page, which needs no network.

    sections  list of Section; those without data are left out
    cards     headline numbers, as of `report_text.headline`
    script    text of the page's script; None for none
    answer    (sentences, Picture or None) above all sections; None for none
    """
    style = (FOLDER / "report.css").read_text(encoding="utf-8")
    return environment().get_template("page.html").render(
        title=title, subtitle=subtitle, cards=cards, answer=answer, sections=[section for section in sections if section.data],
        style=Markup(style), script=Markup(script) if script else "")


def chart_script(scripts):
    """Text of the script that draws charts, followed by the scripts of a page.

    scripts  dict of constant to (name of a script file in this folder, data); the script finds its data in the constant
    """
    texts = [(FOLDER / "charts.js").read_text(encoding="utf-8")]
    for constant, (name, data) in scripts.items():
        payload = json.dumps(data, separators=(",", ":"), ensure_ascii=False).replace("<", "\\u003c")
        texts += [f"const {constant}={payload};", (FOLDER / name).read_text(encoding="utf-8")]
    return "\n".join(texts)


def write_page(path, text):
    """Writes the text of a page into a file, whole or not at all, and returns the path."""
    output_folder.write_text(path, text)
    return path
