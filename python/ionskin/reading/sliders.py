# SPDX-License-Identifier: Apache-2.0
"""The sliders of a case: one, or those of a list [[slider]]."""

SHARED = ("motion", "contact")  # tables whose keys an entry of the list may have of its own


def cases_of_sliders(case):
    """One case for each slider, in which its tables stand as [slider], [motion] and [contact].

    case : dict
        as TOML has it
    """
    entries = case.get("slider")
    if not isinstance(entries, list):
        return [case]
    return [case | {"slider": {name: value for name, value in entry.items() if name not in SHARED}}
            | {name: shared(case.get(name, {}), entry.get(name, {})) for name in SHARED} for entry in entries]


def shared(table, own):
    """A table of the case with the keys that an entry has of its own. Another kind of motion takes nothing but the cycles."""
    if "kind" in own:
        table = {name: value for name, value in table.items() if name == "cycles"}
    return table | own


def suffix(slider):
    """End of the names of what belongs to a slider, by its place in the list from 0: none for the first, "_2" for the second."""
    return "" if slider == 0 else f"_{slider + 1}"
