# SPDX-License-Identifier: Apache-2.0
"""Results of a run as the terminal shows them, in the words and digits of its page: /usr/bin/python3 -m ionskin.page.terminal FOLDER"""

import argparse

from ..errors import exit_on
from ..results import Results
from ..words import aligned
from . import answer, report_text


def lines(results):
    """The sentences on readings that the page opens with and its headline: words, values with their errors, names in files."""
    return [*answer.readings(results),
            *aligned([(words, f"{value} {error}".rstrip(), name) for name, (words, value, error) in report_text.headline(results).items()])]


def main():
    """Prints the answer of a finished run on the terminal, by the command line."""
    parser = argparse.ArgumentParser(prog="ionskin.page.terminal", description=__doc__)
    parser.add_argument("folder", help="output folder of a run")
    with exit_on(OSError):
        print("\n".join(lines(Results(parser.parse_args().folder, unfinished=True))))


if __name__ == "__main__":
    main()
