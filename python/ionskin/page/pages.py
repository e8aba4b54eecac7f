# SPDX-License-Identifier: Apache-2.0
"""Report pages from the templates beside this file. Whatever comes from a case or a file is escaped by them."""

import functools
import json
import pathlib
from typing import Any, NamedTuple

from markupsafe import Markup

from .. import output_folder
from ..words import without_folders

FOLDER = pathlib.Path(__file__).parent


class Section(NamedTuple):
    """One section of a page: `part` names the macro of templates/parts.html that draws `data`."""

    identifier: str
    heading: str
    part: str
    data: Any


class Table(NamedTuple):
    """Rows of texts under a head; columns of numbers, by index, are aligned to the right."""

    head: tuple
    rows: list
    numbers: tuple = ()


class Picture(NamedTuple):
    """A figure of a page; `image` is an SVG element or the address of a picture."""

    identifier: str
    heading: str
    caption: str
    image: Any


@functools.cache
def environment():
    """The templates, every value in them escaped."""
    import jinja2  # half of the figures' users never make a page

    return jinja2.Environment(loader=jinja2.FileSystemLoader(FOLDER / "templates"), autoescape=True, trim_blocks=True,
                              lstrip_blocks=True, undefined=jinja2.StrictUndefined, finalize=shown)


def shown(value):
    """A value as a page shows it: a page may be given away, and folders tell of a user's machine."""
    if not isinstance(value, str) or isinstance(value, Markup) or value.startswith("data:"):
        return value
    return without_folders(value)


def page(title, subtitle, sections, *, cards=(), script=None, answer=None):
    """The whole page as text; it stands alone, without any network. Sections without data are left out. answer: (sentences,
    Picture or None) before all others"""
    style = (FOLDER / "report.css").read_text(encoding="utf-8")
    return environment().get_template("page.html").render(
        title=title, subtitle=subtitle, cards=cards, answer=answer, sections=[section for section in sections if section.data],
        style=Markup(style), script=Markup(script) if script else "")


def chart_script(scripts):
    """The script that draws all charts, and the scripts of a page behind it. scripts: {constant: (file of this folder,
    data)}; a script finds its data, which JSON can hold, in the constant"""
    texts = [(FOLDER / "charts.js").read_text(encoding="utf-8")]
    for constant, (name, data) in scripts.items():
        payload = json.dumps(data, separators=(",", ":"), ensure_ascii=False).replace("<", "\\u003c")
        texts += [f"const {constant}={payload};", (FOLDER / name).read_text(encoding="utf-8")]
    return "\n".join(texts)


def write_page(path, text):
    """Writes a page so that readers see the old one or the whole new one."""
    output_folder.write_text(path, text)
    return path
