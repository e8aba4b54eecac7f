# SPDX-License-Identifier: Apache-2.0
"""The page on the Python package, from the docstrings of what it exports."""

import functools
import importlib
import inspect
import pathlib
import re
import sys

ATTRIBUTES = (property, functools.cached_property)
FIRST = re.compile(r"\(self(, )?")
HEAD = """# Python reference

Every name of the package `ionskin`, as its docstrings tell. How the names work together is shown in [Python](python.md).
Numbers are in SI units throughout.

"""


def package(folder):
    """The module `ionskin` of a folder; needs numpy, but not the compiled solver."""
    sys.path.insert(0, str(folder))
    return importlib.import_module("ionskin")


def signature(name, value):
    """Signature of a function, with its types where they are given."""
    try:
        return f"{name}{inspect.signature(value)}"
    except ValueError:
        return name


def text_block(value):
    """A docstring as it stands: its columns are aligned by hand."""
    return f"```text\n{inspect.getdoc(value) or ''}\n```\n"


def members(value):
    """Public methods and properties that the class itself documents, by name."""
    for name, member in vars(value).items():
        plain = getattr(value, name) if isinstance(member, classmethod) else member
        if not name.startswith("_") and (inspect.isroutine(plain) or isinstance(plain, ATTRIBUTES)) and plain.__doc__:
            yield name, plain


def entry(name, value):
    """Section of one exported name."""
    parts = [f"## `{name}`\n"]
    if not (inspect.isclass(value) and issubclass(value, (Exception, tuple))):
        parts.append(f"```python\n{signature(f'ionskin.{name}', value)}\n```\n")
    parts.append(text_block(value))
    for own, member in members(value) if inspect.isclass(value) else ():
        shown = own if isinstance(member, ATTRIBUTES) else FIRST.sub("(", signature(own, member))
        parts.append(f"### `{name}.{shown.split(' ->')[0]}`\n\n{text_block(member)}")
    return "\n".join(parts)


def python_api(folder: pathlib.Path):
    """Markdown of the page."""
    module = package(folder)
    return HEAD + "\n".join(entry(name, getattr(module, name)) for name in module.__all__)
