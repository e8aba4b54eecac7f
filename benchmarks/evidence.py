#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Measurements on wet ionic polymers beside what ionskin says of them: runs cases/evidence at `coarse` and prints the
rows of the page "Model against measurement".

    /usr/bin/python3 benchmarks/evidence.py build/ionskin [--json FILE] [--check]

With --check it ends with 1 where a row says something else than the page does.
"""

import argparse
import dataclasses
import json
import math
import sys
import tempfile
from pathlib import Path

from evidence_rows import EXPERIMENTS, departures, two_decays, two_laws
from evidence_runs import Runs


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=Path, help="the ionskin program")
    parser.add_argument("--json", type=Path, metavar="FILE", help="write the rows to this file")
    parser.add_argument("--check", action="store_true", help="end with 1 where a row says something else than the page does")
    options = parser.parse_args()
    rows = []
    with tempfile.TemporaryDirectory() as work:
        runs = Runs(options.program.resolve(), Path(work))
        for experiment in EXPERIMENTS:
            for row in experiment(runs):
                rows.append(row)
                print(f"{row.verdict:14} {row.name}: measured {row.measured}; computed {row.computed or '-'}", flush=True)
        laws, decays = two_laws(runs), two_decays(runs)
    counts = {verdict: sum(row.verdict == verdict for row in rows) for verdict in ("agrees", "disagrees", "cannot be had")}
    print(", ".join(f"{count} {verdict}" for verdict, count in counts.items()))
    print(f"largest stated error of a peak: {100 * runs.largest_error:.2g} %; {len(runs.known)} runs")
    if options.json:
        numbers = [{name: None if isinstance(value, float) and math.isnan(value) else value
                    for name, value in dataclasses.asdict(row).items()} for row in rows]
        options.json.write_text(json.dumps({"largest_error": runs.largest_error, "rows": numbers, "two_laws": laws, "two_decays": decays}, indent=1) + "\n", encoding="utf-8")
    if options.check and (wrong := [*departures(rows)]):
        sys.exit("\n".join(wrong))


if __name__ == "__main__":
    main()
