# SPDX-License-Identifier: Apache-2.0
"""ionskin motion: python3 -m ionskin.reading.recording RECORDING... --output PATH"""

import argparse
import sys

from ...evaluation.command import guarded
from . import motion


def main() -> int:
    """The exit code."""
    parser = argparse.ArgumentParser(prog="ionskin motion")
    parser.add_argument("recordings", nargs="+")
    parser.add_argument("--output", required=True)
    parser.add_argument("--column", action="append", default=[], dest="columns")
    for name, default in (("origin", (0, 0, 0)), ("x-axis", (1, 0, 0)), ("y-axis", (0, 1, 0)), ("tool", None),
                          ("force-in", "skin"), ("level", "auto"), ("contact-force", None), ("gap", "1 mm"), ("rate", None),
                          ("filter", None)):
        parser.add_argument(f"--{name}", default=default)
    for flag in ("--tare", "--overwrite", "--quiet"):
        parser.add_argument(flag, action="store_true")
    options = vars(parser.parse_args())
    output, overwrite, quiet = (options.pop(name) for name in ("output", "overwrite", "quiet"))
    path = motion(options.pop("recordings"), **options)
    path.write(output, overwrite)
    if not quiet:
        print("\n".join(path.notes))
        print(f"path: {output}\ntry it: ionskin check CASE.toml --set motion.kind=waypoints --set motion.file={output}")
    return 0


if __name__ == "__main__":
    with guarded():
        sys.exit(main())
