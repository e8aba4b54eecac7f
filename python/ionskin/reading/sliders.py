# SPDX-License-Identifier: Apache-2.0
"""Sliders of a case: a single table [slider], or a list [[slider]]."""

SHARED = ("motion", "contact")  # tables whose keys an entry of the list may have of its own


def cases_of_sliders(case):
    """Splits a case into one case for each slider, in which [slider], [motion] and [contact] are the tables of this slider.

    case  nested dict of the TOML text

    Returns a list of such dicts; [case] itself for a single slider.
    """
    entries = case.get("slider")
    if not isinstance(entries, list):
        return [case]
    return [case | {"slider": {name: value for name, value in entry.items() if name not in SHARED}}
            | {name: shared(case.get(name, {}), entry.get(name, {})) for name in SHARED} for entry in entries]


def shared(table, own):
    """Merges a table of the case with the keys of a slider's own; where these name another
    kind of motion, only the cycles are shared."""
    if "kind" in own:
        table = {name: value for name, value in table.items() if name == "cycles"}
    return table | own


def suffix(slider):
    """Suffix of the names of a slider's signals, by its index in the list from 0: ""
    for the first slider, "_2" for the second."""
    return "" if slider == 0 else f"_{slider + 1}"
