# SPDX-License-Identifier: Apache-2.0
"""Tests that wait for `make check-long`."""


def long_test(test):
    """Marks a test, or a class of them, that `make check` leaves to `make check-long`."""
    test.is_long = True
    return test
