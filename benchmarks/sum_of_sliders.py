#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Charges of several sliders on one skin beside the sum of the charges of each slider by itself, by full runs.

    /usr/bin/python3 benchmarks/sum_of_sliders.py build/ionskin [--case cases/pinch.toml] [--preset coarse] [--law LAW ...]

The case has a list [[slider]]. For each coupling law the script prints the largest difference, and its root mean square over
the time, over the largest charge. docs/live.md says what follows for live fingers.
"""

import argparse
import pathlib
import re
import subprocess
import tempfile

import numpy

CASES = pathlib.Path(__file__).resolve().parent.parent / "cases"
SLIDER = re.compile(r"^\[\[slider\]\]\n(?:(?!\[).*\n)*", re.MULTILINE)


def charge(folder):
    """Time [s] and charge of the top electrode [C] of a run."""
    with open(folder / "signals.csv", encoding="utf-8") as table:
        titles = [title.split()[0] for title in table.readline().split(",")]
        return numpy.loadtxt(table, delimiter=",", usecols=(titles.index("time"), titles.index("charge_top")), unpack=True)


def main():
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--case", type=pathlib.Path, default=CASES / "pinch.toml")
    parser.add_argument("--preset", default="coarse")
    parser.add_argument("--law", nargs="+", default=["column-neutral", "volume-neutral", "fixed-charge"])
    arguments = parser.parse_args()
    text = arguments.case.read_text(encoding="utf-8")
    sliders = SLIDER.findall(text)
    texts = {"all": text, **{f"slider {number}": SLIDER.sub(lambda found, own=own: own if found[0] == own else "", text)
                             for number, own in enumerate(sliders, 1)}}
    for law in arguments.law:
        with tempfile.TemporaryDirectory() as scratch:
            charges = {}
            for name, content in texts.items():
                case = pathlib.Path(scratch) / f"{name}.toml"
                case.write_text(content, encoding="utf-8")
                subprocess.run([arguments.program.resolve(), "run", case, "-o", case.with_suffix(""), "--no-report", "--quiet", "--set",
                                f"numerics.preset={arguments.preset}", "--set", "numerics.error_estimate=off", "--set",
                                f"coupling.law={law}"], check=True)
                charges[name] = charge(case.with_suffix(""))
        time, together = charges.pop("all")
        difference = sum(numpy.interp(time, *own) for own in charges.values()) - together
        largest = numpy.abs(together).max()
        print(f"{law}: largest charge {largest:.3g} C; sum of {len(charges)} sliders differs by {numpy.abs(difference).max() / largest:.1%} "
              f"at most, {numpy.sqrt(numpy.average(difference**2, weights=numpy.gradient(time))) / largest:.1%} rms")


if __name__ == "__main__":
    main()
