# SPDX-License-Identifier: Apache-2.0
"""The command `ionskin motion`."""

import sys

from ...evaluation.command import given_options, guarded
from . import motion
from .path import require_writable


def main() -> int:
    """Runs the command line of `ionskin motion` and returns the exit code."""
    options = {name: value for name, value in vars(given_options()).items() if value != ""}  # else what the recording tells
    output, overwrite, quiet = (options.pop(name) for name in ("output", "overwrite", "quiet"))
    require_writable(output, overwrite)
    path = motion(options.pop("recordings"), **options)
    path.write(output, overwrite)
    if not quiet:
        print("\n".join(path.notes))
        print(f"path: {output}\ntry it: ionskin check CASE.toml --set motion.kind=waypoints --set motion.file={output}")
    return 0


if __name__ == "__main__":
    with guarded():
        sys.exit(main())
