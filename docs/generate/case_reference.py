# SPDX-License-Identifier: Apache-2.0
"""The case reference and the command line page, from what the program itself says."""

import json
import subprocess

SECTIONS = {"title": "Title", "skin": "Skin", "materials": "Materials", "slider": "Slider", "motion": "Motion",
            "contact": "Contact", "electrochemistry": "Ions", "coupling": "Coupling", "strain": "Strain source",
            "readout": "Readout", "numerics": "Accuracy", "output": "Output"}

SEVERAL = """A list `[[slider]]` puts several sliders on the skin. An entry takes the keys of `slider` below, and as `motion.KEY` and `contact.KEY` keys of
these sections of its own; `--set slider[1].radius="9 mm"` changes the second ([several sliders](motion.md#several-sliders-on-one-skin)).
"""

HEAD = """# Case reference

Made from the table by which the program reads and checks a case: `ionskin keys --json`. Quantities are texts with a
unit, `"15 mm"`; any unit of the right dimension does. `--set KEY=VALUE` changes a key for one run, `--over` varies it
in a sweep. `[]` stands for an entry of a list of tables, `NAME` for a name of your choice.

| key | what it is |
|---|---|
"""


def output_of(program, *arguments):
    """Text that the program prints."""
    return subprocess.run([program, *arguments], capture_output=True, text=True, check=True).stdout


def kind(row):
    """Type with dimension, and the range that the value must lie in."""
    if row["choices"]:
        return "one of " + ", ".join(f"`\"{choice}\"`" for choice in row["choices"])
    words = row["type"]
    if row["dimensions"]:
        words += ": " + " or ".join(row["dimensions"])
    if row["range"]:
        words += f", {row['range']}"
    return words + (f" ({row['range_reason']})" if row["range_reason"] else "")


def entry(row):
    """The paragraph of one key."""
    value = f"default `{row['default']}`" if row["default"] else row["need"]
    lines = [f"### `{row['key']}`", "", row["help"], "", f"- {kind(row)}", f"- {value}"]
    if row["source"]:
        lines.append(f"- source: {row['source']}")
    return "\n".join(lines) + "\n"


def anchor(key):
    """The address that the heading of a key gets."""
    return "".join(letter for letter in key.lower() if letter.isalnum() or letter in "_-")


def case_reference(program):
    """Markdown of the page on all keys."""
    rows = json.loads(output_of(program, "keys", "--json"))
    index = "".join(f"| [`{row['key']}`](#{anchor(row['key'])}) | {row['help']} |\n" for row in rows)
    parts, section = [], None
    for row in rows:
        name = row["key"].split(".")[0]
        if name != section:
            parts.append(f"## {SECTIONS.get(name, name.capitalize())}\n")
            section = name
            parts.extend([SEVERAL] if name == "slider" else [])
        parts.append(entry(row))
    return HEAD + index + "\n" + "\n".join(parts)


def command_line(program):
    """Markdown of the page on all verbs."""
    text = ["# Command line\n", "As `ionskin --help` and `ionskin VERB --help` print it.\n"]
    top = output_of(program, "--help")
    text.append(f"```text\n{top.rstrip()}\n```\n")
    verbs = [line.split()[0] for line in top.split("Subcommands:")[1].split("Exit codes:")[0].splitlines()
             if line.startswith("  ") and line.strip()]
    for verb in verbs:
        text.append(f"## `ionskin {verb}`\n\n```text\n{output_of(program, verb, '--help').rstrip()}\n```\n")
    text.append("""## Shell completion and manual page

    source <(ionskin completion bash)        # in ~/.bashrc; zsh: ionskin completion zsh
    ionskin man | man -l -

Completion knows verbs, options, choices, files, and the keys of a case behind `--set` and `--over`.
""")
    return "\n".join(text)
