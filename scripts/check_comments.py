#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that comments say what a thing is, and that each room of src/ionskin has a page.

A comment is a sentence with a subject, or a noun phrase. It begins neither with a word that leaves the subject out, such
as "Of" or "Whether", nor with "The same", which leaves it to the comment before, nor with a preposition unless a comma
divides it from the subject: "In a sweep, the points share their mechanics." Unit tests are named in capitalised words
without underscores.
"""

import ast
import pathlib
import re
import sys

SOURCES = ("apps", "benchmarks", "cases", "docs", "examples", "fuzz", "python", "scripts", "src", "studio", "tests",
           "verification")
SUFFIXES = (".cpp", ".hpp", ".h", ".py", ".ts", ".js")
WITHOUT_SUBJECT = set("""also and another as because but by from how into its of or out per since so than that their those to
                         what whether which who whose why""".split())
PREPOSITIONS = set("""above after against along among at before behind below beside between beyond during for if in on over
                      through under until when where while with within without""".split())
# Words that send the reader to the comment before: reference pages and editors show each comment by itself.
REPEATS = re.compile(r"(The same|Same|Likewise|Ditto|As above)\b(?! (as|that|in) )")
# Words with which even a comment behind a declaration, that goes on from the name, leaves its subject out.
WITHOUT_NAME = set("how so that those what whether which why".split())
LINE = re.compile(r"^\s*///?(?!<) ?(.*)$")
PARAMETER = re.compile(r"@(param|returns?)\b")
CONSTRUCTOR = re.compile(r"\s*(explicit\s+)?[A-Z]\w*\(")
BEHIND = re.compile(r"///< ?(.*)$")
SENTENCE = re.compile(r".*?[.:;](?=\s|$)|.*", re.DOTALL)
TEST_NAME = re.compile(r"^(?:TYPED_)?TEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\)", re.MULTILINE)
CAPITALISED = re.compile(r"[A-Z][A-Za-z0-9]*$")
PAGE_PARTS = ("**In:**", "**Out:**", "**Equations:**", "**Begin with:**")


def line_comments(text):
    """Yields line number and text of each comment that stands on lines of its own, before what it is about."""
    first, parts = 0, []
    for number, line in enumerate([*text.splitlines(), ""], 1):
        own = LINE.match(line)
        if own and "SPDX" not in line:
            first, parts = (first, [*parts, own[1]]) if parts else (number, [own[1]])
            continue
        if parts:
            yield first, " ".join(parts)
            parts = []


def comments_behind(text):
    """Yields line number and text of each comment that goes on from a name: `double length; ///< along x [m]`."""
    for number, line in enumerate(text.splitlines(), 1):
        if behind := BEHIND.search(line):
            yield number, behind[1]


def parameters_alone(text):
    """Yields line number and text of each comment of parameters alone, before anything but a constructor."""
    lines = text.splitlines()
    for first, comment in line_comments(text):
        declared = next((line for line in lines[first:] if not LINE.match(line)), "")
        if PARAMETER.match(comment) and not CONSTRUCTOR.match(declared):
            yield first, comment


def docstrings(text):
    """Yields line number and text of each docstring of a Python source."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)) and ast.get_docstring(node):
            yield node.body[0].lineno, ast.get_docstring(node)


def first_word(comment):
    """First word of a comment, in small letters."""
    return re.match(r"[A-Za-z]*", comment)[0].lower()


def lacks_subject(comment):
    """True where the first sentence of a comment leaves its subject out, or to the comment before."""
    word = first_word(comment)
    return REPEATS.match(comment) or word in WITHOUT_SUBJECT or (word in PREPOSITIONS and "," not in SENTENCE.match(comment)[0])


def mistakes(name, text):
    """Yields one message for each comment of a source that leaves its subject out."""
    python = name.endswith(".py")
    found = [one for one in (docstrings(text) if python else line_comments(text)) if lacks_subject(one[1])]
    found += [] if python else [one for one in comments_behind(text) if first_word(one[1]) in WITHOUT_NAME]
    found += parameters_alone(text) if name.endswith((".hpp", ".h")) else []
    for line, comment in sorted(found):
        yield f"{name}:{line}: say what this is, as a sentence with a subject or a noun phrase: {comment.split(chr(10))[0][:60]}"


def name_mistakes(name, text):
    """Yields one message for each unit test of a source whose name is not written in capitalised words."""
    for test in TEST_NAME.finditer(text):
        if not CAPITALISED.match(test[1]) or not CAPITALISED.match(test[2]):
            yield f"{name}:{text[:test.start()].count(chr(10)) + 1}: name the test in capitalised words: {test[1]}.{test[2]}"


def page_mistakes(room, page):
    """Yields one message for each part that the page of a room lacks; `page` is None where there is no page."""
    if page is None:
        yield f"{room}/README.md: missing; it says {', '.join(PAGE_PARTS)}"
        return
    for part in PAGE_PARTS:
        if part not in page:
            yield f"{room}/README.md: lacks {part}"


def main():
    root = pathlib.Path(__file__).resolve().parent.parent
    found = []
    for source in SOURCES:
        for path in sorted((root / source).rglob("*")):
            name = path.relative_to(root).as_posix()
            if path.suffix in SUFFIXES and "/_build/" not in name:
                text = path.read_text(encoding="utf-8")
                found += [*mistakes(name, text), *name_mistakes(name, text)]
    for room in sorted(path for path in (root / "src" / "ionskin").iterdir() if path.is_dir()):
        page = room / "README.md"
        found += page_mistakes(room.relative_to(root).as_posix(), page.read_text(encoding="utf-8") if page.exists() else None)
    for message in found:
        print(message)
    print(f"comments: {len(found)} mistakes")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
