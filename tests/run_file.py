# SPDX-License-Identifier: Apache-2.0
"""Runs the tests of one file of unittest's: run_file.py [--part short|long] [--may-skip REASON] [-k PATTERN] FILE

All of them, or those that are marked @long_test, or the others. A test that is skipped is named in a line of its own, which
scripts/run_tests.py counts, and is a failure unless the regular expression REASON, or that in the environment variable
IONSKIN_MAY_SKIP, matches why. So is a file without tests.
"""

import argparse
import fnmatch
import importlib
import os
import pathlib
import re
import resource
import sys
import unittest

TESTS = pathlib.Path(__file__).resolve().parent


def single_tests(suite):
    """The tests of a suite one by one."""
    for one in suite:
        if isinstance(one, unittest.TestSuite):
            yield from single_tests(one)
        else:
            yield one


def is_long(test):
    """True if the test or its class is marked."""
    method = getattr(test, getattr(test, "_testMethodName", ""), None)
    return getattr(method, "is_long", False) or getattr(type(test), "is_long", False)


def selected(module, part, pattern):
    """The tests of a module that belong to a part and match a pattern, as a suite."""
    tests = [test for test in single_tests(unittest.defaultTestLoader.loadTestsFromModule(module))
             if (not part or is_long(test) == (part == "long")) and fnmatch.fnmatch(test.id(), f"*{pattern}*")]
    return unittest.TestSuite(tests)


def processor_seconds():
    """Processor time of this process and of those that it waited for [s]."""
    usage = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(one.ru_utime + one.ru_stime for one in usage)


class TimedResult(unittest.TextTestResult):
    """Outcome of the tests with the processor time of each [s]; that of a class's fixture counts for its first test."""

    def __init__(self, *arguments, **options):
        super().__init__(*arguments, **options)
        self.costs = []
        self.until_now = processor_seconds()

    def stopTest(self, test):
        super().stopTest(test)
        before, self.until_now = self.until_now, processor_seconds()
        self.costs.append((self.until_now - before, test.id()))


def main():
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("file", type=pathlib.Path)
    parser.add_argument("--part", choices=("short", "long"))
    parser.add_argument("--may-skip", metavar="REASON")
    parser.add_argument("-k", dest="pattern", default="", metavar="PATTERN")
    arguments = parser.parse_args()
    sys.path[:1] = [str(arguments.file.resolve().parent), str(TESTS)]
    suite = selected(importlib.import_module(arguments.file.stem), arguments.part, arguments.pattern)
    result = unittest.TextTestRunner(sys.stdout, verbosity=2, buffer=False, resultclass=TimedResult).run(suite)
    unexpected = 0
    for test, reason in result.skipped:
        expected = any(allowed and re.search(allowed, reason)
                       for allowed in (arguments.may_skip, os.environ.get("IONSKIN_MAY_SKIP")))
        unexpected += not expected
        print(f"skipped{'' if expected else ' unexpectedly'}: {test.id()}: {reason}")
    if not suite.countTestCases():
        print("no such test")
    for seconds, name in sorted(result.costs, reverse=True):
        if seconds > 2:
            print(f"{seconds:6.1f} s of processor time: {name}")
    print(f"processor time: {processor_seconds():.1f} s")
    sys.exit(0 if result.wasSuccessful() and suite.countTestCases() and not unexpected else 1)


if __name__ == "__main__":
    main()
