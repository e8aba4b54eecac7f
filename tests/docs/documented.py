# SPDX-License-Identifier: Apache-2.0
"""Commands and output as they stand in the pages, and whether a program still prints that output."""

import math
import re

NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
DURATION = re.compile(r"[\d.]+ s in all")
SAME = 2e-3  # relative; the pages show numbers of a coarse preset


def console_blocks(text):
    """Pairs of command and expected lines of all ```console blocks."""
    pairs = []
    for block in re.findall(r"^```console\n(.*?)^```", text, re.DOTALL | re.MULTILINE):
        for line in block.splitlines():
            if line.startswith("$ "):
                pairs.append((line[2:], []))
            else:
                pairs[-1][1].append(line)
    return pairs


def indented_commands(text, starts):
    """Commands in indented blocks that begin with one of `starts`, without their comments."""
    lines = [line[4:].split("  #")[0].strip() for line in text.splitlines() if line.startswith("    ")]
    return [line for line in lines if line.startswith(starts)]


def same_line(expected, printed):
    """Equal but for spacing, the last digits of numbers, and how long something took."""
    expected, printed = (DURATION.sub("0 s in all", line) for line in (expected, printed))
    words = [" ".join(NUMBER.sub("#", line).split()) for line in (expected, printed)]
    if words[0] != words[1]:
        return False
    numbers = [[float(number) for number in NUMBER.findall(line)] for line in (expected, printed)]
    return all(math.isclose(one, two, rel_tol=SAME, abs_tol=1e-9) for one, two in zip(*numbers))


def first_difference(expected, printed):
    """The first expected line that is not there in its place, or None. `...` stands for any lines."""
    at, free = 0, False
    for line in expected:
        if line == "...":
            free = True
            continue
        while free and at < len(printed) and not same_line(line, printed[at]):
            at += 1
        if at >= len(printed) or not same_line(line, printed[at]):
            return line
        at, free = at + 1, False
    return None if free or at == len(printed) else f"(nothing more, but: {printed[at]})"
